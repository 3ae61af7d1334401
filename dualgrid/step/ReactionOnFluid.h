/// What the particles do to the fluid: the impulse that they reported, what ∇p and ∇·τ gave them beyond what the fluid's
/// equations carry, and the coefficients of what they will do in the coming step.
///
/// What particles get of ∇p - ρg and ∇·τ, a mean over the coarse cell, and what the fluid's equations carry for their αs
/// differ by a few per cent, by the mapping and by clipped solid. The difference goes to the fluid, cell by cell.
/// The weight ρg is that of the fluid in the sphere's own place; the fluid carries αsρg, which is smeared over the
/// surface. The difference, a few per cent of the buoyancy of what floats, goes to the fluid as one acceleration for all
/// of it: along gravity, a slightly other weight, that leaves still water still. Cell by cell it would stir it.
/// Cost: two windows per particle, a pass over the parts each for load, force and coefficients, one prolongation.
/// Parallel: collective; halo exchanges of four fields, an Allreduce of 2 numbers.
#pragma once

#include <vector>

#include "CouplingSettings.h"
#include "FineSource.h"
#include "FluidOnGrid.h"
#include "Interaction.h"
#include "Ledger.h"
#include "ParticlePlaces.h"
#include "Prolongation.h"
#include "SolidOnGrid.h"

namespace frazil
{

/// Of the particles in a coarse cell. Doubles only: it travels through the halo as such.
struct DragAndAddedMass {
    double drag = 0;      ///< Σ K [kg/s]
    Vec3 dragMomentum;    ///< Σ K v [N]
    double addedMass = 0; ///< [kg]

    DragAndAddedMass& operator+=(const DragAndAddedMass& b)
    {
        drag += b.drag, dragMomentum += b.dragMomentum, addedMass += b.addedMass;
        return *this;
    }
};

inline DragAndAddedMass operator*(double share, const DragAndAddedMass& all)
{
    return {share * all.drag, share * all.dragMomentum, share * all.addedMass};
}

class ReactionOnFluid
{
  public:
    explicit ReactionOnFluid(const CouplingModel& model);

    /// particles -> coarse: the impulse of drag and added mass since the last exchange. In a cell without fluid it waits.
    void collectImpulse(const ParticleView& particles, const ParticlePlaces& places, FluidOnGrid& grid,
                        CoarseState& state, Ledger& ledger);
    /// fine -> coarse: what the fluid's equations carry for the solid
    void restrictLoad(const FineFlow& flow, const SolidOnGrid& solid, FluidOnGrid& grid, CoarseState& state,
                      Ledger& ledger);
    /// particles -> coarse: drag and added mass of the coming step
    void collectCoefficients(const ParticleView& particles, const ParticlePlaces& places,
                             const std::vector<Interaction>& replies, FluidOnGrid& grid, CoarseState& state);
    /// coarse -> fine: force on the fluid
    void prolongForce(const FineFlow& flow, double deltaT, const SolidOnGrid& solid, FluidOnGrid& grid,
                      CoarseState& state, FineSource& source, Ledger& ledger);
    /// coarse -> fine: drag and added mass, by the share of the coarse cell's fluid mass
    void prolongCoefficients(const FineFlow& flow, const FluidOnGrid& grid, CoarseState& state, FineSource& source);
    /// The rest of the weight, to all of the fluid by its mass.
    void returnWeight(const ParticleView& particles, const ParticlePlaces& places, const FineFlow& flow,
                      const FluidOnGrid& grid, const CoarseState& state, FineSource& source, Ledger& ledger) const;

  private:
    void placeImpulse(const FluidOnGrid& grid, CoarseState& state, Ledger& ledger);
    Vec3 returnedTo(int cell, const SolidOnGrid& solid, const CoarseField<CoarseFluid>& fluid) const;
    double weightToReturn(const ParticleView& particles, const ParticlePlaces& places, const CoarseState& state) const;

    const CouplingModel& model_;
    Prolongation<Vec3> prolongation_;
    CoarseField<SolidLoad> load_;
    CoarseField<Vec3> acceleration_, moment_; ///< of the fluid by the particles [m/s2], and its moment
    CoarseField<DragAndAddedMass> coefficients_;
    std::vector<double> density_; ///< ρ ε per fine cell [kg/m3]
    std::vector<Vec3> parts_;     ///< force per part [N]
};

} // namespace frazil
