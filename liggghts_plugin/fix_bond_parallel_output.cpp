/* fix bond/parallel: results, events file, virial and stress, critical time step. */

#include "fix_bond_parallel.h"

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
        if (table_.target1[k] >= atom->nlocal) continue;
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
    if (n > 3 && totalsAt_ != evaluations_) reduceTotals();
    switch (n) {
    case 0: return counts_[INTACT];
    case 1: return counts_[TENSION] + counts_[SHEAR];
    case 2: return counts_[TENSION];
    case 3: return counts_[SHEAR];
    case 4: return totals_[ELASTIC];
    case 5: return totals_[DAMPED] + totals_[RELEASED];
    case 6: return use_[0];
    case 7: return use_[1];
    default: return totals_[RELEASED];
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
        double v[6] = {d.x * f.x, d.y * f.y, d.z * f.z, 0.5 * (d.x * f.y + d.y * f.x), 0.5 * (d.x * f.z + d.z * f.x),
                       0.5 * (d.y * f.z + d.z * f.y)};
        int list[2], n = 0;
        for (int target : {table_.target1[k], table_.target2[k]})
            if (target < atom->nlocal) list[n++] = target;
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
        for (int c = 0; c < 6; ++c) array_atom[i][2 + c] = contact ? -contact[i][c] : 0;
    for (std::size_t k = 0; k < table_.size(); ++k) {
        const BondState state = table_.stateOf(k);
        const BondShape shape = table_.shapeOf(k);
        const BondStiffness stiffness = stiffnessOf(material_, shape.restLength, shape.radius);
        const Vec3 f = elasticLoad(state, stiffness, shape.restLength).force, &d = state.separation;
        const double v[6] = {d.x * f.x, d.y * f.y, d.z * f.z, 0.5 * (d.x * f.y + d.y * f.x),
                             0.5 * (d.x * f.z + d.z * f.x), 0.5 * (d.y * f.z + d.z * f.y)};
        const int target[2] = {table_.target1[k], table_.target2[k]};
        const double share[2] = {shape.share, 1 - shape.share};
        for (int end = 0; end < 2; ++end)
            if (target[end] < owned)
                for (int c = 0; c < 6; ++c) array_atom[target[end]][2 + c] += share[end] * v[c];
    }
    for (int i = 0; i < owned; ++i) {
        const double perVolume = 0.75 / (M_PI * std::pow(atom->radius[i], 3));
        for (int c = 0; c < 6; ++c) array_atom[i][2 + c] *= perVolume;
    }
}

/// The pair style gives its per-atom virial only on steps announced beforehand by a compute.
void FixBondParallel::post_create()
{
    if (modify->find_compute((std::string(id) + "_contact_virial").c_str()) >= 0) return;
    stressId_ = new char[strlen(id) + 32];
    sprintf(stressId_, "%s_contact_virial", id);
    const char* arg[] = {stressId_, group->names[igroup], "stress/atom", "pair"};
    modify->add_compute(4, const_cast<char**>(arg));
}

void FixBondParallel::pre_delete(bool unfix)
{
    if (unfix && stressId_) modify->delete_compute(stressId_);
}

/// Announces the next step after `now` on which a dump or thermo may read the stress.
void FixBondParallel::scheduleStress(bigint now)
{
    if (now >= update->firststep && now < nextStress_) return;
    bigint next = now < update->ntimestep ? update->ntimestep : update->laststep;
    const auto consider = [&](int every) {
        if (every > 0) next = std::min(next, (now / every + 1) * every);
    };
    if (now == update->ntimestep) {
        for (int n = 0; n < output->ndump; ++n) consider(output->every_dump[n]);
        consider(output->thermo_every);
    }
    nextStress_ = next;
    const int compute = stressId_ ? modify->find_compute(stressId_) : -1;
    if (compute >= 0 && next > now) modify->compute[compute]->addstep(next);
}

/* ----------------------------------------------------------------------
   events
------------------------------------------------------------------------- */

