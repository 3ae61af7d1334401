#include "DirectStep.h"

#include <algorithm>
#include <numeric>

#include "ParticleTerms.h"
#include "Sum.h"

namespace frazil
{

namespace
{

/// Places in a list, in the order of the ids.
template <class Item> std::vector<std::size_t> orderById(const std::vector<Item>& items)
{
    std::vector<std::size_t> order(items.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return items[a].id < items[b].id; });
    return order;
}

} // namespace

DirectStep::DirectStep(const CouplingModel& model, CoarseState& state, MPI_Comm comm)
    : model_(model), state_(state), comm_(comm), router_(comm), holders_(state.cells.ownedCount())
{
    state_.fluid.reset(state_.cells);
}

/// Tells the owner of every coarse cell which ranks have fine cells in it.
void DirectStep::setParts(const std::vector<FinePiece>& pieces)
{
    struct Notice {
        std::int64_t cell;
        int rank;
    };
    const std::vector<std::int64_t> touched = touchedCells(pieces);
    std::vector<int> owners;
    std::vector<Notice> notices;
    for (const std::int64_t cell : touched) {
        owners.push_back(state_.cells.grid().ownerOf(cell));
        notices.push_back({cell, rankIn(comm_)});
    }
    holders_.assign(state_.cells.ownedCount(), {});
    for (const Notice& notice : router_.send(owners, notices)) {
        holders_[state_.cells.local(notice.cell)].push_back(notice.rank); // comes ordered by rank
    }
}

Ledger DirectStep::advance(const ParticleView& particles, const FineFlow& flow, double deltaT,
                           std::vector<Interaction>& replies, FineSource& source)
{
    Ledger ledger;
    source.reset(flow.count);
    std::vector<int> to;
    std::vector<std::size_t> who;
    std::vector<Visitor> visitors;
    std::vector<Interaction> answers;
    {
        const PhaseTimer::Scope scope(state_.timer, PhaseTimer::projection);
        const std::vector<Place> places = locate(particles, flow);
        const std::vector<Visitor> departing = depart(particles, places, to, who, ledger);
        visitors = router_.send(to, departing);
        settle(visitors, flow, deltaT, source, ledger);
    }
    {
        const PhaseTimer::Scope scope(state_.timer, PhaseTimer::forces);
        std::vector<Interaction> given = interact(visitors, flow, source, ledger);
        giveBack(visitors, given, flow, source, ledger);
        respond(visitors, flow, source, deltaT, given, ledger);
        react(visitors, given, source);
        answers = router_.answer(given);
    }
    replies.assign(particles.count, Interaction{});
    for (std::size_t n = 0; n < who.size(); ++n)
        replies[who[n]] = answers[n];
    ledger.addFine(flow, source.solidFraction, source.force, deltaT);
    ledger.sumOver(comm_);
    return ledger;
}

std::vector<DirectStep::Place> DirectStep::locate(const ParticleView& particles, const FineFlow& flow)
{
    std::vector<int> to;
    std::vector<Vec3> centres;
    std::vector<std::size_t> asker;
    for (std::size_t i = 0; i < particles.count; ++i) {
        for (const int rank : holders_[homeOf(particles, i, state_.cells)]) {
            to.push_back(rank);
            centres.push_back(particles.position[i]);
            asker.push_back(i);
        }
    }
    const std::vector<Vec3> asked = router_.send(to, centres);
    std::vector<int> found(asked.size());
    for (std::size_t n = 0; n < asked.size(); ++n) {
        found[n] = fineCellAt_(asked[n]);
        if (found[n] >= 0 && !(flow.fluidShare[found[n]] > 0))
            found[n] = -1; // inside a body
    }
    const std::vector<int> answer = router_.answer(found);
    std::vector<Place> places(particles.count);
    for (std::size_t n = 0; n < answer.size(); ++n) {
        Place& place = places[asker[n]];
        if (answer[n] >= 0 && place.rank < 0)
            place = {to[n], answer[n]};
    }
    return places;
}

std::vector<DirectStep::Visitor> DirectStep::depart(const ParticleView& particles, const std::vector<Place>& places,
                                                    std::vector<int>& to, std::vector<std::size_t>& who, Ledger& ledger)
{
    state_.solidVolume.reset(state_.cells);
    state_.impulse.reset(state_.cells);
    for (const Vec3& carried : state_.carried) {
        ledger.carriedIn += carried;
        ledger.impulseScale += norm(carried);
    }
    std::vector<Visitor> visitors;
    for (std::size_t i = 0; i < particles.count; ++i) {
        const int home = homeOf(particles, i, state_.cells);
        const ParticleMotion motion = motionOf(particles, i);
        const double whole = volumeOf(particles, i), volume = places[i].rank < 0 ? 0 : motion.displacing * whole;
        const Vec3 own = model_.settings.momentumExchange ? particles.impulse[i] : Vec3{};
        ++ledger.particles;
        ledger.particleVolume += whole;
        ledger.absentVolume += whole - volume;
        ledger.received += own;
        ledger.impulseScale += norm(own);
        state_.carried[home] += own;
        if (places[i].rank < 0) {
            ++ledger.dryParticles;
            continue;
        }
        state_.solidVolume[home] += volume;
        state_.impulse[home] += state_.carried[home];
        visitors.push_back(
            {particles.id[i], places[i].fineCell, volume, state_.carried[home], stateOf(particles, i, 1), motion});
        state_.carried[home] = Vec3{};
        to.push_back(places[i].rank);
        who.push_back(i);
    }
    for (const Vec3& carried : state_.carried) {
        ledger.unplaced += carried;
        ledger.coarseImpulse += carried;
    }
    return visitors;
}

