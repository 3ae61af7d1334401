#include "ClosedSurface.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <unordered_map>

#include <fmt/format.h>

#include "InputError.h"

namespace frazil
{

namespace
{

constexpr double joinTolerance = 1e-6; // of the surface's diagonal
constexpr std::size_t binaryHeader = 84, binaryTriangle = 50;

InputError notStl(const std::string& path, const std::string& problem)
{
    return {path, "", "", problem, "Export the surface again as STL (ascii or binary)."};
}

std::string readBytes(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        throw InputError(path, "", "", "the file cannot be opened",
                         "Check the path; it is taken relative to the folder the program runs in.");
    }
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::uint32_t binaryCount(const std::string& bytes)
{
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + binaryHeader - 4, 4);
    return count;
}

// The length decides, because binary files may also begin with the word "solid".
bool isBinary(const std::string& bytes)
{
    return bytes.size() >= binaryHeader &&
           bytes.size() == binaryHeader + binaryTriangle * std::size_t(binaryCount(bytes));
}

std::vector<Triangle> parseBinary(const std::string& bytes)
{
    std::vector<Triangle> triangles(binaryCount(bytes));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        float values[12]; // normal (not used: the corners' order defines it), then three corners
        std::memcpy(values, bytes.data() + binaryHeader + binaryTriangle * t, sizeof(values));
        for (int corner = 0; corner < 3; ++corner) {
            const float* v = values + 3 + 3 * corner;
            triangles[t][corner] = {v[0], v[1], v[2]};
        }
    }
    return triangles;
}

std::vector<Triangle> parseAscii(const std::string& bytes, const std::string& path)
{
    std::istringstream in(bytes);
    std::string word;
    std::vector<Vec3> corners;
    while (in >> word) {
        if (word != "vertex") {
            continue;
        }
        Vec3 p;
        if (!(in >> p.x >> p.y >> p.z)) {
            throw notStl(path, fmt::format("vertex {} has no three numbers", corners.size() + 1));
        }
        corners.push_back(p);
    }
    if (corners.size() % 3 != 0) {
        throw notStl(path, fmt::format("{} vertices are no triangles", corners.size()));
    }
    std::vector<Triangle> triangles(corners.size() / 3);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        triangles[t] = {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
    }
    return triangles;
}

// Bucket of the hash that joinCorners searches; buckets are as wide as the tolerance.
struct Bucket {
    std::int64_t x, y, z;
    bool operator==(const Bucket& b) const { return x == b.x && y == b.y && z == b.z; }
};

struct BucketHash {
    std::size_t operator()(const Bucket& b) const
    {
        return std::size_t(b.x * 73856093LL ^ b.y * 19349663LL ^ b.z * 83492791LL);
    }
};

class Joiner
{
  public:
    Joiner(const Vec3& origin, double tolerance) : origin_(origin), tolerance_(tolerance) {}

    int join(const Vec3& p)
    {
        const Bucket centre = bucketOf(p);
        for (int n = 0; n < 27; ++n) {
            const Bucket b{centre.x + n % 3 - 1, centre.y + n / 3 % 3 - 1, centre.z + n / 9 - 1};
            const auto found = index_.find(b);
            if (found != index_.end() && norm(points[found->second] - p) <= tolerance_) {
                return found->second;
            }
        }
        const int added = int(points.size());
        points.push_back(p);
        index_.emplace(centre, added);
        return added;
    }

    std::vector<Vec3> points;

  private:
    Bucket bucketOf(const Vec3& p) const
    {
        const Vec3 r = (p - origin_) / tolerance_;
        return {std::int64_t(std::floor(r.x)), std::int64_t(std::floor(r.y)), std::int64_t(std::floor(r.z))};
    }

    Vec3 origin_;
    double tolerance_;
    std::unordered_map<Bucket, int, BucketHash> index_;
};

using Edge = std::pair<int, int>;

// Every edge of a closed, oriented surface is walked once in each direction. Value: (forwards, backwards).
std::map<Edge, std::array<int, 2>> walkEdges(const IndexedSurface& surface)
{
    std::map<Edge, std::array<int, 2>> walks;
    for (const auto& t : surface.triangles) {
        for (int side = 0; side < 3; ++side) {
            const int a = t[side], b = t[(side + 1) % 3];
            ++walks[{std::min(a, b), std::max(a, b)}][a < b ? 0 : 1];
        }
    }
    return walks;
}

std::string show(const Vec3& p)
{
    return fmt::format("({:.6g} {:.6g} {:.6g})", p.x, p.y, p.z);
}

struct BadEdges {
    int count = 0;
    Edge first{};
    void add(const Edge& edge)
    {
        if (count++ == 0) {
            first = edge;
        }
    }
    std::string where(const IndexedSurface& s) const
    {
        return fmt::format("{}, the first from {} to {} m", count, show(s.points[first.first]),
                           show(s.points[first.second]));
    }
};

