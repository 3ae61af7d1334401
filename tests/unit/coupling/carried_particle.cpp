/// What a particle carries between exchanges: its ramp, and the force and acceleration over a fluid step, by hand.
#include <gtest/gtest.h>

#include "carried_particle.h"
#include "fluid_push.h"

using namespace frazil;

TEST(CarriedParticle, AnInsertedOneDisplacesItsVolumeOverTheRamp)
{
    CarriedParticle p;
    p.age = 0.002;
    EXPECT_DOUBLE_EQ(p.displacing(0.01), 0.2);
    EXPECT_EQ(p.displacing(0.002), 1);
    EXPECT_EQ(p.displacing(0), 1);
}

TEST(CarriedParticle, TheAccelerationIsThatOfTheStepBeforeTheLast)
{
    CarriedParticle p;
    ParticleMotion motion;
    const double deltaT = 0.5;
    for (double way : {1.0, 3.0, 6.0}) { // mean velocities 2, 6, 12 m/s
        p.path = {way, 0, 0};
        p.others = {0, 4 * way, 0};
        p.endStep(deltaT, motion);
        p.clearSums();
    }
    EXPECT_DOUBLE_EQ(motion.reference.x, (6.0 - 2.0) / deltaT);
    EXPECT_DOUBLE_EQ(motion.otherForce.y, 4 * 6.0 / deltaT);
    EXPECT_DOUBLE_EQ(p.speed[0].x, 12);
    EXPECT_EQ(p.path.x, 0);
}

TEST(FluidPush, ASphereThatIsLighterThanItsAddedMassStaysStable)
{
    Interaction fluid;
    fluid.dragCoefficient = 3;
    fluid.addedMass = 2;
    const double m = 0.5, dt = 10;
    const Vec3 v{1, 0, 0}, gravity{0, -5, 0};
    const Vec3 force = gravity + reactionOnMoving(fluid, gravity, v, m, dt);
    // (m + ma + K dt) a = F - K v
    EXPECT_NEAR(force.x, m * -3 / (0.5 + 2 + 30), 1e-15);
    EXPECT_NEAR(force.y, m * -5 / (0.5 + 2 + 30), 1e-15);
}

TEST(FluidPush, APrescribedMotionFeelsItsAddedMass)
{
    Interaction fluid;
    fluid.dragCoefficient = 3;
    fluid.addedMass = 2;
    fluid.fluidVelocity = {1, 0, 0};
    const Vec3 force = reactionOnPrescribed(fluid, {0, 0, 0}, {0, 4, 0});
    EXPECT_EQ(force.x, 3);
    EXPECT_EQ(force.y, -8);
}
