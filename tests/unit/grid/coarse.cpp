/// CoarseGrid and LocalCells: index, owner and storage agree.
#include <gtest/gtest.h>

#include "InputError.h"
#include "LocalCells.h"

using frazil::Box;
using frazil::CoarseGrid;
using frazil::LocalCells;
using frazil::Vec3;

namespace
{

const Vec3 down{0, -9.81, 0};

CoarseGrid plate(int owners)
{
    return CoarseGrid(Box{{-1, 0, 2}, {1.3, 0.75, 4}}, 0.25, owners, down);
}

} // namespace

TEST(CoarseGrid, RoundsUpToWholeCells)
{
    const CoarseGrid grid = plate(1); // 2.3/0.25 = 9.2, 0.75/0.25 = 3, 2/0.25 = 8
    EXPECT_EQ(grid.cells(), (frazil::CellIndex{10, 3, 8}));
    EXPECT_DOUBLE_EQ(grid.box().max.x, 1.5);
    EXPECT_DOUBLE_EQ(grid.box().max.y, 0.75);
    EXPECT_EQ(grid.cellCount(), 240);
}

TEST(CoarseGrid, PositionIndexAndCentreAgree)
{
    const CoarseGrid grid = plate(4);
    for (std::int64_t id = 0; id < grid.cellCount(); ++id) {
        EXPECT_EQ(grid.id(grid.index(id)), id);
        EXPECT_EQ(grid.cellOf(grid.centre(id)), id);
        EXPECT_EQ(grid.ownerOf(grid.centre(id)), grid.ownerOf(id));
    }
    EXPECT_EQ(grid.cellOf(grid.box().max), grid.cellCount() - 1);
    EXPECT_EQ(grid.cellOf({-1.001, 0.1, 3}), -1);
    EXPECT_EQ(grid.ownerOf(Vec3{-1.001, 0.1, 3}), -1);
}

TEST(CoarseGrid, EveryCellIsInItsOwnersBlockOnce)
{
    for (const int owners : {1, 2, 3, 4, 6, 7, 8, 80}) {
        const CoarseGrid grid = plate(owners);
        ASSERT_EQ(grid.owners(), owners);
        std::int64_t sum = 0;
        for (int owner = 0; owner < owners; ++owner) {
            const auto block = grid.block(owner);
            EXPECT_GT(block.count(), 0);
            EXPECT_EQ(block.hi[1] - block.lo[1], 3) << "the axis along gravity is not cut";
            sum += block.count();
        }
        EXPECT_EQ(sum, grid.cellCount());
        for (std::int64_t id = 0; id < grid.cellCount(); ++id) {
            const auto block = grid.block(grid.ownerOf(id));
            const auto c = grid.index(id);
            for (int a = 0; a < 3; ++a)
                EXPECT_TRUE(c[a] >= block.lo[a] && c[a] < block.hi[a]);
        }
    }
}

TEST(CoarseGrid, BlocksAreAsSquareAsPossible)
{
    const CoarseGrid grid = plate(4); // 10 x 8 columns: 2 x 2 blocks of 5 x 4
    for (int owner = 0; owner < 4; ++owner)
        EXPECT_EQ(grid.block(owner).count(), 5 * 3 * 4);
}

TEST(CoarseGrid, RefusesInWords)
{
    const auto refusal = [](auto&& action) -> std::string {
        try {
            action();
        } catch (const frazil::InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(
        refusal([] { plate(11); }),
        "constant/couplingProperties: coarseGrid: 8 x 10 columns of cells across y (the vertical) cannot be shared "
        "in blocks among 11 fluid ranks, at least one column each. Use fewer fluid ranks, a smaller cellSize or a "
        "larger box.");
    EXPECT_EQ(refusal([] {
                  CoarseGrid(Box{{0, 0, 0}, {1, 0, 1}}, 0.1, 1, down);
              }),
              "constant/couplingProperties: coarseGrid.max (1 0 1): does not lie above min (0 0 0) along y. "
              "Give the lower corner as min and the upper one as max.");
    EXPECT_EQ(refusal([] { requireCellSize(plate(1), 0.3); }),
              "constant/couplingProperties: coarseGrid.cellSize 0.25: is smaller than the largest particle's diameter "
              "0.3 m. Make it 2 to 4 particle diameters.");
    EXPECT_EQ(refusal([] {
                  requireReach(plate(1), Box{{-2, 0, 2}, {1, 0.5, 3}});
              }),
              "constant/couplingProperties: coarseGrid: the box (-1 0 2) - (1.5 0.75 4) is smaller than the particles' "
              "reach (-2 0 2) - (1 0.5 3). Move min and max outwards until the particles' reach lies inside.");
    EXPECT_EQ(refusal([] { requireReach(plate(1), Box{{-1, 0, 2}, {1, 0.5, 3}}); }), "");
}

TEST(LocalCells, OwnedFirstThenTheRing)
{
    const CoarseGrid grid = plate(4);
    const LocalCells cells(grid, 0); // block of 5 x 3 x 4 in a corner: ring adds one layer on two sides
    EXPECT_EQ(cells.ownedCount(), 60);
    EXPECT_EQ(cells.count(), 6 * 3 * 5);
    for (int l = 0; l < cells.count(); ++l) {
        EXPECT_EQ(cells.local(cells.global(l)), l);
        EXPECT_EQ(grid.ownerOf(cells.global(l)) == 0, l < cells.ownedCount());
    }
    EXPECT_EQ(cells.local(grid.cellCount() - 1), -1);
    EXPECT_EQ(cells.local(std::int64_t(-1)), -1);
}

TEST(LocalCells, TouchedCellsBringTheirNeighbours)
{
    const CoarseGrid grid = plate(4);
    const std::int64_t far = grid.id({8, 1, 6});
    const LocalCells cells(grid, 0, {far, far});
    EXPECT_EQ(cells.count(), 6 * 3 * 5 + 27);
    EXPECT_GE(cells.local(far), cells.ownedCount());
    EXPECT_GE(cells.local(grid.id({9, 2, 7})), 0);
}
