/* fix bond/parallel: refuses a time step above the stable one and warns of one close to it (equations:
   bond_frequency.h, contact_frequency.h).

   The bonds' frequency is found once per creation or restart. That of the contacts is bounded at every set-up: the
   largest sum over a sphere's contacts of the pair's own frequency squared, plus one new contact of a sphere with the
   stiffest material there is, at the overlap that the greatest speed found would drive it to.
   Cost: 60 products of the stiffness matrix once, a pass over the pair list per set-up. Parallel: sums and maxima over
   all ranks. */

#include "fix_bond_parallel.h"

#include "bond_frequency.h"
#include "contact_frequency.h"
#include "host_vector.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_property_global.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace frazil;

namespace
{

/// All times in s; contacts: square of their frequency [1/s2].
std::string describeTimeStep(double dt, double critical, double ofBonds, double contacts, double stable)
{
    char text[128];
    snprintf(text, sizeof text, "the time step of %g s is %.3g of the critical %.4g s (2/omega_max; bonds alone %.4g s",
             dt, dt / critical, critical, ofBonds);
    std::string result = text;
    if (contacts > 0) {
        snprintf(text, sizeof text, ", contacts alone %.4g s", 2 / std::sqrt(contacts));
        result += text;
    }
    if (stable < critical) {
        snprintf(text, sizeof text, "; the bonds' damping lowers the limit to %.4g s", stable);
        result += text;
    }
    return result + ")";
}

} // namespace

void FixBondParallel::checkTimeStep()
{
    const bool first = frequency_ == 0;
    if (first) {
        frequency_ = largestBondFrequency();
        dashpotTime_ = largestOfDashpots();
    }
    if (frequency_ == 0)
        return; // no bond is left
    const double bonds = frequency_ * frequency_, contacts = contactFrequencySquared();
    const StepLimit limit = stepLimit(bonds, contacts, dashpotTime_);

    const std::string numbers = describeTimeStep(update->dt, limit.critical, 2 / frequency_, contacts, limit.stable);
    char cure[64];
    snprintf(cure, sizeof cure, "; cure: 'timestep %.3g' or less", std::min(0.2 * limit.critical, 0.9 * limit.stable));
    if (update->dt > limit.stable)
        error->fix_error(FLERR, this, (numbers + cure).c_str());
    if (first)
        say(numbers);
    if (update->dt > 0.2 * limit.critical && comm->me == 0)
        error->warning(FLERR, ("Fix bond/parallel (id " + std::string(id) + "): " + numbers + cure).c_str());
}

/* ----------------------------------------------------------------------
   bonds
------------------------------------------------------------------------- */

