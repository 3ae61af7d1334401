#include "CoarseGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "InputError.h"

namespace frazil
{

namespace
{

const char* const file = "constant/couplingProperties";
const char* const axisName = "xyz";

std::string text(const Vec3& v)
{
    return fmt::format("({:.6g} {:.6g} {:.6g})", v.x, v.y, v.z);
}

/// The axis that floating particles do not spread along.
int verticalAxis(const Vec3& gravity, const CellIndex& n)
{
    if (dot(gravity, gravity) == 0)
        return int(std::min_element(n.begin(), n.end()) - n.begin());
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
        if (std::abs(gravity[a]) > std::abs(gravity[axis]))
            axis = a;
    }
    return axis;
}

/// Cells needed to cover `length`; a length that is whole up to rounding does not get one more.
int cellsAlong(double length, double cellSize)
{
    const double wholeUpToRounding = 1e-9;
    return std::max(1, int(std::ceil(length / cellSize - wholeUpToRounding)));
}

} // namespace

CoarseGrid::CoarseGrid(const Box& box, double cellSize, int owners, const Vec3& gravity)
    : box_(box), h_(cellSize), n_{}, blocks_{1, 1, 1}
{
    if (!(cellSize > 0)) {
        throw InputError(file, "coarseGrid.cellSize", fmt::format("{:g}", cellSize), "must be greater than zero",
                         "Make it 2 to 4 particle diameters");
    }
    for (int a = 0; a < 3; ++a) {
        const double length = box.size()[a];
        if (!(length > 0)) {
            throw InputError(file, "coarseGrid.max", text(box.max),
                             fmt::format("does not lie above min {} along {}", text(box.min), axisName[a]),
                             "Give the lower corner as min and the upper one as max");
        }
        if (length / cellSize > 1e6) {
            throw InputError(file, "coarseGrid.cellSize", fmt::format("{:g}", cellSize),
                             fmt::format("gives {:.3g} cells along {}", length / cellSize, axisName[a]),
                             "Make it 2 to 4 particle diameters");
        }
        n_[a] = cellsAlong(length, cellSize);
        box_.max[a] = box.min[a] + n_[a] * cellSize;
    }
    chooseBlocks(owners, verticalAxis(gravity, n_));
}

void CoarseGrid::chooseBlocks(int owners, int vertical)
{
    const int u = (vertical + 1) % 3, v = (vertical + 2) % 3;
    double least = std::numeric_limits<double>::max();
    for (int a = 1; a <= owners; ++a) {
        const int b = owners / a;
        if (a * b != owners || a > n_[u] || b > n_[v])
            continue;
        const double halfPerimeter = double(n_[u]) / a + double(n_[v]) / b;
        if (halfPerimeter < least) {
            least = halfPerimeter;
            blocks_[u] = a;
            blocks_[v] = b;
        }
    }
    if (least < std::numeric_limits<double>::max())
        return;
    throw InputError(
        file, "coarseGrid", "",
        fmt::format("{} x {} columns of cells across {} (the vertical) cannot be shared in blocks among {} "
                    "fluid ranks, at least one column each",
                    n_[u], n_[v], axisName[vertical], owners),
        "Use fewer fluid ranks, a smaller cellSize or a larger box");
}

std::int64_t CoarseGrid::cellOf(const Vec3& p) const
{
    if (!contains(p))
        return -1;
    CellIndex c;
    // The outermost face, and a point that rounding moves onto it, belong to the last cell.
    for (int a = 0; a < 3; ++a)
        c[a] = std::min(int((p[a] - box_.min[a]) / h_), n_[a] - 1);
    return id(c);
}

CellIndex CoarseGrid::nearest(const Vec3& p) const
{
    CellIndex c;
    for (int a = 0; a < 3; ++a)
        c[a] = int(std::clamp(std::floor((p[a] - box_.min[a]) / h_), 0.0, n_[a] - 1.0));
    return c;
}

Vec3 CoarseGrid::centre(std::int64_t id) const
{
    const CellIndex c = index(id);
    return {box_.min.x + (c[0] + 0.5) * h_, box_.min.y + (c[1] + 0.5) * h_, box_.min.z + (c[2] + 0.5) * h_};
}

Box CoarseGrid::cellBox(const CellIndex& c) const
{
    Box cell;
    for (int a = 0; a < 3; ++a) {
        cell.min[a] = box_.min[a] + c[a] * h_;
        cell.max[a] = box_.min[a] + (c[a] + 1) * h_;
    }
    return cell;
}

int CoarseGrid::ownerOf(const CellIndex& c) const
{
    // Inverse of lo = floor(n r / blocks) in block().
    int r[3];
    for (int a = 0; a < 3; ++a)
        r[a] = int((std::int64_t(c[a] + 1) * blocks_[a] - 1) / n_[a]);
    return r[0] + blocks_[0] * (r[1] + blocks_[1] * r[2]);
}

int CoarseGrid::ownerOf(const Vec3& p) const
{
    const std::int64_t cell = cellOf(p);
    return cell < 0 ? -1 : ownerOf(cell);
}

CoarseGrid::Block CoarseGrid::block(int owner) const
{
    const int r[3] = {owner % blocks_[0], owner / blocks_[0] % blocks_[1], owner / blocks_[0] / blocks_[1]};
    Block block{};
    for (int a = 0; a < 3; ++a) {
        block.lo[a] = int(std::int64_t(n_[a]) * r[a] / blocks_[a]);
        block.hi[a] = int(std::int64_t(n_[a]) * (r[a] + 1) / blocks_[a]);
    }
    return block;
}

void requireReach(const CoarseGrid& grid, const Box& reach)
{
    if (grid.contains(reach.min) && grid.contains(reach.max))
        return;
    throw InputError(file, "coarseGrid", "",
                     fmt::format("the box {} - {} is smaller than the particles' reach {} - {}", text(grid.box().min),
                                 text(grid.box().max), text(reach.min), text(reach.max)),
                     "Move min and max outwards until the particles' reach lies inside");
}

void requireCellSize(const CoarseGrid& grid, double largestDiameter)
{
    if (grid.cellSize() >= largestDiameter)
        return;
    throw InputError(file, "coarseGrid.cellSize", fmt::format("{:g}", grid.cellSize()),
                     fmt::format("is smaller than the largest particle's diameter {:g} m", largestDiameter),
                     "Make it 2 to 4 particle diameters");
}

} // namespace frazil
