/* The parallel bond's law on numbers small enough to check by hand, and its objectivity in rigid rotations. */

#include "bond_table.h"
#include "parallel_bond.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace frazil;

namespace
{

BondMaterial material()
{
    BondMaterial m;
    m.young = 2e9;
    m.stiffnessRatio = 2;
    m.tensileStrength = 1e6;
    m.shearStrength = 1e6;
    return m;
}

const BondShape shape{0.002, 0.001, 0.5, 1};

BondStiffness stiffness()
{
    return stiffnessOf(material(), shape.restLength, shape.radius);
}

BondState atRest(const Vec3& direction)
{
    return {direction * shape.restLength, {}, {}, 0};
}

/// Rodrigues' rotation of v about the unit axis by an angle.
Vec3 rotated(const Vec3& v, const Vec3& axis, double angle)
{
    return v * std::cos(angle) + cross(axis, v) * std::sin(angle) + axis * (dot(axis, v) * (1 - std::cos(angle)));
}

void expectNear(const Vec3& a, const Vec3& b, double tolerance)
{
    EXPECT_LE(norm(a - b), tolerance);
}

} // namespace

TEST(ParallelBond, StiffnessesByHand)
{
    const BondStiffness k = stiffness();
    const double area = M_PI * 1e-6; // kn = 1e12 Pa/m, ks = 5e11 Pa/m
    EXPECT_DOUBLE_EQ(k.area, area);
    EXPECT_DOUBLE_EQ(k.normal, 1e12 * area);
    EXPECT_DOUBLE_EQ(k.shear, 5e11 * area);
    EXPECT_DOUBLE_EQ(k.bending, 1e12 * area * 1e-6 / 4);
    EXPECT_DOUBLE_EQ(k.torsion, 5e11 * area * 1e-6 / 2);
}

TEST(ParallelBond, CayleyVectorIsTwiceTheTangentOfHalfTheAngle)
{
    const Vec3 axis{0.6, 0, 0.8};
    expectNear(cayleyVector(axis * 30, 0.01), axis * (2 * std::tan(0.15)), 1e-9);
    expectNear(cayleyVector({}, 0.01), {}, 0);
}

TEST(ParallelBond, PullGivesTensionOnBoth)
{
    BondState state = atRest({1, 0, 0});
    advance(state, stiffness(), 0.5, {0.002 + 1e-7, 0, 0}, {}, {});
    const BondLoad load = elasticLoad(state, stiffness(), shape.restLength);
    EXPECT_NEAR(load.force.x, stiffness().normal * 1e-7, 1e-9 * stiffness().normal * 1e-7 + 1e-9);
    EXPECT_GT(stressOf(state, stiffness(), shape, 1).sigma, 0);
}

TEST(ParallelBond, RelativeRotationIsNotHalved)
{
    BondState state = atRest({0, 0, 1});
    advance(state, stiffness(), 0.5, {0, 0, 0.002}, {}, {0, 0, 1e-5});
    EXPECT_NEAR(state.torsion, stiffness().torsion * 1e-5, 1e-12 * stiffness().torsion);
    state = atRest({0, 0, 1});
    advance(state, stiffness(), 0.5, {0, 0, 0.002}, {-0.5e-5, 0, 0}, {0.5e-5, 0, 0});
    expectNear(state.bending, {stiffness().bending * 1e-5, 0, 0}, 1e-12 * stiffness().bending);
    expectNear(state.shear, {}, 1e-15 * stiffness().shear);
}

TEST(ParallelBond, LargeRigidRotationsOnlyTurnTheLoads)
{
    const Vec3 axes[] = {{1, 0, 0}, {0, 0, 1}, {0.6, 0, 0.8}, {2. / 3, -1. / 3, 2. / 3}};
    const Vec3 bond{0, 0.6, 0.8}, across{1, 0, 0};
    for (const Vec3& axis : axes) {
        BondState state = atRest(bond);
        state.shear = across * 3 + cross(bond, across) * 2;
        state.bending = cross(bond, across) * 0.5;
        state.torsion = 0.7;
        const double angle = 0.03; // per step [rad]
        const int steps = 2000;
        const BondState start = state;
        for (int n = 1; n <= steps; ++n) {
            const Vec3 turn = axis * (2 * std::tan(0.5 * angle));
            advance(state, stiffness(), 0.5, rotated(bond, axis, n * angle) * shape.restLength, turn, turn);
        }
        expectNear(state.shear, rotated(start.shear, axis, steps * angle), 1e-9);
        expectNear(state.bending, rotated(start.bending, axis, steps * angle), 1e-9);
        EXPECT_NEAR(state.torsion, 0.7, 1e-9);
    }
}

