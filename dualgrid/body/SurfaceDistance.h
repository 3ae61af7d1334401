/// Exact signed distance [m] to a closed surface of triangles, negative inside.
///
/// The nearest point is searched in a tree of bounding boxes; the sign is that
/// of the angle-weighted pseudo-normal of the nearest face, edge or corner,
/// which is right everywhere for a closed surface (face normals alone are wrong
/// next to sharp edges, e.g. behind a cone's rim).
///
/// Cost: about 1 µs per point and 1,000 triangles' logarithm when a good bound
/// is given. No parallelism; immutable after construction.
///
/// Source: Baerentzen & Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243;
/// nearest point of a triangle: Ericson, Real-time collision detection, 5.1.5.
#pragma once

#include "ClosedSurface.h"

namespace frazil
{

class SurfaceDistance
{
    struct node {
        Box box;
        int first; // first triangle of a leaf, or the right child
        int count; // triangles of a leaf, 0: left child follows, right = first
    };

    // Pseudo-normals of one triangle: face, three corners, three edges
    // (edge i from corner i to the next)
    struct normals {
        Vec3 face, corner[3], edge[3];
    };

    struct nearest {
        double squared;
        double signedBy; // (p - nearest point)·pseudo-normal
    };

    std::vector<Triangle> triangles_;
    std::vector<normals> normals_;
    std::vector<node> tree_;

    void buildNormals(const IndexedSurface& surface);
    int buildTree(std::vector<int>& order, int first, int last);
    void visit(const node& leaf, const Vec3& p, nearest& best) const;

  public:
    explicit SurfaceDistance(const IndexedSurface& surface);

    /// Signed distance of p [m]. bound: a distance known not to be exceeded
    /// (from a neighbouring point), which saves most of the search.
    double operator()(const Vec3& p, double bound = 1e30) const;
};

} // namespace frazil