void FixBondParallel::flushEvents()
{
    if (eventsFile_.empty()) return;
    const int words = sizeof(Event) / sizeof(char);
    int here = static_cast<int>(events_.size()) * words;
    std::vector<int> counts(comm->nprocs), starts(comm->nprocs);
    MPI_Gather(&here, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, world);
    for (int rank = 1; rank < comm->nprocs; ++rank) starts[rank] = starts[rank - 1] + counts[rank - 1];
    std::vector<Event> all(comm->me == 0 ? (starts.back() + counts.back()) / words : 0);
    MPI_Gatherv(events_.data(), here, MPI_BYTE, all.data(), counts.data(), starts.data(), MPI_BYTE, 0, world);
    events_.clear();
    int fine = comm->me || writeEvents(all);
    if (!eventsOpened_) {
        MPI_Bcast(&fine, 1, MPI_INT, 0, world);
        eventsOpened_ = true;
        require(fine, "events", eventsFile_, "cannot be written", "name a file in a folder that exists and is writable");
    }
    if (!fine) error->one(FLERR, ("Fix bond/parallel: the events file '" + eventsFile_ + "' cannot be written any more; "
                                  "cure: room on the disk, and leave its folder in place").c_str());
}

/// Rank 0: in the order of time and ids, whichever rank saw them. A restarted run appends.
bool FixBondParallel::writeEvents(std::vector<Event>& all)
{
    if (eventsOpened_ && all.empty()) return true;
    const bool append = eventsOpened_ || restarted_;
    FILE* file = fopen(eventsFile_.c_str(), append ? "a" : "w");
    if (!file) return false;
    fseek(file, 0, SEEK_END);
    if (ftell(file) == 0) fputs("time,id1,id2,mode,x,y,z,sigma,tau\n", file);
    std::sort(all.begin(), all.end(), [](const Event& a, const Event& b) {
        return std::tie(a.time, a.id1, a.id2) < std::tie(b.time, b.id1, b.id2);
    });
    for (const Event& e : all)
        fprintf(file, "%.12g,%d,%d,%s,%.9g,%.9g,%.9g,%.9g,%.9g\n", e.time, e.id1, e.id2,
                e.shear ? "shear" : "tension", e.x, e.y, e.z, e.sigma, e.tau);
    return fclose(file) == 0;
}

/* ----------------------------------------------------------------------
   critical time step: dt_c = 2/omega_max, omega_max^2 the largest eigenvalue of (mass)^-1 (stiffness) of all bonds in
   the six degrees of freedom of each sphere, by Lanczos iteration in the inner product of the mass (from below, within
   about 0.5 %). Breaking only lowers it, so once per creation or restart is enough.
------------------------------------------------------------------------- */

namespace
{

/// Largest eigenvalue of the symmetric tridiagonal matrix, by bisection on the signs of its pivots.
double largestEigenvalue(const std::vector<double>& diagonal, const std::vector<double>& beside)
{
    double low = 0, high = 0;
    for (std::size_t i = 0; i < diagonal.size(); ++i)
        high = std::max(high, diagonal[i] + beside[i] + (i ? beside[i - 1] : 0));
    for (int halving = 0; halving < 50; ++halving) {
        const double x = 0.5 * (low + high);
        bool above = false; // is an eigenvalue above x?
        double pivot = 1;
        for (std::size_t i = 0; i < diagonal.size() && !above; ++i) {
            pivot = diagonal[i] - x - (i ? beside[i - 1] * beside[i - 1] / pivot : 0);
            above = pivot >= 0;
        }
        (above ? low : high) = x;
    }
    return high;
}

} // namespace

void FixBondParallel::checkTimeStep()
{
    if (frequency_ == 0) frequency_ = largestFrequency();
    if (frequency_ == 0) return; // no bond is left
    const double critical = 2 / frequency_, ratio = update->dt / critical;
    char text[512];
    snprintf(text, sizeof text, "the time step of %g s is %.3g of the critical %.4g s of the bonds (2/omega_max, "
             "omega_max = %.4g rad/s); cure: 'timestep %.3g' or less", update->dt, ratio, critical, frequency_,
             0.2 * critical);
    if (ratio > 1) error->fix_error(FLERR, this, text);
    if (ratio > 0.2 && comm->me == 0)
        error->warning(FLERR, ("Fix bond/parallel (id " + std::string(id) + "): " + text).c_str());
}

