#include "CouplingStep.h"

#include "DirectStep.h"
#include "Sum.h"

namespace frazil
{

CouplingStep::CouplingStep(const Settings& settings, const CoarseGrid& grid, const Phase& water, const Phase& air,
                           const Vec3& gravity, MPI_Comm comm)
    : model_{CouplingSettings::read(settings), ForceModel(settings.sub("forces")), water, air, gravity},
      state_(LocalCells(grid, rankIn(comm))), grid_(state_.cells, comm), places_(model_.settings.kernel),
      solid_(model_.settings), forces_(model_), reaction_(model_)
{
    if (!dualGrid())
        direct_ = std::make_unique<DirectStep>(model_, state_, comm);
}

CouplingStep::~CouplingStep() = default;

void CouplingStep::setParts(const std::vector<FinePiece>& pieces)
{
    if (direct_)
        direct_->setParts(pieces);
    else
        grid_.setParts(pieces, state_);
}

void CouplingStep::setLocator(std::function<int(const Vec3&)> fineCellAt)
{
    if (direct_)
        direct_->setLocator(std::move(fineCellAt));
}

Ledger CouplingStep::advance(const ParticleView& particles, const FineFlow& flow, double deltaT,
                             std::vector<Interaction>& replies, FineSource& source)
{
    if (direct_)
        return direct_->advance(particles, flow, deltaT, replies, source);

    Ledger ledger;
    source.reset(flow.count);

    // Where everything is
    grid_.restrictFluid(flow, model_.gravity, state_);         // fine -> coarse: averages of water and air
    places_.find(particles, grid_, state_, ledger);            // particles: shares in water, air, mesh; windows
    solid_.project(particles, places_, grid_, state_, ledger); // particles -> coarse: solid volume
    solid_.prolong(flow, grid_, state_, source);               // coarse -> fine: αs

    // What the fluid does to the particles
    forces_.act(particles, places_, solid_, state_, replies, ledger);            // coarse -> particles: force laws
    forces_.respond(particles, places_, deltaT, grid_, state_, replies, ledger); // answer of ∇p to their motion

    // What the particles do to the fluid
    reaction_.collectImpulse(particles, places_, grid_, state_, ledger);       // particles -> coarse: J
    reaction_.restrictLoad(flow, solid_, grid_, state_, ledger);               // fine -> coarse: -αs∇p + αs∇·τ
    reaction_.collectCoefficients(particles, places_, replies, grid_, state_); // particles -> coarse: K, Ca
    reaction_.prolongForce(flow, deltaT, solid_, grid_, state_, source, ledger);     // coarse -> fine: force
    reaction_.prolongCoefficients(flow, grid_, state_, source);                      // coarse -> fine: K, Ca
    reaction_.returnWeight(particles, places_, flow, grid_, state_, source, ledger); // to all of the fluid

    ledger.addFine(flow, source.solidFraction, source.force, deltaT);
    ledger.sumOver(grid_.comm);
    return ledger;
}

} // namespace frazil
