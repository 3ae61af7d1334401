/// Output of the coupling on the fine mesh, one entry per fine cell of this rank.
#pragma once

#include <cstddef>
#include <vector>

#include "Vec3.h"

namespace frazil
{

struct FineSource {
    std::vector<double> solidFraction; ///< αs [-], of the volume that is open to fluid: αf = 1 - αs
    std::vector<Vec3> force;           ///< on the fluid [N]; divide by the cell's volume for S [N/m3]

    // What the particles in the cell will do to it in the coming step, for the prediction (CouplingStep.h).
    std::vector<double> drag;       ///< Σ K [kg/s]
    std::vector<Vec3> dragVelocity; ///< Σ K v / Σ K [m/s], zero without drag
    std::vector<double> addedMass;  ///< Σ Ca ρf V [kg]

    void reset(std::size_t fineCells)
    {
        solidFraction.assign(fineCells, 0.0);
        force.assign(fineCells, Vec3{});
        drag.assign(fineCells, 0.0);
        dragVelocity.assign(fineCells, Vec3{});
        addedMass.assign(fineCells, 0.0);
    }
    /// While summing, dragVelocity holds Σ K v [N].
    void addReaction(std::size_t cell, double k, const Vec3& momentum, double mass)
    {
        drag[cell] += k;
        dragVelocity[cell] += momentum;
        addedMass[cell] += mass;
    }
    void finishReaction()
    {
        for (std::size_t f = 0; f < drag.size(); ++f) {
            if (drag[f] > 0)
                dragVelocity[f] *= 1 / drag[f];
        }
    }
};

} // namespace frazil
