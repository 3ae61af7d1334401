#include "ReactionOnFluid.h"

#include <limits>
#include <utility>

#include "ParticleTerms.h"
#include "Sum.h"

namespace frazil
{

ReactionOnFluid::ReactionOnFluid(const CouplingModel& model) : model_(model), prolongation_(model.settings.prolongation)
{
}

void ReactionOnFluid::collectImpulse(const ParticleView& particles, const ParticlePlaces& places, FluidOnGrid& grid,
                                     CoarseState& state, Ledger& ledger)
{
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::projection);
    state.impulse.reset(state.cells);
    for (std::size_t i = 0; model_.settings.momentumExchange && i < particles.count; ++i) {
        spread(places[i].mass, particles.impulse[i], state.impulse);
        ledger.received += particles.impulse[i];
        ledger.impulseScale += norm(particles.impulse[i]);
    }
    grid.plan.accumulate(state.impulse.data());
    placeImpulse(grid, state, ledger);
    grid.plan.update(state.impulse.data());
}

void ReactionOnFluid::placeImpulse(const FluidOnGrid& grid, CoarseState& state, Ledger& ledger)
{
    for (int c = 0; c < state.cells.ownedCount(); ++c) {
        Vec3 &carried = state.carried[c], &impulse = state.impulse[c];
        ledger.carriedIn += carried;
        ledger.impulseScale += norm(carried);
        impulse += carried;
        ledger.coarseImpulse += impulse;
        carried = Vec3{};
        if (grid.fluidMass[c] > 0)
            continue;
        std::swap(carried, impulse);
        ledger.unplaced += carried;
    }
}

void ReactionOnFluid::restrictLoad(const FineFlow& flow, const SolidOnGrid& solid, FluidOnGrid& grid,
                                   CoarseState& state, Ledger& ledger)
{
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::restriction);
    const PassiveForces passive{model_.forces.pressureGradient(), model_.forces.viscous(), model_.gravity};
    frazil::restrictLoad(grid.parts, flow, passive, solid.parts().data(), state.cells, load_);
    grid.complete(load_);
    for (int c = 0; c < state.cells.ownedCount(); ++c)
        ledger.passiveCarried += load_[c].carried - load_[c].displaced * model_.gravity;
}

void ReactionOnFluid::collectCoefficients(const ParticleView& particles, const ParticlePlaces& places,
                                          const std::vector<Interaction>& replies, FluidOnGrid& grid,
                                          CoarseState& state)
{
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::projection);
    coefficients_.reset(state.cells);
    if (!model_.settings.momentumExchange)
        return;
    for (std::size_t i = 0; i < particles.count; ++i) {
        const double drag = replies[i].dragCoefficient;
        const DragAndAddedMass own{drag, drag * particles.velocity[i], replies[i].addedMass};
        spread(places[i].mass, own, coefficients_);
    }
    grid.complete(coefficients_);
}

/// What the particles of a cell get of ∇p - ρg and ∇·τ, less what the fluid's equations carry for them [N].
Vec3 ReactionOnFluid::returnedTo(int cell, const SolidOnGrid& solid, const CoarseField<CoarseFluid>& fluid) const
{
    if (!model_.settings.momentumExchange)
        return {};
    Vec3 received;
    if (model_.forces.pressureGradient())
        received -= solid.spheres()[cell].present * fluid[cell].pressureGradient;
    if (model_.forces.viscous())
        received += solid.spheres()[cell].present * fluid[cell].viscousForce;
    return received - load_[cell].carried;
}

void ReactionOnFluid::prolongForce(const FineFlow& flow, double deltaT, const SolidOnGrid& solid, FluidOnGrid& grid,
                                   CoarseState& state, FineSource& source, Ledger& ledger)
{
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::prolongation);
    density_.resize(flow.count);
    for (std::size_t f = 0; f < flow.count; ++f)
        density_[f] = flow.density[f] * flow.fluidShare[f];
    acceleration_.reset(state.cells);
    for (int c = 0; c < state.cells.count(); ++c) {
        if (!(grid.fluidMass[c] > 0))
            continue;
        const Vec3 returned = returnedTo(c, solid, state.fluid);
        acceleration_[c] = (state.impulse[c] / deltaT + returned) * (-1 / grid.fluidMass[c]);
        if (c < state.cells.ownedCount())
            ledger.passiveReturned += returned;
    }
    prolongation_.shape(grid.parts, state.cells, acceleration_, grid.fluidMass, density_.data(), moment_);
    grid.complete(moment_);
    const double none = std::numeric_limits<double>::infinity();
    prolongation_.spread(grid.parts, acceleration_, grid.fluidMass, density_.data(), moment_, -none, none, parts_);
    addToCells(grid.parts, parts_, source.force.data());
}

/// No slope: a coefficient must not be negative.
void ReactionOnFluid::prolongCoefficients(const FineFlow& flow, const FluidOnGrid& grid, CoarseState& state,
                                          FineSource& source)
{
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::prolongation);
    for (int row = 0; row < grid.parts.rows(); ++row) {
        const int cell = grid.parts.coarseCell(row);
        const DragAndAddedMass& all = coefficients_[cell];
        if (!(grid.fluidMass[cell] > 0) || !(all.drag > 0 || all.addedMass > 0))
            continue;
        for (const FinePart* part = grid.parts.begin(row); part != grid.parts.end(row); ++part) {
            const int f = part->fineCell;
            const double share = flow.density[f] * flow.fluidShare[f] * part->volume / grid.fluidMass[cell];
            source.addReaction(f, share * all.drag, share * all.dragMomentum, share * all.addedMass);
        }
    }
    source.finishReaction();
}

/// Mass that the spheres displace less that which the fluid carries, this rank's share [kg].
double ReactionOnFluid::weightToReturn(const ParticleView& particles, const ParticlePlaces& places,
                                       const CoarseState& state) const
{
    double mass = 0;
    for (std::size_t i = 0; i < particles.count; ++i)
        mass += places[i].presence * volumeOf(particles, i) * places[i].density(model_.water, model_.air);
    for (int c = 0; c < state.cells.ownedCount(); ++c)
        mass -= load_[c].displaced;
    return mass;
}

void ReactionOnFluid::returnWeight(const ParticleView& particles, const ParticlePlaces& places, const FineFlow& flow,
                                   const FluidOnGrid& grid, const CoarseState& state, FineSource& source,
                                   Ledger& ledger) const
{
    if (!model_.settings.momentumExchange || !model_.forces.pressureGradient())
        return;
    double sums[2] = {weightToReturn(particles, places, state), 0}; // and the mass of the fluid [kg]
    for (std::size_t f = 0; f < flow.count; ++f)
        sums[1] += flow.density[f] * flow.fluidShare[f] * flow.volume[f];
    ledger.passiveReturned -= sums[0] * model_.gravity; // this rank's share
    sumOverRanks(sums, 2, grid.comm);
    const Vec3 acceleration = sums[1] > 0 ? sums[0] / sums[1] * model_.gravity : Vec3{};
    for (std::size_t f = 0; f < flow.count; ++f)
        source.force[f] += flow.density[f] * flow.fluidShare[f] * flow.volume[f] * acceleration;
}

} // namespace frazil
