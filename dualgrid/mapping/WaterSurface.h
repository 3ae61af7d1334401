/// The free surface inside a coarse cell: the plane that the water's volume and first moment tell.
///
/// A coarse cell of three particle diameters knows more of its water than the mean: the sums over its fine parts give
/// the share w of its open volume that is water, and the centroids of the water and of the open volume. The surface is
/// taken as the plane with
///
///   normal  n ∝ x_open - x_water   (out of the water),
///   level   so that it cuts the share w off the cell.
///
/// Exact for a plane surface along an axis or a diagonal, a few degrees off between them; the volume is exact always.
/// Where water and air are mixed (foam, splashes) there is no such plane: then |x_open - x_water| is below that of any
/// plane, at least 0.938 (1-w) h/2, and the mean w takes over in proportion.
/// Weights are the open volume, not the fluid's: particles on one side of the surface must not move it.
/// Source: first moments after Dyadechko & Shashkov, Moment-of-fluid interface reconstruction, LA-UR-05-7571 (2005),
/// without their search for the best normal; volume below a plane: Scardovelli & Zaleski, J. Comput. Phys. 164 (2000)
/// 228. Cost: some ten evaluations of that formula per cell. No MPI.
#pragma once

#include "Box.h"
#include "CoarseField.h"
#include "FilledBox.h"
#include "Restriction.h"

namespace frazil
{

struct WaterSurface {
    Vec3 normal;           ///< water is where dot(normal, x) < level
    double level = 0;      ///< [m], from the origin of the axes
    double sharpness = 0;  ///< [-] 1: a plane, 0: mixed evenly, or one fluid only
    double waterShare = 0; ///< [-] of the cell's open volume

    /// Share of a box in this cell [-] that is water.
    double shareOf(const Box& box) const;
};

/// Share of a box [-] that lies where dot(normal, x) < level [m].
double shareBelow(const Box& box, const Vec3& normal, double level);

/// The surface in a coarse cell from its sums (Restriction.h).
/// @param cell  the part of the cell that is in the mesh (FilledBox.h)
WaterSurface surfaceIn(const Box& cell, const CoarseFluid& fluid);

/// The cube of the same volume as the sphere, which counts in its place [m].
Box cubeOf(const Vec3& centre, double radius);

/// Calls visit(cell) for the local cells that a box no larger than a coarse cell reaches into: at most two along each axis.
template <class Visit> void forCellsOf(const Box& box, const LocalCells& cells, Visit&& visit)
{
    const CellIndex lo = cells.grid().nearest(box.min), hi = cells.grid().nearest(box.max);
    for (int n = 0; n < 8; ++n) {
        const CellIndex index{n & 1 ? hi[0] : lo[0], n & 2 ? hi[1] : lo[1], n & 4 ? hi[2] : lo[2]};
        if ((n & 1 && hi[0] == lo[0]) || (n & 2 && hi[1] == lo[1]) || (n & 4 && hi[2] == lo[2]))
            continue;
        const int cell = cells.local(index);
        if (cell >= 0)
            visit(cell);
    }
}

/// Where a sphere is.
struct SphereShare {
    double inMesh = 0;  ///< of its volume [-]
    double inWater = 0; ///< of the volume that finds fluid [-]
    bool dry = true;    ///< there is none
};

/// The sphere counts as the cube of the same volume, cut along the coarse cells, so that the shares are continuous as it
/// moves: through the surface, and across the edge of the mesh. Cells without fluid are left out of `inWater`.
/// @param centre, radius  [m]; the diameter is at most the coarse cell's size
/// @param filled          part of each cell that is in the mesh
SphereShare shareOfSphere(const Vec3& centre, double radius, const LocalCells& cells, const CoarseField<Box>& filled,
                          const CoarseField<CoarseFluid>& fluid, const CoarseField<WaterSurface>& surface);

} // namespace frazil
