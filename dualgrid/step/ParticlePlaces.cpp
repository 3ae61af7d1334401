#include "ParticlePlaces.h"

#include <cmath>

#include "ParticleTerms.h"

namespace frazil
{

void ParticlePlaces::find(const ParticleView& particles, const FluidOnGrid& grid, CoarseState& state, Ledger& ledger)
{
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::projection);
    makeStencils(particles, state.cells);
    findSurfaces(particles, grid, state);
    ledger.particles = std::int64_t(particles.count);
    for (std::size_t i = 0; i < particles.count; ++i) {
        const SphereShare share =
            shareOfSphere(particles.position[i], particles.radius[i], state.cells, grid.filled, state.fluid, surface_);
        finish(places_[i], share, grid);
        ledger.particleVolume += volumeOf(particles, i);
        ledger.dryParticles += !(places_[i].presence > 0);
    }
}

void ParticlePlaces::makeStencils(const ParticleView& particles, const LocalCells& cells)
{
    places_.resize(particles.count);
    std::visit(
        [&](const auto& kernel) {
            for (std::size_t i = 0; i < particles.count; ++i) {
                homeOf(particles, i, cells); // refuses a particle that is not ours
                places_[i].solid = kernel(cells, particles.position[i]);
            }
        },
        kernel_);
}

/// In the cells around the particles only.
void ParticlePlaces::findSurfaces(const ParticleView& particles, const FluidOnGrid& grid, const CoarseState& state)
{
    needed_.reset(state.cells, 0);
    for (std::size_t i = 0; i < particles.count; ++i) {
        forCellsOf(cubeOf(particles.position[i], particles.radius[i]), state.cells,
                   [&](int cell) { needed_[cell] = 1; });
    }
    surface_.reset(state.cells);
    for (int c = 0; c < state.cells.count(); ++c) {
        if (needed_[c])
            surface_[c] = surfaceIn(grid.filled[c], state.fluid[c]);
    }
}

void ParticlePlaces::finish(Place& place, const SphereShare& share, const FluidOnGrid& grid) const
{
    place.wet = place.dry = place.mass = place.solid;
    const double water = gather(place.wet, grid.openWater), air = gather(place.dry, grid.openAir);
    const bool inWater = reweigh(place.wet, grid.openWater), inAir = reweigh(place.dry, grid.openAir);
    reweigh(place.solid, grid.solidWindow);
    reweigh(place.mass, grid.fluidMass);
    place.presence = inWater || inAir ? share.inMesh : 0;
    place.wetShare = !inAir ? 1 : !inWater ? 0 : share.dry ? water / (water + air) : share.inWater;
    if (place.wetShare < roundOffShare || place.wetShare > 1 - roundOffShare)
        place.wetShare = std::round(place.wetShare);
}

} // namespace frazil
