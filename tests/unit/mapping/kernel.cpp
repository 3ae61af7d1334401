/// Kernels: of every one, the weights sum to one and spread and gather are adjoint; trilinear: linear fields come out
/// exact; centre: all of it goes into one cell.
#include <gtest/gtest.h>

#include <random>

#include "Kernel.h"

using namespace frazil;

namespace
{

const CoarseGrid grid(Box{{0, 0, 0}, {5, 4, 3}}, 1, 1, {0, 0, -9.81});
const LocalCells cells(grid, 0);

std::vector<Vec3> somePoints(int count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(0, 1);
    std::vector<Vec3> points;
    for (int n = 0; n < count; ++n)
        points.push_back({5 * u(random), 4 * u(random), 3 * u(random)});
    return points;
}

Stencil stencilOf(const Vec3& p)
{
    return Trilinear{}(cells, p);
}

template <class Variant> struct TypesOf;
template <class... Items> struct TypesOf<std::variant<Items...>> {
    using type = testing::Types<Items...>;
};

template <class K> class EveryKernel : public testing::Test
{
};
TYPED_TEST_SUITE(EveryKernel, TypesOf<Kernel>::type);

} // namespace

TYPED_TEST(EveryKernel, WeightsSumToOneAlsoAtTheEdge)
{
    auto points = somePoints(1000);
    points.insert(points.end(), {{0, 0, 0}, {5, 4, 3}, {0, 4, 1.5}});
    for (const Vec3& p : points) {
        const Stencil stencil = TypeParam{}(cells, p);
        double sum = 0;
        ASSERT_LE(stencil.count, Stencil::capacity);
        for (int n = 0; n < stencil.count; ++n) {
            ASSERT_GE(stencil.cell[n], 0);
            EXPECT_GE(stencil.weight[n], 0);
            sum += stencil.weight[n];
        }
        EXPECT_NEAR(sum, 1, 1e-15);
    }
}

TEST(Trilinear, QuarterWay)
{
    // p = (1.75, 1.5, 1.5): a quarter of the way from centre (1.5 ..) to centre (2.5 ..) along x only.
    CoarseField<double> mark(cells);
    mark[cells.local(grid.id({2, 1, 1}))] = 1;
    EXPECT_DOUBLE_EQ(gather(stencilOf({1.75, 1.5, 1.5}), mark), 0.25);
}

TEST(Trilinear, LinearFieldIsExactInside)
{
    CoarseField<double> field(cells);
    const auto linear = [](const Vec3& x) { return 2 + 3 * x.x - x.y + 0.5 * x.z; };
    for (int c = 0; c < cells.count(); ++c)
        field[c] = linear(grid.centre(cells.global(c)));
    for (const Vec3& p : somePoints(1000)) {
        const bool inside = p.x > 0.5 && p.x < 4.5 && p.y > 0.5 && p.y < 3.5 && p.z > 0.5 && p.z < 2.5;
        if (inside) {
            EXPECT_NEAR(gather(stencilOf(p), field), linear(p), 1e-14);
        }
    }
}

TYPED_TEST(EveryKernel, SpreadAndGatherAreAdjoint)
{
    CoarseField<double> phi(cells), sum(cells), importance(cells, 1.0);
    for (int c = 0; c < cells.count(); ++c) {
        phi[c] = std::sin(1.0 + c);
        importance[c] = c % 3 == 0 ? 0 : 1 + 0.1 * c;
    }
    double gathered = 0, spreadAndWeighed = 0, q = 1;
    for (const Vec3& p : somePoints(200)) {
        Stencil stencil = TypeParam{}(cells, p);
        reweigh(stencil, importance);
        q = -1.1 * q + 0.3;
        q = std::fmod(q, 2.0);
        spread(stencil, q, sum);
        gathered += q * gather(stencil, phi);
    }
    for (int c = 0; c < cells.count(); ++c)
        spreadAndWeighed += phi[c] * sum[c];
    EXPECT_NEAR(gathered, spreadAndWeighed, 1e-12);
}

TEST(Trilinear, ReweighLeavesOutWhatCannotHold)
{
    CoarseField<double> importance(cells);
    const int only = cells.local(grid.id({2, 1, 1}));
    importance[only] = 1e-3;
    Stencil stencil = stencilOf({2.1, 1.2, 1.3});
    ASSERT_TRUE(reweigh(stencil, importance));
    for (int n = 0; n < stencil.count; ++n)
        EXPECT_EQ(stencil.weight[n], stencil.cell[n] == only ? 1 : 0);

    Stencil far = stencilOf({0.2, 0.2, 0.2});
    const Stencil before = far;
    EXPECT_FALSE(reweigh(far, importance));
    for (int n = 0; n < far.count; ++n)
        EXPECT_EQ(far.weight[n], before.weight[n]);
}

TEST(CentreCell, AllInTheCellThatHoldsTheCentre)
{
    CoarseField<double> solid(cells);
    spread(CentreCell{}(cells, {2.9, 1.1, 0.5}), 3.0, solid);
    for (int c = 0; c < cells.count(); ++c)
        EXPECT_EQ(solid[c], c == cells.local(grid.id({2, 1, 0})) ? 3 : 0);
}
