/// ExchangePlan against a slow reference that knows every rank's values: update and accumulate of scalars and vectors.
/// Run on 1, 2 and 4 ranks; the exit code is the number of values that differ.
#include <cstdio>
#include <map>

#include "CoarseField.h"
#include "CoarseGrid.h"
#include "ExchangePlan.h"

using namespace frazil;

namespace
{

int rank, size;

std::vector<std::int64_t> touchedBy(int r, const CoarseGrid& grid)
{
    // cells far from the own block too, as fine cells of an awkward decomposition are
    std::vector<std::int64_t> ids;
    for (std::int64_t id = (7 * r) % 11; id < grid.cellCount(); id += 29) {
        ids.push_back(id);
    }
    return ids;
}

double valueOn(int r, std::int64_t id)
{
    return 1.0 / (3 + r) + 0.37 * double(id);
}

/// What accumulate must give: the owner's value, then the copies', in rank order.
double sumOverRanks(const CoarseGrid& grid, std::int64_t id)
{
    const int owner = grid.ownerOf(id);
    double sum = valueOn(owner, id);
    for (int r = 0; r < size; ++r) {
        if (r != owner && LocalCells(grid, r, touchedBy(r, grid)).local(id) >= 0) {
            sum += valueOn(r, id);
        }
    }
    return sum;
}

int compare(const char* what, double found, double expected)
{
    if (found == expected) {
        return 0;
    }
    std::printf("rank %d: %s: %.17g, expected %.17g\n", rank, what, found, expected);
    return 1;
}

} // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);

    const CoarseGrid grid({{0, 0, 0}, {0.6, 0.3, 0.7}}, 0.1, size, {0, -9.81, 0});
    const LocalCells cells(grid, rank, touchedBy(rank, grid));
    ExchangePlan plan(cells, MPI_COMM_WORLD);
    ExchangePlan again(cells, MPI_COMM_WORLD);
    int wrong = compare("count", plan.count(), cells.count());

    CoarseField<double> scalar(cells), sum(cells);
    CoarseField<Vec3> vector(cells);
    for (int c = 0; c < cells.count(); ++c) {
        const double value = valueOn(rank, cells.global(c));
        scalar[c] = sum[c] = value;
        vector[c] = {value, -value, 2 * value};
    }
    plan.update(scalar.data());
    again.update(vector.data());
    plan.accumulate(sum.data());
    for (int c = 0; c < cells.count(); ++c) {
        const std::int64_t id = cells.global(c);
        const double owners = valueOn(grid.ownerOf(id), id);
        wrong += compare("update", scalar[c], owners);
        wrong += compare("update of a vector", vector[c].y, -owners);
        wrong += compare("update of a vector", vector[c].z, 2 * owners);
        wrong += compare("accumulate", sum[c], c < cells.ownedCount() ? sumOverRanks(grid, id) : valueOn(rank, id));
    }
    std::printf("rank %d: %d cells, %d wrong values\n", rank, cells.count(), wrong);
    int worst;
    MPI_Allreduce(&wrong, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    MPI_Finalize();
    return worst > 0;
}