TEST(ParallelBond, CompressionIsNegativeStressAndRaisesShearStrength)
{
    BondState state = atRest({1, 0, 0});
    advance(state, stiffness(), 0.5, {0.002 - 1e-6, 0, 0}, {}, {}); // kn * 1e-6 m = 1 MPa
    EXPECT_NEAR(stressOf(state, stiffness(), shape, 1).sigma, -1e6, 1);
    state.shear = {0, 1e6 * stiffness().area, 0};
    BondMaterial m = material();
    EXPECT_NEAR(useOf(state, stiffness(), shape, m).shear, 1, 1e-9);
    m.frictionTan = 1;
    EXPECT_NEAR(useOf(state, stiffness(), shape, m).shear, 0.5, 1e-6);
}

TEST(ParallelBond, MomentsEnterTheStressesWithTheirFactor)
{
    BondState state = atRest({1, 0, 0});
    state.bending = {0, 1e-3, 0};
    state.torsion = -2e-3;
    const double r3 = M_PI * 1e-9; // M Rb/I = 4 M/(pi Rb^3), M Rb/J = 2 M/(pi Rb^3)
    EXPECT_NEAR(stressOf(state, stiffness(), shape, 0.5).sigma, 0.5 * 4e-3 / r3, 1e-3);
    EXPECT_NEAR(stressOf(state, stiffness(), shape, 0.5).tau, 0.5 * 4e-3 / r3, 1e-3);
}

TEST(ParallelBond, EnergyIsHalfForceTimesPath)
{
    BondState state = atRest({1, 0, 0});
    advance(state, stiffness(), 0.5, {0.002 + 2e-6, 0, 0}, {}, {});
    EXPECT_NEAR(elasticEnergy(state, stiffness(), shape.restLength), 0.5 * stiffness().normal * 4e-12, 1e-15);
}

TEST(ParallelBond, WeibullFactorsHaveMeanOneAndAreRepeatable)
{
    double sum = 0;
    const int count = 100000;
    for (int i = 1; i <= count; ++i)
        sum += weibullFactor(i, i + 7, 5, 42);
    EXPECT_NEAR(sum / count, 1, 3e-3); // standard deviation 0.23/sqrt(1e5)
    EXPECT_EQ(weibullFactor(3, 9, 5, 42), weibullFactor(3, 9, 5, 42));
    EXPECT_NE(weibullFactor(3, 9, 5, 42), weibullFactor(3, 9, 5, 43));
}

TEST(BondStore, HalvesReturnAsTheyLeft)
{
    BondTable table;
    for (int k = 0; k < 2; ++k) { // spheres 0 - 1 - 2 in a row, ids 10, 11, 12
        table.add();
        table.id1[k] = 10 + k;
        table.id2[k] = 11 + k;
        table.target1[k] = k;
        table.target2[k] = k + 1;
        table.restLength[k] = 0.1 * (k + 1);
        for (int c = 0; c < BondTable::stateColumns; ++c)
            table.state[c][k] = 100 * k + c;
    }
    BondStore store;
    store.owners.resize(4);
    store.fill(table, 2); // sphere 2 is a ghost
    EXPECT_EQ(store.owners[0].count, 1);
    EXPECT_EQ(store.owners[1].count, 2);
    double buffer[3 + 2 * BondHalf::words];
    EXPECT_EQ(store.pack(1, buffer), BondStore::words(2));
    EXPECT_EQ(store.unpack(3, buffer), BondStore::words(2));
    const BondHalf& half = store.pool[store.owners[3].first + 1];
    EXPECT_EQ(half.partner, 12);
    EXPECT_EQ(half.restLength, 0.2);
    EXPECT_EQ(half.state[9], 109);
}
