/// Closed test surfaces whose volume is known.
#pragma once

#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>

#include "ClosedSurface.h"
#include "Sphere.h"

namespace frazil::shapes
{

/// Box from `lo` to `hi`, 12 triangles.
inline std::vector<Triangle> box(const Vec3& lo, const Vec3& hi)
{
    const auto p = [&](int i, int j, int k) { return Vec3{i ? hi.x : lo.x, j ? hi.y : lo.y, k ? hi.z : lo.z}; };
    std::vector<Triangle> out;
    const auto quad = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
        out.push_back({a, b, c});
        out.push_back({a, c, d});
    };
    quad(p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0));
    quad(p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1));
    quad(p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1));
    quad(p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0));
    quad(p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0));
    quad(p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1));
    return out;
}

/// Surface of revolution about z through the profile (r, z), from the lower pole (r = 0) to the upper one (r = 0).
inline std::vector<Triangle> revolve(const std::vector<std::array<double, 2>>& profile, int sectors)
{
    std::vector<Triangle> out;
    const auto p = [&](std::size_t i, int s) {
        const double angle = 2 * pi * (s % sectors) / sectors;
        return Vec3{profile[i][0] * std::cos(angle), profile[i][0] * std::sin(angle), profile[i][1]};
    };
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        for (int s = 0; s < sectors; ++s) {
            const Vec3 a = p(i, s), b = p(i, s + 1), c = p(i + 1, s + 1), d = p(i + 1, s);
            if (profile[i][0] > 0) {
                out.push_back({a, b, c});
            }
            if (profile[i + 1][0] > 0) {
                out.push_back({a, c, d});
            }
        }
    }
    return out;
}

/// Sphere of `radius` about the origin, as a polyhedron.
inline std::vector<Triangle> sphere(double radius, int rings = 48)
{
    std::vector<std::array<double, 2>> profile;
    for (int i = 0; i <= rings; ++i) {
        const double angle = pi * i / rings;
        const bool pole = i == 0 || i == rings;
        profile.push_back({pole ? 0 : radius * std::sin(angle), -radius * std::cos(angle)});
    }
    return revolve(profile, 2 * rings);
}

/// Cone with its apex at the origin, opening along +z with the given full angle [rad], then a cylinder: the projectile.
inline std::vector<Triangle> projectile(double diameter, double fullAngle, double length, int sectors = 96)
{
    const double r = 0.5 * diameter, h = r / std::tan(0.5 * fullAngle);
    return revolve({{0, 0}, {r, h}, {r, length}, {0, length}}, sectors);
}

inline void writeAscii(const std::vector<Triangle>& triangles, const std::string& path)
{
    std::ofstream out(path);
    out.precision(9);
    out << "solid body\n";
    for (const Triangle& t : triangles) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (const Vec3& p : t) {
            out << "vertex " << p.x << ' ' << p.y << ' ' << p.z << '\n';
        }
        out << "endloop\nendfacet\n";
    }
    out << "endsolid body\n";
}

inline void writeBinary(const std::vector<Triangle>& triangles, const std::string& path)
{
    std::ofstream out(path, std::ios::binary);
    const std::string header = "solid binary files may begin like ascii ones" + std::string(36, ' ');
    out.write(header.data(), 80);
    const std::uint32_t count = std::uint32_t(triangles.size());
    out.write(reinterpret_cast<const char*>(&count), 4);
    for (const Triangle& t : triangles) {
        float values[12] = {};
        for (int c = 0; c < 3; ++c) {
            for (int axis = 0; axis < 3; ++axis) {
                values[3 + 3 * c + axis] = float(t[c][axis]);
            }
        }
        out.write(reinterpret_cast<const char*>(values), sizeof(values));
        out.write("\0\0", 2);
    }
}

} // namespace frazil::shapes
