#include "SolidOnGrid.h"

#include <algorithm>

#include "ParticleTerms.h"

namespace frazil
{

SolidOnGrid::SolidOnGrid(const CouplingSettings& settings)
    : largest_(1 - settings.smallestFluidFraction), prolongation_(settings.prolongation)
{
}

void SolidOnGrid::project(const ParticleView& particles, const ParticlePlaces& places, FluidOnGrid& grid,
                          CoarseState& state, Ledger& ledger)
{
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::projection);
    spreadSpheres(particles, places, state.cells, ledger);
    grid.complete(spheres_);
    fit(grid, state, ledger);
}

void SolidOnGrid::spreadSpheres(const ParticleView& particles, const ParticlePlaces& places, const LocalCells& cells,
                                Ledger& ledger)
{
    spheres_.reset(cells);
    for (std::size_t i = 0; i < particles.count; ++i) {
        const double volume = places[i].presence * volumeOf(particles, i);
        const double displaced = motionOf(particles, i).displacing * volume;
        ledger.absentVolume += volumeOf(particles, i) - displaced;
        spread(places[i].solid, SphereVolume{volume, displaced}, spheres_);
    }
}

/// On every copy of a cell alike.
void SolidOnGrid::fit(const FluidOnGrid& grid, CoarseState& state, Ledger& ledger)
{
    state.solidVolume.reset(state.cells);
    fraction_.reset(state.cells);
    for (int c = 0; c < state.cells.count(); ++c) {
        const double displaced = spheres_[c].displaced;
        const double room = largest_ * grid.openVolume[c];
        double& solid = state.solidVolume[c];
        solid = std::min(displaced, room);
        if (solid > 0)
            fraction_[c] = solid / grid.openVolume[c];
        if (c >= state.cells.ownedCount())
            continue;
        ledger.coarseVolume += displaced;
        ledger.clippedVolume += displaced - solid;
        ledger.clippedCells += displaced > room;
    }
}

void SolidOnGrid::prolong(const FineFlow& flow, FluidOnGrid& grid, CoarseState& state, FineSource& source)
{
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::prolongation);
    open_.resize(flow.count);
    for (std::size_t f = 0; f < flow.count; ++f)
        open_[f] = flow.open(f);
    prolongation_.shape(grid.parts, state.cells, fraction_, grid.openVolume, open_.data(), moment_);
    grid.complete(moment_);
    prolongation_.spread(grid.parts, fraction_, grid.openVolume, open_.data(), moment_, 0, largest_, parts_);
    addToCells(grid.parts, parts_, source.solidFraction.data());
    for (std::size_t f = 0; f < flow.count; ++f) {
        if (source.solidFraction[f] > 0)
            source.solidFraction[f] /= flow.open(f) * flow.volume[f];
    }
}

} // namespace frazil
