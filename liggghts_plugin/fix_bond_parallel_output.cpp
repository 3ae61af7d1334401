/* fix bond/parallel: results, events file, virial and stress. */

#include "fix_bond_parallel.h"

#include "InputError.h"
#include "Sphere.h"

#include "atom.h"
#include "comm.h"
#include "compute.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "output.h"
#include "pair.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace frazil;

/* ----------------------------------------------------------------------
   global vector
------------------------------------------------------------------------- */

/// Bonds on all ranks: asked for at every fluid step, so without their loads. A bond across ranks counts for the owner
/// of the lower id.
void FixBondParallel::reduceCounts()
{
    const auto owned = [this](int target) { return target < atom->nlocal; };
    const auto end = table_.target1.begin() + table_.size();
    double here[COUNTS] = {double(std::count_if(table_.target1.begin(), end, owned)), brokenTension_, brokenShear_};
    MPI_Allreduce(here, counts_, COUNTS, MPI_DOUBLE, MPI_SUM, world);
    countsAt_ = evaluations_;
}

/// Sums and maxima over the bonds of all ranks.
void FixBondParallel::reduceTotals()
{
    const BondTotals mine = totalsOf(table_, options_.material, atom->nlocal);
    const double here[TOTALS] = {mine.elasticEnergy, step_.damped, released_};
    const double use[2] = {mine.useTension, mine.useShear};
    MPI_Allreduce(here, totals_, TOTALS, MPI_DOUBLE, MPI_SUM, world);
    MPI_Allreduce(use, use_, 2, MPI_DOUBLE, MPI_MAX, world);
    totalsAt_ = evaluations_;
}

double FixBondParallel::compute_vector(int n)
{
    if (countsAt_ != evaluations_) {
        reduceCounts();
        flushEvents();
    }
    if (n > 3 && totalsAt_ != evaluations_)
        reduceTotals();
    switch (n) {
    case 0:
        return counts_[INTACT];
    case 1:
        return counts_[TENSION] + counts_[SHEAR];
    case 2:
        return counts_[TENSION];
    case 3:
        return counts_[SHEAR];
    case 4:
        return totals_[ELASTIC];
    case 5:
        return totals_[DAMPED] + totals_[RELEASED];
    case 6:
        return use_[0];
    case 7:
        return use_[1];
    default:
        return totals_[RELEASED];
    }
}

double FixBondParallel::memory_usage()
{
    const double perBond = 6 * sizeof(int) + (BondTable::stateColumns + 6) * sizeof(double);
    return table_.size() * perBond + store_.pool.capacity() * sizeof(BondHalf) +
           atom->nmax * (sizeof(BondStore::Owner) + sizeof(Vec3) + size_peratom_cols * sizeof(double));
}

/* ----------------------------------------------------------------------
   virial and stress
------------------------------------------------------------------------- */

/// For compute pressure and stress/atom: elastic force on sphere 1 times x1 - x2, half to each sphere.
void FixBondParallel::tallyVirial(int vflag)
{
    v_setup(vflag);
    for (std::size_t k = 0; k < table_.size(); ++k) {
        const Vec3 branch = -table_.stateOf(k).separation;
        SymmetricTensor virial = virialOf(branch, elasticForce(table_, k, options_.material));
        int list[2], n = 0;
        for (int target : {table_.target1[k], table_.target2[k]})
            if (target < atom->nlocal)
                list[n++] = target;
        v_tally(n, list, 2, virial.data());
    }
}

/// Columns 3-8: sum over bonds and contacts of (branch from the centre) x (force), over the sphere's own volume,
/// tension positive. Contacts come from the pair style's per-atom virial, which has the opposite sign.
void FixBondParallel::stressArray()
{
    const int owned = atom->nlocal;
    double** contact = force->pair && force->pair->vflag_atom ? force->pair->vatom : nullptr;
    for (int i = 0; i < owned; ++i)
        for (int c = 0; c < 6; ++c)
            array_atom[i][2 + c] = contact ? -contact[i][c] : 0;
    addBondVirial(table_, options_.material, owned, array_atom, 2);
    for (int i = 0; i < owned; ++i) {
        const double perVolume = 1 / volumeOf(atom->radius[i]);
        for (int c = 0; c < 6; ++c)
            array_atom[i][2 + c] *= perVolume;
    }
}

/// The pair style gives its per-atom virial only on steps announced beforehand by a compute.
void FixBondParallel::post_create()
{
    const std::string name = std::string(id) + "_contact_virial";
    if (modify->find_compute(name.c_str()) >= 0)
        return;
    stressId_ = name;
    const char* arg[] = {stressId_.c_str(), group->names[igroup], "stress/atom", "pair"};
    modify->add_compute(4, const_cast<char**>(arg));
}

void FixBondParallel::pre_delete(bool unfix)
{
    if (unfix && !stressId_.empty())
        modify->delete_compute(stressId_.c_str());
}

/// Announces the next step after `now` on which a dump or thermo may read the stress.
void FixBondParallel::scheduleStress(bigint now)
{
    if (now >= update->firststep && now < nextStress_)
        return;
    bigint next = now < update->ntimestep ? update->ntimestep : update->laststep;
    const auto consider = [&](int every) {
        if (every > 0)
            next = std::min(next, (now / every + 1) * every);
    };
    if (now == update->ntimestep) {
        for (int n = 0; n < output->ndump; ++n)
            consider(output->every_dump[n]);
        consider(output->thermo_every);
    }
    nextStress_ = next;
    const int compute = stressId_.empty() ? -1 : modify->find_compute(stressId_.c_str());
    if (compute >= 0 && next > now)
        modify->compute[compute]->addstep(next);
}

/* ----------------------------------------------------------------------
   events
------------------------------------------------------------------------- */

void FixBondParallel::flushEvents()
{
    if (options_.eventsFile.empty())
        return;
    int fine = writeNew(gatherEvents());
    if (!eventsOpened_) {
        MPI_Bcast(&fine, 1, MPI_INT, 0, world);
        eventsOpened_ = true;
        if (!fine) {
            const InputError wrong("", "events", options_.eventsFile, "cannot be written",
                                   "Name a file in a folder that exists and is writable");
            error->fix_error(FLERR, this, wrong.what());
        }
    }
    if (!fine)
        error->one(FLERR, ("Fix bond/parallel: the events file '" + options_.eventsFile +
                           "' cannot be written any more; cure: room on the disk, and leave its folder in place")
                              .c_str());
}

/// Those of all ranks, on rank 0.
std::vector<BondEvent> FixBondParallel::gatherEvents()
{
    const int size = sizeof(BondEvent), here = static_cast<int>(events_.size()) * size;
    std::vector<int> counts(comm->nprocs), starts(comm->nprocs);
    MPI_Gather(&here, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, world);
    for (int rank = 1; rank < comm->nprocs; ++rank)
        starts[rank] = starts[rank - 1] + counts[rank - 1];
    std::vector<BondEvent> all(comm->me == 0 ? (starts.back() + counts.back()) / size : 0);
    MPI_Gatherv(events_.data(), here, MPI_BYTE, all.data(), counts.data(), starts.data(), MPI_BYTE, 0, world);
    events_.clear();
    return all;
}

/// On rank 0; the first time also without an event, so that a file that cannot be written is told at once.
bool FixBondParallel::writeNew(std::vector<BondEvent> events)
{
    if (comm->me || (eventsOpened_ && events.empty()))
        return true;
    return writeEvents(options_.eventsFile, eventsOpened_ || restarted_, events);
}
