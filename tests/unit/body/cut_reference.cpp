/// CellCutting against slow references: what lies inside is clipped off corner by corner, or counted out in fine columns.
///
/// plane     any convex cell and any plane; the reference clips the faces and takes the volume under them      1e-12
/// sphere    cubes across a sphere; columns of each cube, chords of each face, a column's length exact:
///           mean error of the shares relative to the sphere falls with the square of the edge length, and
///           at 16 cubes per diameter is at most 0.35 % (cells) and 0.3 % (faces)
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "CellCutting.h"
#include "Sphere.h"

using namespace frazil;

namespace
{

using Polygon = std::vector<Vec3>;

/// A convex cell by its faces, corners in order around each.
struct Polyhedron {
    std::vector<Polygon> faces;

    Vec3 centre() const
    {
        Vec3 sum;
        double count = 0;
        for (const Polygon& face : faces) {
            for (const Vec3& p : face)
                sum += p, ++count;
        }
        return sum / count;
    }
};

Vec3 areaVector(const Polygon& face)
{
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        sum += 0.5 * cross(face[i] - face[0], face[i + 1] - face[0]);
    return sum;
}

/// The plane n·(x - point) = 0 as a signed distance, negative inside.
struct Plane {
    Vec3 point, normal;
    double operator()(const Vec3& x) const { return dot(normal, x - point); }
};

Polygon clipped(const Polygon& face, const Plane& plane)
{
    Polygon inside;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3 a = face[i], b = face[(i + 1) % face.size()];
        const double da = plane(a), db = plane(b);
        if (da < 0)
            inside.push_back(a);
        if ((da < 0) != (db < 0))
            inside.push_back(a + (da / (da - db)) * (b - a));
    }
    return inside;
}

/// Volume under the clipped faces, seen from a point of the plane: the cut itself adds nothing.
double clippedVolume(const Polyhedron& cell, const Plane& plane)
{
    double sum = 0;
    for (const Polygon& face : cell.faces) {
        const Polygon inside = clipped(face, plane);
        const double outwards = dot(areaVector(face), face[0] - cell.centre()) > 0 ? 1 : -1;
        if (inside.size() > 2)
            sum += outwards * dot(areaVector(inside), inside[0] - plane.point) / 3;
    }
    return sum;
}

double volume(const Polyhedron& cell)
{
    double sum = 0;
    for (const Polygon& face : cell.faces)
        sum += std::abs(dot(areaVector(face), face[0] - cell.centre())) / 3;
    return sum;
}

template <class Distance> double faceShare(const Polygon& face, const Distance& distance, CutCell* cell = nullptr)
{
    std::vector<double> distances;
    Vec3 centre;
    for (const Vec3& p : face) {
        distances.push_back(distance(p));
        centre += p / double(face.size());
    }
    const CutFace cut{int(face.size()), face.data(), distances.data(), centre, distance(centre)};
    if (cell)
        cell->add(cut);
    return insideShare(cut);
}

template <class Distance> double cellShare(const Polyhedron& cell, const Distance& distance)
{
    CutCell cut(cell.centre(), distance(cell.centre()));
    for (const Polygon& face : cell.faces)
        faceShare(face, distance, &cut);
    return cut.insideShare();
}

Polyhedron shaped(const std::vector<Vec3>& corners, const std::vector<std::vector<int>>& faces)
{
    Polyhedron cell;
    for (const std::vector<int>& face : faces) {
        cell.faces.emplace_back();
        for (const int corner : face)
            cell.faces.back().push_back(corners[corner]);
    }
    return cell;
}

