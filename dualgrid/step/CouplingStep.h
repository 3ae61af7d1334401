/// One exchange between particles and fluid. The algorithm on one page: advance() in CouplingStep.cpp.
///
///   restrict   fine mesh -> coarse grid: averages of water and air (2.24)
///   place      each sphere's share in the water, in the air and in the mesh (WaterSurface.h), its windows
///   spread     particles -> coarse grid: solid volume and impulse (trilinear, weights sum to one)
///   prolong    coarse grid -> fine mesh: αs, conservative per coarse cell
///   restrict   fine mesh -> coarse grid: what the fluid's equations carry for that αs, -αs∇p + αs∇·τ
///   forces     gather the coarse fluid at each particle, force laws -> replies
///   respond    how ∇p will answer to the particles' motion (PressureResponse.h)
///   prolong    coarse grid -> fine mesh: force on the fluid; drag and added mass of the coming step
///
/// Momentum (model A: S = -Σ (fd + fa)/V): the particles report the drag and added-mass impulse J that they really
/// received since the last exchange, and the fluid gets exactly the opposite. That alone comes two exchanges after the
/// velocity that caused it. Per fluid mass m, with κ = K Δt/m and χ = Ca αs/αf, λ³ - λ² + (κ+χ) λ - χ = 0: unstable in
/// dense particles. So the host adds a conservative prediction: in step k the fluid gets the impulse
///
///   G_k = -(J_k + P_k - P_{k-1}),   P_k = Δt ΣK (u - v) + Σ Ca ρf V (u - u_old), implicit in u, per fine cell,
///
/// where what was predicted is given back as what really happened arrives: Σ G = -Σ J - P_last, exact up to the one
/// amount held. (1+κ+χ) λ³ - (1+κ+2χ) λ² + (κ+2χ) λ - χ = 0 is stable for all κ, χ. FineSource has the coefficients;
/// they follow the stencils of J and, within a coarse cell, the fluid's mass.
/// Cost: O(particles x 8 + fine cells), fifteen small halo exchanges, Allreduces of 37 and 2 numbers. Buffers only
/// grow. Parallel: one object per fluid rank, every call is collective over the communicator. For one number of ranks
/// the result does not depend on how the particles came in; between numbers of ranks it differs by round-off only.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <mpi.h>

#include "CoarseGrid.h"
#include "CoarseState.h"
#include "CouplingSettings.h"
#include "FineSource.h"
#include "FluidOnGrid.h"
#include "ForcesOnParticles.h"
#include "Interaction.h"
#include "Ledger.h"
#include "Overlap.h"
#include "ParticlePlaces.h"
#include "ReactionOnFluid.h"
#include "Settings.h"
#include "SolidOnGrid.h"

namespace frazil
{

class DirectStep;

class CouplingStep
{
  public:
    /// Reads from the settings:
    ///   dualGrid          on (default) | off: each particle couples with the fine cell that holds its centre
    ///   kernel            trilinear (default) | centre: how a particle is spread over the coarse cells (Kernel.h)
    ///   prolongation      { exponent 2; limiter cell (default) | none; }   see Prolongation.h
    ///   voidFraction      { min 0.25; }  what would leave less fluid in a cell is clipped and listed in the ledger
    ///   forces            { ... }  see ForceModel.h
    ///   momentumExchange  on (default) | off: the fluid does not feel drag and added mass (one-way)
    /// @param gravity  [m/s2]
    /// @param comm     the fluid ranks; rank r owns the blocks of owner r of the grid
    CouplingStep(const Settings& settings, const CoarseGrid& grid, const Phase& water, const Phase& air,
                 const Vec3& gravity, MPI_Comm comm);
    ~CouplingStep();
    CouplingStep(const CouplingStep&) = delete;
    CouplingStep& operator=(const CouplingStep&) = delete;

    /// Is `dualGrid` on? If not, setLocator is needed besides setParts.
    bool dualGrid() const { return model_.settings.dualGrid; }
    /// The pieces of this rank's fine cells (Overlap.h). Call at the start and whenever the mesh changes.
    void setParts(const std::vector<FinePiece>& pieces);
    /// For `dualGrid off`: index of this rank's fine cell that holds a point, -1 if none does.
    void setLocator(std::function<int(const Vec3&)> fineCellAt);

    /// One exchange.
    /// @param particles  those whose centre lies in a coarse cell owned by this rank, sorted by id
    /// @param deltaT     the step that both programs are about to take [s]
    /// @param replies    out: one Interaction per particle, same order
    /// @param source     out: αs, force and the coefficients of the prediction for the coming step
    Ledger advance(const ParticleView& particles, const FineFlow& flow, double deltaT,
                   std::vector<Interaction>& replies, FineSource& source);

    /// Impulse that waits for fluid (restart): this rank's, and back, of any ranks.
    std::vector<CarriedImpulse> carried() const { return state_.waiting(); }
    void setCarried(const std::vector<CarriedImpulse>& waiting) { state_.setWaiting(waiting); }

    // Coarse fields of the last advance(), for output; ownedCount() own cells come first. dualGrid off: no fluid().
    const LocalCells& cells() const { return state_.cells; }
    /// Σ V_p in the cell, what was clipped excluded [m3]
    const CoarseField<double>& solidVolume() const { return state_.solidVolume; }
    const CoarseField<CoarseFluid>& fluid() const { return state_.fluid; }
    /// J: on the particles, to be given to the fluid in the coming step [N s]
    const CoarseField<Vec3>& impulse() const { return state_.impulse; }
    const PhaseTimer& timer() const { return state_.timer; }

  private:
    const CouplingModel model_;
    CoarseState state_;
    // The phases, in the order in which advance() asks them
    FluidOnGrid grid_;
    ParticlePlaces places_;
    SolidOnGrid solid_;
    ForcesOnParticles forces_;
    ReactionOnFluid reaction_;
    std::unique_ptr<DirectStep> direct_; ///< with `dualGrid off`, instead of them
};

} // namespace frazil
