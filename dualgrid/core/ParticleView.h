/// Particles as the coupling sees them: arrays owned by somebody else, one entry per particle.
#pragma once

#include <cstddef>
#include <cstdint>

#include "Vec3.h"

namespace frazil {

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
};

} // namespace frazil
