/// Particles as the coupling sees them: arrays owned by somebody else, one entry per particle.
#pragma once

#include <cstddef>
#include <cstdint>

#include "Vec3.h"

namespace frazil
{

/// How a sphere has moved over the last fluid step, for the prediction of its answer to the pressure (PressureResponse.h).
struct ParticleMotion {
    Vec3 otherForce;       ///< mean of all forces but the fluid's: contacts, bonds, gravity [N]
    Vec3 reference;        ///< acceleration that the fluid has seen when it made its pressure, a step late [m/s2]
    double mass = 0;       ///< [kg]; 0 where no force moves it (frozen, prescribed motion)
    double displacing = 1; ///< share of its volume that the fluid gives way to, below 1 for a while after insertion [-]
};

/// Non-owning view of `count` spheres, sorted by `id` so that sums over them do not depend on where they came from.
struct ParticleView {
    std::size_t count = 0;
    const std::int64_t* id = nullptr;
    const Vec3* position = nullptr;         ///< [m]
    const Vec3* velocity = nullptr;         ///< [m/s]
    const Vec3* angularVelocity = nullptr;  ///< [rad/s]
    const double* radius = nullptr;         ///< [m]
    const double* exposure = nullptr;       ///< [-] 1 = drag and added mass in full, 0 = shielded by its neighbours
    const Vec3* impulse = nullptr;          ///< [N s] drag and added-mass impulse received since the last exchange
    const ParticleMotion* motion = nullptr; ///< nullptr: all displace their volume, none of them is moved by a force
};

} // namespace frazil
