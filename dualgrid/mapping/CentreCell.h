/// The particle-centroid method: all of a particle belongs to the coarse cell that holds its centre.
///
///   w_c(p) = 1 where c holds p
///
/// The simplest kernel, and what many codes use: solid and forces jump as a centre crosses from cell to cell, by the
/// particle's share of the cell. For comparison with them. Source: Peng, Doroodchi, Luo & Moghtaderi, AIChE J. 60 (2014)
/// 2000 (limits of the method). Cost: one look-up. No MPI.
#pragma once

#include "Stencil.h"

namespace frazil
{

struct CentreCell {
    static constexpr const char* name = "centre";

    /// @param p  a point in a cell that this rank owns [m]
    Stencil operator()(const LocalCells& cells, const Vec3& p) const
    {
        Stencil stencil;
        stencil.count = 1;
        stencil.cell[0] = cells.local(cells.grid().cellOf(p));
        stencil.weight[0] = 1;
        return stencil;
    }
};

} // namespace frazil
