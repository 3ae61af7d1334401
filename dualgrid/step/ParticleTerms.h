/// Small questions that both ways of coupling ask: where a particle is, how the force laws see it, which coarse cells the
/// fine cells touch.
#pragma once

#include <cstdint>
#include <vector>

#include "Interaction.h"
#include "LocalCells.h"
#include "LocalFlow.h"
#include "Overlap.h"
#include "ParticleView.h"
#include "PressureResponse.h"
#include "Sphere.h"

namespace frazil
{

/// Owned local cell that holds particle i. InputError, naming the particle and the cure, if this rank does not own it.
int homeOf(const ParticleView& particles, std::size_t i, const LocalCells& cells);

/// Global ids of the coarse cells with pieces, ascending, each once.
std::vector<std::int64_t> touchedCells(const std::vector<FinePiece>& pieces);

/// [m3]
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
