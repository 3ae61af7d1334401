/// Rotations about axes whose outcome is known, and the free motion of a body that can be worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "RigidMotion.h"
#include "Rotation.h"

using namespace frazil;

namespace
{

const double pi = std::acos(-1.0);

void expectNear(const Vec3& a, const Vec3& b, double tolerance = 1e-15)
{
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
}

} // namespace

TEST(Rotation, TheDefaultDoesNotTurn)
{
    expectNear(rotated(Quaternion(), Vec3{1, 2, 3}), {1, 2, 3}, 0);
    expectNear(rotated(rotationBy({}), Vec3{1, 2, 3}), {1, 2, 3}, 0);
}

TEST(Rotation, QuarterTurnsAreCounterClockwise)
{
    expectNear(rotated(rotationBy({0, 0, pi / 2}), Vec3{1, 0, 0}), {0, 1, 0});
    expectNear(rotated(rotationBy({pi / 2, 0, 0}), Vec3{0, 1, 0}), {0, 0, 1});
    expectNear(rotated(rotationBy({0, pi / 2, 0}), Vec3{0, 0, 1}), {1, 0, 0});
}

TEST(Rotation, HalfTurnsMirrorWhatIsAcrossTheAxis)
{
    expectNear(rotated(rotationBy({pi, 0, 0}), Vec3{1, 2, 3}), {1, -2, -3});
    expectNear(rotated(rotationBy({0, pi, 0}), Vec3{1, 2, 3}), {-1, 2, -3});
    const double each = pi / std::sqrt(3.0); // about (1 1 1): v -> 2 n (n.v) - v
    expectNear(rotated(rotationBy({each, each, each}), Vec3{1, 2, 3}), {3, 2, 1}, 4e-15);
}

TEST(Rotation, ThirdTurnAboutTheDiagonalPermutesTheAxes)
{
    const double each = 2 * pi / 3 / std::sqrt(3.0);
    expectNear(rotated(rotationBy({each, each, each}), Vec3{1, 2, 3}), {3, 1, 2}, 2e-15);
}

TEST(Rotation, AProductTurnsByItsRightFactorFirst)
{
    const Quaternion aboutX = rotationBy({pi / 2, 0, 0}), aboutZ = rotationBy({0, 0, pi / 2});
    expectNear(rotated(aboutX * aboutZ, Vec3{1, 0, 0}),
               {0, 0, 1}); // x -> y by the turn about z, y -> z by that about x
    expectNear(rotated(aboutZ * aboutX, Vec3{1, 0, 0}), {0, 1, 0}); // x stays, then x -> y
}

TEST(Rotation, TheInverseTurnsBack)
{
    const Quaternion q = rotationBy({0.3, -1.1, 0.7});
    expectNear(rotated(inverse(q), rotated(q, Vec3{1, 2, 3})), {1, 2, 3}, 2e-15);
    const Quaternion none = q * inverse(q);
    EXPECT_NEAR(none.w, 1, 1e-15);
    expectNear({none.x, none.y, none.z}, {});
}

TEST(Rotation, ManySmallTurnsMakeALargeOne)
{
    Quaternion q;
    for (int turn = 0; turn < 1000; ++turn)
        q = normalised(rotationBy(Vec3{0.6, 0, 0.8} * (pi / 1000)) * q);
    expectNear(rotated(q, Vec3{0, 1, 0}), {0, -1, 0}, 1e-13);
    EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1, 1e-15);
}

TEST(Rotation, TheSeriesOfSmallAnglesMeetsTheSine)
{
    const double angle = 1e-4; // where rotationBy changes over
    const Quaternion below = rotationBy({0.999999 * angle, 0, 0});
    const Quaternion above = rotationBy({1.000001 * angle, 0, 0});
    EXPECT_NEAR(below.x, std::sin(0.5 * 0.999999 * angle), 1e-19);
    EXPECT_NEAR(above.x, std::sin(0.5 * 1.000001 * angle), 1e-19);
}

TEST(Inertia, AQuarterTurnSwapsTheMomentsAndTheSignOfProducts)
{
    const Inertia turned = rotated(rotationBy({0, 0, pi / 2}), Inertia{1, 2, 3, 0.1, 0.2, 0.3});
    const double expected[6] = {2, 1, 3, -0.1, -0.3, 0.2}; // x -> y, y -> -x
    for (int c = 0; c < 6; ++c)
        EXPECT_NEAR(turned[c], expected[c], 1e-15) << "component " << c;
    EXPECT_TRUE(positiveDefinite(turned));
    EXPECT_FALSE(positiveDefinite({1, 1, 1, 2, 0, 0}));
}

TEST(RigidMotion, ABodyThatSpinsAboutAPrincipalAxisTurnsByOmegaTimesTime)
{
    RigidMotion body;
    body.mass = 2;
    body.inertia = {1, 2, 3, 0, 0, 0};
    body.velocity = {1, 0, 0};
    body.setOmega({0, 0, pi});
    for (int step = 0; step < 500; ++step)
        body.drift(1e-3);
    expectNear(body.centre, {0.5, 0, 0}, 1e-14);
    expectNear(rotated(body.orientation, Vec3{1, 0, 0}), {0, 1, 0}, 1e-12);
}

TEST(RigidMotion, LockedComponentsKeepTheirVelocity)
{
    RigidMotion body;
    body.mass = 2;
    body.inertia = {1, 1, 1, 0, 0, 0};
    body.velocity = {1, 0, 0};
    body.lockMove[0] = body.lockTurn[1] = true;
    body.kick({4, 4, 0}, {0, 5, 6}, 0.5);
    expectNear(body.velocity, {1, 1, 0}, 0);
    expectNear(body.omega(), {0, 0, 3}, 0);
}
