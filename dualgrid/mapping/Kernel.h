/// The particles' window on the coarse grid: trilinear weights between cell centres.
///
///   w_c(p) = Π_axes (1 - |p - x_c|/h),  8 cells, Σ w = 1
///
/// At the edge of the grid the weight of a missing cell folds back onto the edge cell, so the sum stays 1. Spread and
/// gather read the same stencil, so they are adjoint by construction: Σ_c φ_c (spread q)_c = Σ_p q_p (gather φ)_p.
/// Cost: 8 look-ups per particle. Parallel: local; the ring of ghosts (LocalCells.h) makes stencils of owned cells
/// whole.
#pragma once

#include "CoarseField.h"

namespace frazil
{

struct Stencil {
    int cell[8];      ///< local indices; folded cells appear more than once
    double weight[8]; ///< [-], sum 1
};

/// @param p  a point in a cell that this rank owns [m]
Stencil stencilOf(const LocalCells& cells, const Vec3& p);

/// Scales the weights by `importance` (>= 0) of their cells and normalises them again, so that nothing is sent to, or
/// read from, cells that cannot hold it. False, and the stencil unchanged, if no cell of the stencil has any.
bool reweigh(Stencil& stencil, const CoarseField<double>& importance);

template <class T> T gather(const Stencil& stencil, const CoarseField<T>& field)
{
    T sum{};
    for (int n = 0; n < 8; ++n)
        sum += stencil.weight[n] * field[stencil.cell[n]];
    return sum;
}

template <class T> void spread(const Stencil& stencil, const T& amount, CoarseField<T>& field)
{
    for (int n = 0; n < 8; ++n)
        field[stencil.cell[n]] += stencil.weight[n] * amount;
}

} // namespace frazil
