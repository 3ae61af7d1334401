/// Numbers of a sphere.
#pragma once

namespace frazil
{

constexpr double pi = 3.14159265358979323846;

/// [m3], of a radius [m]
inline double volumeOf(double radius)
{
    return 4.0 / 3 * pi * radius * radius * radius;
}

} // namespace frazil