double FixBondParallel::largestBondFrequency()
{
    VibratingSpheres spheres{atom->nlocal, atom->nlocal + atom->nghost, atom->tag, atom->rmass, atom->radius, {}, {}};
    spheres.fillGhosts = [this](std::vector<double>& motion) {
        vibration_ = &motion;
        comm->forward_comm_fix(this);
        vibration_ = nullptr;
    };
    spheres.sumOverRanks = [this](double here) {
        double sum;
        MPI_Allreduce(&here, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
        return sum;
    };
    return largestFrequency(table_, options_.material, spheres);
}

double FixBondParallel::largestOfDashpots()
{
    double here = largestDashpotTime(table_, options_.material), largest;
    MPI_Allreduce(&here, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
    return largest;
}

int FixBondParallel::pack_comm(int n, int* list, double* buffer, int, int*)
{
    for (int a = 0; a < n; ++a)
        std::copy_n(&(*vibration_)[6 * list[a]], 6, buffer + 6 * a);
    return 6;
}

void FixBondParallel::unpack_comm(int n, int first, double* buffer)
{
    std::copy_n(buffer, 6 * n, &(*vibration_)[6 * first]);
}

/* ----------------------------------------------------------------------
   contacts
------------------------------------------------------------------------- */

/// Bound on the square of the contacts' largest frequency [1/s2]; 0 without materials (property/global) for a contact
/// law.
double FixBondParallel::contactFrequencySquared()
{
    const auto property = [&](const char* name) {
        Fix* fix = modify->find_fix_property(name, "property/global", "peratomtype", 0, 0, style, false);
        return fix ? static_cast<FixPropertyGlobal*>(fix)->get_values() : nullptr;
    };
    const double *young = property("youngsModulus"), *poisson = property("poissonsRatio");
    if (!young || !poisson)
        return 0;
    const double here[2] = {presentContacts(young, poisson), newContact(young, poisson, greatestSpeed())};
    double all[2];
    MPI_Allreduce(here, all, 2, MPI_DOUBLE, MPI_MAX, world);
    return all[0] + all[1];
}

/// The largest sum over a sphere's contacts.
double FixBondParallel::presentContacts(const double* young, const double* poisson) const
{
    const NeighList* list = force->pair ? force->pair->list : nullptr;
    if (!list)
        return 0;
    std::vector<double> sums(atom->nlocal + atom->nghost, 0);
    for (int row = 0; row < list->inum; ++row) {
        const int i = list->ilist[row];
        for (int n = 0; n < list->numneigh[i]; ++n) {
            const int j = list->firstneigh[i][n] & NEIGHMASK;
            const double r1 = atom->radius[i], r2 = atom->radius[j];
            const double overlap = r1 + r2 - norm(vec(atom->x[j]) - vec(atom->x[i]));
            if (overlap <= 0)
                continue;
            const int a = atom->type[i] - 1, b = atom->type[j] - 1;
            const double perMass = 1 / atom->rmass[i] + 1 / atom->rmass[j]; // R^2/I = 2.5/m
            const double square = ContactModuli(young[a], poisson[a], young[b], poisson[b])
                                      .frequencySquared(r1 * r2 / (r1 + r2), overlap, perMass, 2.5 * perMass);
            sums[i] += square;
            sums[j] += square;
        }
    }
    return atom->nlocal ? *std::max_element(sums.begin(), sums.begin() + atom->nlocal) : 0;
}

/// A sphere of the group that is driven into something heavy of the stiffest material at `speed` [m/s].
double FixBondParallel::newContact(const double* young, const double* poisson, double speed) const
{
    const int stiffest = static_cast<int>(std::max_element(young, young + atom->ntypes) - young);
    double largest = 0;
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!(atom->mask[i] & groupbit))
            continue;
        const int a = atom->type[i] - 1;
        const ContactModuli moduli(young[a], poisson[a], young[stiffest], poisson[stiffest]);
        const double r = atom->radius[i], m = atom->rmass[i], overlap = moduli.impactOverlap(m, r, speed);
        largest = std::max(largest, moduli.frequencySquared(r, overlap, 1 / m, 2.5 / m));
    }
    return largest;
}

/// Bound on how fast any two of all spheres, rigid bodies and what stands still approach each other [m/s].
double FixBondParallel::greatestSpeed() const
{
    double extremes[6] = {0, 0, 0, 0, 0, 0}; // of the velocity, and of minus the velocity
    const auto include = [&](double vx, double vy, double vz) {
        const double v[6] = {vx, vy, vz, -vx, -vy, -vz};
        for (int c = 0; c < 6; ++c)
            extremes[c] = std::max(extremes[c], v[c]);
    };
    for (int i = 0; i < atom->nlocal; ++i)
        include(atom->v[i][0], atom->v[i][1], atom->v[i][2]);
    for (int n = 0; n < modify->nfix; ++n) {
        Fix* fix = modify->fix[n];
        if (strcmp(fix->style, "body/rigid") == 0)
            include(fix->compute_vector(3), fix->compute_vector(4), fix->compute_vector(5));
    }
    double all[6];
    MPI_Allreduce(extremes, all, 6, MPI_DOUBLE, MPI_MAX, world);
    return norm(Vec3{all[0] + all[3], all[1] + all[4], all[2] + all[5]});
}