double FixBondParallel::largestFrequency()
{
    const int owned = atom->nlocal, all = owned + atom->nghost;
    std::vector<double> before(6 * all, 0), result, diagonal, beside;
    vibration_.assign(6 * all, 0);
    for (int i = 0; i < owned; ++i) // the same start on any number of ranks
        for (int c = 0; c < 6; ++c)
            vibration_[6 * i + c] = std::sin(12.9898 * atom->tag[i] + 78.233 * c) / (c < 3 ? 1 : atom->radius[i]);
    double length = std::sqrt(massProduct(vibration_, vibration_));
    for (int iteration = 0; iteration < 60 && length > 0; ++iteration) {
        for (double& u : vibration_) u /= length;
        comm->forward_comm_fix(this);
        result.assign(6 * all, 0);
        stiffnessTimes(result);
        const double old = iteration ? length : 0;
        for (int i = 0; i < owned; ++i)
            for (int c = 0; c < 6; ++c) result[6 * i + c] = result[6 * i + c] / inertia(i, c) - old * before[6 * i + c];
        diagonal.push_back(massProduct(result, vibration_));
        for (int n = 0; n < 6 * owned; ++n) result[n] -= diagonal.back() * vibration_[n];
        length = std::sqrt(massProduct(result, result));
        if (length < 1e-9 * diagonal.front()) length = 0; // the start spans few modes, and they are found
        beside.push_back(length);
        before.swap(vibration_);
        vibration_.swap(result);
    }
    std::vector<double>().swap(vibration_);
    return diagonal.empty() ? 0 : std::sqrt(largestEigenvalue(diagonal, beside));
}

/// Mass [kg] or moment of inertia [kg m2] of degree of freedom c of a sphere.
double FixBondParallel::inertia(int i, int c) const
{
    return atom->rmass[i] * (c < 3 ? 1 : 0.4 * atom->radius[i] * atom->radius[i]);
}

double FixBondParallel::massProduct(const std::vector<double>& a, const std::vector<double>& b)
{
    double here = 0, sum;
    for (int i = 0; i < atom->nlocal; ++i)
        for (int c = 0; c < 6; ++c) here += inertia(i, c) * a[6 * i + c] * b[6 * i + c];
    MPI_Allreduce(&here, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
    return sum;
}

/// result += K u for the owned spheres, u = vibration_ (three displacements [m], three rotations [rad] per sphere).
void FixBondParallel::stiffnessTimes(std::vector<double>& result)
{
    const auto at = [](const std::vector<double>& v, int i, int c) { return Vec3{v[6 * i + c], v[6 * i + c + 1], v[6 * i + c + 2]}; };
    const auto add = [&](int i, int c, const Vec3& v) {
        for (int axis = 0; axis < 3; ++axis) result[6 * i + c + axis] += v[axis];
    };
    for (std::size_t k = 0; k < table_.size(); ++k) {
        const BondStiffness s = stiffnessOf(material_, table_.restLength[k], table_.radius[k]);
        const int i = table_.at1[k], j = table_.at2[k];
        const double share = table_.share[k];
        const Vec3 d = table_.stateOf(k).separation, n = d / norm(d);
        const Vec3 turn1 = at(vibration_, i, 3), turn2 = at(vibration_, j, 3);
        const Vec3 slip = at(vibration_, j, 0) - at(vibration_, i, 0) - cross(share * turn1 + (1 - share) * turn2, d);
        const Vec3 bend = turn2 - turn1;
        const Vec3 f = s.shear * slip + (s.normal - s.shear) * dot(slip, n) * n;
        const Vec3 m = s.bending * bend + (s.torsion - s.bending) * dot(bend, n) * n;
        const Vec3 lever = cross(d, f);
        add(table_.target1[k], 0, -f);
        add(table_.target2[k], 0, f);
        add(table_.target1[k], 3, -(share * lever + m));
        add(table_.target2[k], 3, -((1 - share) * lever - m));
    }
}

int FixBondParallel::pack_comm(int n, int* list, double* buffer, int, int*)
{
    for (int a = 0; a < n; ++a) std::copy_n(&vibration_[6 * list[a]], 6, buffer + 6 * a);
    return 6;
}

void FixBondParallel::unpack_comm(int n, int first, double* buffer)
{
    std::copy_n(buffer, 6 * n, &vibration_[6 * first]);
}
