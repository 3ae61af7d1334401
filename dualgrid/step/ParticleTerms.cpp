#include "ParticleTerms.h"

#include <algorithm>

#include <fmt/format.h>

#include "InputError.h"

namespace frazil
{

namespace
{

[[noreturn]] void refuse(const ParticleView& particles, std::size_t i, const CoarseGrid& grid)
{
    const Vec3 &p = particles.position[i], &low = grid.box().min, &high = grid.box().max;
    throw InputError("constant/couplingProperties", "coarseGrid", "",
                     fmt::format("particle {} at ({:.6g} {:.6g} {:.6g}) is outside of this rank's share of the box "
                                 "({:.6g} {:.6g} {:.6g}) - ({:.6g} {:.6g} {:.6g})",
                                 particles.id[i], p.x, p.y, p.z, low.x, low.y, low.z, high.x, high.y, high.z),
                     "Move min and max outwards until the particles' reach lies inside");
}

} // namespace

int homeOf(const ParticleView& particles, std::size_t i, const LocalCells& cells)
{
    const int home = cells.local(cells.grid().cellOf(particles.position[i]));
    if (home < 0 || home >= cells.ownedCount())
        refuse(particles, i, cells.grid());
    return home;
}

std::vector<std::int64_t> touchedCells(const std::vector<FinePiece>& pieces)
{
    std::vector<std::int64_t> touched;
    for (const FinePiece& piece : pieces) {
        if (touched.empty() || touched.back() != piece.coarseCell)
            touched.push_back(piece.coarseCell);
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    return touched;
}

} // namespace frazil