const std::vector<Vec3> cubeCorners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                    {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

Polyhedron cube()
{
    return shaped(cubeCorners, {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

Polyhedron prism()
{
    return shaped(cubeCorners, {{0, 2, 1}, {4, 5, 6}, {0, 1, 5, 4}, {0, 4, 6, 2}, {1, 2, 6, 5}});
}

Polyhedron pyramid()
{
    return shaped({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.4, 0.7, 1}},
                  {{0, 2, 3, 1}, {0, 1, 4}, {1, 3, 4}, {3, 2, 4}, {2, 0, 4}});
}

/// Its sides are trapezia: triangles of different sizes around their centres.
Polyhedron frustum()
{
    return shaped(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.1, 0.2, 1}, {0.6, 0.2, 1}, {0.1, 0.7, 1}, {0.6, 0.7, 1}},
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

Polyhedron tetrahedron()
{
    return shaped({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

/// The shape under a linear map: cells as skewed and stretched as meshes have them.
Polyhedron mapped(Polyhedron cell, const std::array<Vec3, 3>& edges)
{
    for (Polygon& face : cell.faces) {
        for (Vec3& p : face)
            p = p.x * edges[0] + p.y * edges[1] + p.z * edges[2];
    }
    return cell;
}

} // namespace

TEST(CutReference, AnyPlaneThroughAnyConvexCell)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(-1, 1);
    const auto vector = [&] { return Vec3{value(random), value(random), value(random)}; };
    int cut = 0;
    for (const Polyhedron& shape : {cube(), prism(), pyramid(), frustum(), tetrahedron()}) {
        for (int n = 0; n < 500; ++n) {
            const std::array<Vec3, 3> edges{Vec3{2, 0, 0} + vector(), Vec3{0, 2, 0} + vector(),
                                            Vec3{0, 0, 2} + vector()};
            const Polyhedron cell = mapped(shape, edges);
            const Vec3 normal = vector();
            const Plane plane{cell.centre() + 0.5 * vector(), normal / norm(normal)};
            const double share = clippedVolume(cell, plane) / volume(cell);
            EXPECT_NEAR(cellShare(cell, plane), share, 1e-12);
            for (const Polygon& face : cell.faces) {
                const Polygon inside = clipped(face, plane);
                const double area = inside.size() > 2 ? norm(areaVector(inside)) : 0;
                EXPECT_NEAR(faceShare(face, plane), area / norm(areaVector(face)), 1e-12);
            }
            cut += share > 0 && share < 1;
        }
    }
    EXPECT_GT(cut, 1000);
}

namespace
{

/// Length of [low, high] that lies in (-half, half).
double overlap(double low, double high, double half)
{
    return std::max(0.0, std::min(high, half) - std::max(low, -half));
}

/// Share of a cube inside the unit sphere: `fine` x `fine` columns along z, each exact.
double columnShare(const Vec3& low, double size, int fine)
{
    double sum = 0;
    for (int n = 0; n < fine * fine; ++n) {
        const double x = low.x + (n % fine + 0.5) * size / fine, y = low.y + (n / fine + 0.5) * size / fine;
        const double left = 1 - x * x - y * y;
        sum += left > 0 ? overlap(low.z, low.z + size, std::sqrt(left)) : 0;
    }
    return sum / size / fine / fine;
}

/// Share of the cube's lower face inside the unit sphere: `fine` chords along y.
double chordShare(const Vec3& low, double size, int fine)
{
    double sum = 0;
    for (int n = 0; n < fine; ++n) {
        const double x = low.x + (n + 0.5) * size / fine, left = 1 - x * x - low.z * low.z;
        sum += left > 0 ? overlap(low.y, low.y + size, std::sqrt(left)) : 0;
    }
    return sum / size / fine;
}

struct Errors {
    double cells = 0, faces = 0; ///< Σ|share - reference| over what the sphere itself takes up
};

/// Cubes over the unit sphere, none in a symmetric place.
Errors sphereErrors(int perDiameter)
{
    const double size = 2.0 / perDiameter;
    const int n = perDiameter + 3;
    const auto sphere = [](const Vec3& p) { return norm(p) - 1; };
    Errors error;
    for (int c = 0; c < n * n * n; ++c) {
        const Vec3 low =
            size * Vec3{c % n + 0.37, c / n % n + 0.11, c / n / n + 0.71} - Vec3{1, 1, 1} - size * Vec3{2, 2, 2};
        if (std::abs(sphere(low + 0.5 * size * Vec3{1, 1, 1})) > size)
            continue; // neither cell nor face is cut
        const auto inPlace = [&](const Vec3& p) { return sphere(low + p); };
        const Polyhedron cell = mapped(cube(), {Vec3{size, 0, 0}, Vec3{0, size, 0}, Vec3{0, 0, size}});
        error.cells += std::abs(cellShare(cell, inPlace) - columnShare(low, size, 64));
        error.faces += std::abs(faceShare(cell.faces[4], inPlace) - chordShare(low, size, 1000));
    }
    const double taken =
        volumeOf(1) / (size * size * size); // cubes, and lower faces of cubes, that the sphere takes up
    return {error.cells / taken, error.faces / taken};
}

} // namespace

TEST(CutReference, SphereConvergesWithTheSquareOfTheEdge)
{
    const Errors coarse = sphereErrors(8), middle = sphereErrors(16), fine = sphereErrors(32);
    std::printf("cells %.2e %.2e %.2e, faces %.2e %.2e %.2e\n", coarse.cells, middle.cells, fine.cells, coarse.faces,
                middle.faces, fine.faces);
    EXPECT_LT(middle.cells, 3.5e-3);
    EXPECT_LT(middle.faces, 3e-3);
    for (const auto& [one, next] : {std::pair{coarse, middle}, std::pair{middle, fine}}) {
        EXPECT_GT(std::log2(one.cells / next.cells), 1.8);
        EXPECT_GT(std::log2(one.faces / next.faces), 1.8);
    }
}
