/// The coupling through the coarse grid: the algorithm that CouplingStep.h describes.
#pragma once

#include "CouplingScheme.h"
#include "ExchangePlan.h"
#include "Kernel.h"

namespace frazil
{

class DualGridScheme : public CouplingScheme
{
  public:
    DualGridScheme(const CouplingSettings& settings, ForceModel forces, const Phase& water, const Phase& air,
                   const CoarseGrid& grid, MPI_Comm comm);

    void setParts(const std::vector<FinePiece>& pieces) override;
    void setLocator(std::function<int(const Vec3&)>) override {} ///< not needed: the parts say where fine cells are
    Ledger advance(const ParticleView& particles, const FineFlow& flow, double deltaT,
                   std::vector<Interaction>& replies, FineSource& source) override;

  private:
    void restrictFluid(const FineFlow& flow);
    void project(const ParticleView& particles, Ledger& ledger);
    void spreadParticles(const ParticleView& particles, Ledger& ledger);
    void fitSolid(Ledger& ledger);
    void placeImpulse(Ledger& ledger);
    void interact(const ParticleView& particles, std::vector<Interaction>& replies);
    LocalFlow flowAt(const Stencil& stencil) const;
    void prolong(const FineFlow& flow, double deltaT, FineSource& source);
    void prolongSolid(const FineFlow& flow, FineSource& source);
    void prolongForce(const FineFlow& flow, double deltaT, FineSource& source);

    /// Every rank's contributions to the owner, the owner's sum to every copy.
    template <class T> void complete(CoarseField<T>& field)
    {
        plan_.accumulate(field.data());
        plan_.update(field.data());
    }

    MPI_Comm comm_;
    ExchangePlan plan_;
    FineParts parts_;
    Prolongation<double> solidProlongation_;
    Prolongation<Vec3> forceProlongation_;

    CoarseField<double> openVolume_;    ///< [m3]
    CoarseField<double> fluidMass_;     ///< [kg]
    CoarseField<double> solidFraction_; ///< αs of the open volume [-]
    CoarseField<Vec3> acceleration_;    ///< of the fluid by the particles [m/s2]
    CoarseField<double> scalarMoment_;
    CoarseField<Vec3> vectorMoment_;
    std::vector<Vec3> carried_;     ///< per owned cell: impulse that found no fluid yet [N s]
    std::vector<Stencil> stencils_; ///< per particle, weighted by open volume
    std::vector<char> dry_;         ///< per particle: no fluid in the stencil
    std::vector<double> density_;   ///< per fine cell: what a prolonged value is per, 1/m3 of it
};

} // namespace frazil
