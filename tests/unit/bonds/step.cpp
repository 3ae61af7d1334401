/// The step of all bonds against the law bond by bond, and what must hold whatever the law: action and reaction.
#include <gtest/gtest.h>

#include "Cluster.h"

using namespace frazil;

namespace
{

const double dt = 1e-6;

BondOptions damped()
{
    Settings words = bondWords();
    words.set("damping", "0.1 0.2 0.3 0.4");
    return BondOptions(words);
}

/// Slow reference: each bond alone, with the scalar functions of the law.
void addReference(const Cluster& before, const Cluster& now, const BondMaterial& m, std::vector<Vec3>& force,
                  std::vector<Vec3>& torque)
{
    const BondTable& table = before.table;
    for (std::size_t k = 0; k < table.size(); ++k) {
        const int i = table.at1[k], j = table.at2[k];
        const BondShape shape = table.shapeOf(k);
        const BondStiffness stiffness = stiffnessOf(m, shape.restLength, shape.radius);
        BondState state = table.stateOf(k);
        const Vec3 d = now.position[j] - now.position[i];
        const BondIncrement motion =
            advance(state, stiffness, shape.share, d, cayleyVector(now.spin[i], dt), cayleyVector(now.spin[j], dt));
        BondLoad load = elasticLoad(state, stiffness, shape.restLength);
        const BondLoad viscous =
            viscousLoad(motion, dashpotsOf(stiffness, m.damping, table.reducedMass[k], table.reducedInertia[k]),
                        d / norm(d), 1 / dt);
        load.force += viscous.force;
        load.moment += viscous.moment;
        force[i] += load.force;
        force[j] -= load.force;
        torque[i] += shape.share * cross(d, load.force) + load.moment;
        torque[j] += (1 - shape.share) * cross(d, load.force) - load.moment;
    }
}

double largest(const std::vector<Vec3>& list)
{
    double size = 0;
    for (const Vec3& v : list)
        size = std::max(size, norm(v));
    return size;
}

} // namespace

TEST(BondStep, EqualsTheLawBondByBond)
{
    const BondOptions options = damped();
    Cluster cluster(options);
    ASSERT_GT(cluster.table.size(), std::size_t(2 * BondBlock::capacity));
    const Cluster before = cluster;
    cluster.move(dt);
    BondStep step;
    step.advance(cluster.table, options.material, cluster.spheres(), dt, true);
    std::vector<Vec3> force(Cluster::count), torque(Cluster::count);
    addReference(before, cluster, options.material, force, torque);
    for (int i = 0; i < Cluster::count; ++i) {
        EXPECT_LE(norm(cluster.force[i] - force[i]), 1e-12 * largest(force)) << "sphere " << i;
        EXPECT_LE(norm(cluster.torque[i] - torque[i]), 1e-12 * largest(torque)) << "sphere " << i;
    }
}

TEST(BondStep, ForcesAndMomentsOfTheWholeVanish)
{
    const BondOptions options = damped();
    Cluster cluster(options);
    BondStep step;
    for (int n = 0; n < 10; ++n) {
        cluster.move(dt);
        step.advance(cluster.table, options.material, cluster.spheres(), dt, true);
    }
    Vec3 force, moment;
    for (int i = 0; i < Cluster::count; ++i) {
        force += cluster.force[i];
        moment += cluster.torque[i] + cross(cluster.position[i], cluster.force[i]);
    }
    EXPECT_LE(norm(force), 1e-12 * largest(cluster.force));
    EXPECT_LE(norm(moment), 1e-11 * largest(cluster.torque));
    EXPECT_GT(step.damped, 0);
}

TEST(BondStep, WhatBreaksGivesNoLoadAndLeavesTheTable)
{
    Settings words = bondWords();
    words.set("tensile_strength", "1e5");
    const BondOptions options(words);
    Cluster cluster(options);
    const std::size_t bonds = cluster.table.size();
    for (Vec3& spin : cluster.spin)
        spin = Vec3();
    for (Vec3& velocity : cluster.velocity)
        velocity = Vec3();
    cluster.velocity.back() = {10, 0, 0}; // the last sphere tears off: its four bonds break, those before it stay
    cluster.move(dt);
    BondStep step;
    step.advance(cluster.table, options.material, cluster.spheres(), dt, true);
    ASSERT_EQ(step.broken().size(), 4u);
    for (const BrokenBond& bond : step.broken()) {
        EXPECT_EQ(cluster.table.id2[bond.row], Cluster::count);
        EXPECT_GT(bond.use.tension, 1);
    }
    EXPECT_EQ(largest(cluster.force), 0);
    step.removeBroken(cluster.table);
    EXPECT_EQ(cluster.table.size(), bonds - 4);
    for (std::size_t k = 0; k < cluster.table.size(); ++k)
        EXPECT_LT(cluster.table.id2[k], Cluster::count);
}

TEST(BondStep, ASetUpDampsAsTheStepThatEndsThere)
{
    const BondOptions options = damped();
    Cluster moving(options);
    moving.move(dt);
    BondStep step;
    step.advance(moving.table, options.material, moving.spheres(), dt, true);
    const std::vector<Vec3> force = moving.force, torque = moving.torque;
    const double taken = step.damped;
    step.advance(moving.table, options.material, moving.spheres(), dt, false);
    for (int i = 0; i < Cluster::count; ++i) {
        EXPECT_LE(norm(moving.force[i] - force[i]), 1e-9 * largest(force)) << "sphere " << i;
        EXPECT_LE(norm(moving.torque[i] - torque[i]), 1e-9 * largest(torque)) << "sphere " << i;
    }
    EXPECT_EQ(step.damped, taken); // no time has passed
}

TEST(BondStep, AGhostsHalfOfTheDampedEnergyIsItsOwners)
{
    const BondOptions options = damped();
    Cluster whole(options), part(options);
    whole.move(dt);
    part.move(dt);
    BondStep all, some;
    all.advance(whole.table, options.material, whole.spheres(), dt, true);
    BondSpheres spheres = part.spheres();
    spheres.owned = 0;
    some.advance(part.table, options.material, spheres, dt, true);
    EXPECT_GT(all.damped, 0);
    EXPECT_EQ(some.damped, 0);
}
