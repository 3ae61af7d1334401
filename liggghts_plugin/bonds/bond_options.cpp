#include "bond_options.h"

#include "Sphere.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frazil
{

BondOptions::BondOptions(const Settings& words)
{
    material.young = words.positive("young");
    material.stiffnessRatio = words.positive("stiffness_ratio");
    readStrength(words);
    readDamping(words);
    radiusFactor = words.positive("radius_factor", radiusFactor);
    createGap = words.notNegative("create_gap", createGap);
    listFile = words.text("list", "");
    if (words.has("list") && words.has("create_gap"))
        words.reject("list", "stands beside create_gap", "Give one of the two");
    eventsFile = words.text("events", "");
}

void BondOptions::readStrength(const Settings& words)
{
    material.tensileStrength = words.positive("tensile_strength");
    material.shearStrength = words.positive("shear_strength");
    material.momentFactor = words.notNegative("moment_factor", material.momentFactor);
    const double degrees = words.notNegative("friction_angle", 0);
    if (degrees >= 90)
        words.reject("friction_angle", "is no friction angle", "Give degrees, 0 or more and below 90");
    material.frictionTan = std::tan(degrees * pi / 180);
    if (words.has("weibull"))
        readWeibull(words);
}

void BondOptions::readWeibull(const Settings& words)
{
    const std::vector<double> given = words.numbers("weibull"); // modulus, seed
    weibullModulus = given[0];
    if (!(weibullModulus > 0))
        words.reject("weibull", "has no Weibull modulus", "Give m > 0, then the seed");
    if (given[1] < 1 || given[1] > std::numeric_limits<int>::max() || given[1] != std::floor(given[1]))
        words.reject("weibull", "has no seed", "Give m, then a whole number from 1 to 2147483647");
    weibullSeed = static_cast<int>(given[1]);
}

/// One fraction for all modes, or one for each.
void BondOptions::readDamping(const Settings& words)
{
    if (!words.has("damping"))
        return;
    std::vector<double> fractions = words.numbers("damping");
    if (fractions.size() == 1)
        fractions.resize(4, fractions[0]);
    if (fractions.size() != 4)
        words.reject("damping", "is neither one number nor four",
                     "Give one fraction for all modes, or those of normal, shear, torsion and bending");
    if (*std::min_element(fractions.begin(), fractions.end()) < 0)
        words.reject("damping", "is negative", "Give values of 0 or more");
    material.damping = {fractions[0], fractions[1], fractions[2], fractions[3]};
}

} // namespace frazil
