/// The coupling through the coarse grid: the algorithm that CouplingStep.h describes.
///
/// Limit of the lag: the fluid answers an impulse two exchanges after the velocity that caused it. For one fluid cell
/// of mass m and Σ K = K_c that is u(k+2) = u(k+1) - (K_c Δt/m) u(k), stable for K_c Δt < m only. A particle's K is
/// therefore held below half of its share of the fluid mass, ρ αf V_p/αs, per Δt. In ordinary flow K is far below;
/// where it is not (a dense plate shot through, or a fluid step that is too long) the ledger counts the particles.
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
    void interact(const ParticleView& particles, double deltaT, std::vector<Interaction>& replies, Ledger& ledger);
    double largestDrag(const Stencil& stencil, double volume, double deltaT) const;
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
