// Reading STL, refusing surfaces that do not close, and mass properties against formulas.
#include <gtest/gtest.h>

#include "BodyShapes.h"
#include "InputError.h"

using namespace frazil;

namespace
{

std::string messageOf(const std::vector<Triangle>& triangles)
{
    try {
        checkClosed(triangles, "body.stl");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// A file of the test in the system's folder for such.
std::string scratch(const std::string& name)
{
    return testing::TempDir() + name;
}

} // namespace

TEST(ClosedSurface, BoxFarFromTheOrigin)
{
    const MassProperties m = massProperties(shapes::box({10, 20, 30}, {11, 22, 33}), 2.0);
    EXPECT_NEAR(m.volume, 6, 1e-12);
    EXPECT_NEAR(m.mass, 12, 1e-12);
    EXPECT_NEAR(norm(m.centre - Vec3{10.5, 21, 31.5}), 0, 1e-12);
    EXPECT_NEAR(m.inertia[0], 12.0 / 12 * (4 + 9), 1e-10);
    EXPECT_NEAR(m.inertia[1], 12.0 / 12 * (1 + 9), 1e-10);
    EXPECT_NEAR(m.inertia[2], 12.0 / 12 * (1 + 4), 1e-10);
    for (int i = 3; i < 6; ++i) {
        EXPECT_NEAR(m.inertia[i], 0, 1e-10);
    }
}

// A right-angled tetrahedron with legs 1: ∫xy dV = 1/120, centre at 1/4, so Ixy = -(1/120 - 1/6/16) ρ.
TEST(ClosedSurface, ProductsOfInertiaAreTensorComponents)
{
    const Vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    const MassProperties m = massProperties({{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}}, 1.0);
    EXPECT_NEAR(m.volume, 1.0 / 6, 1e-15);
    EXPECT_NEAR(m.inertia[3], -(1.0 / 120 - 1.0 / 96), 1e-15);
    EXPECT_NEAR(m.inertia[0], 1.0 / 30 - 2.0 / 96, 1e-15);
}

TEST(ClosedSurface, SphereAndProjectile)
{
    const MassProperties ball = massProperties(shapes::sphere(0.008), 2700);
    EXPECT_NEAR(ball.volume, 4.0 / 3 * pi * std::pow(0.008, 3), 3e-3 * ball.volume);
    EXPECT_NEAR(ball.inertia[0], 0.4 * ball.mass * 0.008 * 0.008, 5e-3 * ball.inertia[0]);
    const double r = 0.008, h = r / std::sqrt(3.0), length = 3.375 * 0.016;
    const MassProperties cone = massProperties(shapes::projectile(0.016, 2 * pi / 3, length), 2700);
    EXPECT_NEAR(cone.volume, pi * r * r * (length - 2 * h / 3), 1e-3 * cone.volume);
}

TEST(ClosedSurface, AsciiAndBinaryStlAreTheSame)
{
    const auto triangles = shapes::sphere(0.01, 12);
    shapes::writeAscii(triangles, scratch("ascii.stl"));
    shapes::writeBinary(triangles, scratch("binary.stl"));
    const auto ascii = readClosedStl(scratch("ascii.stl")), binary = readClosedStl(scratch("binary.stl"));
    ASSERT_EQ(ascii.size(), triangles.size());
    ASSERT_EQ(binary.size(), triangles.size());
    const double exact = massProperties(triangles, 1).volume;
    EXPECT_NEAR(massProperties(ascii, 1).volume, exact, 1e-7 * exact);
    EXPECT_NEAR(massProperties(binary, 1).volume, exact, 1e-6 * exact);
}

TEST(ClosedSurface, OpenEdgeIsNamed)
{
    auto open = shapes::box({0, 0, 0}, {1, 1, 1});
    open.pop_back();
    const std::string message = messageOf(open);
    EXPECT_NE(message.find("not closed"), std::string::npos) << message;
    EXPECT_NE(message.find("open edges: 3"), std::string::npos) << message;
    EXPECT_NE(message.find("(1 0 0) to (1 0 1)"), std::string::npos) << message;
}

TEST(ClosedSurface, WrongOrientationIsRefused)
{
    auto mixed = shapes::box({0, 0, 0}, {1, 1, 1});
    std::swap(mixed[0][1], mixed[0][2]);
    EXPECT_NE(messageOf(mixed).find("disagree about the outside"), std::string::npos);
    auto inside = shapes::box({0, 0, 0}, {1, 1, 1});
    for (Triangle& t : inside) {
        std::swap(t[1], t[2]);
    }
    EXPECT_NE(messageOf(inside).find("inside out"), std::string::npos);
    EXPECT_EQ(messageOf(shapes::box({0, 0, 0}, {1, 1, 1})), "");
}

TEST(ClosedSurface, FilesThatAreNotStl)
{
    EXPECT_THROW(readStl("not_there.stl"), InputError);
    std::ofstream(scratch("words.stl")) << "these are words";
    EXPECT_THROW(readStl(scratch("words.stl")), InputError);
    std::ofstream(scratch("half.stl")) << "solid x\nfacet\nvertex 0 0 0\nvertex 1 0 0\n";
    EXPECT_THROW(readStl(scratch("half.stl")), InputError);
}
