/// Fine mesh -> coarse grid: averages over the fluid in each coarse cell (the study's equation 2.24).
///
///   φ_c = Σ φ_f ε_f V_part / Σ ε_f V_part    over the parts of fine cells that lie in the coarse cell,
///
/// with ε = αf (1-γ), so particles and bodies carry no weight. A fluid at rest has ∇p = ρ g in every fine cell, hence
/// exactly ρ_c g here: same weights for ρ and ∇p. Linear fields come out exact (value at the fluid's centroid).
/// Cost: one pass over the parts, 29 additions each. Parallel: partial sums per rank, then accumulate + update of the
/// halo (the caller does it), finishAverages() on the owned cells in between.
#pragma once

#include <cstddef>

#include "CoarseField.h"
#include "FineParts.h"
#include "Vec3.h"

namespace frazil
{

/// The host's fluid fields, one entry per fine cell of this rank.
struct FineFlow {
    std::size_t count = 0;
    const double* volume = nullptr;         ///< whole cell [m3]
    const double* fluidFraction = nullptr;  ///< ε = αf (1-γ) [-]
    const double* openFraction = nullptr;   ///< 1-γ, share not filled by bodies [-]; nullptr: 1 everywhere
    const double* density = nullptr;        ///< ρ of the fluid mixture [kg/m3]
    const double* wetFraction = nullptr;    ///< α1 [-]
    const Vec3* velocity = nullptr;         ///< u [m/s]
    const Vec3* pressureGradient = nullptr; ///< ∇p of the total pressure [Pa/m]
    const Vec3* viscousForce = nullptr;     ///< ∇·τ [N/m3]
    const Vec3* acceleration = nullptr;     ///< Du/Dt [m/s2]
    const Vec3* vorticity = nullptr;        ///< ∇×u [1/s]
    /// Weight of the cell in the mean of Du/Dt [-], 0 where a body sets u; nullptr: 1 everywhere
    const double* accelerationShare = nullptr;

    double open(std::size_t cell) const { return openFraction ? openFraction[cell] : 1.0; }
    double accelerated(std::size_t cell) const { return accelerationShare ? accelerationShare[cell] : 1.0; }
};

/// The fluid in one coarse cell. Doubles only: it travels through the halo as such.
struct CoarseFluid {
    double openVolume = 0;  ///< Σ (1-γ) V of the fine parts in the cell [m3]
    double openWater = 0;   ///< Σ α1 (1-γ) V [m3]
    Vec3 openMoment;        ///< Σ (1-γ) V x about the cell's centre [m4]
    Vec3 waterMoment;       ///< Σ α1 (1-γ) V x about the cell's centre [m4]
    double fluidVolume = 0; ///< Σ ε V [m3]
    double fluidMass = 0;   ///< Σ ρ ε V [kg]
    double accelerated = 0; ///< share of the fluid whose Du/Dt is known [-]; here and below: sums, then averages
    double wetFraction = 0; ///< α1 [-]
    Vec3 velocity;          ///< [m/s]
    Vec3 pressureGradient;  ///< [Pa/m]
    Vec3 viscousForce;      ///< [N/m3]
    Vec3 acceleration;      ///< [m/s2], mean over that share
    Vec3 vorticity;         ///< [1/s]

    bool hasFluid() const { return fluidVolume > 0; }
    /// ρ_c [kg/m3]; 0 without fluid.
    double density() const { return hasFluid() ? fluidMass / fluidVolume : 0; }
};

/// Adds this rank's parts to the sums (the field is reset first).
void restrictSums(const FineParts& parts, const FineFlow& flow, const LocalCells& cells,
                  CoarseField<CoarseFluid>& sums);
/// Turns the complete sums of one coarse cell of `cellVolume` [m3] into averages; all zero if there is no fluid in it.
void finishAverages(CoarseFluid& cell, double cellVolume);

} // namespace frazil
