/// Beetstra, van der Hoef & Kuipers, AIChE J. 53 (2007) 489, from lattice-Boltzmann simulations, Re up to 1000.
///
///   f = 10 αs/αf² + αf² (1 + 1.5 √αs)
///     + 0.413 Re/(24 αf²) (1/αf + 3 αf αs + 8.4 Re^-0.343) / (1 + 10^(3 αs) Re^(-(1 + 4 αs)/2))
///   in units of 3 π μ D αf (u - up),   hence F = αf f.
#pragma once

#include <cmath>

namespace frazil
{

struct Beetstra {
    static constexpr const char* name = "Beetstra";
    static constexpr const char* source = "AIChE J. 53 (2007) 489";

    static double inertia(double re, double fluidFraction)
    {
        if (re < 1e-12)
            return 0; // the limit; avoids 0^-0.343
        const double e = fluidFraction, s = 1 - e;
        return 0.413 * re / (24 * e * e) * (1 / e + 3 * e * s + 8.4 * std::pow(re, -0.343)) /
               (1 + std::pow(10, 3 * s) * std::pow(re, -0.5 * (1 + 4 * s)));
    }

    double operator()(double re, double fluidFraction) const
    {
        const double e = fluidFraction, s = 1 - e;
        return e * (10 * s / (e * e) + e * e * (1 + 1.5 * std::sqrt(s)) + inertia(re, e));
    }
};

} // namespace frazil
