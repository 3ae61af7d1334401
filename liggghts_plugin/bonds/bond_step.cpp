#include "bond_step.h"

#include <algorithm>

namespace frazil
{

namespace
{

inline Vec3 row(const double* rows, int i)
{
    return {rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]};
}

/// Does any bond of the block exceed its strength?
bool breaks(const BondBlock& block)
{
    int count = 0;
    for (int b = 0; b < block.count; ++b)
        count += (block.useTension[b] > 1) | (block.useShear[b] > 1);
    return count > 0;
}

} // namespace

void BondStep::advance(BondTable& table, const BondMaterial& material, const BondSpheres& spheres, double dt,
                       bool moved)
{
    material_ = &material;
    spheres_ = &spheres;
    broken_.clear();
    turns_.resize(spheres.all);
    for (int i = 0; i < spheres.all; ++i)
        turns_[i] = cayleyVector(row(spheres.spin, i), moved ? dt : 0);
    for (std::size_t begin = 0; begin < table.size(); begin += BondBlock::capacity)
        advanceRows(table, begin, dt, moved);
}

void BondStep::removeBroken(BondTable& table)
{
    for (; !broken_.empty(); broken_.pop_back())
        table.remove(broken_.back().row);
}

void BondStep::advanceRows(BondTable& table, std::size_t begin, double dt, bool moved)
{
    const std::size_t left = table.size() - begin;
    BondBlock block(table, begin, static_cast<int>(std::min<std::size_t>(BondBlock::capacity, left)));
    gather(block, table, begin);
    advanceBlock(block, *material_, moved ? 1 / dt : 0);
    const bool damped = material_->damping.any();
    if (!moved && damped)
        dampAtRest(block, table, begin, dt);
    if (breaks(block))
        breakExcess(block, begin);
    scatter(block, table, begin);
    if (damped)
        countPower(block, table, begin, moved ? dt : 0);
}

void BondStep::gather(BondBlock& block, const BondTable& table, std::size_t begin) const
{
    const double* x = spheres_->position;
    const int *at1 = &table.at1[begin], *at2 = &table.at2[begin];
    for (int b = 0; b < block.count; ++b) {
        const double *x1 = x + 3 * at1[b], *x2 = x + 3 * at2[b];
        const Vec3 &turn1 = turns_[at1[b]], &turn2 = turns_[at2[b]];
        for (int axis = 0; axis < 3; ++axis) {
            block.separation[axis][b] = x2[axis] - x1[axis];
            block.turn1[axis][b] = turn1[axis];
            block.turn2[axis][b] = turn2[axis];
        }
    }
}

void BondStep::dampAtRest(BondBlock& block, const BondTable& table, std::size_t begin, double dt) const
{
    for (int b = 0; b < block.count; ++b) {
        const std::size_t k = begin + b;
        const int i = table.at1[k], j = table.at2[k];
        const BondShape shape = table.shapeOf(k);
        const BondStiffness stiffness = stiffnessOf(*material_, shape.restLength, shape.radius);
        BondState before = table.stateOf(k);
        const Vec3 d = before.separation;
        before.separation -= dt * (row(spheres_->velocity, j) - row(spheres_->velocity, i));
        const BondIncrement motion =
            frazil::advance(before, stiffness, shape.share, d, cayleyVector(row(spheres_->spin, i), dt),
                            cayleyVector(row(spheres_->spin, j), dt));
        const BondDashpots dashpots =
            dashpotsOf(stiffness, material_->damping, table.reducedMass[k], table.reducedInertia[k]);
        const BondLoad load = viscousLoad(motion, dashpots, d / norm(d), 1 / dt);
        const Vec3 lever = cross(d, load.force);
        for (int axis = 0; axis < 3; ++axis) {
            block.force[axis][b] += load.force[axis];
            block.torque1[axis][b] += shape.share * lever[axis] + load.moment[axis];
            block.torque2[axis][b] += (1 - shape.share) * lever[axis] - load.moment[axis];
        }
    }
}

void BondStep::breakExcess(BondBlock& block, std::size_t begin)
{
    for (int b = 0; b < block.count; ++b) {
        if (!(block.useTension[b] > 1 || block.useShear[b] > 1))
            continue;
        broken_.push_back({begin + b, {block.useTension[b], block.useShear[b]}});
        for (int axis = 0; axis < 3; ++axis)
            block.force[axis][b] = block.torque1[axis][b] = block.torque2[axis][b] = 0;
        block.power[b] = 0;
    }
}

void BondStep::scatter(const BondBlock& block, const BondTable& table, std::size_t begin) const
{
    double *force = spheres_->force, *torque = spheres_->torque;
    const int *target1 = &table.target1[begin], *target2 = &table.target2[begin];
    for (int b = 0; b < block.count; ++b) {
        const int i = 3 * target1[b], j = 3 * target2[b];
        for (int axis = 0; axis < 3; ++axis) {
            force[i + axis] += block.force[axis][b];
            force[j + axis] -= block.force[axis][b];
            torque[i + axis] += block.torque1[axis][b];
            torque[j + axis] += block.torque2[axis][b];
        }
    }
}

void BondStep::countPower(const BondBlock& block, const BondTable& table, std::size_t begin, double dt)
{
    const int *target1 = &table.target1[begin], *target2 = &table.target2[begin], owned = spheres_->owned;
    for (int b = 0; b < block.count; ++b)
        damped += dt * block.power[b] * 0.5 * ((target1[b] < owned) + (target2[b] < owned));
}

} // namespace frazil