void checkEdges(const IndexedSurface& surface, const std::string& file, const std::string& key)
{
    BadEdges open, turned, crowded;
    for (const auto& [edge, walk] : walkEdges(surface)) {
        const int triangles = walk[0] + walk[1];
        if (triangles == 1) {
            open.add(edge);
        } else if (triangles > 2) {
            crowded.add(edge);
        } else if (walk[0] != 1) {
            turned.add(edge);
        }
    }
    if (open.count) {
        throw InputError(file, key, "", "the surface is not closed; open edges: " + open.where(surface),
                         "Close the surface in the program that made it (in OpenFOAM: surfaceCheck shows the holes).");
    }
    if (crowded.count) {
        throw InputError(file, key, "", "edges with more than two triangles: " + crowded.where(surface),
                         "Remove inner walls and doubled triangles: the surface must enclose one volume.");
    }
    if (turned.count) {
        throw InputError(file, key, "",
                         "neighbouring triangles disagree about the outside at edges: " + turned.where(surface),
                         "Make the normals consistent (in OpenFOAM: surfaceOrient).");
    }
}

} // namespace

std::vector<Triangle> readStl(const std::string& path)
{
    const std::string bytes = readBytes(path);
    if (isBinary(bytes)) {
        return parseBinary(bytes);
    }
    const std::size_t start = bytes.find_first_not_of(" \t\r\n");
    if (start == std::string::npos || bytes.compare(start, 5, "solid") != 0) {
        throw notStl(path,
                     "the file is neither ascii STL (first word 'solid') nor binary STL (84 + 50 bytes per triangle)");
    }
    std::vector<Triangle> triangles = parseAscii(bytes, path);
    if (triangles.empty()) {
        throw notStl(path, "the file holds no triangles");
    }
    return triangles;
}

Box boundsOf(const std::vector<Triangle>& triangles)
{
    Box box{triangles.at(0)[0], triangles.at(0)[0]};
    for (const Triangle& t : triangles) {
        for (const Vec3& p : t) {
            for (int axis = 0; axis < 3; ++axis) {
                box.min[axis] = std::min(box.min[axis], p[axis]);
                box.max[axis] = std::max(box.max[axis], p[axis]);
            }
        }
    }
    return box;
}

IndexedSurface joinCorners(const std::vector<Triangle>& triangles)
{
    const Box box = boundsOf(triangles);
    Joiner joiner(box.min, std::max(joinTolerance * norm(box.size()), 1e-300));
    IndexedSurface surface;
    surface.triangles.reserve(triangles.size());
    for (const Triangle& t : triangles) {
        const std::array<int, 3> corners{joiner.join(t[0]), joiner.join(t[1]), joiner.join(t[2])};
        const bool flat = corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
        if (!flat) {
            surface.triangles.push_back(corners);
        }
    }
    surface.points = std::move(joiner.points);
    return surface;
}

void checkClosed(const std::vector<Triangle>& triangles, const std::string& file, const std::string& key)
{
    if (triangles.empty()) {
        throw InputError(file, key, "", "the surface has no triangles", "Give a closed surface.");
    }
    checkEdges(joinCorners(triangles), file, key);
    const double volume = massProperties(triangles, 1.0).volume;
    if (!(volume > 0)) {
        throw InputError(file, key, "", fmt::format("the surface is inside out: its volume is {:.6g} m3", volume),
                         "Flip all normals so that they point out of the body.");
    }
}

MassProperties massProperties(const std::vector<Triangle>& triangles, double density)
{
    const Box box = boundsOf(triangles);
    const Vec3 origin = 0.5 * (box.min + box.max);
    double volume = 0;
    Vec3 first;            // ∫x dV
    double second[6] = {}; // ∫xx yy zz xy xz yz dV
    constexpr int axes[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    for (const Triangle& t : triangles) {
        const Vec3 a = t[0] - origin, b = t[1] - origin, c = t[2] - origin;
        const double v = dot(a, cross(b, c)) / 6.0;
        const Vec3 sum = a + b + c;
        volume += v;
        first += 0.25 * v * sum;
        // ∫ x_i x_j over a tetrahedron with one corner at the origin
        for (int m = 0; m < 6; ++m) {
            const int i = axes[m][0], j = axes[m][1];
            second[m] += v / 20.0 * (sum[i] * sum[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]);
        }
    }
    const Vec3 centre = first / volume;
    for (int m = 0; m < 6; ++m) {
        second[m] -= volume * centre[axes[m][0]] * centre[axes[m][1]];
    }
    MassProperties p;
    p.volume = volume;
    p.mass = density * volume;
    p.centre = centre + origin;
    p.inertia = {density * (second[1] + second[2]),
                 density * (second[0] + second[2]),
                 density * (second[0] + second[1]),
                 -density * second[3],
                 -density * second[4],
                 -density * second[5]};
    return p;
}

std::vector<Triangle> readClosedStl(const std::string& path, const std::string& key)
{
    std::vector<Triangle> triangles = readStl(path);
    checkClosed(triangles, path, key);
    return triangles;
}

} // namespace frazil
