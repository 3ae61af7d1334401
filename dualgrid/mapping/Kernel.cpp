#include "Kernel.h"

#include <algorithm>
#include <cmath>

namespace frazil
{

Stencil stencilOf(const LocalCells& cells, const Vec3& p)
{
    const CoarseGrid& grid = cells.grid();
    CellIndex side[2];
    double weight[2][3];
    for (int a = 0; a < 3; ++a) {
        const double s = (p[a] - grid.box().min[a]) / grid.cellSize() - 0.5; // in cells, from the first centre
        const double lower = std::floor(s);
        const int last = grid.cells()[a] - 1;
        side[0][a] = std::clamp(int(lower), 0, last);
        side[1][a] = std::clamp(int(lower) + 1, 0, last);
        weight[1][a] = s - lower;
        weight[0][a] = 1 - weight[1][a];
    }
    Stencil stencil;
    for (int n = 0; n < 8; ++n) {
        const int x = n & 1, y = n >> 1 & 1, z = n >> 2;
        stencil.cell[n] = cells.local(CellIndex{side[x][0], side[y][1], side[z][2]});
        stencil.weight[n] = weight[x][0] * weight[y][1] * weight[z][2];
    }
    return stencil;
}

bool reweigh(Stencil& stencil, const CoarseField<double>& importance)
{
    double scaled[8], sum = 0;
    for (int n = 0; n < 8; ++n)
        sum += scaled[n] = stencil.weight[n] * importance[stencil.cell[n]];
    if (!(sum > 0))
        return false;
    for (int n = 0; n < 8; ++n)
        stencil.weight[n] = scaled[n] / sum;
    return true;
}

} // namespace frazil
