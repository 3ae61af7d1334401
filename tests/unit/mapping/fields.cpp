/// Restriction and prolongation on a fine mesh that straddles the coarse cells.
#include <gtest/gtest.h>

#include <limits>

#include "Prolongation.h"
#include "Restriction.h"

using namespace frazil;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

/// 4 x 3 x 3 coarse cells of 1 m under 11 x 7 x 10 fine boxes that do not line up, some larger than a coarse cell.
struct Case {
    CoarseGrid grid{Box{{0, 0, 0}, {4, 3, 3}}, 1, 1, {0, 0, -9.81}};
    LocalCells cells{grid, 0};
    FineParts parts;
    std::vector<double> volume, epsilon, open, density, wet;
    std::vector<Vec3> centre, velocity, gradient, zero;

    Case()
    {
        std::vector<FinePiece> pieces;
        const int n[3] = {11, 7, 10};
        for (int f = 0; f < n[0] * n[1] * n[2]; ++f)
            addCell(f, n, pieces);
        parts = FineParts(pieces, cells);
        zero.resize(volume.size());
    }
    void addCell(int f, const int* n, std::vector<FinePiece>& pieces)
    {
        const int i[3] = {f % n[0], f / n[0] % n[1], f / n[0] / n[1]};
        Box box;
        for (int a = 0; a < 3; ++a) {
            box.min[a] = grid.box().max[a] * std::pow(double(i[a]) / n[a], 1.3); // graded
            box.max[a] = grid.box().max[a] * std::pow(double(i[a] + 1) / n[a], 1.3);
        }
        clipBox(box, grid, [&](std::int64_t cell, double v, const Vec3& c) { pieces.push_back({f, cell, v, c}); });
        const Vec3 size = box.size();
        volume.push_back(size.x * size.y * size.z);
        centre.push_back(0.5 * (box.min + box.max));
        open.push_back(f % 17 ? 1 : 0.3);
        epsilon.push_back(open.back() * (0.5 + 0.4 * std::sin(f)));
        wet.push_back(centre.back().z < 1.4 ? 1 : 0);
        density.push_back(wet.back() ? 1000 : 1.2);
        velocity.push_back({centre.back().x, 2, -centre.back().y});
        gradient.push_back({0, 0, -9.81 * density.back()});
    }
    FineFlow flow() const
    {
        return {volume.size(),   volume.data(),   epsilon.data(), open.data(), density.data(), wet.data(),
                velocity.data(), gradient.data(), zero.data(),    zero.data(), zero.data()};
    }
    CoarseField<CoarseFluid> restricted() const
    {
        CoarseField<CoarseFluid> fluid;
        restrictSums(parts, flow(), {0, 0, -9.81}, cells, fluid);
        for (int c = 0; c < cells.count(); ++c)
            finishAverages(fluid[c], grid.cellVolume());
        return fluid;
    }
};

/// The slow, obvious reference: equation 2.23 as printed, from all cells around the node.
double referenceAt(const Case& c, const CoarseField<double>& value, int cell, const Vec3& x, double exponent)
{
    const CellIndex i = c.grid.index(c.cells.global(cell));
    double sum = 0, weights = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int node[3] = {i[0] + (corner & 1), i[1] + (corner >> 1 & 1), i[2] + (corner >> 2)};
        double nodeSum = 0;
        int around = 0;
        for (int k = 0; k < c.cells.count(); ++k) {
            const CellIndex j = c.grid.index(c.cells.global(k));
            bool shares = true;
            for (int a = 0; a < 3; ++a)
                shares = shares && (j[a] == node[a] || j[a] == node[a] - 1);
            if (shares) {
                nodeSum += value[k];
                ++around;
            }
        }
        const double w = std::pow(norm(x - Vec3{double(node[0]), double(node[1]), double(node[2])}), -exponent);
        sum += w * nodeSum / around;
        weights += w;
    }
    return sum / weights;
}

} // namespace

