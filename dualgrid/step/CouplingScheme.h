/// What the two ways of coupling (dual grid, direct) have in common: their interface and the fields they leave behind.
#pragma once

#include <functional>
#include <vector>

#include "CoarseField.h"
#include "ForceModel.h"
#include "Ledger.h"
#include "ParticleView.h"
#include "PhaseTimer.h"
#include "PressureResponse.h"
#include "Prolongation.h"
#include "Restriction.h"

namespace frazil
{

/// Output of the coupling on the fine mesh, one entry per fine cell of this rank.
struct FineSource {
    std::vector<double> solidFraction; ///< αs [-], of the volume that is open to fluid: αf = 1 - αs
    std::vector<Vec3> force;           ///< on the fluid [N]; divide by the cell's volume for S [N/m3]

    // What the particles in the cell will do to it in the coming step, for the prediction (CouplingStep.h).
    std::vector<double> drag;       ///< Σ K [kg/s]
    std::vector<Vec3> dragVelocity; ///< Σ K v / Σ K [m/s], zero without drag
    std::vector<double> addedMass;  ///< Σ Ca ρf V [kg]

    void reset(std::size_t fineCells)
    {
        solidFraction.assign(fineCells, 0.0);
        force.assign(fineCells, Vec3{});
        drag.assign(fineCells, 0.0);
        dragVelocity.assign(fineCells, Vec3{});
        addedMass.assign(fineCells, 0.0);
    }
    /// While summing, dragVelocity holds Σ K v [N].
    void addReaction(std::size_t cell, double k, const Vec3& momentum, double mass)
    {
        drag[cell] += k;
        dragVelocity[cell] += momentum;
        addedMass[cell] += mass;
    }
    void finishReaction()
    {
        for (std::size_t f = 0; f < drag.size(); ++f) {
            if (drag[f] > 0)
                dragVelocity[f] *= 1 / drag[f];
        }
    }
};

/// Impulse that waits in a coarse cell without fluid.
struct CarriedImpulse {
    std::int64_t cell; ///< global id
    Vec3 impulse;      ///< [N s]
};

struct CouplingSettings {
    ProlongationSettings prolongation;
    double smallestFluidFraction = 0.25; ///< αf never falls below [-]
    bool momentumExchange = true;        ///< off: the fluid does not feel drag and added mass
};

class CouplingScheme
{
  public:
    CouplingScheme(const CouplingSettings& settings, ForceModel forces, const Phase& water, const Phase& air,
                   LocalCells cells)
        : cells(std::move(cells)), settings_(settings), forces_(std::move(forces)), water_(water), air_(air),
          carried_(this->cells.ownedCount())
    {
    }
    virtual ~CouplingScheme() = default;

    virtual void setParts(const std::vector<FinePiece>& pieces) = 0;
    virtual void setLocator(std::function<int(const Vec3&)> fineCellAt) = 0;
    virtual Ledger advance(const ParticleView& particles, const FineFlow& flow, double deltaT,
                           std::vector<Interaction>& replies, FineSource& source) = 0;

    /// What waits in this rank's cells, for a restart file; and back from there, any cells.
    std::vector<CarriedImpulse> carried() const
    {
        std::vector<CarriedImpulse> waiting;
        for (int c = 0; c < cells.ownedCount(); ++c) {
            if (norm(carried_[c]) > 0)
                waiting.push_back({cells.global(c), carried_[c]});
        }
        return waiting;
    }
    void setCarried(const std::vector<CarriedImpulse>& waiting)
    {
        for (const CarriedImpulse& one : waiting) {
            const int c = cells.local(one.cell);
            if (c >= 0 && c < cells.ownedCount())
                carried_[c] = one.impulse;
        }
    }

    LocalCells cells;
    CoarseField<double> solidVolume; ///< [m3]
    CoarseField<CoarseFluid> fluid;
    CoarseField<Vec3> impulse; ///< on the particles [N s]
    PhaseTimer timer;

  protected:
    const CouplingSettings settings_;
    const ForceModel forces_;
    const Phase water_, air_;
    std::vector<Vec3> carried_; ///< per owned cell: impulse that found no fluid yet [N s]
};

inline double volumeOf(double radius)
{
    return 4.0 / 3 * 3.14159265358979323846 * radius * radius * radius;
}

inline double volumeOf(const ParticleView& particles, std::size_t i)
{
    return volumeOf(particles.radius[i]);
}

/// State of particle i for the force laws; presence: share of its volume that the fluid feels [-].
inline ParticleState stateOf(const ParticleView& particles, std::size_t i, double presence)
{
    return {particles.velocity[i], particles.angularVelocity[i], particles.radius[i], particles.exposure[i], presence};
}

inline ParticleMotion motionOf(const ParticleView& particles, std::size_t i)
{
    return particles.motion ? particles.motion[i] : ParticleMotion{};
}

/// A particle's part in the sums of PressureResponse.h.
/// @param density  of the fluid that it displaces [kg/m3]
inline ResponseSums responseOf(const ParticleState& state, const ParticleMotion& motion, double density,
                               const Interaction& force)
{
    const double volume = state.presence * volumeOf(state.radius);
    const Vec3 drive = motion.otherForce + force.passiveForce +
                       force.dragCoefficient * (force.fluidVelocity - state.velocity) +
                       force.addedMass * force.fluidAcceleration;
    return {volume,           motion.mass, force.addedMass,          force.dragCoefficient,
            density * volume, drive,       volume * motion.reference};
}

} // namespace frazil
