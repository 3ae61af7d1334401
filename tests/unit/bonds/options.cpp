/// The words of fix bond/parallel: what they become, and what is refused.
#include <gtest/gtest.h>

#include "Cluster.h"
#include "InputError.h"

using namespace frazil;

namespace
{

std::string refusal(const std::string& key, const std::string& value)
{
    Settings words = bondWords();
    words.set(key, value);
    try {
        BondOptions options(words);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(BondOptions, DefaultsAreThoseOfTheDocumentation)
{
    const BondOptions options(bondWords());
    EXPECT_EQ(options.material.young, 5e8);
    EXPECT_EQ(options.radiusFactor, 1);
    EXPECT_EQ(options.material.momentFactor, 1);
    EXPECT_EQ(options.material.frictionTan, 0);
    EXPECT_FALSE(options.material.damping.any());
    EXPECT_EQ(options.createGap, 0.01);
    EXPECT_EQ(options.weibullModulus, 0);
    EXPECT_EQ(options.eventsFile + options.listFile, "");
}

TEST(BondOptions, OneFractionDampsAllModesAndFourEachItsOwn)
{
    Settings words = bondWords();
    words.set("damping", "0.3");
    EXPECT_EQ(BondOptions(words).material.damping.bending, 0.3);
    words.set("damping", "0.1 0.2 0.3 0.4");
    const BondFractions damping = BondOptions(words).material.damping;
    EXPECT_EQ(damping.normal, 0.1);
    EXPECT_EQ(damping.shear, 0.2);
    EXPECT_EQ(damping.torsion, 0.3);
    EXPECT_EQ(damping.bending, 0.4);
}

TEST(BondOptions, WhatMakesNoSenseIsRefused)
{
    EXPECT_EQ(refusal("friction_angle", "90"),
              "friction_angle 90: is no friction angle. Give degrees, 0 or more and below 90.");
    EXPECT_EQ(refusal("weibull", "0 3"), "weibull 0 3: has no Weibull modulus. Give m > 0, then the seed.");
    for (const char* seed : {"5 -3", "5 1.5", "5 0", "5 1e30"})
        EXPECT_EQ(refusal("weibull", seed),
                  "weibull " + std::string(seed) + ": has no seed. Give m, then a whole number from 1 to 2147483647.");
    EXPECT_EQ(refusal("damping", "0.1 nan"),
              "damping 0.1 nan: nan is not a number. Write it like 0.005 or 5e-3, in SI units.");
    EXPECT_EQ(refusal("young", "inf"), "young inf: is not a number. Write it like 0.005 or 5e-3, in SI units.");
    EXPECT_EQ(refusal("create_gap", "-0.1"), "create_gap -0.1: must not be negative. Give 0 or more.");
}
