/// The default kernel: trilinear weights between the centres of the coarse cells.
///
///   w_c(p) = Π_axes (1 - |p - x_c|/h),  8 cells, Σ w = 1
///
/// Continuous as the particle moves. At the edge of the grid the weight of a missing cell folds back onto the edge cell,
/// so that the sum stays 1. Cost: 8 look-ups. No MPI.
#pragma once

#include <algorithm>
#include <cmath>

#include "Stencil.h"

namespace frazil
{

struct Trilinear {
    static constexpr const char* name = "trilinear";

    /// @param p  a point in a cell that this rank owns [m]
    Stencil operator()(const LocalCells& cells, const Vec3& p) const
    {
        const CoarseGrid& grid = cells.grid();
        CellIndex side[2];
        double weight[2][3];
        for (int a = 0; a < 3; ++a) {
            const double s = (p[a] - grid.box().min[a]) / grid.cellSize() - 0.5; // in cells, from the first centre
            const double lower = std::floor(s);
            const int last = grid.cells()[a] - 1;
            side[0][a] = std::clamp(int(lower), 0, last);
            side[1][a] = std::clamp(int(lower) + 1, 0, last);
            weight[1][a] = s - lower;
            weight[0][a] = 1 - weight[1][a];
        }
        Stencil stencil;
        stencil.count = 8;
        for (int n = 0; n < stencil.count; ++n) {
            const int x = n & 1, y = n >> 1 & 1, z = n >> 2;
            stencil.cell[n] = cells.local(CellIndex{side[x][0], side[y][1], side[z][2]});
            stencil.weight[n] = weight[x][0] * weight[y][1] * weight[z][2];
        }
        return stencil;
    }
};

} // namespace frazil