TEST(Restriction, VolumesAddUp)
{
    const Case c;
    const auto fluid = c.restricted();
    double open = 0, mass = 0, openFine = 0, massFine = 0;
    for (int k = 0; k < c.cells.count(); ++k) {
        open += fluid[k].openVolume;
        mass += fluid[k].fluidMass;
    }
    for (std::size_t f = 0; f < c.volume.size(); ++f) {
        openFine += c.open[f] * c.volume[f];
        massFine += c.density[f] * c.epsilon[f] * c.volume[f];
    }
    EXPECT_NEAR(open, openFine, 1e-13 * openFine);
    EXPECT_NEAR(mass, massFine, 1e-13 * massFine);
}

TEST(Restriction, MeansAreOverTheFluid)
{
    const Case c;
    const auto fluid = c.restricted();
    for (int k = 0; k < c.cells.count(); ++k) {
        EXPECT_NEAR(fluid[k].density(), 1000 * fluid[k].wetFraction() + 1.2 * (1 - fluid[k].wetFraction()), 1e-10);
        EXPECT_NEAR(fluid[k].velocity().y, 2, 1e-14);
        EXPECT_NEAR(fluid[k].pressureGradient.z, 0, 1e-13 * 9810) << "at rest";
    }
}

TEST(Restriction, LinearFieldGivesItsValueAtTheFluidsCentroid)
{
    // One coarse cell, two fine boxes of thickness 0.25 and 0.75 with ε = 1 and 0.5: u = x at the boxes' centres.
    // (0.125·0.25 + 0.625·0.375)/(0.25 + 0.375) = 0.425
    const CoarseGrid grid(Box{{0, 0, 0}, {1, 1, 1}}, 1, 1, {});
    const LocalCells cells(grid, 0);
    const FineParts parts({{0, 0, 0.25, {0.125, 0.5, 0.5}}, {1, 0, 0.75, {0.625, 0.5, 0.5}}}, cells);
    const double volume[] = {0.25, 0.75}, epsilon[] = {1, 0.5}, density[] = {1, 1}, wet[] = {1, 1};
    const Vec3 velocity[] = {{0.125, 0, 0}, {0.625, 0, 0}}, zero[2] = {};
    CoarseField<CoarseFluid> fluid;
    restrictSums(parts, {2, volume, epsilon, nullptr, density, wet, velocity, zero, zero, zero, zero}, {}, cells,
                 fluid);
    finishAverages(fluid[0], 1);
    EXPECT_DOUBLE_EQ(fluid[0].water.velocity.x, 0.425);
    EXPECT_DOUBLE_EQ(fluid[0].openVolume, 1);
    EXPECT_DOUBLE_EQ(fluid[0].fluidVolume, 0.625);
}

TEST(Restriction, AccelerationWhereTheFluidSetsItAlone)
{
    const CoarseGrid grid(Box{{0, 0, 0}, {1, 1, 1}}, 1, 1, {});
    const LocalCells cells(grid, 0);
    const FineParts parts({{0, 0, 0.25, {0.125, 0.5, 0.5}}, {1, 0, 0.75, {0.625, 0.5, 0.5}}}, cells);
    const double volume[] = {0.25, 0.75}, epsilon[] = {1, 0.5}, density[] = {1, 1}, wet[] = {1, 1}, share[] = {1, 0};
    const Vec3 acceleration[] = {{3, 0, 0}, {1e6, 0, 0}}, zero[2] = {};
    CoarseField<CoarseFluid> fluid;
    restrictSums(parts, {2, volume, epsilon, nullptr, density, wet, zero, zero, zero, acceleration, zero, share}, {},
                 cells, fluid);
    finishAverages(fluid[0], 1);
    EXPECT_DOUBLE_EQ(fluid[0].water.acceleration.x, 3);
    EXPECT_DOUBLE_EQ(fluid[0].water.accelerated, 0.25 / 0.625);
}

/// A wind over still water in one coarse cell: neither moves the other's mean.
TEST(Restriction, EachFluidHasItsOwnMean)
{
    const CoarseGrid grid(Box{{0, 0, 0}, {1, 1, 1}}, 1, 1, {});
    const LocalCells cells(grid, 0);
    const FineParts parts({{0, 0, 0.25, {0.5, 0.5, 0.125}}, {1, 0, 0.75, {0.5, 0.5, 0.625}}}, cells);
    const double volume[] = {0.25, 0.75}, epsilon[] = {1, 0.5}, density[] = {1000, 101}, wet[] = {1, 0.1};
    const Vec3 velocity[] = {{0, 0, 0}, {20, 0, 0}}, zero[2] = {};
    CoarseField<CoarseFluid> fluid;
    restrictSums(parts, {2, volume, epsilon, nullptr, density, wet, velocity, zero, zero, zero, zero}, {}, cells,
                 fluid);
    finishAverages(fluid[0], 1);
    EXPECT_DOUBLE_EQ(fluid[0].water.volume, 0.25 + 0.1 * 0.375);
    EXPECT_DOUBLE_EQ(fluid[0].water.velocity.x, 20 * 0.0375 / 0.2875);
    EXPECT_DOUBLE_EQ(fluid[0].air.velocity.x, 20);
}

