/// Motion of one rigid body with six degrees of freedom, any of which may be locked.
///
/// Translation: velocity Verlet, m dv/dt = F. Rotation: dL/dt = T in the frame of space, dq/dt = ½ ω q with
/// ω = I(q)^-1 L. The angular momentum L is the state, so a body without torque keeps it to round-off; the
/// orientation takes one step with the ω of the half-way orientation (implicit midpoint, solved by iteration):
/// second order, time-reversible, so that the energy of a free top oscillates and does not drift.
/// A locked direction keeps its velocity: the constraint acts along locked axes only, so the free components
/// of L still obey dL/dt = T, and ω follows from the free rows of I ω = L.
/// Cost: a few hundred operations per step. Parallel: every rank integrates the same numbers.
/// Source: Simo & Wong, Int. J. Numer. Meth. Eng. 31 (1991); Krysl & Endres, IJNME 62 (2005).
#pragma once

#include <array>

#include "Rotation.h"

namespace frazil
{

/// Tensor of inertia: xx yy zz xy xz yz, xy = -∫ρ x y dV [kg m2].
using Inertia = std::array<double, 6>;

Vec3 operator*(const Inertia& tensor, const Vec3& v);

/// The tensor of a body that has turned by q.
Inertia rotated(const Quaternion& q, const Inertia& tensor);

bool positiveDefinite(const Inertia& tensor);

struct RigidMotion {
    double mass = 0;        ///< [kg]
    Inertia inertia{};      ///< about the centre, in the orientation of the start [kg m2]
    Vec3 centre;            ///< centre of mass [m]
    Vec3 velocity;          ///< [m/s]
    Quaternion orientation; ///< from the start to now
    Vec3 angularMomentum;   ///< about the centre, in the frame of space [kg m2/s]
    bool lockMove[3] = {false, false, false};
    bool lockTurn[3] = {false, false, false};
    Vec3 lockedOmega; ///< kept about the locked axes [rad/s]

    /// Angular velocity in the frame of space [rad/s].
    Vec3 omega() const { return omegaAt(orientation); }
    void setOmega(const Vec3& omega);

    /// F [N] and T about the centre [N m] act for dt [s]; the pose stays.
    void kick(const Vec3& force, const Vec3& torque, double dt);

    /// What a surface that is carried along must follow.
    struct Step {
        Vec3 displacement; ///< of the centre [m]
        Vec3 rotation;     ///< rotation vector about the new centre [rad]
    };

    /// The pose advances by dt [s] under the momenta.
    Step drift(double dt);

  private:
    Vec3 omegaAt(const Quaternion& q) const;
};

} // namespace frazil
