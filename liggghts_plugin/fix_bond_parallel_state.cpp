/* fix bond/parallel: how bonds travel: between particles and the table, between ranks, to restart files. */

#include "fix_bond_parallel.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "memory.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace frazil;

/* ----------------------------------------------------------------------
   table <-> particles
------------------------------------------------------------------------- */

/// Table -> particles. Called before anything that moves particles between indices or ranks.
void FixBondParallel::store()
{
    if (!tableNewer_)
        return;
    store_.fill(table_, owned_);
    tableNewer_ = false;
    comm->maxexchange_fix = std::max(comm->maxexchange_fix, BondStore::words(largestCount()));
}

/// Particles -> table, with fresh local indices.
void FixBondParallel::load()
{
    if (!created_)
        return;
    store();
    table_.clear();
    std::vector<int> missing;
    bool renumbered = false;
    for (int i = 0; i < atom->nlocal; ++i) {
        const BondStore::Owner owner = store_.owners[i];
        renumbered |= owner.count && owner.self != atom->tag[i];
        store_.owners[i].self = atom->tag[i];
        for (int h = owner.first; h < owner.first + owner.count; ++h)
            loadHalf(i, store_.pool[h], missing);
    }
    tableNewer_ = true;
    owned_ = atom->nlocal;
    countBonds();
    dropMissing(missing, renumbered);
    flushEvents();
}

/// A row for a bond of sphere i, unless it comes from the partner's half on this rank.
void FixBondParallel::loadHalf(int i, const BondHalf& half, std::vector<int>& missing)
{
    const int partner = atom->map(half.partner);
    const bool ordered = atom->tag[i] < half.partner;
    if (partner < 0) {
        missing.push_back(half.partner);
        return;
    }
    if (partner < atom->nlocal && !ordered)
        return;
    const int image = domain->closest_image(i, partner);
    const std::size_t k = addBond(ordered ? i : image, ordered ? image : i, ordered ? i : image, ordered ? image : i);
    table_.restLength[k] = half.restLength;
    for (int c = 0; c < BondTable::stateColumns; ++c)
        table_.state[c][k] = half.state[c];
    completeShape(k);
}

/// Partners that are nowhere took their bonds with them; one that exists beyond the ghosts is an error.
void FixBondParallel::dropMissing(const std::vector<int>& missing, bool renumbered)
{
    const int found[2] = {static_cast<int>(missing.size()), renumbered};
    int sums[2];
    MPI_Allreduce(found, sums, 2, MPI_INT, MPI_SUM, world);
    if (sums[1])
        error->fix_error(FLERR, this,
                         "particle ids changed while bonds refer to them; cure: delete_atoms ... compress no");
    if (sums[0] > 0)
        refuseFar(missing);
    countLost();
}

