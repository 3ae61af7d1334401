#include "Rotation.h"

#include <cmath>

namespace frazil
{

Quaternion operator*(const Quaternion& a, const Quaternion& b)
{
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Quaternion inverse(const Quaternion& q)
{
    return {q.w, -q.x, -q.y, -q.z};
}

Quaternion normalised(const Quaternion& q)
{
    const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {q.w / length, q.x / length, q.y / length, q.z / length};
}

Quaternion rotationBy(const Vec3& r)
{
    const double angle = norm(r);
    // sin(angle/2)/angle by its series where the quotient loses digits
    const double scale = angle > 1e-4 ? std::sin(0.5 * angle) / angle : 0.5 - angle * angle / 48.0;
    return {std::cos(0.5 * angle), scale * r.x, scale * r.y, scale * r.z};
}

Vec3 rotated(const Quaternion& q, const Vec3& v)
{
    const Vec3 axis{q.x, q.y, q.z};
    const Vec3 t = 2.0 * cross(axis, v);
    return v + q.w * t + cross(axis, t);
}

} // namespace frazil
