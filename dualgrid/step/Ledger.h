/// What each grid holds of solid volume and of exchanged momentum after one step, and by how much they differ.
/// Sums over all fluid ranks, equal on every rank.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mpi.h>

#include "Vec3.h"

namespace frazil
{

struct FineFlow;

struct Ledger {
    // Solid volume [m3]: particles = coarse + absent, coarse = fine + clipped.
    double particleVolume = 0; ///< Σ V_p
    double absentVolume = 0;   ///< of it outside of the mesh, without fluid around, or not yet there (insertion)
    double coarseVolume = 0;   ///< Σ over the coarse cells
    double fineVolume = 0;     ///< Σ αs (1-γ) V over the fine mesh
    double clippedVolume = 0;  ///< did not fit below 1 - voidFraction.min

    // Impulse of drag and added mass [N s]: received + carriedIn = coarse, coarse = given + unplaced.
    Vec3 received;      ///< by the particles, since the last exchange
    Vec3 carriedIn;     ///< left over from the step before
    Vec3 coarseImpulse; ///< on the coarse grid after projection, carriedIn included
    Vec3 given; ///< to the fine mesh in the coming step, sign of the particles' (force on fluid = -given/Δt - returned)
    Vec3 unplaced; ///< in coarse cells without fluid, tried again next step
    /// Prediction that the fluid has got ahead and gives back in the coming step (CouplingStep.h), sign of the
    /// particles'. Set by the host after advance(), summed over the ranks already.
    Vec3 held;
    double impulseScale = 0; ///< Σ |impulse_p| + Σ |carried|, what the errors are relative to

    // Force of ∇p and ∇·τ at this exchange [N]: received = carried + returned.
    Vec3 passiveReceived;    ///< by the particles, over the coming step
    Vec3 passiveCarried;     ///< by the fluid's equations for the same αs, Σ αs (-∇p + ∇·τ) V
    Vec3 passiveReturned;    ///< the difference, cell by cell: the fluid gets minus that over the coming step
    Vec3 response;           ///< on the particles beside it: ∇p of the coming step (PressureResponse.h)
    double passiveScale = 0; ///< Σ |passive_p|
    double deltaT = 0;       ///< coming step [s]

    std::int64_t particles = 0;
    std::int64_t dryParticles = 0; ///< with no fluid in their whole stencil: they feel nothing
    std::int64_t clippedCells = 0; ///< coarse cells (dualGrid off: fine cells) with clipped volume

    /// Adds what the fine mesh of this rank got: αs, and the force [N] over the coming step. Call it last before sumOver.
    void addFine(const FineFlow& flow, const std::vector<double>& solidFraction, const std::vector<Vec3>& force,
                 double deltaT);
    /// Sums every entry over the ranks.
    void sumOver(MPI_Comm comm);

    double volumeErrorCoarse() const;  ///< |coarse + absent - particles| / particles
    double volumeErrorFine() const;    ///< |fine + clipped - coarse| / particles
    double impulseErrorCoarse() const; ///< |coarse - received - carriedIn| / scale
    double impulseErrorFine() const;   ///< |given + unplaced - coarse| / (scale + Δt passiveScale)
    double passiveError() const;       ///< |carried + returned - received| / scale

    /// Header and line of ledger.csv, without line end; time [s]. Columns: couplingProperties.md.
    static std::string csvHeader();
    std::string csvLine(double time) const;
};

} // namespace frazil
