/// A rigid body's surface: triangles that close a volume, their check, and the mass they hold.
///
/// Mass properties come from the divergence theorem: every triangle spans a tetrahedron with a reference point, whose
/// signed volume and moments add up to those of the body (exact for the polyhedron, at any distance from the origin
/// because the reference point is the centre of the bounding box).
/// Cost: one pass over the triangles for the mass, a hash of the points for the check. No parallelism: a surface has
/// thousands of triangles, every rank reads its own copy.
/// Source: Eberly, "Polyhedral mass properties (revisited)", 2002; Mirtich, J. Graphics Tools 1(2), 1996.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "Box.h"

namespace frazil
{

/// Corners [m], counter-clockwise seen from outside.
using Triangle = std::array<Vec3, 3>;

struct MassProperties {
    double volume = 0;               ///< [m3]
    double mass = 0;                 ///< [kg]
    Vec3 centre;                     ///< centre of mass [m]
    std::array<double, 6> inertia{}; ///< tensor about the centre: xx yy zz xy xz yz, xy = -∫ρ x y dV [kg m2]
};

/// Triangles that share their corners.
struct IndexedSurface {
    std::vector<Vec3> points;                  ///< [m]
    std::vector<std::array<int, 3>> triangles; ///< without those that have no area because corners coincide
};

/// Read an STL file, ascii or binary. InputError if it is missing or is not STL.
std::vector<Triangle> readStl(const std::string& path);

/// Smallest box that holds the triangles [m].
Box boundsOf(const std::vector<Triangle>& triangles);

/// Join corners closer than 1e-6 of the surface's diagonal (STL repeats every corner, ascii STL rounds it).
IndexedSurface joinCorners(const std::vector<Triangle>& triangles);

/// Refuse, with an InputError that names `file` and `key`, a surface that is not closed (position and number of open
/// edges), whose triangles disagree about the outside, or that is turned inside out.
void checkClosed(const std::vector<Triangle>& triangles, const std::string& file, const std::string& key = "surface");

/// Volume, mass, centre and inertia of the closed surface filled with `density` [kg/m3].
MassProperties massProperties(const std::vector<Triangle>& triangles, double density);

/// readStl, then checkClosed.
std::vector<Triangle> readClosedStl(const std::string& path, const std::string& key = "surface");

} // namespace frazil
