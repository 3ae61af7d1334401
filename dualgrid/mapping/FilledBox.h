/// The part of a coarse cell that lies in the fluid mesh, as a box: its size and place follow from its volume and
/// centroid.
///
///   along each axis  f = 1 - 2 |c|/h of the cell is filled, on the side of the centroid's offset c from the middle
///
/// Exact where the mesh ends along the axes, anywhere in the cell. Where that box does not have the volume (a slanted
/// wall) the whole cell is taken: spheres near such a wall are inside. No MPI; sums only, so that several ranks can share
/// a cell.
#pragma once

#include <algorithm>
#include <cmath>

#include "Box.h"

namespace frazil
{

/// Sums over the fine parts in a coarse cell. Doubles only: it travels through the halo as such.
struct MeshShare {
    double volume = 0; ///< [m3]
    Vec3 moment;       ///< Σ V x about the cell's centre [m4]
};

/// Empty (min = max) where there is no mesh.
inline Box filledBox(const Box& cell, const MeshShare& share)
{
    const double tiny = 1e-6, h = cell.size().x;
    if (!(share.volume > 1e-12 * h * h * h))
        return {cell.min, cell.min};
    Box filled = cell;
    double volume = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double offset = share.moment[axis] / share.volume;
        const double size = h - 2 * std::abs(offset);
        (offset > 0 ? filled.min[axis] : filled.max[axis]) = offset > 0 ? cell.max[axis] - size : cell.min[axis] + size;
        volume *= size;
    }
    return std::abs(share.volume - volume) < tiny * volume ? filled : cell;
}

} // namespace frazil
