#include "ForcesOnParticles.h"

#include "ParticleTerms.h"

namespace frazil
{

namespace
{

PhaseFlow phaseAt(const Stencil& window, const CoarseField<CoarseFluid>& fluid, CoarsePhase CoarseFluid::*phase)
{
    PhaseFlow flow;
    double accelerated = 0;
    for (int n = 0; n < window.count; ++n) {
        const CoarsePhase& cell = fluid[window.cell[n]].*phase;
        const double w = window.weight[n];
        flow.velocity += w * cell.velocity;
        flow.acceleration += w * cell.accelerated * cell.acceleration;
        accelerated += w * cell.accelerated;
        flow.vorticity += w * cell.vorticity;
    }
    if (accelerated > roundOffShare)
        flow.acceleration *= 1 / accelerated;
    return flow;
}

/// Is it free to follow the pressure?
bool answers(const ParticleView& particles, const ParticlePlaces& places, std::size_t i)
{
    return places[i].presence > 0 && motionOf(particles, i).mass > 0;
}

} // namespace

void ForcesOnParticles::act(const ParticleView& particles, const ParticlePlaces& places, const SolidOnGrid& solid,
                            CoarseState& state, std::vector<Interaction>& replies, Ledger& ledger) const
{
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::forces);
    replies.assign(particles.count, Interaction{});
    model_.forces.withDrag([&](const auto& force) {
        for (std::size_t i = 0; i < particles.count; ++i) {
            if (!(places[i].presence > 0))
                continue;
            const LocalFlow flow = flowAt(places[i], state.fluid, solid.fraction());
            replies[i] = force(flow, stateOf(particles, i, places[i].presence), model_.water, model_.air);
            ledger.passiveReceived += replies[i].passiveForce;
            ledger.passiveScale += norm(replies[i].passiveForce);
        }
    });
}

LocalFlow ForcesOnParticles::flowAt(const Place& place, const CoarseField<CoarseFluid>& fluid,
                                    const CoarseField<double>& solidFraction) const
{
    LocalFlow flow;
    flow.wetShare = place.wetShare;
    if (place.wetShare > 0)
        flow.water = phaseAt(place.wet, fluid, &CoarseFluid::water);
    if (place.wetShare < 1)
        flow.air = phaseAt(place.dry, fluid, &CoarseFluid::air);
    flow.water.fluidFraction = flow.air.fluidFraction = 1 - gather(place.solid, solidFraction);
    flow.pressureGradient = gather(place.solid, fluid, [](const CoarseFluid& cell) { return cell.pressureGradient; });
    flow.viscousForce = gather(place.solid, fluid, [](const CoarseFluid& cell) { return cell.viscousForce; });
    flow.pressureGradient += place.density(model_.water, model_.air) * model_.gravity;
    return flow;
}

void ForcesOnParticles::sumResponse(const ParticleView& particles, const ParticlePlaces& places,
                                    const CoarseState& state, const std::vector<Interaction>& replies)
{
    sums_.reset(state.cells);
    for (std::size_t i = 0; i < particles.count; ++i) {
        if (!answers(particles, places, i))
            continue;
        const Place& place = places[i];
        const ResponseSums own = responseOf(stateOf(particles, i, place.presence), particles.motion[i],
                                            place.density(model_.water, model_.air), replies[i]);
        spread(place.solid, own, sums_);
    }
}

void ForcesOnParticles::respond(const ParticleView& particles, const ParticlePlaces& places, double deltaT,
                                FluidOnGrid& grid, CoarseState& state, std::vector<Interaction>& replies,
                                Ledger& ledger)
{
    if (!model_.forces.pressureGradient())
        return;
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::forces);
    sumResponse(particles, places, state, replies);
    grid.plan.accumulate(sums_.data());
    response_.reset(state.cells);
    for (int c = 0; c < state.cells.ownedCount(); ++c) {
        if (sums_[c].volume > 0) {
            const double solidFraction = state.solidVolume[c] / state.fluid[c].openVolume;
            response_[c] = pressureResponse(sums_[c], 1 - solidFraction, deltaT);
        }
    }
    grid.plan.update(response_.data());
    for (std::size_t i = 0; i < particles.count; ++i) {
        if (!answers(particles, places, i))
            continue;
        const Vec3 force = places[i].presence * volumeOf(particles, i) * gather(places[i].solid, response_);
        replies[i].passiveForce += force;
        ledger.response += force;
    }
}

} // namespace frazil
