#include "DualGridScheme.h"

#include <algorithm>
#include <limits>

#include "ParticleReach.h"
#include "Sum.h"

namespace frazil
{

DualGridScheme::DualGridScheme(const CouplingSettings& settings, ForceModel forces, const Phase& water,
                               const Phase& air, const CoarseGrid& grid, MPI_Comm comm)
    : CouplingScheme(settings, std::move(forces), water, air, LocalCells(grid, rankIn(comm))), comm_(comm),
      plan_(cells, comm), solidProlongation_(settings.prolongation), forceProlongation_(settings.prolongation),
      carried_(cells.ownedCount())
{
}

void DualGridScheme::setParts(const std::vector<FinePiece>& pieces)
{
    cells = LocalCells(cells.grid(), rankIn(comm_), touchedCells(pieces));
    plan_ = ExchangePlan(cells, comm_);
    parts_ = FineParts(pieces, cells);
}

Ledger DualGridScheme::advance(const ParticleView& particles, const FineFlow& flow, double deltaT,
                               std::vector<Interaction>& replies, FineSource& source)
{
    Ledger ledger;
    restrictFluid(flow);                          // fine -> coarse: averages of the fluid
    project(particles, ledger);                   // particles -> coarse: solid volume, impulse
    interact(particles, deltaT, replies, ledger); // coarse -> particles: local flow, force laws
    prolong(flow, deltaT, source);                // coarse -> fine: αs, force on the fluid
    ledger.addFine(flow, source.solidFraction, source.force, deltaT);
    ledger.sumOver(comm_);
    return ledger;
}

void DualGridScheme::restrictFluid(const FineFlow& flow)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::restriction);
    restrictSums(parts_, flow, cells, fluid);
    plan_.accumulate(fluid.data());
    for (int c = 0; c < cells.ownedCount(); ++c)
        finishAverages(fluid[c], cells.grid().cellVolume());
    plan_.update(fluid.data());
    openVolume_.reset(cells);
    fluidMass_.reset(cells);
    for (int c = 0; c < cells.count(); ++c) {
        openVolume_[c] = fluid[c].openVolume;
        fluidMass_[c] = fluid[c].fluidMass;
    }
}

void DualGridScheme::project(const ParticleView& particles, Ledger& ledger)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::projection);
    spreadParticles(particles, ledger);
    plan_.accumulate(solidVolume.data());
    fitSolid(ledger);
    plan_.update(solidFraction_.data());
    plan_.update(solidVolume.data());
    plan_.accumulate(impulse.data());
    placeImpulse(ledger);
    plan_.update(impulse.data());
}

void DualGridScheme::spreadParticles(const ParticleView& particles, Ledger& ledger)
{
    solidVolume.reset(cells);
    impulse.reset(cells);
    stencils_.resize(particles.count);
    dry_.resize(particles.count);
    ledger.particles = std::int64_t(particles.count);
    for (std::size_t i = 0; i < particles.count; ++i) {
        homeOf(particles, i, cells); // refuses a particle that is not ours
        Stencil& stencil = stencils_[i] = stencilOf(cells, particles.position[i]);
        Stencil byMass = stencil;
        dry_[i] = !reweigh(stencil, openVolume_);
        const double volume = volumeOf(particles, i);
        spread(stencil, volume, solidVolume);
        ledger.particleVolume += volume;
        ledger.dryParticles += dry_[i];
        if (!settings_.momentumExchange)
            continue;
        // By mass: a particle at the surface pushes the water, not the air above it.
        reweigh(byMass, fluidMass_);
        spread(byMass, particles.impulse[i], impulse);
        ledger.received += particles.impulse[i];
        ledger.impulseScale += norm(particles.impulse[i]);
    }
}

/// The solid that fits below the smallest fluid fraction; the rest is clipped and listed.
void DualGridScheme::fitSolid(Ledger& ledger)
{
    solidFraction_.reset(cells);
    for (int c = 0; c < cells.ownedCount(); ++c) {
        ledger.coarseVolume += solidVolume[c];
        const double room = (1 - settings_.smallestFluidFraction) * openVolume_[c];
        if (solidVolume[c] > room) {
            ledger.clippedVolume += solidVolume[c] - room;
            ++ledger.clippedCells;
            solidVolume[c] = room;
        }
        if (openVolume_[c] > 0)
            solidFraction_[c] = solidVolume[c] / openVolume_[c];
    }
}