/// Water at rest below, pushed along x, air above: what the fine cells carry for their solid, beside the weight.
TEST(Restriction, LoadOfTheSolidIsWhatTheFineCellsCarry)
{
    const CoarseGrid grid(Box{{0, 0, 0}, {1, 1, 1}}, 1, 1, {});
    const LocalCells cells(grid, 0);
    const FineParts parts({{0, 0, 0.5, {0.5, 0.5, 0.25}}, {1, 0, 0.5, {0.5, 0.5, 0.75}}}, cells);
    const double volume[] = {0.5, 0.5}, epsilon[] = {0.9, 0.9}, density[] = {1000, 1}, wet[] = {1, 0};
    const double solid[] = {0.06, 0.04};
    const Vec3 gradient[] = {{3, 0, -10000}, {0, 0, -10}}, viscous[] = {{0, 7, 0}, {0, 0, 0}}, zero[2] = {};
    CoarseField<SolidLoad> load;
    const FineFlow flow{2, volume, epsilon, nullptr, density, wet, zero, gradient, viscous, zero, zero};
    restrictLoad(parts, flow, {true, true, {0, 0, -10}}, solid, cells, load);
    EXPECT_DOUBLE_EQ(load[0].carried.x, -0.18);
    EXPECT_DOUBLE_EQ(load[0].carried.y, 0.42);
    EXPECT_DOUBLE_EQ(load[0].carried.z, 0);
    EXPECT_DOUBLE_EQ(load[0].displaced, 60.04);
}

TEST(Prolongation, CornerWeights)
{
    const Box cell{{0, 0, 0}, {1, 1, 1}};
    for (const double w : cornerWeights({0.5, 0.5, 0.5}, cell, 2))
        EXPECT_DOUBLE_EQ(w, 0.125);
    const auto onNode = cornerWeights({1, 0, 1}, cell, 2);
    for (int n = 0; n < 8; ++n)
        EXPECT_EQ(onNode[n], n == 5 ? 1 : 0);
    double sum = 0;
    for (const double w : cornerWeights({0.1, 0.7, 0.35}, cell, 3.5))
        sum += w;
    EXPECT_NEAR(sum, 1, 1e-15);
}

class ProlongationOf : public ::testing::TestWithParam<bool>
{
  protected:
    Case c;
    CoarseField<double> value{c.cells}, weight{c.cells}, moment;
    std::vector<double> fine = std::vector<double>(c.volume.size());

    void fill(double (*f)(int))
    {
        const auto fluid = c.restricted();
        for (int k = 0; k < c.cells.count(); ++k) {
            weight[k] = fluid[k].openVolume;
            value[k] = f(k);
        }
    }
    void run(double lowest, double highest)
    {
        Prolongation<double> prolongation({2, GetParam()});
        prolongation.shape(c.parts, c.cells, value, weight, c.open.data(), moment);
        std::vector<double> amount;
        prolongation.spread(c.parts, value, weight, c.open.data(), moment, lowest, highest, amount);
        addToCells(c.parts, amount, fine.data());
    }
};

TEST_P(ProlongationOf, SolidIsConservedAndBounded)
{
    fill([](int k) { return k % 4 == 0 ? 0 : k % 4 == 1 ? 0.8 : 0.4 + 0.3 * std::sin(k); });
    run(0, 0.8);
    double coarse = 0, sum = 0;
    for (int k = 0; k < c.cells.count(); ++k)
        coarse += value[k] * weight[k];
    for (std::size_t f = 0; f < fine.size(); ++f) {
        sum += fine[f];
        const double alpha = fine[f] / (c.open[f] * c.volume[f]);
        EXPECT_GE(alpha, -1e-15);
        EXPECT_LE(alpha, 0.8 + 1e-14);
    }
    EXPECT_NEAR(sum, coarse, 1e-14 * coarse);
}

