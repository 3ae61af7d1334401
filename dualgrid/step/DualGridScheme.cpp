#include "DualGridScheme.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ParticleReach.h"
#include "Sum.h"

namespace frazil
{

namespace
{

/// Less water (or air) than this share of a coarse cell is round-off: nothing is in it. Not larger, so that crossing it
/// changes nothing but round-off.
const double nothing = 1e-14;

/// Volume and centroid of the mesh in each coarse cell, this rank's share.
CoarseField<MeshShare> sharesOf(const FineParts& parts, const LocalCells& cells)
{
    CoarseField<MeshShare> shares(cells);
    for (int row = 0; row < parts.rows(); ++row) {
        const int cell = parts.coarseCell(row);
        const Vec3 centre = cells.grid().centre(cells.global(cell));
        for (const FinePart* part = parts.begin(row); part != parts.end(row); ++part) {
            shares[cell].volume += part->volume;
            shares[cell].moment += part->volume * (part->centroid - centre);
        }
    }
    return shares;
}

} // namespace

DualGridScheme::DualGridScheme(const CouplingSettings& settings, ForceModel forces, const Phase& water,
                               const Phase& air, const Vec3& gravity, const CoarseGrid& grid, MPI_Comm comm)
    : CouplingScheme(settings, std::move(forces), water, air, LocalCells(grid, rankIn(comm))), gravity_(gravity),
      comm_(comm), plan_(cells, comm), solidProlongation_(settings.prolongation),
      forceProlongation_(settings.prolongation), filled_(cells), meshVolume_(cells)
{
}

void DualGridScheme::setParts(const std::vector<FinePiece>& pieces)
{
    cells = LocalCells(cells.grid(), rankIn(comm_), touchedCells(pieces));
    plan_ = ExchangePlan(cells, comm_);
    parts_ = FineParts(pieces, cells);
    CoarseField<MeshShare> shares = sharesOf(parts_, cells);
    complete(shares);
    filled_.reset(cells);
    meshVolume_.reset(cells);
    for (int c = 0; c < cells.count(); ++c) {
        filled_[c] = filledBox(cells.grid().cellBox(cells.grid().index(cells.global(c))), shares[c]);
        meshVolume_[c] = shares[c].volume;
    }
}

Ledger DualGridScheme::advance(const ParticleView& particles, const FineFlow& flow, double deltaT,
                               std::vector<Interaction>& replies, FineSource& source)
{
    Ledger ledger;
    source.reset(flow.count);
    restrictFluid(flow);                         // fine -> coarse: averages of water and air
    place(particles, ledger);                    // particles: their shares in water, in air, in the mesh; their windows
    project(particles, ledger);                  // particles -> coarse: solid volume, impulse
    prolongSolid(flow, source);                  // coarse -> fine: αs
    restrictLoads(flow, ledger);                 // fine -> coarse: what the fluid carries for the solid
    interact(particles, replies, ledger);        // coarse -> particles: local flow, force laws
    respond(particles, deltaT, replies, ledger); // how the pressure will answer to their motion
    spreadReaction(particles, replies);          // particles -> coarse: drag and added mass
    prolongForce(flow, deltaT, source, ledger);  // coarse -> fine: force on the fluid
    prolongReaction(flow, source);               // coarse -> fine: drag and added mass
    returnWeight(particles, flow, source, ledger); // to all of the fluid
    ledger.addFine(flow, source.solidFraction, source.force, deltaT);
    ledger.sumOver(comm_);
    return ledger;
}

void DualGridScheme::restrictFluid(const FineFlow& flow)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::restriction);
    restrictSums(parts_, flow, gravity_, cells, fluid);
    plan_.accumulate(fluid.data());
    for (int c = 0; c < cells.ownedCount(); ++c)
        finishAverages(fluid[c], cells.grid().cellVolume());
    plan_.update(fluid.data());
    for (CoarseField<double>* field : {&openVolume_, &solidWindow_, &openWater_, &openAir_, &fluidMass_})
        field->reset(cells);
    const double least = nothing * cells.grid().cellVolume();
    for (int c = 0; c < cells.count(); ++c) {
        const CoarseFluid& here = fluid[c];
        fluidMass_[c] = here.fluidMass;
        if (!here.hasFluid())
            continue;
        // The open volume, not the fluid's: spheres displace the fluid around them, and what is free of them elsewhere
        // would draw more than its share
        openVolume_[c] = here.openVolume;
        solidWindow_[c] = here.openVolume > least ? meshVolume_[c] : 0;
        openWater_[c] = here.openWater > least ? here.openWater : 0;
        openAir_[c] = here.openAir() > least ? here.openAir() : 0;
    }
}

