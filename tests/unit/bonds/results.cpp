/// What bonds tell about themselves, on numbers small enough to check by hand.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "bond_results.h"

using namespace frazil;

namespace
{

/// One bond along x between the spheres 3 and 8: 2 mm long, disc of 1 mm, stretched by 1e-6 m.
struct OneBond {
    BondTable table;
    BondMaterial material;
    double stretch = 1e-6;

    OneBond()
    {
        material.young = 2e9;
        material.tensileStrength = material.shearStrength = 1e6;
        table.add();
        table.id1[0] = 3, table.id2[0] = 8;
        table.target1[0] = 0, table.target2[0] = 1;
        table.restLength[0] = 0.002, table.radius[0] = 0.001, table.share[0] = 0.25, table.strength[0] = 1;
        table.state[BondTable::separation][0] = 0.002 + stretch;
    }

    double force() const { return 1e12 * M_PI * 1e-6 * stretch; } // kn A Δ, kn = E/L
};

} // namespace

TEST(BondResults, EnergyAndUseOfAStretchedBond)
{
    const OneBond one;
    const BondTotals totals = totalsOf(one.table, one.material, 2);
    EXPECT_NEAR(totals.elasticEnergy, 0.5 * one.force() * one.stretch, 1e-9 * one.force() * one.stretch);
    EXPECT_NEAR(totals.useTension, 1, 1e-9); // 1e12 Pa/m over 1e-6 m: the strength of 1 MPa
    EXPECT_EQ(totals.useShear, 0);
    EXPECT_EQ(totalsOf(one.table, one.material, 0).elasticEnergy, 0); // another rank owns sphere 3
}

TEST(BondResults, TheVirialIsSharedAsTheBondCentreLies)
{
    const OneBond one;
    double rows[2][8] = {};
    double* pointers[2] = {rows[0], rows[1]};
    addBondVirial(one.table, one.material, 2, pointers, 2);
    const double whole = one.force() * (0.002 + one.stretch);
    EXPECT_NEAR(rows[0][2], 0.25 * whole, 1e-9 * whole);
    EXPECT_NEAR(rows[1][2], 0.75 * whole, 1e-9 * whole);
    for (int c : {0, 1, 3, 4, 5, 6, 7})
        EXPECT_EQ(rows[0][c], 0) << "column " << c;
}

TEST(BondResults, TheVirialIsTheSymmetricPart)
{
    const SymmetricTensor v = virialOf({1, 2, 3}, {4, 5, 6});
    EXPECT_EQ(v, (SymmetricTensor{4, 10, 18, 6.5, 9, 13.5}));
}

TEST(BondResults, EventsAreSortedAndAppended)
{
    const OneBond one;
    const std::string path = testing::TempDir() + "bond_events.csv";
    BondEvent late = eventOf(one.table, 0, one.material, false, 2, {1, 0, 0}), early = late;
    early.time = 1, early.shear = 1;
    std::vector<BondEvent> events = {late, early}, more = {late};
    ASSERT_TRUE(writeEvents(path, false, events));
    ASSERT_TRUE(writeEvents(path, true, more));
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    const std::string last = "2,3,8,tension,1.00050025,0,0,1000000,0"; // a quarter of the way from sphere 3
    EXPECT_EQ(lines, (std::vector<std::string>{"time,id1,id2,mode,x,y,z,sigma,tau",
                                               "1,3,8,shear,1.00050025,0,0,1000000,0", last, last}));
    std::remove(path.c_str());
    EXPECT_FALSE(writeEvents(testing::TempDir() + "nowhere/events.csv", false, events));
}
