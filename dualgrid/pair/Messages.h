/// What the two programs say to each other. Plain structs of doubles, sent as bytes between equal machines.
#pragma once

#include <cstdint>

#include "Interaction.h"
#include "ParticleView.h"
#include "Rotation.h"
#include "Vec3.h"

namespace frazil
{

/// One particle on its way from frazilDem to the fluid rank that owns its coarse cell.
struct ParticleRecord {
    std::int64_t id = 0;
    Vec3 position;        ///< [m]
    Vec3 velocity;        ///< [m/s]
    Vec3 angularVelocity; ///< [rad/s]
    Vec3 impulse;         ///< drag and added-mass impulse received since the last exchange [N s]
    double radius = 0;    ///< [m]
    double exposure = 1;  ///< [-]
    ParticleMotion motion;
};

/// The reply for one particle, in the order of the records.
using ParticleReply = Interaction;

/// frazilFoam's order for the step that both now take.
struct StepOrder {
    double time = 0;           ///< fluid time at the start of the step [s]
    double deltaT = 0;         ///< fluid time step [s], substeps × DEM time step
    std::int64_t substeps = 0; ///< DEM steps in it
    std::int64_t finish = 0;   ///< 1: the fluid has reached its end, no step follows
    std::int64_t written = 0;  ///< 1: fields were written at `time`, so frazilDem writes a restart file
    double waited = 0;         ///< wall time that frazilFoam has waited for frazilDem so far [s]
};

/// frazilDem's report at the start of a fluid step.
struct StepReport {
    double time = 0;        ///< DEM time [s]
    double solidVolume = 0; ///< Σ V_p over all particles of the group [m3]
    Vec3 impulse;           ///< Σ impulse over them, lost ones included [N s]
    Vec3 momentum;          ///< Σ m v over them [N s]
    std::int64_t particles = 0;
    std::int64_t finish = 0; ///< 1: frazilDem has reached its end, no step follows
};

/// State of a rigid body at the start of a fluid step.
struct BodyState {
    char name[64] = {};
    Vec3 centre;            ///< centre of mass [m]
    Vec3 velocity;          ///< [m/s]
    Vec3 angularVelocity;   ///< [rad/s]
    Quaternion orientation; ///< from the surface as first loaded to now
    Vec3 centroidOffset;    ///< centroid of the closed surface minus centre of mass, initial orientation [m]
};

/// What the fluid does to the body over a step.
struct BodyLoad {
    Vec3 force;                ///< [N], buoyancy included
    Vec3 torque;               ///< about the centre of mass [N m]
    double submergedShare = 0; ///< share of the body's volume below water [-]
    char name[64] = {};        ///< of the BodyState: the two programs list their bodies in orders of their own
};

} // namespace frazil
