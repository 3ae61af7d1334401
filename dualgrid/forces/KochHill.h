/// Koch & Hill, Annu. Rev. Fluid Mech. 33 (2001) 619, from lattice-Boltzmann simulations of random arrays.
///
///   β = 18 μ αf² αs/D² (F0(αs) + ½ F3(αs) Re),   hence F = αf² (F0 + ½ F3 Re).
#pragma once

#include <cmath>

namespace frazil
{

struct KochHill {
    static constexpr const char* name = "KochHill";
    static constexpr const char* source = "Annu. Rev. Fluid Mech. 33 (2001) 619";

    /// Stokes part; 0.4 is where the two published branches meet.
    static double f0(double s)
    {
        if (s >= 0.4)
            return 10 * s / ((1 - s) * (1 - s) * (1 - s));
        if (s <= 0)
            return 1;
        return (1 + 3 * std::sqrt(0.5 * s) + 135.0 / 64 * s * std::log(s) + 16.14 * s) /
               (1 + 0.681 * s - 8.48 * s * s + 8.16 * s * s * s);
    }
    static double f3(double s) { return 0.0673 + 0.212 * s + 0.0232 / std::pow(1 - s, 5); }

    double operator()(double re, double fluidFraction) const
    {
        const double s = 1 - fluidFraction;
        return fluidFraction * fluidFraction * (f0(s) + 0.5 * f3(s) * re);
    }
};

} // namespace frazil
