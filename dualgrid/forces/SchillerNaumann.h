/// Drag of a single sphere. Schiller & Naumann, Z. Ver. Dtsch. Ing. 77 (1933) 318.
#pragma once

#include <cmath>

namespace frazil
{

struct SchillerNaumann {
    static constexpr const char* name = "SchillerNaumann";
    static constexpr const char* source = "Z. Ver. Dtsch. Ing. 77 (1933) 318";

    /// Cd Re [-], Re without voidage: 24 (1 + 0.15 Re^0.687) up to 1000, Newton's Cd = 0.44 above.
    static double cdRe(double re) { return re < 1000 ? 24 * (1 + 0.15 * std::pow(re, 0.687)) : 0.44 * re; }

    /// The neighbours have no influence: for dilute flow.
    double operator()(double re, double fluidFraction) const { return cdRe(re / fluidFraction) / 24; }
};

} // namespace frazil
