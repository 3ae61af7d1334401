/* Fluid force and torque on one sphere over one DEM step, implicit in the sphere's own motion.

   Backward Euler of
     m dv/dt = F + P + K (uf - v) + ma (Du/Dt - dv/dt)     F: all other forces, P: passive fluid force
   gives the acceleration
     a = (F + P + K (uf - v) + ma Du/Dt) / (m + ma + K dt)
   and the stock integrator, which computes f/m, takes f = m a. It is stable for any K and any ma, also where ma > m
   (a light sphere). The reaction that the fluid receives is what the integrator really applied: f - F - P.
   Torque: I dw/dt = T + C (W - w), w the spin, likewise.
   A sphere whose motion is prescribed feels P + K (uf - v) + ma (Du/Dt - a) with that motion's a; one that nobody
   moves, or that is towed at constant velocity, has a = 0.
   Cost: about 60 flops. Source: Auton, Hunt & Prud'homme 1988 for the added mass. */

#ifndef FRAZIL_FLUID_PUSH_H
#define FRAZIL_FLUID_PUSH_H

#include "Interaction.h"

namespace frazil
{

// drag and added-mass force [N] on a sphere of mass m [kg], velocity v [m/s], under the other forces [N]
inline Vec3 reactionOnMoving(const Interaction& fluid, const Vec3& other, const Vec3& v, double m, double dt)
{
    const double K = fluid.dragCoefficient, ma = fluid.addedMass;
    const Vec3 driving = K * (fluid.fluidVelocity - v) + ma * fluid.fluidAcceleration;
    const Vec3 a = (other + fluid.passiveForce + driving) * (1.0 / (m + ma + K * dt));
    return driving - (ma + K * dt) * a;
}

// the same on a sphere that performs the acceleration a [m/s2] whatever the force
inline Vec3 reactionOnPrescribed(const Interaction& fluid, const Vec3& v, const Vec3& a)
{
    return fluid.dragCoefficient * (fluid.fluidVelocity - v) + fluid.addedMass * (fluid.fluidAcceleration - a);
}

// torque [N m] on a sphere of moment of inertia I [kg m2], spin w [rad/s], under the other torques [N m]
inline Vec3 torqueOnMoving(const Interaction& fluid, const Vec3& other, const Vec3& w, double I, double dt)
{
    const double C = fluid.spinCoefficient;
    const Vec3 driving = C * (fluid.fluidSpin - w);
    return driving - (C * dt / (I + C * dt)) * (other + driving);
}

// the same on a sphere that no torque turns
inline Vec3 torqueOnPrescribed(const Interaction& fluid, const Vec3& w)
{
    return fluid.spinCoefficient * (fluid.fluidSpin - w);
}

} // namespace frazil

#endif
