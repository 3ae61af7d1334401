#include "RigidMotion.h"

#include <cmath>
#include <limits>

namespace frazil
{

Vec3 operator*(const Inertia& m, const Vec3& v)
{
    return {m[0] * v.x + m[3] * v.y + m[4] * v.z, m[3] * v.x + m[1] * v.y + m[5] * v.z,
            m[4] * v.x + m[5] * v.y + m[2] * v.z};
}

Inertia rotated(const Quaternion& q, const Inertia& tensor)
{
    // rows of R are the axes of space seen from the body: I_ij = r_i · (I r_j)
    const Quaternion back = inverse(q);
    const Vec3 r[3] = {rotated(back, Vec3{1, 0, 0}), rotated(back, Vec3{0, 1, 0}), rotated(back, Vec3{0, 0, 1})};
    const Vec3 s[3] = {tensor * r[0], tensor * r[1], tensor * r[2]};
    return {dot(r[0], s[0]), dot(r[1], s[1]), dot(r[2], s[2]), dot(r[0], s[1]), dot(r[0], s[2]), dot(r[1], s[2])};
}

bool positiveDefinite(const Inertia& m)
{
    const Vec3 a{m[0], m[3], m[4]}, b{m[3], m[1], m[5]}, c{m[4], m[5], m[2]};
    return m[0] > 0 && m[0] * m[1] - m[3] * m[3] > 0 && dot(a, cross(b, c)) > 0;
}

Vec3 RigidMotion::omegaAt(const Quaternion& q) const
{
    const Inertia m = rotated(q, inertia);
    Vec3 row[3] = {{m[0], m[3], m[4]}, {m[3], m[1], m[5]}, {m[4], m[5], m[2]}};
    Vec3 right = angularMomentum;
    // a locked axis replaces its row of I ω = L by ω_i = locked value; the scale of the row keeps the system well scaled
    for (int i = 0; i < 3; i++)
        if (lockTurn[i]) {
            const double scale = row[i][i];
            row[i] = Vec3();
            row[i][i] = scale;
            right[i] = scale * lockedOmega[i];
        }
    const Vec3 yz = cross(row[1], row[2]), zx = cross(row[2], row[0]), xy = cross(row[0], row[1]);
    return (right.x * yz + right.y * zx + right.z * xy) / dot(row[0], yz);
}

void RigidMotion::setOmega(const Vec3& omega)
{
    lockedOmega = omega;
    angularMomentum = rotated(orientation, inertia) * omega;
}

void RigidMotion::kick(const Vec3& force, const Vec3& torque, double dt)
{
    for (int i = 0; i < 3; i++)
        if (!lockMove[i])
            velocity[i] += dt / mass * force[i];
    angularMomentum += dt * torque;
}

RigidMotion::Step RigidMotion::drift(double dt)
{
    const Vec3 displacement = dt * velocity;
    centre += displacement;

    // ω of the half-way orientation: a contraction with ratio ~ ω dt, so a handful of turns reach round-off
    Vec3 turn = dt * omega();
    for (int turns = 0; turns < 20; turns++) {
        const Vec3 next = dt * omegaAt(rotationBy(0.5 * turn) * orientation);
        const double change = norm(next - turn);
        turn = next;
        if (change <= 2 * std::numeric_limits<double>::epsilon() * norm(turn))
            break;
    }
    orientation = normalised(rotationBy(turn) * orientation);
    return {displacement, turn};
}

} // namespace frazil
