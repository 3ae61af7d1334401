#include "SurfaceDistance.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace
{

using frazil::Box;
using frazil::Triangle;
using frazil::Vec3;

constexpr int leafSize = 4;

Vec3 unit(const Vec3& v)
{
    const double length = norm(v);
    return length > 0 ? v / length : Vec3{};
}

double angleAt(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 u = b - a, v = c - a;
    return std::atan2(norm(cross(u, v)), dot(u, v));
}

double squaredDistance(const Box& box, const Vec3& p)
{
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double gap = std::max({box.min[axis] - p[axis], 0.0, p[axis] - box.max[axis]});
        sum += gap * gap;
    }
    return sum;
}

// Where on the triangle the nearest point lies
enum feature { face = 0, corner0 = 1, edge0 = 4 };

struct foot {
    Vec3 point;
    int where;
};

foot nearestPoint(const Triangle& t, const Vec3& p)
{
    const Vec3 ab = t[1] - t[0], ac = t[2] - t[0];

    const Vec3 ap = p - t[0];
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0 && d2 <= 0)
        return {t[0], corner0};

    const Vec3 bp = p - t[1];
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3)
        return {t[1], corner0 + 1};

    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        return {t[0] + (d1 / (d1 - d3)) * ab, edge0};
    }

    const Vec3 cp = p - t[2];
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6)
        return {t[2], corner0 + 2};

    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        return {t[0] + (d2 / (d2 - d6)) * ac, edge0 + 2};
    }

    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {t[1] + w * (t[2] - t[1]), edge0 + 1};
    }

    const double scale = 1 / (va + vb + vc);
    return {t[0] + (vb * scale) * ab + (vc * scale) * ac, face};
}

} // namespace

void frazil::SurfaceDistance::buildNormals(const IndexedSurface& surface)
{
    const auto edgeOf = [](int a, int b) { return std::make_pair(std::min(a, b), std::max(a, b)); };

    std::vector<Vec3> cornerNormal(surface.points.size());
    std::map<std::pair<int, int>, Vec3> edgeNormal;
    normals_.resize(triangles_.size());

    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        const Triangle& x = triangles_[t];
        const auto& ids = surface.triangles[t];
        const Vec3 n = unit(cross(x[1] - x[0], x[2] - x[0]));
        normals_[t].face = n;
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            cornerNormal[ids[i]] += angleAt(x[i], x[j], x[k]) * n;
            edgeNormal[edgeOf(ids[i], ids[j])] += n;
        }
    }

    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        const auto& ids = surface.triangles[t];
        for (int i = 0; i < 3; ++i) {
            normals_[t].corner[i] = cornerNormal[ids[i]];
            normals_[t].edge[i] = edgeNormal.at(edgeOf(ids[i], ids[(i + 1) % 3]));
        }
    }
}

int frazil::SurfaceDistance::buildTree(std::vector<int>& order, int first, int last)
{
    const int self = int(tree_.size());
    tree_.push_back({});

    std::vector<Triangle> held;
    for (int i = first; i < last; ++i)
        held.push_back(triangles_[order[i]]);
    const Box box = boundsOf(held);

    if (last - first <= leafSize) {
        tree_[self] = {box, first, last - first};
        return self;
    }

    const Vec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    const auto middle = [&](int t) {
        const Triangle& x = triangles_[t];
        return x[0][axis] + x[1][axis] + x[2][axis];
    };
    const int half = (first + last) / 2;
    std::nth_element(order.begin() + first, order.begin() + half, order.begin() + last,
                     [&](int a, int b) { return middle(a) < middle(b); });

    buildTree(order, first, half);
    const int right = buildTree(order, half, last);
    tree_[self] = {box, right, 0};
    return self;
}

void frazil::SurfaceDistance::visit(const node& leaf, const Vec3& p, nearest& best) const
{
    for (int t = leaf.first; t < leaf.first + leaf.count; ++t) {
        const foot f = nearestPoint(triangles_[t], p);
        const Vec3 r = p - f.point;
        const double squared = dot(r, r);
        if (squared >= best.squared)
            continue;

        const normals& n = normals_[t];
        const Vec3& by = f.where == face   ? n.face
                         : f.where < edge0 ? n.corner[f.where - corner0]
                                           : n.edge[f.where - edge0];
        best = {squared, dot(r, by)};
    }
}

frazil::SurfaceDistance::SurfaceDistance(const IndexedSurface& surface)
{
    for (const auto& t : surface.triangles) {
        triangles_.push_back({surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]});
    }
    buildNormals(surface);

    std::vector<int> order(triangles_.size());
    std::iota(order.begin(), order.end(), 0);
    buildTree(order, 0, int(order.size()));

    // Leaves read their triangles one after the other
    const auto triangles = triangles_;
    const auto normals = normals_;
    for (std::size_t i = 0; i < order.size(); ++i) {
        triangles_[i] = triangles[order[i]];
        normals_[i] = normals[order[i]];
    }
}

double frazil::SurfaceDistance::operator()(const Vec3& p, double bound) const
{
    // A little more than the bound, so that a point at just that distance is
    // found in spite of round-off
    nearest best{1.0001 * bound * bound, 1};

    struct branch {
        int node;
        double squared;
    };
    branch stack[64];
    int height = 0;
    stack[height++] = {0, 0};

    while (height > 0) {
        const branch top = stack[--height];
        if (top.squared >= best.squared)
            continue;

        const node& n = tree_[top.node];
        if (n.count > 0) {
            visit(n, p, best);
            continue;
        }
        const branch left{top.node + 1, squaredDistance(tree_[top.node + 1].box, p)};
        const branch right{n.first, squaredDistance(tree_[n.first].box, p)};
        const bool leftFirst = left.squared < right.squared;
        stack[height++] = leftFirst ? right : left;
        stack[height++] = leftFirst ? left : right;
    }

    return best.signedBy < 0 ? -std::sqrt(best.squared) : std::sqrt(best.squared);
}
