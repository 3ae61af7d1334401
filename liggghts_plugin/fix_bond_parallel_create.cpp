/* fix bond/parallel: where bonds come from: every pair of the group within a gap, or the pairs of a file. */

#include "fix_bond_parallel.h"

#include "Sphere.h"
#include "bond_shape.h"
#include "host_vector.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "neigh_list.h"
#include "neighbor.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;
using namespace frazil;

namespace
{

/// What is wrong with a line of the list of bonds.
struct ListFault {
    enum Kind { NONE, FAR, OUTSIDE, UNKNOWN };
    int line = std::numeric_limits<int>::max();
    int kind = NONE;

    void blame(int itsLine, Kind itsKind)
    {
        if (itsLine < line)
            *this = {itsLine, itsKind};
    }

    std::string describe(const std::string& file, const BondList& pairs) const
    {
        static const char* const texts[] = {
            "", "lie so far apart that no rank sees both; cure: 'communicate single vel yes cutoff <m>'",
            "are not both in the fix's group; cure: a group that holds them, or another list",
            "do not both exist; cure: the ids of the data file, and spheres that exist before the first run"};
        const auto at = std::find_if(pairs.begin(), pairs.end(), [&](const ListedBond& p) { return p.line == line; });
        return "list " + file + ", line " + std::to_string(line) + ": the spheres " + std::to_string(at->id1) +
               " and " + std::to_string(at->id2) + " " + texts[kind];
    }
};

} // namespace

void FixBondParallel::create()
{
    if (options_.listFile.empty())
        bondNeighbours();
    else
        bondListed();
    startFromRest();
    countInitial();
    if (options_.listFile.empty())
        checkReach();
    say(std::to_string(initialBonds_) + " bonds created");
}

/// The bonds' rest lengths are the distances of now.
void FixBondParallel::startFromRest()
{
    for (std::size_t k = 0; k < table_.size(); ++k) {
        const Vec3 d = vec(atom->x[table_.at2[k]]) - vec(atom->x[table_.at1[k]]);
        table_.restLength[k] = norm(d);
        for (int axis = 0; axis < 3; ++axis)
            table_.state[BondTable::separation + axis][k] = d[axis];
        completeShape(k);
    }
    created_ = tableNewer_ = true;
}

void FixBondParallel::countInitial()
{
    owned_ = atom->nlocal;
    for (int i = 0; i < owned_; ++i)
        store_.owners[i].self = atom->tag[i];
    countBonds();
    double volume = 0;
    for (int i = 0; i < owned_; ++i) {
        store_.owners[i].initial = static_cast<int>(array_atom[i][0]);
        array_atom[i][1] = array_atom[i][0];
        if (atom->mask[i] & groupbit)
            volume += volumeOf(atom->radius[i]);
    }
    MPI_Allreduce(&volume, &initialVolume_, 1, MPI_DOUBLE, MPI_SUM, world);
    reduceCounts();
    initialBonds_ = static_cast<bigint>(counts_[INTACT]);
}

/* ----------------------------------------------------------------------
   from a full neighbour list, so that each rank finds all bonds of its own spheres
------------------------------------------------------------------------- */

void FixBondParallel::bondNeighbours()
{
    neighbor->build_one(list_->index);
    smallestGap_ = std::numeric_limits<double>::max();
    largestReach_ = 0;
    for (int row = 0; row < list_->inum; ++row) {
        const int i = list_->ilist[row];
        if (!(atom->mask[i] & groupbit))
            continue;
        for (int n = 0; n < list_->numneigh[i]; ++n) {
            const int j = list_->firstneigh[i][n] & NEIGHMASK;
            if (atom->mask[j] & groupbit)
                bondIfNear(i, j);
        }
    }
}

void FixBondParallel::bondIfNear(int i, int j)
{
    const double *x1 = atom->x[i], *x2 = atom->x[j];
    const double distance =
        std::sqrt(std::pow(x2[0] - x1[0], 2) + std::pow(x2[1] - x1[1], 2) + std::pow(x2[2] - x1[2], 2));
    const double gap = distance - atom->radius[i] - atom->radius[j];
    const double mean = 0.5 * (atom->radius[i] + atom->radius[j]);
    smallestGap_ = std::min(smallestGap_, gap / mean);
    largestReach_ = std::max(largestReach_, options_.createGap * mean);
    if (gap <= options_.createGap * mean)
        bondFrom(i, j);
}

/// Bond of the owned sphere i with j, seen from i; if both are owned the lower id's sphere adds it.
void FixBondParallel::bondFrom(int i, int j)
{
    const bool ordered = atom->tag[i] < atom->tag[j];
    if (!ordered && atom->map(atom->tag[j]) < atom->nlocal)
        return;
    addBond(ordered ? i : j, ordered ? j : i, ordered ? i : j, ordered ? j : i);
}

