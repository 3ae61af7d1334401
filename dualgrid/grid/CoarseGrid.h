/// The coarse grid: geometry, index and owner of its cells. A value: both programs build the same one from six numbers.
///
/// Cartesian, cubic cells of size h [m]; global id = i + nx (j + ny k). Cells are owned in blocks: the two axes normal
/// to gravity are cut into a x b blocks (owners = a b, blocks as square as possible), never the axis along gravity,
/// because floating particles fill a flat layer and every owner shall get its share. So the owner of a cell is a
/// formula, not a table: O(1) time and no memory, on any rank of either program.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "Box.h"

namespace frazil
{

using CellIndex = std::array<int, 3>;

class CoarseGrid
{
  public:
    /// A block of cells, lo included, hi excluded.
    struct Block {
        CellIndex lo, hi;
        std::int64_t count() const { return std::int64_t(hi[0] - lo[0]) * (hi[1] - lo[1]) * (hi[2] - lo[2]); }
    };

    /// @param box       region to cover [m]; its max is rounded up to whole cells
    /// @param cellSize  h [m]
    /// @param owners    number of owners (fluid ranks)
    /// @param gravity   [m/s2]; its largest component names the axis that is not cut (the shortest axis if zero)
    /// Throws InputError (file constant/couplingProperties) when a size makes no sense or an owner would get no column.
    CoarseGrid(const Box& box, double cellSize, int owners, const Vec3& gravity);

    const CellIndex& cells() const { return n_; }
    std::int64_t cellCount() const { return std::int64_t(n_[0]) * n_[1] * n_[2]; }
    double cellSize() const { return h_; }             ///< [m]
    double cellVolume() const { return h_ * h_ * h_; } ///< [m3]
    const Box& box() const { return box_; }            ///< [m]
    int owners() const { return blocks_[0] * blocks_[1] * blocks_[2]; }

    bool contains(const Vec3& p) const { return box_.contains(p); }
    /// Cell that holds p [m]; on a face shared by two cells the upper one; -1 outside of the grid.
    std::int64_t cellOf(const Vec3& p) const;
    /// Cell that holds p, or the nearest one if p is outside of the grid.
    CellIndex nearest(const Vec3& p) const;
    CellIndex index(std::int64_t id) const
    {
        return {int(id % n_[0]), int(id / n_[0] % n_[1]), int(id / n_[0] / n_[1])};
    }
    std::int64_t id(const CellIndex& c) const
    {
        return c[0] + std::int64_t(n_[0]) * (c[1] + std::int64_t(n_[1]) * c[2]);
    }
    bool holds(const CellIndex& c) const
    {
        return c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < n_[0] && c[1] < n_[1] && c[2] < n_[2];
    }
    Vec3 centre(std::int64_t id) const;    ///< [m]
    Box cellBox(const CellIndex& c) const; ///< [m]

    int ownerOf(std::int64_t id) const { return ownerOf(index(id)); }
    int ownerOf(const CellIndex& c) const;
    /// Owner of the cell that holds p; -1 outside of the grid.
    int ownerOf(const Vec3& p) const;
    Block block(int owner) const;

  private:
    void chooseBlocks(int owners, int vertical);

    Box box_;
    double h_;
    CellIndex n_;
    CellIndex blocks_; ///< owners along each axis, 1 along gravity
};

/// Throws InputError when the particles may reach beyond the grid. `reach`: the box that holds their centres [m].
void requireReach(const CoarseGrid& grid, const Box& reach);
/// Throws InputError when a coarse cell is smaller than the largest particle's diameter [m].
void requireCellSize(const CoarseGrid& grid, double largestDiameter);

} // namespace frazil
