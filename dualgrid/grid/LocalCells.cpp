#include "LocalCells.h"

#include <algorithm>

namespace frazil
{

LocalCells::LocalCells(const CoarseGrid& grid, int owner, const std::vector<std::int64_t>& touched) : grid_(grid)
{
    addOwned(owner);
    addGhosts(owner, touched);
    buildLookup();
}

void LocalCells::addOwned(int owner)
{
    const auto block = grid_.block(owner);
    global_.reserve(block.count());
    for (int k = block.lo[2]; k < block.hi[2]; ++k) {
        for (int j = block.lo[1]; j < block.hi[1]; ++j) {
            for (int i = block.lo[0]; i < block.hi[0]; ++i)
                global_.push_back(grid_.id({i, j, k}));
        }
    }
    owned_ = int(global_.size());
}

void LocalCells::addGhosts(int owner, const std::vector<std::int64_t>& touched)
{
    std::vector<std::int64_t> centres(touched);
    centres.insert(centres.end(), global_.begin(), global_.end());
    std::sort(centres.begin(), centres.end());
    centres.erase(std::unique(centres.begin(), centres.end()), centres.end());

    std::vector<std::int64_t> ghosts;
    for (const std::int64_t id : centres) {
        const CellIndex c = grid_.index(id);
        for (int n = 0; n < 27; ++n) {
            const CellIndex neighbour{c[0] + n % 3 - 1, c[1] + n / 3 % 3 - 1, c[2] + n / 9 - 1};
            if (grid_.holds(neighbour) && grid_.ownerOf(neighbour) != owner)
                ghosts.push_back(grid_.id(neighbour));
        }
    }
    std::sort(ghosts.begin(), ghosts.end());
    ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
    global_.insert(global_.end(), ghosts.begin(), ghosts.end());
}

void LocalCells::buildLookup()
{
    CellIndex hi{};
    lo_ = grid_.cells();
    for (const std::int64_t id : global_) {
        const CellIndex c = grid_.index(id);
        for (int a = 0; a < 3; ++a) {
            lo_[a] = std::min(lo_[a], c[a]);
            hi[a] = std::max(hi[a], c[a] + 1);
        }
    }
    for (int a = 0; a < 3; ++a)
        size_[a] = hi[a] - lo_[a];
    lookup_.assign(std::size_t(size_[0]) * size_[1] * size_[2], -1);
    for (int l = 0; l < count(); ++l) {
        const CellIndex c = grid_.index(global_[l]);
        lookup_[c[0] - lo_[0] + std::size_t(size_[0]) * (c[1] - lo_[1] + std::size_t(size_[1]) * (c[2] - lo_[2]))] = l;
    }
}

int LocalCells::local(std::int64_t global) const
{
    if (global < 0 || global >= grid_.cellCount())
        return -1;
    return local(grid_.index(global));
}

int LocalCells::local(const CellIndex& c) const
{
    for (int a = 0; a < 3; ++a) {
        if (c[a] < lo_[a] || c[a] >= lo_[a] + size_[a])
            return -1;
    }
    return lookup_[c[0] - lo_[0] + std::size_t(size_[0]) * (c[1] - lo_[1] + std::size_t(size_[1]) * (c[2] - lo_[2]))];
}

} // namespace frazil
