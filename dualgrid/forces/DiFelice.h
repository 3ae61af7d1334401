/// Di Felice, Int. J. Multiphase Flow 20 (1994) 153: from a single sphere to a packed bed, any Re. The default.
///
///   K = ½ ρ Cd A |u - up| αf^(2-χ),  Cd = (0.63 + 4.8/√Re)²,  χ = 3.7 - 0.65 exp(-(1.5 - log10 Re)²/2)
///   hence F = (0.63 √Re + 4.8)² αf^(1-χ) / 24.
/// As Re -> 0: F -> 0.96 αf^-2.7 (the law's own Stokes limit is 4 % low).
#pragma once

#include <algorithm>
#include <cmath>

namespace frazil
{

struct DiFelice {
    static constexpr const char* name = "DiFelice";
    static constexpr const char* source = "Int. J. Multiphase Flow 20 (1994) 153";

    static double exponent(double re)
    {
        const double tiny = 1e-30; // log10 of zero raises a floating-point exception; χ is 3.7 long before
        const double s = 1.5 - std::log10(std::max(re, tiny));
        return 3.7 - 0.65 * std::exp(-0.5 * s * s);
    }

    double operator()(double re, double fluidFraction) const
    {
        const double root = 0.63 * std::sqrt(re) + 4.8;
        return root * root / 24 * std::pow(fluidFraction, 1 - exponent(re));
    }
};

} // namespace frazil
