/// What a coupling step leaves on the coarse grid, whichever way it couples: for the next step, output and restarts.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "CoarseField.h"
#include "PhaseTimer.h"
#include "Restriction.h"

namespace frazil
{

/// Impulse that waits in a coarse cell without fluid.
struct CarriedImpulse {
    std::int64_t cell; ///< global id
    Vec3 impulse;      ///< [N s]
};

struct CoarseState {
    LocalCells cells;
    CoarseField<double> solidVolume; ///< Σ V_p in the cell, what was clipped excluded [m3]
    CoarseField<CoarseFluid> fluid;
    CoarseField<Vec3> impulse; ///< J: on the particles, to be given to the fluid in the coming step [N s]
    std::vector<Vec3> carried; ///< per owned cell: impulse that found no fluid yet [N s]
    PhaseTimer timer;

    explicit CoarseState(LocalCells own) : cells(std::move(own)), carried(cells.ownedCount()) {}

    /// What waits in this rank's cells, for a restart file; and back from there, any cells.
    std::vector<CarriedImpulse> waiting() const
    {
        std::vector<CarriedImpulse> waiting;
        for (int c = 0; c < cells.ownedCount(); ++c) {
            if (norm(carried[c]) > 0)
                waiting.push_back({cells.global(c), carried[c]});
        }
        return waiting;
    }
    void setWaiting(const std::vector<CarriedImpulse>& waiting)
    {
        for (const CarriedImpulse& one : waiting) {
            const int c = cells.local(one.cell);
            if (c >= 0 && c < cells.ownedCount())
                carried[c] = one.impulse;
        }
    }
};

} // namespace frazil
