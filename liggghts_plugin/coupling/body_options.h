/* What the user says of a rigid body: the words behind `body/rigid`, read and checked, and the motion that they start.
   SI. */

#ifndef FRAZIL_BODY_OPTIONS_H
#define FRAZIL_BODY_OPTIONS_H

#include "ClosedSurface.h"
#include "RigidMotion.h"
#include "Settings.h"

#include <string>

namespace frazil
{

struct BodyOptions {
    std::string mesh;             ///< ID of the surface's fix
    double density = 0, mass = 0; ///< [kg/m3], [kg]; 0: not given
    Vec3 velocity, omega;         ///< at the start [m/s], [rad/s]
    Vec3 com;                     ///< centre of mass [m], if hasCom
    Inertia inertia{};            ///< about the centre of mass [kg m2], if hasInertia
    bool hasCom = false, hasInertia = false;
    bool lock[6] = {false, false, false, false, false, false}; ///< x y z rx ry rz

    /// InputError on the first value that is missing or makes no sense.
    explicit BodyOptions(const Settings& words);

  private:
    void readInertia(const Settings& words);
    void readLock(const Settings& words);
};

/// At the start of the run. solid: of the surface, filled with the density (1 kg/m3 where only the mass is given).
RigidMotion startMotion(const BodyOptions& options, const MassProperties& solid);

} // namespace frazil

#endif
