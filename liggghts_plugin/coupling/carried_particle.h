/* What a particle of fix couple/foam carries from one exchange with the fluid to the next: it travels with the particle
   between ranks and through restart files. Doubles only, so that it can be copied as such. */

#ifndef FRAZIL_CARRIED_PARTICLE_H
#define FRAZIL_CARRIED_PARTICLE_H

#include "Interaction.h"
#include "Messages.h"

namespace frazil
{

struct CarriedParticle {
    Interaction fluid; ///< coefficients of the fluid force, from the last exchange
    Vec3 impulse;      ///< drag and added mass, received since the last exchange [N s]
    Vec3 reaction;     ///< drag and added-mass force of the last DEM step [N]
    Vec3 others;       ///< impulse of all other forces since the last exchange [N s]
    Vec3 path;         ///< way since the last exchange [m]
    Vec3 speed[2];     ///< mean velocity over the last fluid step and the one before [m/s]
    double age = 0;    ///< time in the coupling [s], for the ramp of inserted particles
    /// Where a fix prescribes a motion that accelerates: velocity of the last DEM step [m/s], and 1 if there was one.
    Vec3 velocity;
    double velocityKnown = 0;

    /// Share of its volume that an inserted particle displaces, over a ramp of this length [s].
    double displacing(double ramp) const { return age < ramp ? age / ramp : 1; }

    /// Adds to `motion` the force and the acceleration over the fluid step of `deltaT` [s] that ends, for the
    /// prediction of the particle's answer to the pressure, and begins the next step. The pressure that acts now was
    /// made by the step that ends, from the volume that moved in the step before; so its acceleration is the difference
    /// of the two mean velocities before the last.
    void endStep(double deltaT, ParticleMotion& motion)
    {
        motion.otherForce = others / deltaT;
        motion.reference = (speed[0] - speed[1]) / deltaT;
        speed[1] = speed[0];
        speed[0] = path / deltaT;
    }

    /// What has been told to the fluid counts anew.
    void clearSums() { impulse = others = path = Vec3(); }
};

static_assert(sizeof(CarriedParticle) % sizeof(double) == 0, "CarriedParticle is sent and stored as doubles");

} // namespace frazil

#endif
