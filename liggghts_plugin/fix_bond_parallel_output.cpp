/* fix bond/parallel: results, events file, virial and stress. */

#include "fix_bond_parallel.h"

#include "InputError.h"

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
#include <cmath>
#include <cstring>
#include <tuple>

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
    double here[TOTALS] = {0, damped_, released_};
    double use[2] = {0, 0};
    for (std::size_t k = 0; k < table_.size(); ++k) {
        if (table_.target1[k] >= atom->nlocal)
            continue;
        const BondState state = table_.stateOf(k);
        const BondShape shape = table_.shapeOf(k);
        const BondStiffness stiffness = stiffnessOf(material_, shape.restLength, shape.radius);
        here[ELASTIC] += elasticEnergy(state, stiffness, shape.restLength);
        const BondUse used = useOf(state, stiffness, shape, material_);
        use[0] = std::max(use[0], used.tension);
        use[1] = std::max(use[1], used.shear);
    }
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

/// For compute pressure and stress/atom: elastic force times branch vector, half to each sphere.
void FixBondParallel::tallyVirial(int vflag)
{
    v_setup(vflag);
    for (std::size_t k = 0; k < table_.size(); ++k) {
        const BondState state = table_.stateOf(k);
        const BondStiffness stiffness = stiffnessOf(material_, table_.restLength[k], table_.radius[k]);
        const Vec3 f = elasticLoad(state, stiffness, table_.restLength[k]).force;
        const Vec3 d = -state.separation; // x1 - x2, as force f acts on 1
        double v[6] = {d.x * f.x,
                       d.y * f.y,
                       d.z * f.z,
                       0.5 * (d.x * f.y + d.y * f.x),
                       0.5 * (d.x * f.z + d.z * f.x),
                       0.5 * (d.y * f.z + d.z * f.y)};
        int list[2], n = 0;
        for (int target : {table_.target1[k], table_.target2[k]})
            if (target < atom->nlocal)
                list[n++] = target;
        v_tally(n, list, 2, v);
    }
}

/// Columns 3-8: sum over bonds and contacts of (branch from the centre) x (force), over the sphere's own volume,
/// tension positive. Contacts come from the pair style's per-atom virial, which has the opposite sign.
void FixBondParallel::stressArray()
{
    const int owned = atom->nlocal;
    double** contact = force->pair && force->pair->vflag_atom ? force->pair->vatom : NULL;
    for (int i = 0; i < owned; ++i)
        for (int c = 0; c < 6; ++c)
            array_atom[i][2 + c] = contact ? -contact[i][c] : 0;
    for (std::size_t k = 0; k < table_.size(); ++k) {
        const BondState state = table_.stateOf(k);
        const BondShape shape = table_.shapeOf(k);
        const BondStiffness stiffness = stiffnessOf(material_, shape.restLength, shape.radius);
        const Vec3 f = elasticLoad(state, stiffness, shape.restLength).force, &d = state.separation;
        const double v[6] = {d.x * f.x,
                             d.y * f.y,
                             d.z * f.z,
                             0.5 * (d.x * f.y + d.y * f.x),
                             0.5 * (d.x * f.z + d.z * f.x),
                             0.5 * (d.y * f.z + d.z * f.y)};
        const int target[2] = {table_.target1[k], table_.target2[k]};
        const double share[2] = {shape.share, 1 - shape.share};
        for (int end = 0; end < 2; ++end)
            if (target[end] < owned)
                for (int c = 0; c < 6; ++c)
                    array_atom[target[end]][2 + c] += share[end] * v[c];
    }
    for (int i = 0; i < owned; ++i) {
        const double perVolume = 0.75 / (M_PI * std::pow(atom->radius[i], 3));
        for (int c = 0; c < 6; ++c)
            array_atom[i][2 + c] *= perVolume;
    }
}

/// The pair style gives its per-atom virial only on steps announced beforehand by a compute.
void FixBondParallel::post_create()
{
    if (modify->find_compute((std::string(id) + "_contact_virial").c_str()) >= 0)
        return;
    stressId_ = new char[strlen(id) + 32];
    sprintf(stressId_, "%s_contact_virial", id);
    const char* arg[] = {stressId_, group->names[igroup], "stress/atom", "pair"};
    modify->add_compute(4, const_cast<char**>(arg));
}

void FixBondParallel::pre_delete(bool unfix)
{
    if (unfix && stressId_)
        modify->delete_compute(stressId_);
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
    const int compute = stressId_ ? modify->find_compute(stressId_) : -1;
    if (compute >= 0 && next > now)
        modify->compute[compute]->addstep(next);
}

/* ----------------------------------------------------------------------
   events
------------------------------------------------------------------------- */

void FixBondParallel::flushEvents()
{
    if (eventsFile_.empty())
        return;
    const int words = sizeof(Event) / sizeof(char);
    int here = static_cast<int>(events_.size()) * words;
    std::vector<int> counts(comm->nprocs), starts(comm->nprocs);
    MPI_Gather(&here, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, world);
    for (int rank = 1; rank < comm->nprocs; ++rank)
        starts[rank] = starts[rank - 1] + counts[rank - 1];
    std::vector<Event> all(comm->me == 0 ? (starts.back() + counts.back()) / words : 0);
    MPI_Gatherv(events_.data(), here, MPI_BYTE, all.data(), counts.data(), starts.data(), MPI_BYTE, 0, world);
    events_.clear();
    int fine = comm->me || writeEvents(all);
    if (!eventsOpened_) {
        MPI_Bcast(&fine, 1, MPI_INT, 0, world);
        eventsOpened_ = true;
        if (!fine) {
            const InputError wrong("", "events", eventsFile_, "cannot be written",
                                   "Name a file in a folder that exists and is writable");
            error->fix_error(FLERR, this, wrong.what());
        }
    }
    if (!fine)
        error->one(FLERR, ("Fix bond/parallel: the events file '" + eventsFile_ +
                           "' cannot be written any more; "
                           "cure: room on the disk, and leave its folder in place")
                              .c_str());
}

/// Rank 0: in the order of time and ids, whichever rank saw them. A restarted run appends.
bool FixBondParallel::writeEvents(std::vector<Event>& all)
{
    if (eventsOpened_ && all.empty())
        return true;
    const bool append = eventsOpened_ || restarted_;
    FILE* file = fopen(eventsFile_.c_str(), append ? "a" : "w");
    if (!file)
        return false;
    fseek(file, 0, SEEK_END);
    if (ftell(file) == 0)
        fputs("time,id1,id2,mode,x,y,z,sigma,tau\n", file);
    std::sort(all.begin(), all.end(), [](const Event& a, const Event& b) {
        return std::tie(a.time, a.id1, a.id2) < std::tie(b.time, b.id1, b.id2);
    });
    for (const Event& e : all)
        fprintf(file, "%.12g,%d,%d,%s,%.9g,%.9g,%.9g,%.9g,%.9g\n", e.time, e.id1, e.id2, e.shear ? "shear" : "tension",
                e.x, e.y, e.z, e.sigma, e.tau);
    return fclose(file) == 0;
}
