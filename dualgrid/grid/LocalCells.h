/// The coarse cells that one fluid rank stores: its own block first, then ghosts.
///
/// Ghosts are the ring of one cell around the block (stencils of the particles inside it) and the cells that the rank's
/// fine cells touch, with their ring (values at their nodes). Sorted by global id, so every rank can derive the order.
/// local() is one look-up in a dense array over the bounding box of these cells: O(1), 4 bytes per cell of that box.
#pragma once

#include <cstdint>
#include <vector>

#include "CoarseGrid.h"

namespace frazil
{

class LocalCells
{
  public:
    /// @param touched  global ids of the cells that the rank's fine cells touch, any order, repeats allowed
    LocalCells(const CoarseGrid& grid, int owner, const std::vector<std::int64_t>& touched = {});

    int ownedCount() const { return owned_; }
    int count() const { return int(global_.size()); }
    std::int64_t global(int local) const { return global_[local]; }
    /// Local index of a global id, -1 if this rank does not store the cell.
    int local(std::int64_t global) const;
    int local(const CellIndex& c) const;
    const CoarseGrid& grid() const { return grid_; }
    /// Global ids in local order.
    std::vector<std::int64_t> ownedIds() const { return {global_.begin(), global_.begin() + owned_}; }
    std::vector<std::int64_t> ghostIds() const { return {global_.begin() + owned_, global_.end()}; }

  private:
    void addOwned(int owner);
    void addGhosts(int owner, const std::vector<std::int64_t>& touched);
    void buildLookup();

    CoarseGrid grid_;
    int owned_ = 0;
    std::vector<std::int64_t> global_;
    CellIndex lo_{}, size_{};
    std::vector<int> lookup_;
};

} // namespace frazil
