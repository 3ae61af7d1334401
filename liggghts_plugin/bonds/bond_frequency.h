/* The bonded structure's largest frequency, and the time step that it allows.

   Verlet's scheme is stable while 4 M - dt^2 K - 2 dt C is positive (M mass, K stiffness, C damping over all degrees of
   freedom; the dashpots see the motion of the last step). With the largest frequency of the bonds w_b (K_b, M), a bound
   w_c on that of the contacts, and C <= eta K_b, eta the largest ratio of a dashpot to its spring, this holds for

     dt <= dt_c = (sqrt(a^2 + 4 w^2) - a)/w^2,   w^2 = w_b^2 + w_c^2 (Weyl),   a = eta w_b^2;  without damping 2/w.

   w_b: Lanczos iteration on six degrees of freedom per sphere (from below, within about 0.5 %). Breaking only lowers
   it, so once per creation or restart is enough.
   Cost: 60 products of the stiffness matrix. Parallel: ghosts get their motion from their owners in each iteration;
   sums over all ranks; the same start on any number of ranks. */

#ifndef FRAZIL_BOND_FREQUENCY_H
#define FRAZIL_BOND_FREQUENCY_H

#include "bond_table.h"

#include <functional>

namespace frazil
{

/// The spheres with their masses, and the two messages that the iteration needs.
struct VibratingSpheres {
    int owned, all;       ///< spheres that the rank owns, and these with its ghosts
    const int* id;        ///< of each sphere
    const double* mass;   ///< [kg]
    const double* radius; ///< [m]
    /// Copies six numbers per sphere from the owners to the ghosts.
    std::function<void(std::vector<double>& motion)> fillGhosts;
    std::function<double(double)> sumOverRanks;
};

/// w_b [rad/s] of all ranks' bonds; 0 without any.
double largestFrequency(const BondTable& table, const BondMaterial& material, const VibratingSpheres& spheres);

/// result += K u for the owned spheres, u: three displacements [m] and three rotations [rad] of each sphere.
void addStiffnessTimes(const BondTable& table, const BondMaterial& material, const std::vector<double>& u,
                       std::vector<double>& result);

/// eta [s] of this rank's bonds.
double largestDashpotTime(const BondTable& table, const BondMaterial& material);

struct StepLimit {
    double critical; ///< without damping [s]
    double stable;   ///< dt_c [s]
};

/// Squares of the frequencies [1/s2] of bonds and contacts; eta [s].
StepLimit stepLimit(double bonds, double contacts, double dashpotTime);

} // namespace frazil

#endif