/// In the cells around the particles only.
void DualGridScheme::findSurfaces(const ParticleView& particles)
{
    needed_.reset(cells, 0);
    for (std::size_t i = 0; i < particles.count; ++i) {
        for (const int cell : stencilOf(cells, particles.position[i]).cell)
            needed_[cell] = 1;
    }
    surface_.reset(cells);
    for (int c = 0; c < cells.count(); ++c) {
        if (needed_[c])
            surface_[c] = surfaceIn(filled_[c], fluid[c]);
    }
}

void DualGridScheme::place(const ParticleView& particles, Ledger& ledger)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::projection);
    findSurfaces(particles);
    places_.resize(particles.count);
    ledger.particles = std::int64_t(particles.count);
    for (std::size_t i = 0; i < particles.count; ++i) {
        homeOf(particles, i, cells); // refuses a particle that is not ours
        places_[i] = placeOf(particles, i);
        ledger.particleVolume += volumeOf(particles, i);
        ledger.dryParticles += !(places_[i].presence > 0);
    }
}

DualGridScheme::Place DualGridScheme::placeOf(const ParticleView& particles, std::size_t particle) const
{
    Place place;
    place.solid = place.wet = place.dry = place.mass = stencilOf(cells, particles.position[particle]);
    const double water = gather(place.wet, openWater_), air = gather(place.dry, openAir_);
    const bool inWater = reweigh(place.wet, openWater_), inAir = reweigh(place.dry, openAir_);
    reweigh(place.solid, solidWindow_);
    reweigh(place.mass, fluidMass_);
    const SphereShare share =
        shareOfSphere(particles.position[particle], particles.radius[particle], cells, filled_, fluid, surface_);
    place.presence = inWater || inAir ? share.inMesh : 0;
    place.wetShare = !inAir ? 1 : !inWater ? 0 : share.dry ? water / (water + air) : share.inWater;
    if (place.wetShare < nothing || place.wetShare > 1 - nothing)
        place.wetShare = std::round(place.wetShare);
    return place;
}

void DualGridScheme::project(const ParticleView& particles, Ledger& ledger)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::projection);
    spreadSpheres(particles, ledger);
    complete(spheres_);
    fitSolid(ledger);
    plan_.accumulate(impulse.data());
    placeImpulse(ledger);
    plan_.update(impulse.data());
}

void DualGridScheme::spreadSpheres(const ParticleView& particles, Ledger& ledger)
{
    spheres_.reset(cells);
    impulse.reset(cells);
    for (std::size_t i = 0; i < particles.count; ++i) {
        const Place& place = places_[i];
        const double volume = place.presence * volumeOf(particles, i);
        const double displaced = motionOf(particles, i).displacing * volume;
        ledger.absentVolume += volumeOf(particles, i) - displaced;
        for (int n = 0; n < 8; ++n) {
            Spheres& spheres = spheres_[place.solid.cell[n]];
            spheres.volume += place.solid.weight[n] * volume;
            spheres.displaced += place.solid.weight[n] * displaced;
        }
        if (!settings_.momentumExchange)
            continue;
        spread(place.mass, particles.impulse[i], impulse);
        ledger.received += particles.impulse[i];
        ledger.impulseScale += norm(particles.impulse[i]);
    }
}

/// The solid that fits below the smallest fluid fraction; the rest is clipped and listed. On every copy of a cell alike.
void DualGridScheme::fitSolid(Ledger& ledger)
{
    solidVolume.reset(cells);
    solidFraction_.reset(cells);
    for (int c = 0; c < cells.count(); ++c) {
        const double displaced = spheres_[c].displaced;
        const double room = (1 - settings_.smallestFluidFraction) * openVolume_[c];
        solidVolume[c] = std::min(displaced, room);
        if (solidVolume[c] > 0)
            solidFraction_[c] = solidVolume[c] / openVolume_[c];
        if (c >= cells.ownedCount())
            continue;
        ledger.coarseVolume += displaced;
        ledger.clippedVolume += displaced - solidVolume[c];
        ledger.clippedCells += displaced > room;
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

void DualGridScheme::prolongSolid(const FineFlow& flow, FineSource& source)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::prolongation);
    density_.resize(flow.count);
    for (std::size_t f = 0; f < flow.count; ++f)
        density_[f] = flow.open(f);
    solidProlongation_.shape(parts_, cells, solidFraction_, openVolume_, density_.data(), scalarMoment_);
    complete(scalarMoment_);
    solidProlongation_.spread(parts_, solidFraction_, openVolume_, density_.data(), scalarMoment_, 0,
                              1 - settings_.smallestFluidFraction, solidParts_);
    addToCells(parts_, solidParts_, source.solidFraction.data());
    for (std::size_t f = 0; f < flow.count; ++f) {
        if (source.solidFraction[f] > 0)
            source.solidFraction[f] /= flow.open(f) * flow.volume[f];
    }
}