void DirectStep::settle(const std::vector<Visitor>& visitors, const FineFlow& flow, double deltaT, FineSource& source,
                        Ledger& ledger) const
{
    for (const std::size_t n : orderById(visitors)) {
        const Visitor& visitor = visitors[n];
        source.solidFraction[visitor.fineCell] += visitor.volume;
        source.force[visitor.fineCell] -= visitor.impulse / deltaT;
        ledger.coarseVolume += visitor.volume;
        ledger.coarseImpulse += visitor.impulse;
    }
    fitSolid(flow, source, ledger);
}

/// Drag and added mass into the particle's own cell.
void DirectStep::react(const std::vector<Visitor>& visitors, const std::vector<Interaction>& answers,
                       FineSource& source) const
{
    if (!model_.settings.momentumExchange)
        return;
    for (const std::size_t n : orderById(visitors)) {
        const double drag = answers[n].dragCoefficient;
        source.addReaction(visitors[n].fineCell, drag, drag * visitors[n].state.velocity, answers[n].addedMass);
    }
    source.finishReaction();
}

/// From volume to αs, with what fits below the smallest fluid fraction.
void DirectStep::fitSolid(const FineFlow& flow, FineSource& source, Ledger& ledger) const
{
    for (std::size_t f = 0; f < flow.count; ++f) {
        double& solid = source.solidFraction[f];
        if (!(solid > 0))
            continue;
        const double open = flow.open(f) * flow.volume[f], room = (1 - model_.settings.smallestFluidFraction) * open;
        if (solid > room) {
            ledger.clippedVolume += solid - room;
            ++ledger.clippedCells;
            solid = room;
        }
        solid = open > 0 ? solid / open : 0; // a body may cover the cell in the coming step
    }
}

std::vector<Interaction> DirectStep::interact(const std::vector<Visitor>& visitors, const FineFlow& flow,
                                              FineSource& source, Ledger& ledger) const
{
    std::vector<Interaction> answers(visitors.size());
    model_.forces.withDrag([&](const auto& force) {
        for (std::size_t n = 0; n < visitors.size(); ++n) {
            const int f = visitors[n].fineCell;
            const PhaseFlow here{1 - source.solidFraction[f], flow.velocity[f],
                                 flow.accelerated(f) * flow.acceleration[f], flow.vorticity[f]};
            const LocalFlow local{flow.wet(f), here, here, flow.pressureGradient[f], flow.viscousForce[f]};
            answers[n] = force(local, visitors[n].state, model_.water, model_.air);
            ledger.passiveReceived += answers[n].passiveForce;
            ledger.passiveScale += norm(answers[n].passiveForce);
        }
    });
    return answers;
}

/// The fluid's equations carry ∇p and ∇·τ for the solid that fits into the cell; the rest is given to the fluid.
void DirectStep::giveBack(const std::vector<Visitor>& visitors, const std::vector<Interaction>& answers,
                          const FineFlow& flow, FineSource& source, Ledger& ledger) const
{
    if (!model_.settings.momentumExchange)
        return;
    for (std::size_t f = 0; f < flow.count; ++f) {
        const double volume = source.solidFraction[f] * flow.open(f) * flow.volume[f];
        if (!(volume > 0))
            continue;
        Vec3 carried;
        if (model_.forces.pressureGradient())
            carried -= volume * flow.pressureGradient[f];
        if (model_.forces.viscous())
            carried += volume * flow.viscousForce[f];
        source.force[f] += carried;
        ledger.passiveCarried += carried;
        ledger.passiveReturned -= carried;
    }
    for (const std::size_t n : orderById(visitors)) {
        source.force[visitors[n].fineCell] -= answers[n].passiveForce;
        ledger.passiveReturned += answers[n].passiveForce;
    }
}

void DirectStep::respond(const std::vector<Visitor>& visitors, const FineFlow& flow, const FineSource& source,
                         double deltaT, std::vector<Interaction>& answers, Ledger& ledger)
{
    if (!model_.forces.pressureGradient())
        return;
    sums_.assign(flow.count, ResponseSums{});
    for (const std::size_t n : orderById(visitors)) {
        const Visitor& v = visitors[n];
        if (v.motion.mass > 0)
            sums_[v.fineCell] += responseOf(v.state, v.motion, flow.density[v.fineCell], answers[n]);
    }
    for (std::size_t n = 0; n < visitors.size(); ++n) {
        const Visitor& v = visitors[n];
        if (!(v.motion.mass > 0))
            continue;
        const double e = 1 - source.solidFraction[v.fineCell];
        const Vec3 force = volumeOf(v.state.radius) * pressureResponse(sums_[v.fineCell], e, deltaT);
        answers[n].passiveForce += force;
        ledger.response += force;
    }
}

} // namespace frazil
