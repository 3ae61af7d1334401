/// The fluid as one particle sees it, averaged on the coarse grid. Input of every force law.
#pragma once

#include "Vec3.h"

namespace frazil
{

/// Constant properties of one fluid.
struct Phase {
    double density = 0;   ///< [kg/m3]
    double viscosity = 0; ///< dynamic [Pa s]
};

/// One of the two fluids around a particle.
struct PhaseFlow {
    double fluidFraction = 1; ///< αf in this fluid [-]
    Vec3 velocity;            ///< u [m/s]
    Vec3 acceleration;        ///< Du/Dt [m/s2]
    Vec3 vorticity;           ///< ∇×u [1/s]
};

struct LocalFlow {
    double wetShare = 1; ///< share of the sphere that is in the water [-]
    PhaseFlow water, air;
    Vec3 pressureGradient; ///< ∇p of the TOTAL pressure, buoyancy included [Pa/m]
    Vec3 viscousForce;     ///< ∇·τ [N/m3]
};

/// One sphere as a force law sees it.
struct ParticleState {
    Vec3 velocity;        ///< [m/s]
    Vec3 angularVelocity; ///< [rad/s]
    double radius = 0;    ///< [m]
    double exposure = 1;  ///< [-] scales drag and added mass (shielding)
    double presence = 1;  ///< [-] share of the sphere that feels the fluid
};

} // namespace frazil
