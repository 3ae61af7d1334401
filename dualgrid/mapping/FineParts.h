/// The parts of this rank's fine cells, grouped by coarse cell: the link between the two grids.
///
/// Each part lies in one coarse cell, so whatever is distributed over the parts of a coarse cell is conserved there
/// exactly, however the fine cells straddle. A fine cell's value is the volume-weighted mean of its parts; a fine cell
/// across an interface of coarse cells thereby averages over all of them.
/// Storage: one row of parts per touched coarse cell (compressed rows), 40 bytes per part. Built when the mesh changes.
#pragma once

#include <vector>

#include "LocalCells.h"
#include "Overlap.h"

namespace frazil
{

struct FinePart {
    int fineCell = 0;  ///< index in the host's mesh
    double volume = 0; ///< [m3]
    Vec3 centroid;     ///< [m]
};

class FineParts
{
  public:
    FineParts() = default;
    /// Groups the pieces by coarse cell and merges those of the same fine cell.
    FineParts(const std::vector<FinePiece>& pieces, const LocalCells& cells);

    int rows() const { return int(coarseCell_.size()); }
    int coarseCell(int row) const { return coarseCell_[row]; } ///< local index
    const FinePart* begin(int row) const { return parts_.data() + start_[row]; }
    const FinePart* end(int row) const { return parts_.data() + start_[row + 1]; }
    std::size_t count() const { return parts_.size(); }

  private:
    std::vector<int> coarseCell_;
    std::vector<std::size_t> start_{0};
    std::vector<FinePart> parts_;
};

} // namespace frazil
