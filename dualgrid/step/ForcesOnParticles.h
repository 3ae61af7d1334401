/// What the fluid does to the particles: the force laws in the flow that each sees, and how ∇p will answer their motion.
///
/// ∇p comes in two parts: what moves the fluid, ∇p - ρ g, as wide as the kernel; the fluid's weight, ρ g, that of the
/// fluid which the sphere itself is in. As wide as the kernel, too, it would let the water hold up what is above it.
/// Cost: per particle three windows and the law; the answer of ∇p some 40 operations per coarse cell. Parallel: act()
/// is local, respond() collective with two halo exchanges.
#pragma once

#include <vector>

#include "CouplingSettings.h"
#include "FluidOnGrid.h"
#include "Interaction.h"
#include "Ledger.h"
#include "ParticlePlaces.h"
#include "PressureResponse.h"
#include "SolidOnGrid.h"

namespace frazil
{

class ForcesOnParticles
{
  public:
    explicit ForcesOnParticles(const CouplingModel& model) : model_(model) {}

    /// coarse -> particles: local flow, force laws
    void act(const ParticleView& particles, const ParticlePlaces& places, const SolidOnGrid& solid, CoarseState& state,
             std::vector<Interaction>& replies, Ledger& ledger) const;
    /// Adds the part of ∇p that the particles' coming motion will make (PressureResponse.h).
    void respond(const ParticleView& particles, const ParticlePlaces& places, double deltaT, FluidOnGrid& grid,
                 CoarseState& state, std::vector<Interaction>& replies, Ledger& ledger);

  private:
    LocalFlow flowAt(const Place& place, const CoarseField<CoarseFluid>& fluid,
                     const CoarseField<double>& solidFraction) const;
    void sumResponse(const ParticleView& particles, const ParticlePlaces& places, const CoarseState& state,
                     const std::vector<Interaction>& replies);

    const CouplingModel& model_;
    CoarseField<ResponseSums> sums_;
    CoarseField<Vec3> response_; ///< R/V [N/m3]
};

} // namespace frazil