/// Impulse in a cell without fluid waits there for the next step.
void DualGridScheme::placeImpulse(Ledger& ledger)
{
    for (int c = 0; c < cells.ownedCount(); ++c) {
        ledger.carriedIn += carried_[c];
        ledger.impulseScale += norm(carried_[c]);
        impulse[c] += carried_[c];
        ledger.coarseImpulse += impulse[c];
        carried_[c] = Vec3{};
        if (fluidMass_[c] > 0)
            continue;
        std::swap(carried_[c], impulse[c]);
        ledger.unplaced += carried_[c];
    }
}

void DualGridScheme::interact(const ParticleView& particles, double deltaT, std::vector<Interaction>& replies,
                              Ledger& ledger)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::forces);
    replies.assign(particles.count, Interaction{});
    forces_.withDrag([&](const auto& force) {
        for (std::size_t i = 0; i < particles.count; ++i) {
            if (dry_[i])
                continue;
            replies[i] = force(flowAt(stencils_[i]), stateOf(particles, i), water_, air_);
            if (!settings_.momentumExchange)
                continue; // no answer of the fluid, no lag
            const double largest = largestDrag(stencils_[i], volumeOf(particles, i), deltaT);
            if (replies[i].dragCoefficient > largest) {
                replies[i].dragCoefficient = largest;
                ++ledger.limitedDrags;
            }
        }
    });
}

double DualGridScheme::largestDrag(const Stencil& stencil, double volume, double deltaT) const
{
    double mass = 0, solid = 0; // per stencil, the weights cancel in the ratio
    for (int n = 0; n < 8; ++n) {
        const int c = stencil.cell[n];
        mass += stencil.weight[n] * fluidMass_[c];
        solid += stencil.weight[n] * solidVolume[c];
    }
    return 0.5 * mass * volume / (solid * deltaT);
}

LocalFlow DualGridScheme::flowAt(const Stencil& stencil) const
{
    LocalFlow flow;
    flow.fluidFraction = 1 - gather(stencil, solidFraction_);
    flow.wetFraction = 0;
    for (int n = 0; n < 8; ++n) {
        const CoarseFluid& cell = fluid[stencil.cell[n]];
        const double w = stencil.weight[n];
        flow.wetFraction += w * cell.wetFraction;
        flow.velocity += w * cell.velocity;
        flow.pressureGradient += w * cell.pressureGradient;
        flow.viscousForce += w * cell.viscousForce;
        flow.acceleration += w * cell.acceleration;
        flow.vorticity += w * cell.vorticity;
    }
    return flow;
}

void DualGridScheme::prolong(const FineFlow& flow, double deltaT, FineSource& source)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::prolongation);
    source.reset(flow.count);
    prolongSolid(flow, source);
    prolongForce(flow, deltaT, source);
}

void DualGridScheme::prolongSolid(const FineFlow& flow, FineSource& source)
{
    density_.resize(flow.count);
    for (std::size_t f = 0; f < flow.count; ++f)
        density_[f] = flow.open(f);
    solidProlongation_.shape(parts_, cells, solidFraction_, openVolume_, density_.data(), scalarMoment_);
    complete(scalarMoment_);
    solidProlongation_.spread(parts_, solidFraction_, openVolume_, density_.data(), scalarMoment_, 0,
                              1 - settings_.smallestFluidFraction, source.solidFraction.data());
    for (std::size_t f = 0; f < flow.count; ++f) {
        if (source.solidFraction[f] > 0)
            source.solidFraction[f] /= flow.open(f) * flow.volume[f];
    }
}

void DualGridScheme::prolongForce(const FineFlow& flow, double deltaT, FineSource& source)
{
    for (std::size_t f = 0; f < flow.count; ++f)
        density_[f] = flow.density[f] * flow.fluidFraction[f];
    acceleration_.reset(cells);
    for (int c = 0; c < cells.count(); ++c) {
        if (fluidMass_[c] > 0)
            acceleration_[c] = impulse[c] * (-1 / (deltaT * fluidMass_[c]));
    }
    forceProlongation_.shape(parts_, cells, acceleration_, fluidMass_, density_.data(), vectorMoment_);
    complete(vectorMoment_);
    const double none = std::numeric_limits<double>::infinity();
    forceProlongation_.spread(parts_, acceleration_, fluidMass_, density_.data(), vectorMoment_, -none, none,
                              source.force.data());
}

} // namespace frazil
