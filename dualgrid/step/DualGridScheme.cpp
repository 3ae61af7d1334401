#include "DualGridScheme.h"

#include <algorithm>
#include <limits>

#include "ParticleReach.h"
#include "Sum.h"

namespace frazil
{

DualGridScheme::DualGridScheme(const CouplingSettings& settings, ForceModel forces, const Phase& water,
                               const Phase& air, const Vec3& gravity, const CoarseGrid& grid, MPI_Comm comm)
    : CouplingScheme(settings, std::move(forces), water, air, LocalCells(grid, rankIn(comm))), gravity_(gravity),
      comm_(comm), plan_(cells, comm), solidProlongation_(settings.prolongation),
      forceProlongation_(settings.prolongation), carried_(cells.ownedCount())
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
    restrictFluid(flow);                // fine -> coarse: averages of the fluid
    project(particles, ledger);         // particles -> coarse: solid volume, impulse
    findSurfaces();                     // the water's surface where there are particles
    interact(particles, replies);       // coarse -> particles: local flow, force laws
    spreadReaction(particles, replies); // particles -> coarse: drag and added mass
    prolong(flow, deltaT, source);      // coarse -> fine: αs, force on the fluid, drag and added mass
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
    flowVolume_.reset(cells);
    fluidMass_.reset(cells);
    for (int c = 0; c < cells.count(); ++c) {
        openVolume_[c] = fluid[c].openVolume;
        // not the fluid's volume: spheres displace the water around them, so the free air above would weigh more than
        // its share, and floating_plate floats 1.6 mm too deep
        flowVolume_[c] = fluid[c].hasFluid() ? fluid[c].openVolume : 0;
        fluidMass_[c] = fluid[c].fluidMass;
    }
}

/// A sphere that reaches into a coarse cell has volume in it: its window is wider than itself.
void DualGridScheme::findSurfaces()
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::restriction);
    surface_.reset(cells);
    for (int c = 0; c < cells.count(); ++c) {
        if (solidVolume[c] > 0)
            surface_[c] = surfaceIn(cells.grid().cellBox(cells.grid().index(cells.global(c))), fluid[c]);
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
    windows_.resize(particles.count);
    ledger.particles = std::int64_t(particles.count);
    for (std::size_t i = 0; i < particles.count; ++i) {
        homeOf(particles, i, cells); // refuses a particle that is not ours
        Windows& window = windows_[i];
        window.solid = window.flow = window.mass = stencilOf(cells, particles.position[i]);
        reweigh(window.solid, openVolume_);
        window.dry = !reweigh(window.flow, flowVolume_);
        const double volume = volumeOf(particles, i);
        spread(window.solid, volume, solidVolume);
        ledger.particleVolume += volume;
        ledger.dryParticles += window.dry;
        if (!settings_.momentumExchange)
            continue;
        reweigh(window.mass, fluidMass_);
        spread(window.mass, particles.impulse[i], impulse);
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

void DualGridScheme::interact(const ParticleView& particles, std::vector<Interaction>& replies)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::forces);
    replies.assign(particles.count, Interaction{});
    forces_.withDrag([&](const auto& force) {
        for (std::size_t i = 0; i < particles.count; ++i) {
            if (!windows_[i].dry)
                replies[i] = force(flowAt(particles, i), stateOf(particles, i), water_, air_);
        }
    });
}

/// ∇p in two parts: what moves the fluid, ∇p - ρ g, as wide as the kernel; the fluid's weight, ρ g, that of the water
/// which the sphere itself is in. As wide as the kernel, too, it would let the water hold up what is above it.
LocalFlow DualGridScheme::flowAt(const ParticleView& particles, std::size_t particle) const
{
    const Windows& window = windows_[particle];
    LocalFlow flow;
    flow.fluidFraction = 1 - gather(window.solid, solidFraction_);
    flow.wetFraction = 0;
    double accelerated = 0;
    for (int n = 0; n < 8; ++n) {
        const CoarseFluid& cell = fluid[window.flow.cell[n]];
        const double w = window.flow.weight[n];
        flow.wetFraction += w * cell.wetFraction;
        flow.velocity += w * cell.velocity;
        flow.pressureGradient += w * (cell.pressureGradient - cell.density() * gravity_);
        flow.viscousForce += w * cell.viscousForce;
        flow.acceleration += w * cell.accelerated * cell.acceleration;
        accelerated += w * cell.accelerated;
        flow.vorticity += w * cell.vorticity;
    }
    if (accelerated > 0)
        flow.acceleration *= 1 / accelerated;
    flow.pressureGradient += densityAt(particles, particle, flow.wetFraction) * gravity_;
    return flow;
}

/// Of the fluid in the sphere's place [kg/m3]; that of the coarse grid, `wetFraction`, if its place has none.
double DualGridScheme::densityAt(const ParticleView& particles, std::size_t particle, double wetFraction) const
{
    const double wet =
        wetShare(particles.position[particle], particles.radius[particle], cells, fluid, surface_, wetFraction);
    return wet * water_.density + (1 - wet) * air_.density;
}

void DualGridScheme::spreadReaction(const ParticleView& particles, const std::vector<Interaction>& replies)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::projection);
    reaction_.reset(cells);
    if (!settings_.momentumExchange)
        return;
    for (std::size_t i = 0; i < particles.count; ++i) {
        const double drag = replies[i].dragCoefficient, mass = replies[i].addedMass;
        const Vec3 momentum = drag * particles.velocity[i];
        const Stencil& window = windows_[i].mass;
        for (int n = 0; n < 8; ++n) {
            Reaction& reaction = reaction_[window.cell[n]];
            reaction.drag += window.weight[n] * drag;
            reaction.dragMomentum += window.weight[n] * momentum;
            reaction.addedMass += window.weight[n] * mass;
        }
    }
    complete(reaction_);
}

void DualGridScheme::prolong(const FineFlow& flow, double deltaT, FineSource& source)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::prolongation);
    source.reset(flow.count);
    prolongSolid(flow, source);
    prolongForce(flow, deltaT, source);
    prolongReaction(flow, source);
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

/// By the share of the coarse cell's fluid mass, no slope: a coefficient must not be negative.
void DualGridScheme::prolongReaction(const FineFlow& flow, FineSource& source)
{
    for (int row = 0; row < parts_.rows(); ++row) {
        const int cell = parts_.coarseCell(row);
        const Reaction& reaction = reaction_[cell];
        if (!(fluidMass_[cell] > 0) || !(reaction.drag > 0 || reaction.addedMass > 0))
            continue;
        for (const FinePart* part = parts_.begin(row); part != parts_.end(row); ++part) {
            const int f = part->fineCell;
            const double share = flow.density[f] * flow.fluidFraction[f] * part->volume / fluidMass_[cell];
            source.addReaction(f, share * reaction.drag, share * reaction.dragMomentum, share * reaction.addedMass);
        }
    }
    source.finishReaction();
}

} // namespace frazil
