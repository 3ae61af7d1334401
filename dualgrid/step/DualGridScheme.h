/// The coupling through the coarse grid: the algorithm that CouplingStep.h describes.
#pragma once

#include "CouplingScheme.h"
#include "ExchangePlan.h"
#include "Kernel.h"
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
    void restrictFluid(const FineFlow& flow);
    void findSurfaces();
    void project(const ParticleView& particles, Ledger& ledger);
    void spreadParticles(const ParticleView& particles, Ledger& ledger);
    void fitSolid(Ledger& ledger);
    void placeImpulse(Ledger& ledger);
    void interact(const ParticleView& particles, std::vector<Interaction>& replies);
    LocalFlow flowAt(const ParticleView& particles, std::size_t particle) const;
    double densityAt(const ParticleView& particles, std::size_t particle, double wetFraction) const;
    void spreadReaction(const ParticleView& particles, const std::vector<Interaction>& replies);
    void prolong(const FineFlow& flow, double deltaT, FineSource& source);
    void prolongSolid(const FineFlow& flow, FineSource& source);
    void prolongForce(const FineFlow& flow, double deltaT, FineSource& source);
    void prolongReaction(const FineFlow& flow, FineSource& source);

    /// A particle's window on the coarse grid, by what it is needed for.
    struct Windows {
        Stencil solid; ///< weighted by open volume: where its volume goes
        Stencil flow;  ///< by open volume, cells without fluid left out: where it sees the flow
        Stencil mass;  ///< by fluid mass: where its reaction goes; at the surface the water, not the air above it
        bool dry;      ///< no fluid in it
    };
    /// Of the particles in a coarse cell. Doubles only: it travels through the halo as such.
    struct Reaction {
        double drag = 0;      ///< Σ K [kg/s]
        Vec3 dragMomentum;    ///< Σ K v [N]
        double addedMass = 0; ///< [kg]
    };

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

    CoarseField<double> openVolume_; ///< [m3]
    CoarseField<double> flowVolume_; ///< open volume of the cells that hold fluid [m3]
    CoarseField<double> fluidMass_;  ///< [kg]
    CoarseField<WaterSurface> surface_;
    CoarseField<double> solidFraction_; ///< αs of the open volume [-]
    CoarseField<Vec3> acceleration_;    ///< of the fluid by the particles [m/s2]
    CoarseField<double> scalarMoment_;
    CoarseField<Vec3> vectorMoment_;
    CoarseField<Reaction> reaction_;
    std::vector<Vec3> carried_;    ///< per owned cell: impulse that found no fluid yet [N s]
    std::vector<Windows> windows_; ///< per particle
    std::vector<double> density_;  ///< per fine cell: what a prolonged value is per, 1/m3 of it
};

} // namespace frazil
