/// The handshake's comparison: two programs that fit say nothing; each difference is named with both values and the cure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "Hello.h"

using namespace frazil;

namespace
{

struct Pair {
    DemHello dem;
    FoamHello foam;

    Pair()
    {
        dem.gravity = foam.gravity = {0, -9.81, 0};
        dem.deltaT = 1e-6;
        dem.endTime = foam.endTime = 0.01;
        dem.particles = 10;
        dem.reach = {{0.1, 0.1, 0.1}, {0.9, 0.2, 0.9}};
        foam.mesh = foam.coarse = {{0, 0, 0}, {1, 1, 1}};
        dem.bodies = foam.bodies = {{"cone", 2e-4}};
    }

    std::string mismatch() const { return frazil::mismatch(dem, foam); }

    void expect(const char* what) const
    {
        const std::string lines = mismatch();
        EXPECT_NE(lines.find(what), std::string::npos) << lines;
        EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 1) << lines;
    }
};

} // namespace

TEST(Hello, ThoseThatFitSayNothing)
{
    EXPECT_EQ(Pair().mismatch(), "");
}

TEST(Hello, VolumesOfOneSurfaceAgreeToSixDigits)
{
    EXPECT_TRUE(sameVolume(2e-4 * (1 + 9e-7), 2e-4));
    EXPECT_FALSE(sameVolume(2e-4 * (1 + 2e-6), 2e-4));
    EXPECT_FALSE(sameVolume(NAN, 2e-4));
    Pair pair;
    pair.foam.bodies[0].volume *= 1 + 9e-7;
    EXPECT_EQ(pair.mismatch(), "");
    pair.foam.bodies[0].volume = 2e5; // millimetres
    pair.expect("body `cone`: its surface holds 0.0002 m3 in frazilDem, 200000 m3 in frazilFoam");
}

TEST(Hello, BodiesOfOneSideOnly)
{
    Pair pair;
    pair.foam.bodies.clear();
    pair.expect("frazilDem has a body `cone`");
    pair.foam.bodies = pair.dem.bodies;
    pair.dem.bodies.clear();
    pair.expect("frazilFoam has a body `cone`");
}

TEST(Hello, UnitsGravityAndTimes)
{
    Pair pair;
    pair.dem.units = "cgs";
    pair.expect("Use `units si`");
    pair = Pair();
    pair.dem.gravity.y = 9.81;
    pair.expect("(0 9.81 0) m/s2 (fix gravity), frazilFoam (0 -9.81 0) m/s2");
    pair = Pair();
    pair.dem.endTime = 0.005;
    pair.expect("Lengthen `run` to 10000 steps");
    pair = Pair();
    pair.dem.fluidTime = 0.002;
    pair.expect("belongs to fluid time 0.002 s, frazilFoam starts at 0 s");
}

TEST(Hello, PlacesOfParticlesAndMesh)
{
    Pair pair;
    pair.dem.reach.max.z = 1.1;
    pair.expect("but the particles' centres reach over (0.1 0.1 0.1) to (0.9 0.2 1.1) m");
    pair = Pair();
    pair.foam.mesh = {{2, 0, 0}, {3, 1, 1}};
    pair.expect("does not touch the fluid mesh");
}

TEST(Hello, SurvivesItsPacking)
{
    Pair pair;
    const DemHello dem = unpackDemHello(pack(pair.dem));
    EXPECT_EQ(dem.bodies.at(0).name, "cone");
    EXPECT_EQ(dem.reach.max.x, 0.9);
    const FoamHello foam = unpackFoamHello(pack(pair.foam));
    EXPECT_EQ(foam.bodies.at(0).volume, 2e-4);
    EXPECT_EQ(foam.endTime, 0.01);
}
