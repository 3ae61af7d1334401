/// Gidaspow, Multiphase Flow and Fluidization (1994): Ergun in dense beds, Wen & Yu in dilute suspensions.
/// Jumps at αf = 0.8, as published.
#pragma once

#include <cmath>

#include "SchillerNaumann.h"

namespace frazil
{

/// Ergun, Chem. Eng. Prog. 48 (1952) 89: β = 150 (1-αf)² μ/(αf D²) + 1.75 (1-αf) ρ |u-up|/D,
/// hence F = (150 (1-αf) + 1.75 Re) / (18 αf).
struct Ergun {
    double operator()(double re, double fluidFraction) const
    {
        return (150 * (1 - fluidFraction) + 1.75 * re) / (18 * fluidFraction);
    }
};

/// Wen & Yu, Chem. Eng. Prog. Symp. 62 (1966) 100: F = Cd Re/24 αf^-2.65 with Schiller & Naumann's Cd.
struct WenYu {
    double operator()(double re, double fluidFraction) const
    {
        return SchillerNaumann::cdRe(re) / 24 * std::pow(fluidFraction, -2.65);
    }
};

struct Gidaspow {
    static constexpr const char* name = "Gidaspow";
    static constexpr const char* source = "Multiphase Flow and Fluidization (1994)";

    double operator()(double re, double fluidFraction) const
    {
        return fluidFraction < 0.8 ? Ergun{}(re, fluidFraction) : WenYu{}(re, fluidFraction);
    }
};

} // namespace frazil
