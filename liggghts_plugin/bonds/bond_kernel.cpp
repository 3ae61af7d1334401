#include "bond_kernel.h"

// By what the processor can do, not by its name: "arch=haswell" would be that one family of processors alone
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define FRAZIL_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define FRAZIL_VECTOR_CLONES
#endif

using namespace frazil;

namespace
{

inline Vec3 at(const BondBlock::Row* rows, int b)
{
    return {rows[0][b], rows[1][b], rows[2][b]};
}

inline Vec3 at(double* const* columns, int b)
{
    return {columns[0][b], columns[1][b], columns[2][b]};
}

template <class Rows> inline void put(Rows& rows, int b, const Vec3& v)
{
    rows[0][b] = v.x;
    rows[1][b] = v.y;
    rows[2][b] = v.z;
}

template <bool Damped>
inline __attribute__((always_inline)) void advanceBond(BondBlock& block, int b, const BondMaterial& material,
                                                       double rate)
{
    double* const* columns = block.state;
    BondState state{at(columns + BondTable::separation, b), at(columns + BondTable::shear, b),
                    at(columns + BondTable::bending, b), columns[BondTable::torsion][b]};
    const BondShape shape{block.restLength[b], block.radius[b], block.share[b], block.strength[b]};
    const BondStiffness k = stiffnessOf(material, shape.restLength, shape.radius);
    const BondIncrement motion =
        advance(state, k, shape.share, at(block.separation, b), at(block.turn1, b), at(block.turn2, b));
    BondLoad load = elasticLoad(state, k, shape.restLength);
    if (Damped) {
        const BondDashpots dashpots = dashpotsOf(k, material.damping, block.reducedMass[b], block.reducedInertia[b]);
        const BondLoad viscous = viscousLoad(motion, dashpots, state.separation / norm(state.separation), rate);
        load.force += viscous.force;
        load.moment += viscous.moment;
        block.power[b] = viscousPower(motion, dashpots, rate);
    }
    const BondUse use = useOf(state, k, shape, material);
    block.useTension[b] = use.tension;
    block.useShear[b] = use.shear;
    const Vec3 lever = cross(state.separation, load.force);
    put(block.force, b, load.force);
    put(block.torque1, b, shape.share * lever + load.moment);
    put(block.torque2, b, (1 - shape.share) * lever - load.moment);

    double* const* shear = columns + BondTable::shear;
    double* const* bending = columns + BondTable::bending;
    put(columns, b, state.separation);
    put(shear, b, state.shear);
    put(bending, b, state.bending);
    columns[BondTable::torsion][b] = state.torsion;
}

FRAZIL_VECTOR_CLONES __attribute__((flatten)) void advanceElastic(BondBlock& block, const BondMaterial& material)
{
    const int count = block.count;
#pragma GCC ivdep
    for (int b = 0; b < count; ++b)
        advanceBond<false>(block, b, material, 0);
}

FRAZIL_VECTOR_CLONES __attribute__((flatten)) void advanceDamped(BondBlock& block, const BondMaterial& material,
                                                                 double rate)
{
    const int count = block.count;
#pragma GCC ivdep
    for (int b = 0; b < count; ++b)
        advanceBond<true>(block, b, material, rate);
}

} // namespace

BondBlock::BondBlock(BondTable& table, std::size_t begin, int count)
    : count(count), restLength(&table.restLength[begin]), radius(&table.radius[begin]), share(&table.share[begin]),
      strength(&table.strength[begin]), reducedMass(&table.reducedMass[begin]),
      reducedInertia(&table.reducedInertia[begin])
{
    for (int c = 0; c < BondTable::stateColumns; ++c)
        state[c] = &table.state[c][begin];
}

void frazil::advanceBlock(BondBlock& block, const BondMaterial& material, double rate)
{
    if (material.damping.any())
        advanceDamped(block, material, rate);
    else
        advanceElastic(block, material);
}
