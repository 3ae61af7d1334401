/// What the force laws return for one particle. The host integrates the implicit parts at every DEM substep.
#pragma once

#include "Vec3.h"

namespace frazil
{

/// Force on the particle = passiveForce + dragCoefficient (fluidVelocity - up)
///                         + addedMass (fluidAcceleration - dup/dt),
/// torque = spinCoefficient (fluidSpin - ωp).
struct Interaction {
    Vec3 passiveForce;          ///< pressure gradient (with buoyancy) and viscous force [N]; no reaction (model A)
    double dragCoefficient = 0; ///< K [kg/s]
    Vec3 fluidVelocity;         ///< [m/s]
    double addedMass = 0;       ///< Ca ρf V [kg]
    Vec3 fluidAcceleration;     ///< Du/Dt [m/s2]
    double spinCoefficient = 0; ///< π μ D³ [N m s]
    Vec3 fluidSpin;             ///< ½ ∇×u [rad/s]
};

} // namespace frazil
