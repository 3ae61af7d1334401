/* fix bond/parallel: the critical time step, from the bonds and the contacts that there are.

   Verlet's scheme is stable while 4 M - dt^2 K - 2 dt C is positive (M mass, K stiffness, C damping over all degrees of
   freedom; the dashpots see the motion of the last step). With the largest frequency of the bonds w_b (K_b, M), a bound w_c
   on that of the contacts, and C <= eta K_b, eta the largest ratio of a dashpot to its spring, this holds for

     dt <= dt_c = (sqrt(a^2 + 4 w^2) - a)/w^2,   w^2 = w_b^2 + w_c^2 (Weyl),   a = eta w_b^2;  without damping 2/w.

   Bonds: Lanczos iteration on six degrees of freedom per sphere (from below, within about 0.5 %). Breaking only lowers
   w_b, so once per creation or restart is enough.
   Contacts, at every set-up: w_c^2 <= largest sum over a sphere's contacts of the pair's own frequency squared,
   max(kn/m*, kt (1/m* + R1^2/I1 + R2^2/I2)), with Hertz-Mindlin's tangents kn = 2 E* sqrt(R* d), kt = 8 G* sqrt(R* d) at the
   overlap d; plus one new contact of a sphere with the stiffest material there is, at the overlap that the greatest speed
   V found would drive it to, d = (15 m V^2/(16 E* sqrt(R)))^0.4 (Hertz).

   Cost: 60 products of the stiffness matrix once, a pass over the pair list per set-up. Parallel: ghosts get their motion
   from their owners in each iteration; sums and maxima over all ranks. */

#include "fix_bond_parallel.h"

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
    const bool first = frequency_ == 0;
    if (first) {
        frequency_ = largestFrequency();
        dashpotTime_ = largestDashpotTime();
    }
    if (frequency_ == 0)
        return; // no bond is left
    const double bonds = frequency_ * frequency_, contacts = contactFrequencySquared();
    const double all = bonds + contacts, drag = dashpotTime_ * bonds;
    const double critical = 2 / std::sqrt(all), stable = (std::sqrt(drag * drag + 4 * all) - drag) / all;

    const std::string numbers = describeTimeStep(update->dt, critical, 2 / frequency_, contacts, stable);
    char cure[64];
    snprintf(cure, sizeof cure, "; cure: 'timestep %.3g' or less", std::min(0.2 * critical, 0.9 * stable));
    if (update->dt > stable)
        error->fix_error(FLERR, this, (numbers + cure).c_str());
    if (first)
        say(numbers);
    if (update->dt > 0.2 * critical && comm->me == 0)
        error->warning(FLERR, ("Fix bond/parallel (id " + std::string(id) + "): " + numbers + cure).c_str());
}

/// Largest ratio of a dashpot to its spring, eta [s].
double FixBondParallel::largestDashpotTime()
{
    double here = 0, largest;
    for (std::size_t k = 0; k < table_.size(); ++k) {
        const BondStiffness s = stiffnessOf(material_, table_.restLength[k], table_.radius[k]);
        const BondDashpots c = dashpotsOf(s, material_.damping, table_.reducedMass[k], table_.reducedInertia[k]);
        here = std::max({here, c.normal / s.normal, c.shear / s.shear, c.torsion / s.torsion, c.bending / s.bending});
    }
    MPI_Allreduce(&here, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
    return largest;
}

/* ----------------------------------------------------------------------
   contacts
------------------------------------------------------------------------- */

namespace
{

/// Hertz-Mindlin's moduli of two materials [Pa].
struct ContactModuli {
    double normal, tangential;

    ContactModuli(double young1, double poisson1, double young2, double poisson2)
        : normal(1 / ((1 - poisson1 * poisson1) / young1 + (1 - poisson2 * poisson2) / young2)),
          tangential(0.5 / ((2 - poisson1) * (1 + poisson1) / young1 + (2 - poisson2) * (1 + poisson2) / young2))
    {
    }

    /// Square of the largest frequency of a pair [1/s2]: radius R* and overlap [m], sum of 1/m [1/kg] and of R^2/I [1/kg].
    double frequencySquared(double radius, double overlap, double perMass, double perInertia) const
    {
        const double root = std::sqrt(radius * overlap);
        return root * std::max(2 * normal * perMass, 8 * tangential * (perMass + perInertia));
    }
};

} // namespace

/// Bound on the square of the contacts' largest frequency [1/s2]; 0 without materials (property/global) for a contact law.
double FixBondParallel::contactFrequencySquared()
{
    const auto property = [&](const char* name) {
        Fix* fix = modify->find_fix_property(name, "property/global", "peratomtype", 0, 0, style, false);
        return fix ? static_cast<FixPropertyGlobal*>(fix)->get_values() : NULL;
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
    const NeighList* list = force->pair ? force->pair->list : NULL;
    if (!list)
        return 0;
    std::vector<double> sums(atom->nlocal + atom->nghost, 0);
    for (int row = 0; row < list->inum; ++row) {
        const int i = list->ilist[row];
        for (int n = 0; n < list->numneigh[i]; ++n) {
            const int j = list->firstneigh[i][n] & NEIGHMASK;
            const double r1 = atom->radius[i], r2 = atom->radius[j];
            const double *x1 = atom->x[i], *x2 = atom->x[j];
            const double overlap = r1 + r2 - norm(Vec3{x2[0] - x1[0], x2[1] - x1[1], x2[2] - x1[2]});
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
        const double r = atom->radius[i], m = atom->rmass[i];
        const double overlap = std::pow(15 * m * speed * speed / (16 * moduli.normal * std::sqrt(r)), 0.4);
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

/* ----------------------------------------------------------------------
   bonds
------------------------------------------------------------------------- */

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
        for (double& u : vibration_)
            u /= length;
        comm->forward_comm_fix(this);
        result.assign(6 * all, 0);
        stiffnessTimes(result);
        const double old = iteration ? length : 0;
        for (int i = 0; i < owned; ++i)
            for (int c = 0; c < 6; ++c)
                result[6 * i + c] = result[6 * i + c] / inertia(i, c) - old * before[6 * i + c];
        diagonal.push_back(massProduct(result, vibration_));
        for (int n = 0; n < 6 * owned; ++n)
            result[n] -= diagonal.back() * vibration_[n];
        length = std::sqrt(massProduct(result, result));
        if (length < 1e-9 * diagonal.front())
            length = 0; // the start spans few modes, and they are found
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
        for (int c = 0; c < 6; ++c)
            here += inertia(i, c) * a[6 * i + c] * b[6 * i + c];
    MPI_Allreduce(&here, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
    return sum;
}

/// result += K u for the owned spheres, u = vibration_ (three displacements [m], three rotations [rad] per sphere).
void FixBondParallel::stiffnessTimes(std::vector<double>& result)
{
    const auto at = [](const std::vector<double>& v, int i, int c) {
        return Vec3{v[6 * i + c], v[6 * i + c + 1], v[6 * i + c + 2]};
    };
    const auto add = [&](int i, int c, const Vec3& v) {
        for (int axis = 0; axis < 3; ++axis)
            result[6 * i + c + axis] += v[axis];
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
    for (int a = 0; a < n; ++a)
        std::copy_n(&vibration_[6 * list[a]], 6, buffer + 6 * a);
    return 6;
}

void FixBondParallel::unpack_comm(int n, int first, double* buffer)
{
    std::copy_n(buffer, 6 * n, &vibration_[6 * first]);
}
