#include "WaterSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Sphere.h"

namespace frazil
{

namespace
{

/// Share of the unit cube with m·x < d, for 0 <= m1 <= m2 <= m3, Σ m = 1 and d <= 1/2.
double lowerShare(double m1, double m2, double m3, double d)
{
    const double m12 = m1 + m2, product = 6 * m1 * m2 * m3;
    if (d <= 0)
        return 0;
    if (d < m1)
        return d * d * d / product;
    if (d < m2)
        return d * (d - m1) / (2 * m2 * m3) + m1 * m1 / (6 * m2 * m3);
    const double corners = m1 * m1 * (m1 - 3 * d) + m2 * m2 * (m2 - 3 * d);
    if (d < std::min(m12, m3))
        return (d * d * (3 * m12 - d) + corners) / product;
    if (m12 <= m3)
        return (2 * d - m12) / (2 * m3);
    return (d * d * (3 - 2 * d) + corners + m3 * m3 * (m3 - 3 * d)) / product;
}

Box overlap(const Box& a, const Box& b)
{
    Box both;
    for (int axis = 0; axis < 3; ++axis) {
        both.min[axis] = std::max(a.min[axis], b.min[axis]);
        both.max[axis] = std::max(both.min[axis], std::min(a.max[axis], b.max[axis]));
    }
    return both;
}

double volumeOf(const Box& box)
{
    const Vec3 size = box.size();
    return size.x * size.y * size.z;
}

/// Root of a monotonic function between two ends: regula falsi, which halves an end that stays (Illinois).
double levelOf(const Box& cell, const Vec3& normal, double share)
{
    const Vec3 centre = 0.5 * (cell.min + cell.max), half = 0.5 * cell.size();
    const double reach = std::abs(normal.x) * half.x + std::abs(normal.y) * half.y + std::abs(normal.z) * half.z;
    double low = dot(normal, centre) - reach, high = low + 2 * reach;
    double below = -share, above = 1 - share; // what is missing at both ends
    int kept = 0;                             // end that the last iterations left in place
    for (int n = 0; n < std::numeric_limits<double>::digits; ++n) {
        const double level = (low * above - high * below) / (above - below);
        const double rest = shareBelow(cell, normal, level) - share;
        if (std::abs(rest) < 1e-14)
            return level;
        if (rest < 0) {
            low = level, below = rest;
            above *= kept > 0 ? 0.5 : 1;
            kept = 1;
        } else {
            high = level, above = rest;
            below *= kept < 0 ? 0.5 : 1;
            kept = -1;
        }
    }
    return 0.5 * (low + high);
}

} // namespace

double shareBelow(const Box& box, const Vec3& normal, double level)
{
    const Vec3 size = box.size();
    double m[3], lowest = 0, sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        m[axis] = std::abs(normal[axis]) * size[axis];
        lowest += normal[axis] * (normal[axis] > 0 ? box.min[axis] : box.max[axis]);
        sum += m[axis];
    }
    if (!(sum > 0))
        return level > 0 ? 1 : 0;
    const double d = std::clamp((level - lowest) / sum, 0.0, 1.0);
    std::sort(m, m + 3);
    const double share = lowerShare(m[0] / sum, m[1] / sum, m[2] / sum, std::min(d, 1 - d));
    return d <= 0.5 ? share : 1 - share;
}

double WaterSurface::shareOf(const Box& box) const
{
    if (!(sharpness > 0))
        return waterShare;
    return sharpness * shareBelow(box, normal, level) + (1 - sharpness) * waterShare;
}

WaterSurface surfaceIn(const Box& cell, const CoarseFluid& fluid)
{
    WaterSurface surface;
    if (!(fluid.openVolume > 0))
        return surface;
    surface.waterShare = std::clamp(fluid.openWater / fluid.openVolume, 0.0, 1.0);
    // Less than this is what diffusion leaves far from the surface: it has no place.
    const double nothing = 1e-9;
    if (surface.waterShare < nothing || surface.waterShare > 1 - nothing)
        return surface;
    const Vec3 offset = fluid.openMoment / fluid.openVolume - fluid.waterMoment / fluid.openWater;
    const double length = norm(offset);
    if (!(length > nothing * norm(cell.size())))
        return surface;
    surface.normal = offset / length;
    const Vec3 size = cell.size();
    const double h = norm({surface.normal.x * size.x, surface.normal.y * size.y, surface.normal.z * size.z});
    surface.level = levelOf(cell, surface.normal, surface.waterShare);
    surface.sharpness = std::min(1.0, length / (0.9 * (1 - surface.waterShare) * h / 2));
    return surface;
}

Box cubeOf(const Vec3& centre, double radius)
{
    const double half = 0.5 * std::cbrt(4.0 / 3 * pi) * radius;
    return {centre - Vec3{half, half, half}, centre + Vec3{half, half, half}};
}

SphereShare shareOfSphere(const Vec3& centre, double radius, const LocalCells& cells, const CoarseField<Box>& filled,
                          const CoarseField<CoarseFluid>& fluid, const CoarseField<WaterSurface>& surface)
{
    const Box cube = cubeOf(centre, radius);
    double inMesh = 0, fluidHere = 0, wet = 0;
    forCellsOf(cube, cells, [&](int cell) {
        const Box piece = overlap(cube, filled[cell]);
        const double volume = volumeOf(piece);
        inMesh += volume;
        if (!(fluid[cell].openVolume > 0) || !(volume > 0))
            return;
        fluidHere += volume;
        wet += volume * surface[cell].shareOf(piece);
    });
    SphereShare share;
    share.dry = !(fluidHere > 0);
    share.inMesh = std::min(1.0, inMesh / volumeOf(cube));
    share.inWater = share.dry ? 0 : wet / fluidHere;
    return share;
}

} // namespace frazil
