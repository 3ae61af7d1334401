/// Overlap: volumes and centroids of pieces against closed forms.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "FineParts.h"

using namespace frazil;

namespace
{

const CoarseGrid grid(Box{{0, 0, 0}, {4, 4, 4}}, 1, 1, {0, 0, -9.81});

struct Sum {
    double volume = 0;
    Vec3 moment;
};

struct Pieces {
    std::map<std::int64_t, Sum> byCell;
    PieceSink sink = [this](std::int64_t cell, double volume, const Vec3& centroid) {
        byCell[cell].volume += volume;
        byCell[cell].moment += volume * centroid;
    };
    Sum total() const
    {
        Sum all;
        for (const auto& entry : byCell) {
            all.volume += entry.second.volume;
            all.moment += entry.second.moment;
        }
        return all;
    }
};

void expectNear(const Vec3& a, const Vec3& b, double tolerance)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], tolerance);
}

} // namespace

TEST(Overlap, BoxSmallerThanACell)
{
    Pieces pieces;
    clipBox(Box{{1.25, 1.5, 1.5}, {1.75, 1.75, 2}}, grid, pieces.sink);
    ASSERT_EQ(pieces.byCell.size(), 1u);
    const Sum& sum = pieces.byCell.at(grid.id({1, 1, 1}));
    EXPECT_DOUBLE_EQ(sum.volume, 0.0625);
    expectNear(sum.moment / sum.volume, {1.5, 1.625, 1.75}, 1e-15);
}

TEST(Overlap, BoxAcrossCellsAndBeyondTheGrid)
{
    Pieces pieces;
    clipBox(Box{{-1, 0.5, 3.25}, {1.5, 1.5, 9}}, grid, pieces.sink);
    // Inside the grid: x 0-1.5, y 0.5-1.5, z 3.25-4: cells (0|1, 0|1, 3).
    ASSERT_EQ(pieces.byCell.size(), 4u);
    EXPECT_DOUBLE_EQ(pieces.byCell.at(grid.id({0, 0, 3})).volume, 1 * 0.5 * 0.75);
    EXPECT_DOUBLE_EQ(pieces.byCell.at(grid.id({1, 1, 3})).volume, 0.5 * 0.5 * 0.75);
    EXPECT_DOUBLE_EQ(pieces.total().volume, 1.5 * 1 * 0.75);
}

TEST(Overlap, CornerTetrahedronCutByOnePlane)
{
    // Legs of 2 from (0 0 0): V = 8/6. Beyond x = 1 lies the tip, legs of 1: V = 1/6 in all, of which all in x cell 1.
    Pieces pieces;
    clipTetrahedron({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, grid, pieces.sink);
    EXPECT_NEAR(pieces.byCell.at(grid.id({1, 0, 0})).volume, 1.0 / 6, 1e-15);
    // The unit cube at the corner: all of it but the part beyond x + y + z = 2, a corner of legs 1.
    EXPECT_NEAR(pieces.byCell.at(grid.id({0, 0, 0})).volume, 1 - 1.0 / 6, 1e-15);
    EXPECT_NEAR(pieces.total().volume, 8.0 / 6, 1e-15);
    expectNear(pieces.total().moment / pieces.total().volume, {0.5, 0.5, 0.5}, 1e-15);
}

TEST(Overlap, AnyTetrahedronAddsUpToTheWhole)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> u(0, 4);
    for (int n = 0; n < 300; ++n) {
        Vec3 corner[4];
        for (Vec3& c : corner)
            c = {u(random), u(random), n % 5 ? u(random) : std::floor(u(random))}; // also on planes
        const double whole =
            std::abs(dot(cross(corner[1] - corner[0], corner[2] - corner[0]), corner[3] - corner[0])) / 6;
        Pieces pieces;
        clipTetrahedron(corner, grid, pieces.sink);
        EXPECT_NEAR(pieces.total().volume, whole, 1e-13);
        if (whole > 0) {
            expectNear(pieces.total().moment, 0.25 * whole * (corner[0] + corner[1] + corner[2] + corner[3]), 1e-12);
        }
        for (const auto& entry : pieces.byCell) {
            const Box cell = grid.cellBox(grid.index(entry.first));
            EXPECT_LE(entry.second.volume, 1 + 1e-12);
            const Vec3 centroid = entry.second.moment / entry.second.volume;
            for (int a = 0; a < 3; ++a) {
                EXPECT_GE(centroid[a], cell.min[a] - 1e-9);
                EXPECT_LE(centroid[a], cell.max[a] + 1e-9);
            }
        }
    }
}

TEST(Overlap, TetrahedraOfABoxGiveTheBox)
{
    const Box box{{0.3, -0.4, 0.7}, {2.6, 1.3, 4.5}};
    const auto corner = [&](int n) {
        return Vec3{n & 1 ? box.max.x : box.min.x, n & 2 ? box.max.y : box.min.y, n & 4 ? box.max.z : box.min.z};
    };
    Pieces asBox, asTetrahedra;
    clipBox(box, grid, asBox.sink);
    const int kuhn[6][4] = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};
    for (const auto& t : kuhn) {
        clipTetrahedron({corner(t[0]), corner(t[1]), corner(t[2]), corner(t[3])}, grid, asTetrahedra.sink);
    }
    ASSERT_EQ(asBox.byCell.size(), asTetrahedra.byCell.size());
    for (const auto& entry : asBox.byCell) {
        EXPECT_NEAR(asTetrahedra.byCell.at(entry.first).volume, entry.second.volume, 1e-14);
        expectNear(asTetrahedra.byCell.at(entry.first).moment, entry.second.moment, 1e-13);
    }
}

TEST(FineParts, GroupsByCoarseCellAndMergesPieces)
{
    const LocalCells cells(grid, 0);
    const FineParts parts({{0, 5, 1, {1, 0, 0}}, {1, 4, 2, {0, 0, 0}}, {0, 5, 3, {5, 0, 0}}, {1, 5, 1, {0, 0, 0}}},
                          cells);
    ASSERT_EQ(parts.rows(), 2);
    EXPECT_EQ(parts.coarseCell(0), 4);
    EXPECT_EQ(parts.end(0) - parts.begin(0), 1);
    ASSERT_EQ(parts.end(1) - parts.begin(1), 2);
    EXPECT_EQ(parts.begin(1)->fineCell, 0);
    EXPECT_DOUBLE_EQ(parts.begin(1)->volume, 4);
    EXPECT_DOUBLE_EQ(parts.begin(1)->centroid.x, 4); // (1·1 + 3·5)/4
}
