/// The particle's window on the coarse grid: cells and weights that sum to one. A kernel (Kernel.h) makes it.
///
/// Spread and gather read the same stencil, so they are adjoint by construction: Σ_c φ_c (spread q)_c = Σ_p q_p (gather
/// φ)_p. Both take numbers, vectors and structs of them that have `+=` and `double *`.
/// Cost: a look-up per cell. Parallel: local; the ring of ghosts (LocalCells.h) makes stencils of owned cells whole.
#pragma once

#include <array>

#include "CoarseField.h"

namespace frazil
{

struct Stencil {
    static constexpr int capacity = 8;

    int count = 0;
    std::array<int, capacity> cell;      ///< local indices; a cell may appear more than once
    std::array<double, capacity> weight; ///< [-], sum 1
};

/// Scales the weights by `importance` (>= 0) of their cells and normalises them again, so that nothing is sent to, or
/// read from, cells that cannot hold it. False, and the stencil unchanged, if no cell of the stencil has any.
bool reweigh(Stencil& stencil, const CoarseField<double>& importance);

/// Σ w φ(cell), where `value` turns the entry of a field into what is wanted of it.
template <class T, class Value> auto gather(const Stencil& stencil, const CoarseField<T>& field, Value&& value)
{
    auto sum = decltype(value(field[0])){};
    for (int n = 0; n < stencil.count; ++n)
        sum += stencil.weight[n] * value(field[stencil.cell[n]]);
    return sum;
}

template <class T> T gather(const Stencil& stencil, const CoarseField<T>& field)
{
    return gather(stencil, field, [](const T& value) -> T { return value; });
}

template <class T> void spread(const Stencil& stencil, const T& amount, CoarseField<T>& field)
{
    for (int n = 0; n < stencil.count; ++n)
        field[stencil.cell[n]] += stencil.weight[n] * amount;
}

} // namespace frazil
