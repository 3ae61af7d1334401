/// The particles' volume: spread over the coarse grid, fitted below the smallest fluid fraction, prolonged as αs.
///
///   V_c = Σ_p w_c(p) V_p,   αs_c = min(V_c, (1 - αf_min) V_open)/V_open;   what does not fit is clipped and listed
///
/// Within the coarse cell the prolonged αs leaves out what bodies fill.
/// Cost: 8 additions per particle, one prolongation. Parallel: collective, halo exchanges of two fields.
#pragma once

#include <vector>

#include "CouplingSettings.h"
#include "FineSource.h"
#include "FluidOnGrid.h"
#include "Ledger.h"
#include "ParticlePlaces.h"
#include "Prolongation.h"

namespace frazil
{

/// Volume of the spheres in a coarse cell [m3], before anything is clipped. Doubles only: it travels through the halo.
struct SphereVolume {
    double present = 0;   ///< what feels the fluid
    double displaced = 0; ///< of it, what the fluid gives way to (insertion)

    SphereVolume& operator+=(const SphereVolume& b)
    {
        present += b.present, displaced += b.displaced;
        return *this;
    }
};

inline SphereVolume operator*(double share, const SphereVolume& volume)
{
    return {share * volume.present, share * volume.displaced};
}

class SolidOnGrid
{
  public:
    explicit SolidOnGrid(const CouplingSettings& settings);

    /// particles -> coarse: state.solidVolume, fraction() and spheres()
    void project(const ParticleView& particles, const ParticlePlaces& places, FluidOnGrid& grid, CoarseState& state,
                 Ledger& ledger);
    /// coarse -> fine: αs
    void prolong(const FineFlow& flow, FluidOnGrid& grid, CoarseState& state, FineSource& source);

    const CoarseField<SphereVolume>& spheres() const { return spheres_; }
    /// αs of the open volume [-]
    const CoarseField<double>& fraction() const { return fraction_; }
    /// Volume of the solid per part of the fine cells [m3].
    const std::vector<double>& parts() const { return parts_; }

  private:
    void spreadSpheres(const ParticleView& particles, const ParticlePlaces& places, const LocalCells& cells,
                       Ledger& ledger);
    void fit(const FluidOnGrid& grid, CoarseState& state, Ledger& ledger);

    const double largest_; ///< αs never rises above [-]
    Prolongation<double> prolongation_;
    CoarseField<SphereVolume> spheres_;
    CoarseField<double> fraction_, moment_;
    std::vector<double> parts_, open_; ///< open: share of each fine cell that bodies leave [-]
};

} // namespace frazil
