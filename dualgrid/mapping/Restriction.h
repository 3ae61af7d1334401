/// Fine mesh -> coarse grid: averages over the fluid in each coarse cell (the study's equation 2.24).
///
///   φ_c = Σ φ_f ε_f V_part / Σ ε_f V_part    over the parts of fine cells that lie in the coarse cell,
///
/// with ε = αf (1-γ), so particles and bodies carry no weight. A fluid at rest has ∇p = ρ g in every fine cell, hence
/// exactly ρ_c g here: same weights for ρ and ∇p. Linear fields come out exact (value at the fluid's centroid).
/// Water and air keep means of their own (weights ε α1 and ε (1-α1)): under a wind still water is still.
/// What the fluid's equations carry for the solid, αs (-∇p + ∇·τ), is summed with the αs of the fine cells themselves
/// (SolidLoad). The particles are not given its mean by αs but that by ε: the former lets each fine structure of ∇p answer
/// the very particles that made it (tried: with bonds, differences of round-off grew by nine orders in 200 steps, by ε not).
/// Cost: one pass over the parts, 41 additions each. Parallel: partial sums per rank, then accumulate + update of the
/// halo (the caller does it), finishAverages() on the owned cells in between.
#pragma once

#include <algorithm>
#include <cstddef>

#include "CoarseField.h"
#include "FineParts.h"
#include "Vec3.h"

namespace frazil
{

/// Less fluid than this share of a coarse cell is round-off of the cutting: nothing is there. Not larger, so that crossing
/// it changes nothing but round-off.
constexpr double roundOffShare = 1e-14;

/// The host's fluid fields, one entry per fine cell of this rank.
struct FineFlow {
    std::size_t count = 0;
    const double* volume = nullptr;         ///< whole cell [m3]
    const double* fluidShare = nullptr;     ///< ε = αf (1-γ) [-]
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

    double wet(std::size_t cell) const { return std::clamp(wetFraction[cell], 0.0, 1.0); } ///< round-off of MULES
    double open(std::size_t cell) const { return openFraction ? openFraction[cell] : 1.0; }
    double accelerated(std::size_t cell) const { return accelerationShare ? accelerationShare[cell] : 1.0; }
};

/// Means of one of the two fluids in a coarse cell.
struct CoarsePhase {
    double volume = 0;      ///< Σ ε α V [m3]
    double accelerated = 0; ///< share of it whose Du/Dt is known [-]; here and below: sums, then averages
    Vec3 velocity;          ///< [m/s]
    Vec3 acceleration;      ///< Du/Dt [m/s2], mean over that share
    Vec3 vorticity;         ///< [1/s]
};

/// The fluid in one coarse cell. Doubles only: it travels through the halo as such.
struct CoarseFluid {
    double openVolume = 0;  ///< Σ (1-γ) V of the fine parts in the cell [m3]
    double openWater = 0;   ///< Σ α1 (1-γ) V [m3]
    Vec3 openMoment;        ///< Σ (1-γ) V x about the cell's centre [m4]
    Vec3 waterMoment;       ///< Σ α1 (1-γ) V x about the cell's centre [m4]
    double fluidVolume = 0; ///< Σ ε V [m3]
    double fluidMass = 0;   ///< Σ ρ ε V [kg]
    Vec3 pressureGradient;  ///< ∇p - ρ g, means over both fluids here and below [Pa/m]
    Vec3 viscousForce;      ///< ∇·τ [N/m3]
    CoarsePhase water, air;

    bool hasFluid() const { return fluidVolume > 0; }
    double openAir() const { return openVolume - openWater; } ///< [m3]
    /// α1 [-]
    double wetFraction() const { return hasFluid() ? water.volume / fluidVolume : 0; }
    /// Mean over both fluids [m/s]
    Vec3 velocity() const
    {
        return hasFluid() ? (water.volume * water.velocity + air.volume * air.velocity) / fluidVolume : Vec3{};
    }
    /// ρ_c [kg/m3]; 0 without fluid.
    double density() const { return hasFluid() ? fluidMass / fluidVolume : 0; }
};

/// What the fluid's equations carry for the solid in a coarse cell; the weight apart. Sums, doubles only.
struct SolidLoad {
    Vec3 carried;         ///< Σ αs (-∇p + ρ g + ∇·τ) V [N]
    double displaced = 0; ///< Σ αs ρ V [kg]
};

/// Which of the passive forces the particles feel, and gravity [m/s2]
struct PassiveForces {
    bool pressureGradient, viscous;
    Vec3 gravity;
};

/// Adds this rank's parts to the sums (the field is reset first).
void restrictSums(const FineParts& parts, const FineFlow& flow, const Vec3& gravity, const LocalCells& cells,
                  CoarseField<CoarseFluid>& sums);
/// Turns the complete sums of one coarse cell of `cellVolume` [m3] into averages; all zero if there is no fluid in it.
void finishAverages(CoarseFluid& cell, double cellVolume);

/// What the fluid carries of the solid.
/// @param solid  volume of the solid per part [m3]
void restrictLoad(const FineParts& parts, const FineFlow& flow, const PassiveForces& forces, const double* solid,
                  const LocalCells& cells, CoarseField<SolidLoad>& sums);

} // namespace frazil