/// Could pairs have been missed, and is there any bond at all?
void FixBondParallel::checkReach()
{
    double reach, nearest;
    MPI_Allreduce(&largestReach_, &reach, 1, MPI_DOUBLE, MPI_MAX, world);
    MPI_Allreduce(&smallestGap_, &nearest, 1, MPI_DOUBLE, MPI_MIN, world);
    if (reach > neighbor->skin) {
        char text[512];
        snprintf(text, sizeof text,
                 "create_gap %g reaches %g m, beyond the neighbour skin of %g m, so pairs would be missed; cure: "
                 "'neighbor %g bin' or a smaller create_gap",
                 options_.createGap, reach, neighbor->skin, 1.1 * reach);
        error->fix_error(FLERR, this, text);
    }
    if (initialBonds_ == 0)
        error->fix_error(FLERR, this, noPairInReach(nearest).c_str());
}

/// nearest: smallest surface gap found, in mean radii.
std::string FixBondParallel::noPairInReach(double nearest) const
{
    char text[512];
    if (nearest < std::numeric_limits<double>::max())
        snprintf(text, sizeof text,
                 "no pair of the group is in reach: the smallest surface gap is %g of the mean "
                 "radius, create_gap is %g; cure: create_gap above %g, or check the particles' positions and group",
                 nearest, options_.createGap, nearest);
    else
        snprintf(text, sizeof text,
                 "no pair of the group is in reach: not one within the neighbour distance of "
                 "contact plus %g m; cure: check the particles' positions, radii and group, and that they exist "
                 "before the first run",
                 neighbor->skin);
    return text;
}

/* ----------------------------------------------------------------------
   from a file of pairs
------------------------------------------------------------------------- */

void FixBondParallel::bondListed()
{
    const BondList pairs = listedBonds();
    checkListed(pairs);
    for (const ListedBond& pair : pairs)
        for (const auto& ends : {std::array<int, 2>{pair.id1, pair.id2}, std::array<int, 2>{pair.id2, pair.id1}}) {
            const int i = atom->map(ends[0]), partner = atom->map(ends[1]);
            if (i >= 0 && i < atom->nlocal)
                bondFrom(i, domain->closest_image(i, partner));
        }
}

/// The file's pairs, on every rank; rank 0 reads it.
BondList FixBondParallel::listedBonds()
{
    BondList pairs;
    std::string problem;
    if (comm->me == 0)
        problem = readBondList(options_.listFile, pairs);
    int numbers[2] = {static_cast<int>(problem.size()), static_cast<int>(pairs.size())};
    MPI_Bcast(numbers, 2, MPI_INT, 0, world);
    problem.resize(numbers[0]);
    MPI_Bcast(&problem[0], numbers[0], MPI_CHAR, 0, world);
    if (!problem.empty())
        error->fix_error(FLERR, this, problem.c_str());
    pairs.resize(numbers[1]);
    MPI_Bcast(pairs.data(), 3 * numbers[1], MPI_INT, 0, world);
    return pairs;
}

/// Every sphere of the list exists, is in the group and within sight of its partner's rank.
void FixBondParallel::checkListed(const BondList& pairs)
{
    ListFault first; // the first line of the file that this rank blames
    std::vector<int> owners(2 * pairs.size());
    for (std::size_t n = 0; n < pairs.size(); ++n)
        for (int end = 0; end < 2; ++end) {
            const int i = atom->map(end ? pairs[n].id2 : pairs[n].id1);
            if (i < 0 || i >= atom->nlocal)
                continue;
            owners[2 * n + end] = 1;
            if (!(atom->mask[i] & groupbit))
                first.blame(pairs[n].line, ListFault::OUTSIDE);
            else if (atom->map(end ? pairs[n].id1 : pairs[n].id2) < 0)
                first.blame(pairs[n].line, ListFault::FAR);
        }
    MPI_Allreduce(MPI_IN_PLACE, owners.data(), static_cast<int>(owners.size()), MPI_INT, MPI_SUM, world);
    for (std::size_t n = owners.size(); n-- > 0;)
        if (!owners[n] && pairs[n / 2].line <= first.line)
            first = {pairs[n / 2].line, ListFault::UNKNOWN};
    ListFault worst; // of all ranks
    MPI_Allreduce(&first, &worst, 1, MPI_2INT, MPI_MINLOC, world);
    if (worst.kind != ListFault::NONE)
        error->fix_error(FLERR, this, worst.describe(options_.listFile, pairs).c_str());
}

/* ----------------------------------------------------------------------
   rows of the table
------------------------------------------------------------------------- */

std::size_t FixBondParallel::addBond(int at1, int at2, int target1, int target2)
{
    const std::size_t k = table_.add();
    table_.id1[k] = atom->tag[at1];
    table_.id2[k] = atom->tag[at2];
    table_.at1[k] = at1;
    table_.at2[k] = at2;
    // A periodic image of an owned sphere stands for that sphere.
    const int owner1 = atom->map(table_.id1[k]), owner2 = atom->map(table_.id2[k]);
    table_.target1[k] = owner1 < atom->nlocal ? owner1 : target1;
    table_.target2[k] = owner2 < atom->nlocal ? owner2 : target2;
    return k;
}

void FixBondParallel::completeShape(std::size_t k)
{
    const int i = table_.at1[k], j = table_.at2[k];
    completeRow(table_, k, options_, {atom->radius[i], atom->rmass[i]}, {atom->radius[j], atom->rmass[j]});
}
