/// The words of fix body/rigid, and the motion that they start.
#include <gtest/gtest.h>

#include "InputError.h"
#include "body_options.h"

using namespace frazil;

namespace
{

Settings words(const std::vector<std::pair<const char*, const char*>>& more)
{
    Settings settings("", "", Settings::Form::script);
    settings.set("mesh", "hull");
    for (const auto& [key, value] : more)
        settings.set(key, value);
    return settings;
}

std::string refusal(const std::vector<std::pair<const char*, const char*>>& more)
{
    try {
        BodyOptions options(words(more));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// A homogeneous body of 2 kg, as its surface gives it.
const MassProperties solid{0.002, 2, {1, 2, 3}, {10, 20, 30, 1, 2, 3}};

} // namespace

TEST(BodyOptions, TheSurfaceGivesMassCentreAndInertia)
{
    const RigidMotion motion = startMotion(BodyOptions(words({{"density", "1000"}, {"velocity", "0 -20 0"}})), solid);
    EXPECT_EQ(motion.mass, 2);
    EXPECT_EQ(motion.centre.y, 2);
    EXPECT_EQ(motion.inertia, solid.inertia);
    EXPECT_EQ(motion.velocity.y, -20);
    EXPECT_FALSE(motion.lockMove[0] || motion.lockTurn[0]);
}

TEST(BodyOptions, AGivenMassScalesTheSurfacesInertiaButNotAGivenOne)
{
    EXPECT_EQ(startMotion(BodyOptions(words({{"mass", "4"}})), solid).inertia, (Inertia{20, 40, 60, 2, 4, 6}));
    const auto given = words({{"mass", "4"}, {"inertia", "1 2 3 0 0 0"}, {"com", "0 0 1"}});
    const RigidMotion motion = startMotion(BodyOptions(given), solid);
    EXPECT_EQ(motion.inertia, (Inertia{1, 2, 3, 0, 0, 0}));
    EXPECT_EQ(motion.centre.x, 0);
    EXPECT_EQ(motion.centre.z, 1);
}

TEST(BodyOptions, LocksKeepTheFirstVelocity)
{
    const auto given = words({{"mass", "2"}, {"omega", "0 0 5"}, {"lock", "x rz"}, {"inertia", "1 1 1 0 0 0"}});
    RigidMotion motion = startMotion(BodyOptions(given), solid);
    motion.kick({1, 1, 0}, {0, 0, 7}, 1);
    EXPECT_EQ(motion.velocity.x, 0);
    EXPECT_EQ(motion.velocity.y, 0.5);
    EXPECT_EQ(motion.omega().z, 5);
}

TEST(BodyOptions, WhatMakesNoSenseIsRefused)
{
    EXPECT_EQ(refusal({}),
              "mesh hull: gives the body no mass. Add 'density RHO' [kg/m3] or 'mass M' [kg], above zero.");
    EXPECT_EQ(refusal({{"density", "nan"}}), "density nan: is not a number. Write it like 0.005 or 5e-3, in SI units.");
    EXPECT_EQ(refusal({{"mass", "1"}, {"velocity", "0 inf 0"}}),
              "velocity 0 inf 0: is not a vector. Write three numbers: X Y Z.");
    EXPECT_EQ(refusal({{"mass", "1"}, {"lock", "x z rxx"}}),
              "lock x z rxx: rxx is no direction (did you mean \"rx\"?). Choose from: x y z rx ry rz.");
    EXPECT_NE(refusal({{"mass", "1"}, {"com", "0 0 1"}}).find("its inertia is not known"), std::string::npos);
    EXPECT_NE(refusal({{"mass", "1"}, {"inertia", "1 1 -1 0 0 0"}}).find("not a positive definite"), std::string::npos);
}
