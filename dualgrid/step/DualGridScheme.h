/// The coupling through the coarse grid: the algorithm that CouplingStep.h describes.
///
/// Volume is spread over the mesh's volume, whichever fluid is in it, and whether or not a body is: αs must not move because
/// they do. Within the coarse cell it leaves the body out. Flow is
/// read from each fluid by itself, weighted by the share of the sphere that is in it (WaterSurface.h).
/// What particles get of ∇p - ρg and ∇·τ, a mean over the coarse cell, and what the fluid's equations carry for their αs
/// differ by a few per cent, by the mapping and by clipped solid. The difference goes to the fluid, cell by cell.
/// The weight ρg is that of the fluid in the sphere's own place; the fluid carries αsρg, which is smeared over the surface.
/// The difference, a few per cent of the buoyancy of what floats, goes to the fluid as one acceleration for all of it:
/// along gravity, a slightly other weight, that leaves still water still. Cell by cell it would stir it.
#pragma once

#include "CouplingScheme.h"
#include "ExchangePlan.h"
#include "Kernel.h"
#include "PressureResponse.h"
#include "WaterSurface.h"

namespace frazil
{

class DualGridScheme : public CouplingScheme
{
  public:
    DualGridScheme(const CouplingSettings& settings, ForceModel forces, const Phase& water, const Phase& air,
                   const Vec3& gravity, const CoarseGrid& grid, MPI_Comm comm);

    void setParts(const std::vector<FinePiece>& pieces) override;
    void setLocator(std::function<int(const Vec3&)>) override {} ///< not needed: the parts say where fine cells are
    Ledger advance(const ParticleView& particles, const FineFlow& flow, double deltaT,
                   std::vector<Interaction>& replies, FineSource& source) override;

  private:
    /// A particle on the coarse grid.
    struct Place {
        Stencil solid;   ///< weighted by volume: where its own volume is
        Stencil wet;     ///< by open water: where its share in the water sees the flow
        Stencil dry;     ///< by open air
        Stencil mass;    ///< by fluid mass: where its reaction goes; at the surface the water, not the air above it
        double wetShare; ///< of the sphere [-]
        double presence; ///< share of its volume that is in the mesh [-]; 0: it finds no fluid
    };
    /// Volume of the spheres in a coarse cell [m3], before anything is clipped. Doubles only, as below.
    struct Spheres {
        double volume = 0;    ///< what feels the fluid
        double displaced = 0; ///< of it, what the fluid gives way to (insertion)
    };
    /// Of the particles in a coarse cell. Doubles only: it travels through the halo as such.
    struct Reaction {
        double drag = 0;      ///< Σ K [kg/s]
        Vec3 dragMomentum;    ///< Σ K v [N]
        double addedMass = 0; ///< [kg]
    };

    void restrictFluid(const FineFlow& flow);
    void findSurfaces(const ParticleView& particles);
    void place(const ParticleView& particles, Ledger& ledger);
    Place placeOf(const ParticleView& particles, std::size_t particle) const;
    void project(const ParticleView& particles, Ledger& ledger);
    void spreadSpheres(const ParticleView& particles, Ledger& ledger);
    void fitSolid(Ledger& ledger);
    void placeImpulse(Ledger& ledger);
    void restrictLoads(const FineFlow& flow, Ledger& ledger);
    void interact(const ParticleView& particles, std::vector<Interaction>& replies, Ledger& ledger);
    LocalFlow flowAt(const Place& place) const;
    PhaseFlow phaseAt(const Stencil& window, CoarsePhase CoarseFluid::*phase) const;
    double densityAt(const Place& place) const;
    bool answers(const ParticleView& particles, std::size_t particle) const;
    void respond(const ParticleView& particles, double deltaT, std::vector<Interaction>& replies, Ledger& ledger);
    void spreadReaction(const ParticleView& particles, const std::vector<Interaction>& replies);
    Vec3 returnedTo(int cell) const;
    void prolongSolid(const FineFlow& flow, FineSource& source);
    void prolongForce(const FineFlow& flow, double deltaT, FineSource& source, Ledger& ledger);
    void prolongReaction(const FineFlow& flow, FineSource& source);
    void returnWeight(const ParticleView& particles, const FineFlow& flow, FineSource& source, Ledger& ledger) const;

    /// Every rank's contributions to the owner, the owner's sum to every copy.
    template <class T> void complete(CoarseField<T>& field)
    {
        plan_.accumulate(field.data());
        plan_.update(field.data());
    }

    const Vec3 gravity_; ///< [m/s2]
    MPI_Comm comm_;
    ExchangePlan plan_;
    FineParts parts_;
    Prolongation<double> solidProlongation_;
    Prolongation<Vec3> forceProlongation_;

    CoarseField<Box> filled_;                              ///< part of each cell that is in the mesh
    CoarseField<double> meshVolume_;                       ///< of it [m3]
    CoarseField<double> solidWindow_;                      ///< meshVolume_ of the cells that hold fluid [m3]
    CoarseField<double> openVolume_, openWater_, openAir_; ///< of the cells that hold fluid [m3]
    CoarseField<Spheres> spheres_;
    CoarseField<double> solidFraction_; ///< αs of the open volume [-]
    std::vector<double> solidParts_;    ///< volume of the solid per part [m3]
    CoarseField<double> fluidMass_;     ///< [kg]
    CoarseField<WaterSurface> surface_;
    CoarseField<char> needed_; ///< cells whose surface a sphere asks for
    CoarseField<SolidLoad> load_;
    CoarseField<ResponseSums> sums_;
    CoarseField<Vec3> response_;     ///< R/V [N/m3]
    CoarseField<Vec3> acceleration_; ///< of the fluid by the particles [m/s2]
    CoarseField<double> scalarMoment_;
    CoarseField<Vec3> vectorMoment_;
    CoarseField<Reaction> reaction_;
    std::vector<Place> places_;    ///< per particle
    std::vector<double> density_;  ///< per fine cell: what a prolonged value is per, 1/m3 of it
    std::vector<Vec3> forceParts_; ///< per part [N]
};

} // namespace frazil
