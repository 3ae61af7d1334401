/* The law of parallel_bond.h on a block of bonds at once: every number of the block lies in a row of its own, so that
   the compiler turns the loop over bonds into vector instructions (AVX-512 or AVX2 where the processor has them). All
   instruction sets round alike (no fused multiply-add), so results do not depend on the processor or on a bond's place
   in its block. */

#ifndef FRAZIL_BOND_KERNEL_H
#define FRAZIL_BOND_KERNEL_H

#include "bond_table.h"

namespace frazil
{

struct BondBlock {
    static constexpr int capacity = 64;
    using Row = double[capacity];

    int count;
    /// Columns of the table, from the block's first bond on.
    double* state[BondTable::stateColumns];
    const double *restLength, *radius, *share, *strength, *reducedMass, *reducedInertia;
    /// In: separation [m] and Cayley vectors of both spheres.
    Row separation[3], turn1[3], turn2[3];
    /// Out: force on sphere 1 [N] and torques on both [N m]; stress over strength; power of the dashpots [W].
    Row force[3], torque1[3], torque2[3], useTension, useShear, power;

    BondBlock(BondTable& table, std::size_t begin, int count);
};

/// Advances the block by a step of 1/rate seconds. With a rate of zero (nothing has moved) dashpots give nothing.
void advanceBlock(BondBlock& block, const BondMaterial& material, double rate);

} // namespace frazil

#endif