/// Does any rank own a sphere that another one misses?
void FixBondParallel::refuseFar(const std::vector<int>& missing)
{
    const int here = static_cast<int>(missing.size());
    std::vector<int> counts(comm->nprocs), starts(comm->nprocs);
    MPI_Allgather(&here, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
    for (int rank = 1; rank < comm->nprocs; ++rank)
        starts[rank] = starts[rank - 1] + counts[rank - 1];
    std::vector<int> ids(starts.back() + counts.back());
    MPI_Allgatherv(missing.data(), here, MPI_INT, ids.data(), counts.data(), starts.data(), MPI_INT, world);
    int far = 0, farthest = 0;
    for (int partner : ids) {
        const int i = atom->map(partner);
        if (i >= 0 && i < atom->nlocal)
            far = std::max(far, partner);
    }
    MPI_Allreduce(&far, &farthest, 1, MPI_INT, MPI_MAX, world);
    if (farthest == 0)
        return;
    char text[256];
    snprintf(text, sizeof text,
             "the bonded partner with id %d is farther away than the ghost distance of %g "
             "m; cure: 'communicate single vel yes cutoff %g'",
             farthest, comm->cutghost[0], 2 * comm->cutghost[0]);
    error->fix_error(FLERR, this, text);
}

/// Bonds that neither broke nor are there any more went with particles that were deleted or left the box.
void FixBondParallel::countLost()
{
    reduceCounts();
    const bigint present = static_cast<bigint>(counts_[INTACT] + counts_[TENSION] + counts_[SHEAR]);
    const bigint lost = initialBonds_ - present;
    if (lost > lostBonds_)
        say(std::to_string(lost - lostBonds_) + " bonds went with particles that were deleted or lost (" +
            std::to_string(lost) + " so far)");
    lostBonds_ = lost;
}

/// Columns 1 and 2 of the per-atom array.
void FixBondParallel::countBonds()
{
    for (int i = 0; i < atom->nlocal; ++i) {
        array_atom[i][0] = 0;
        array_atom[i][1] = store_.owners[i].initial;
    }
    for (std::size_t k = 0; k < table_.size(); ++k)
        for (int target : {table_.target1[k], table_.target2[k]})
            if (target < atom->nlocal)
                array_atom[target][0] += 1;
    comm->maxexchange_fix = std::max(comm->maxexchange_fix, BondStore::words(largestCount()));
}

int FixBondParallel::largestCount() const
{
    double largest = 0;
    for (int i = 0; i < atom->nlocal; ++i)
        largest = std::max(largest, array_atom[i][0]);
    return static_cast<int>(largest);
}

/* ----------------------------------------------------------------------
   the host's per-atom arrays
------------------------------------------------------------------------- */

void FixBondParallel::grow_arrays(int nmax)
{
    memory->grow(array_atom, nmax, size_peratom_cols, "bond/parallel:array_atom");
    store_.owners.resize(nmax);
}

void FixBondParallel::copy_arrays(int i, int j, int)
{
    store();
    store_.owners[j] = store_.owners[i];
    std::copy(array_atom[i], array_atom[i] + size_peratom_cols, array_atom[j]);
}

void FixBondParallel::set_arrays(int i)
{
    store();
    store_.owners[i] = BondStore::Owner();
    std::fill(array_atom[i], array_atom[i] + size_peratom_cols, 0.0);
}

int FixBondParallel::pack_exchange(int i, double* buffer)
{
    store();
    return store_.pack(i, buffer);
}

int FixBondParallel::unpack_exchange(int i, double* buffer)
{
    std::fill(array_atom[i], array_atom[i] + size_peratom_cols, 0.0);
    return store_.unpack(i, buffer);
}

/* ----------------------------------------------------------------------
   restart files
------------------------------------------------------------------------- */

int FixBondParallel::pack_restart(int i, double* buffer)
{
    store();
    buffer[0] = size_restart(i);
    return 1 + store_.pack(i, buffer + 1);
}

void FixBondParallel::unpack_restart(int i, int nth)
{
    const double* extra = atom->extra[i];
    int m = 0;
    for (int n = 0; n < nth; ++n)
        m += static_cast<int>(extra[m]);
    store_.unpack(i, extra + m + 1);
}

int FixBondParallel::size_restart(int i)
{
    store();
    return 1 + BondStore::words(store_.owners[i].count);
}

int FixBondParallel::maxsize_restart()
{
    store();
    int here = 0, all = 0;
    for (int i = 0; i < atom->nlocal; ++i)
        here = std::max(here, store_.owners[i].count);
    MPI_Allreduce(&here, &all, 1, MPI_INT, MPI_MAX, world);
    return 1 + BondStore::words(all);
}

void FixBondParallel::write_restart(FILE* file)
{
    const double here[4] = {brokenTension_, brokenShear_, step_.damped, released_};
    double all[4];
    MPI_Allreduce(here, all, 4, MPI_DOUBLE, MPI_SUM, world);
    const double record[9] = {double(created_),
                              double(initialBonds_),
                              double(lostBonds_),
                              initialVolume_,
                              clock_.now(*update),
                              all[0],
                              all[1],
                              all[2],
                              all[3]};
    if (comm->me)
        return;
    const int size = sizeof record;
    fwrite(&size, sizeof size, 1, file);
    fwrite(record, sizeof record, 1, file);
}

void FixBondParallel::restart(char* buffer)
{
    const double* record = reinterpret_cast<const double*>(buffer);
    created_ = restarted_ = record[0] != 0;
    initialBonds_ = static_cast<bigint>(record[1]);
    lostBonds_ = static_cast<bigint>(record[2]);
    initialVolume_ = record[3];
    clock_.restored(record[4]);
    if (comm->me)
        return; // sums over ranks start from rank 0
    brokenTension_ = record[5];
    brokenShear_ = record[6];
    step_.damped = record[7];
    released_ = record[8];
}