void DualGridScheme::restrictLoads(const FineFlow& flow, Ledger& ledger)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::restriction);
    const PassiveForces passive{forces_.pressureGradient(), forces_.viscous(), gravity_};
    restrictLoad(parts_, flow, passive, solidParts_.data(), cells, load_);
    complete(load_);
    for (int c = 0; c < cells.ownedCount(); ++c)
        ledger.passiveCarried += load_[c].carried - load_[c].displaced * gravity_;
}

void DualGridScheme::interact(const ParticleView& particles, std::vector<Interaction>& replies, Ledger& ledger)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::forces);
    replies.assign(particles.count, Interaction{});
    forces_.withDrag([&](const auto& force) {
        for (std::size_t i = 0; i < particles.count; ++i) {
            if (!(places_[i].presence > 0))
                continue;
            replies[i] = force(flowAt(places_[i]), stateOf(particles, i, places_[i].presence), water_, air_);
            ledger.passiveReceived += replies[i].passiveForce;
            ledger.passiveScale += norm(replies[i].passiveForce);
        }
    });
}

/// ∇p in two parts: what moves the fluid, ∇p - ρ g, as wide as the kernel; the fluid's weight, ρ g, that of the fluid
/// which the sphere itself is in. As wide as the kernel, too, it would let the water hold up what is above it.
LocalFlow DualGridScheme::flowAt(const Place& place) const
{
    LocalFlow flow;
    flow.wetFraction = place.wetShare;
    if (place.wetShare > 0)
        flow.water = phaseAt(place.wet, &CoarseFluid::water);
    if (place.wetShare < 1)
        flow.air = phaseAt(place.dry, &CoarseFluid::air);
    flow.water.fluidFraction = flow.air.fluidFraction = 1 - gather(place.solid, solidFraction_);
    for (int n = 0; n < 8; ++n) {
        const CoarseFluid& cell = fluid[place.solid.cell[n]];
        flow.pressureGradient += place.solid.weight[n] * cell.pressureGradient;
        flow.viscousForce += place.solid.weight[n] * cell.viscousForce;
    }
    flow.pressureGradient += densityAt(place) * gravity_;
    return flow;
}

PhaseFlow DualGridScheme::phaseAt(const Stencil& window, CoarsePhase CoarseFluid::*phase) const
{
    PhaseFlow flow;
    double accelerated = 0;
    for (int n = 0; n < 8; ++n) {
        const CoarsePhase& cell = fluid[window.cell[n]].*phase;
        const double w = window.weight[n];
        flow.velocity += w * cell.velocity;
        flow.acceleration += w * cell.accelerated * cell.acceleration;
        accelerated += w * cell.accelerated;
        flow.vorticity += w * cell.vorticity;
    }
    if (accelerated > nothing)
        flow.acceleration *= 1 / accelerated;
    return flow;
}

/// Of the fluid in the sphere's place [kg/m3].
double DualGridScheme::densityAt(const Place& place) const
{
    return place.wetShare * water_.density + (1 - place.wetShare) * air_.density;
}

/// Is it free to follow the pressure?
bool DualGridScheme::answers(const ParticleView& particles, std::size_t particle) const
{
    return places_[particle].presence > 0 && motionOf(particles, particle).mass > 0;
}

