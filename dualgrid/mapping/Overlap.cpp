#include "Overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace frazil
{

namespace
{

using Tetrahedron = std::array<Vec3, 4>;

double volumeOf(const Tetrahedron& t)
{
    return std::abs(dot(cross(t[1] - t[0], t[2] - t[0]), t[3] - t[0])) / 6;
}

/// First and last coarse index along an axis that [low, high] can reach, within the grid.
std::array<int, 2> reach(const CoarseGrid& grid, int axis, double low, double high)
{
    const auto index = [&](double x) {
        const double i = std::floor((x - grid.box().min[axis]) / grid.cellSize());
        return int(std::clamp(i, -1.0, double(grid.cells()[axis])));
    };
    return {std::max(index(low), 0), std::min(index(high), grid.cells()[axis] - 1)};
}

/// A prism with triangles (a0 a1 a2) and (b0 b1 b2) as three tetrahedra.
void addPrism(const Vec3& a0, const Vec3& a1, const Vec3& a2, const Vec3& b0, const Vec3& b1, const Vec3& b2,
              std::vector<Tetrahedron>& out)
{
    out.push_back({a0, a1, a2, b2});
    out.push_back({a0, a1, b1, b2});
    out.push_back({a0, b0, b1, b2});
}

/// Point of the edge a-b on the plane, from the signed heights of its ends.
Vec3 crossing(const Vec3& a, const Vec3& b, double heightA, double heightB)
{
    return a + (heightA / (heightA - heightB)) * (b - a);
}

/// Splits t by the plane x[axis] = level.
void split(const Tetrahedron& t, int axis, double level, std::vector<Tetrahedron>& below,
           std::vector<Tetrahedron>& above)
{
    Vec3 under[4], over[4];
    double hu[4], ho[4];
    int nu = 0, no = 0;
    for (const Vec3& corner : t) {
        const double height = corner[axis] - level;
        if (height < 0) {
            under[nu] = corner;
            hu[nu++] = height;
        } else {
            over[no] = corner;
            ho[no++] = height;
        }
    }
    if (nu == 0)
        return above.push_back(t);
    if (no == 0)
        return below.push_back(t);
    const auto cut = [&](int u, int o) { return crossing(under[u], over[o], hu[u], ho[o]); };
    if (nu == 1) {
        const Vec3 c0 = cut(0, 0), c1 = cut(0, 1), c2 = cut(0, 2);
        below.push_back({under[0], c0, c1, c2});
        addPrism(over[0], over[1], over[2], c0, c1, c2, above);
    } else if (no == 1) {
        const Vec3 c0 = cut(0, 0), c1 = cut(1, 0), c2 = cut(2, 0);
        above.push_back({over[0], c0, c1, c2});
        addPrism(under[0], under[1], under[2], c0, c1, c2, below);
    } else {
        const Vec3 c00 = cut(0, 0), c01 = cut(0, 1), c10 = cut(1, 0), c11 = cut(1, 1);
        addPrism(under[0], c00, c01, under[1], c10, c11, below);
        addPrism(over[0], c00, c10, over[1], c01, c11, above);
    }
}

/// Distributes tetrahedra over the layers of cells along one axis, then goes on to the next axis.
class Cutter
{
  public:
    Cutter(const CoarseGrid& grid, const PieceSink& sink) : grid_(grid), sink_(sink) {}

    void cut(std::vector<Tetrahedron> tets, int axis, CellIndex cell) const
    {
        if (axis == 3)
            return emit(tets, grid_.id(cell));
        double low = tets[0][0][axis], high = low;
        for (const auto& t : tets) {
            for (const Vec3& corner : t) {
                low = std::min(low, corner[axis]);
                high = std::max(high, corner[axis]);
            }
        }
        const auto [first, last] = reach(grid_, axis, low, high);
        std::vector<Tetrahedron> below, above;
        const auto splitAll = [&](int face) {
            below.clear();
            above.clear();
            for (const auto& t : tets)
                split(t, axis, grid_.box().min[axis] + face * grid_.cellSize(), below, above);
        };
        if (first == 0) { // drop what lies below the grid
            splitAll(0);
            tets.swap(above);
        }
        for (int i = first; i <= last && !tets.empty(); ++i) {
            splitAll(i + 1);
            cell[axis] = i;
            if (!below.empty())
                cut(below, axis + 1, cell);
            tets.swap(above);
        }
    }

  private:
    void emit(const std::vector<Tetrahedron>& tets, std::int64_t cell) const
    {
        double volume = 0;
        Vec3 moment;
        for (const auto& t : tets) {
            const double v = volumeOf(t);
            volume += v;
            moment += v / 4 * (t[0] + t[1] + t[2] + t[3]);
        }
        if (volume > 0)
            sink_(cell, volume, moment / volume);
    }

    const CoarseGrid& grid_;
    const PieceSink& sink_;
};

} // namespace

void clipBox(const Box& box, const CoarseGrid& grid, const PieceSink& sink)
{
    std::array<int, 2> range[3];
    for (int a = 0; a < 3; ++a)
        range[a] = reach(grid, a, box.min[a], box.max[a]);
    for (int k = range[2][0]; k <= range[2][1]; ++k) {
        for (int j = range[1][0]; j <= range[1][1]; ++j) {
            for (int i = range[0][0]; i <= range[0][1]; ++i) {
                const Box cell = grid.cellBox({i, j, k});
                double volume = 1;
                Vec3 centroid;
                for (int a = 0; a < 3; ++a) {
                    const double low = std::max(box.min[a], cell.min[a]), high = std::min(box.max[a], cell.max[a]);
                    volume *= std::max(0.0, high - low);
                    centroid[a] = 0.5 * (low + high);
                }
                if (volume > 0)
                    sink(grid.id({i, j, k}), volume, centroid);
            }
        }
    }
}

void clipTetrahedron(const Vec3 (&corner)[4], const CoarseGrid& grid, const PieceSink& sink)
{
    const Tetrahedron whole{corner[0], corner[1], corner[2], corner[3]};
    if (volumeOf(whole) > 0)
        Cutter(grid, sink).cut({whole}, 0, {});
}

} // namespace frazil
