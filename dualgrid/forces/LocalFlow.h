/// The fluid as one particle sees it, averaged on the coarse grid. Input of every force law.
#pragma once

#include "Vec3.h"

namespace frazil {

/// Constant properties of one fluid.
struct Phase {
    double density = 0;    ///< [kg/m3]
    double viscosity = 0;  ///< dynamic [Pa s]
};

struct LocalFlow {
    double fluidFraction = 1;  ///< αf [-]
    double wetFraction = 1;    ///< α1 [-], share of water in the fluid
    Vec3 velocity;             ///< u [m/s]
    Vec3 pressureGradient;     ///< ∇p of the TOTAL pressure, buoyancy included [Pa/m]
    Vec3 viscousForce;         ///< ∇·τ [N/m3]
    Vec3 acceleration;         ///< Du/Dt [m/s2]
    Vec3 vorticity;            ///< ∇×u [1/s]
};

/// One sphere as a force law sees it.
struct ParticleState {
    Vec3 velocity;         ///< [m/s]
    Vec3 angularVelocity;  ///< [rad/s]
    double radius = 0;     ///< [m]
    double exposure = 1;   ///< [-] scales drag and added mass (shielding)
};

} // namespace frazil