TEST_P(ProlongationOf, EveryCoarseCellKeepsItsOwn)
{
    // Only one coarse cell holds solid: its parts get all of it, and fine cells without a part there get none.
    fill([](int k) { return k == 17 ? 0.5 : 0.0; });
    run(0, 0.8);
    std::vector<bool> touches(fine.size(), false);
    for (int row = 0; row < c.parts.rows(); ++row) {
        for (const FinePart* part = c.parts.begin(row); part != c.parts.end(row); ++part) {
            if (c.parts.coarseCell(row) == 17)
                touches[part->fineCell] = true;
        }
    }
    double sum = 0;
    for (std::size_t f = 0; f < fine.size(); ++f) {
        sum += fine[f];
        EXPECT_EQ(fine[f] > 0, touches[f]);
    }
    EXPECT_NEAR(sum, 0.5 * weight[17], 1e-15);
}

TEST_P(ProlongationOf, UniformStaysUniform)
{
    fill([](int) { return 0.3; });
    run(0, 0.8);
    for (std::size_t f = 0; f < fine.size(); ++f)
        EXPECT_NEAR(fine[f] / (c.open[f] * c.volume[f]), 0.3, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutLimiter, ProlongationOf, ::testing::Bool());

TEST(Prolongation, UnlimitedShapeIsThatOfThePrintedEquations)
{
    // φ_p - φ_q of two parts of a coarse cell equals r_p - r_q of the reference.
    Case c;
    CoarseField<double> value(c.cells), weight(c.cells, 1.0), moment;
    for (int k = 0; k < c.cells.count(); ++k)
        value[k] = std::cos(k);
    for (auto& open : c.open)
        open = 1;
    Prolongation<double> prolongation({2, false});
    prolongation.shape(c.parts, c.cells, value, weight, c.open.data(), moment);
    for (int row = 0; row < c.parts.rows(); ++row) {
        const int cell = c.parts.coarseCell(row);
        double expected = 0;
        for (const FinePart* part = c.parts.begin(row); part != c.parts.end(row); ++part) {
            expected += part->volume * referenceAt(c, value, cell, part->centroid, 2);
        }
        EXPECT_NEAR(moment[cell], expected, 1e-13);
    }
}

TEST(Prolongation, ForceGoesWithTheMassAndIsConserved)
{
    const Case c;
    const auto fluid = c.restricted();
    CoarseField<Vec3> acceleration(c.cells), moment;
    CoarseField<double> mass(c.cells);
    Vec3 total;
    for (int k = 0; k < c.cells.count(); ++k) {
        mass[k] = fluid[k].fluidMass;
        const Vec3 force{std::sin(k), 100, -std::cos(3 * k)};
        acceleration[k] = force / mass[k];
        total += force;
    }
    std::vector<double> density(c.volume.size());
    for (std::size_t f = 0; f < density.size(); ++f)
        density[f] = c.density[f] * c.epsilon[f];
    std::vector<Vec3> force(c.volume.size());
    Prolongation<Vec3> prolongation({2, true});
    prolongation.shape(c.parts, c.cells, acceleration, mass, density.data(), moment);
    std::vector<Vec3> amount;
    prolongation.spread(c.parts, acceleration, mass, density.data(), moment, -infinity, infinity, amount);
    addToCells(c.parts, amount, force.data());
    Vec3 sum;
    double fastest = 0, fastestCoarse = 0;
    for (std::size_t f = 0; f < force.size(); ++f) {
        sum += force[f];
        fastest = std::max(fastest, std::abs(force[f].y) / (density[f] * c.volume[f]));
    }
    for (int k = 0; k < c.cells.count(); ++k)
        fastestCoarse = std::max(fastestCoarse, acceleration[k].y);
    for (int a = 0; a < 3; ++a)
        EXPECT_NEAR(sum[a], total[a], 1e-14 * norm(total));
    EXPECT_LE(fastest, fastestCoarse * (1 + 1e-12)) << "no fine cell is pushed harder than the coarse cells around";
}
