/// Cuts fine cells along the coarse grid. Exact for boxes and tetrahedra; other shapes come as tetrahedra.
///
/// A tetrahedron is split by one plane of the grid after the other (1-3 or 2-2 vertices on either side: at most six
/// smaller tetrahedra), so volumes and first moments are closed-form sums and add up to the whole to round-off.
/// Cost: proportional to the number of pieces; done when the fine mesh changes, not every step. What lies outside of
/// the grid is dropped: there are no particles there. No MPI.
#pragma once

#include <cstdint>
#include <functional>

#include "Box.h"
#include "CoarseGrid.h"

namespace frazil
{

/// The piece of one fine cell inside one coarse cell. A coarse cell may come more than once: pieces add up.
struct FinePiece {
    int fineCell = 0;            ///< index in the host's mesh on this rank
    std::int64_t coarseCell = 0; ///< global id
    double volume = 0;           ///< [m3]
    Vec3 centroid;               ///< [m]
};

/// Receives one piece: global id of the coarse cell, volume [m3], centroid [m].
using PieceSink = std::function<void(std::int64_t coarseCell, double volume, const Vec3& centroid)>;

void clipBox(const Box& box, const CoarseGrid& grid, const PieceSink& sink);
/// The order of the corners does not matter.
void clipTetrahedron(const Vec3 (&corner)[4], const CoarseGrid& grid, const PieceSink& sink);

} // namespace frazil