void DualGridScheme::respond(const ParticleView& particles, double deltaT, std::vector<Interaction>& replies,
                             Ledger& ledger)
{
    if (!forces_.pressureGradient())
        return;
    const PhaseTimer::Scope scope(timer, PhaseTimer::forces);
    sums_.reset(cells);
    for (std::size_t i = 0; i < particles.count; ++i) {
        if (!answers(particles, i))
            continue;
        const Place& place = places_[i];
        const ResponseSums own =
            responseOf(stateOf(particles, i, place.presence), particles.motion[i], densityAt(place), replies[i]);
        spread(place.solid, own, sums_);
    }
    plan_.accumulate(sums_.data());
    response_.reset(cells);
    for (int c = 0; c < cells.ownedCount(); ++c) {
        if (sums_[c].volume > 0)
            response_[c] = pressureResponse(sums_[c], 1 - solidVolume[c] / fluid[c].openVolume, deltaT);
    }
    plan_.update(response_.data());
    for (std::size_t i = 0; i < particles.count; ++i) {
        if (!answers(particles, i))
            continue;
        const Vec3 force = places_[i].presence * volumeOf(particles, i) * gather(places_[i].solid, response_);
        replies[i].passiveForce += force;
        ledger.response += force;
    }
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
        const Stencil& window = places_[i].mass;
        for (int n = 0; n < 8; ++n) {
            Reaction& reaction = reaction_[window.cell[n]];
            reaction.drag += window.weight[n] * drag;
            reaction.dragMomentum += window.weight[n] * momentum;
            reaction.addedMass += window.weight[n] * mass;
        }
    }
    complete(reaction_);
}

/// What the particles of a cell get of ∇p - ρg and ∇·τ, less what the fluid's equations carry for them [N].
Vec3 DualGridScheme::returnedTo(int cell) const
{
    if (!settings_.momentumExchange)
        return {};
    Vec3 received;
    if (forces_.pressureGradient())
        received -= spheres_[cell].volume * fluid[cell].pressureGradient;
    if (forces_.viscous())
        received += spheres_[cell].volume * fluid[cell].viscousForce;
    return received - load_[cell].carried;
}

/// The rest of the weight, to all of the fluid by its mass.
void DualGridScheme::returnWeight(const ParticleView& particles, const FineFlow& flow, FineSource& source,
                                  Ledger& ledger) const
{
    if (!settings_.momentumExchange || !forces_.pressureGradient())
        return;
    double sums[2] = {0, 0}; // mass that the spheres displace less that which the fluid carries, mass of the fluid [kg]
    for (std::size_t i = 0; i < particles.count; ++i)
        sums[0] += places_[i].presence * volumeOf(particles, i) * densityAt(places_[i]);
    for (int c = 0; c < cells.ownedCount(); ++c)
        sums[0] -= load_[c].displaced;
    for (std::size_t f = 0; f < flow.count; ++f)
        sums[1] += flow.density[f] * flow.fluidFraction[f] * flow.volume[f];
    ledger.passiveReturned -= sums[0] * gravity_; // this rank's share
    sumOverRanks(sums, 2, comm_);
    const Vec3 acceleration = sums[1] > 0 ? sums[0] / sums[1] * gravity_ : Vec3{};
    for (std::size_t f = 0; f < flow.count; ++f)
        source.force[f] += flow.density[f] * flow.fluidFraction[f] * flow.volume[f] * acceleration;
}

void DualGridScheme::prolongForce(const FineFlow& flow, double deltaT, FineSource& source, Ledger& ledger)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::prolongation);
    for (std::size_t f = 0; f < flow.count; ++f)
        density_[f] = flow.density[f] * flow.fluidFraction[f];
    acceleration_.reset(cells);
    for (int c = 0; c < cells.count(); ++c) {
        if (!(fluidMass_[c] > 0))
            continue;
        const Vec3 returned = returnedTo(c);
        acceleration_[c] = (impulse[c] / deltaT + returned) * (-1 / fluidMass_[c]);
        if (c < cells.ownedCount())
            ledger.passiveReturned += returned;
    }
    forceProlongation_.shape(parts_, cells, acceleration_, fluidMass_, density_.data(), vectorMoment_);
    complete(vectorMoment_);
    const double none = std::numeric_limits<double>::infinity();
    forceProlongation_.spread(parts_, acceleration_, fluidMass_, density_.data(), vectorMoment_, -none, none,
                              forceParts_);
    addToCells(parts_, forceParts_, source.force.data());
}

/// By the share of the coarse cell's fluid mass, no slope: a coefficient must not be negative.
void DualGridScheme::prolongReaction(const FineFlow& flow, FineSource& source)
{
    const PhaseTimer::Scope scope(timer, PhaseTimer::prolongation);
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
