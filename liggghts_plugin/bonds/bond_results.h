/* What the bonds tell about themselves: energies and use of strength, virial and stress, the record of a broken bond.
   A bond across two ranks counts for the rank that owns its sphere of lower id; in per-sphere sums each rank serves the
   spheres that it owns. Cost: one pass over the table. Parallel: sums of this rank, for the caller to reduce. */

#ifndef FRAZIL_BOND_RESULTS_H
#define FRAZIL_BOND_RESULTS_H

#include "bond_table.h"

#include <string>

namespace frazil
{

struct BondTotals {
    double elasticEnergy = 0;            ///< [J]
    double useTension = 0, useShear = 0; ///< largest stress over strength [-]
};

BondTotals totalsOf(const BondTable& table, const BondMaterial& material, int owned);

/// xx yy zz xy xz yz of a symmetric tensor.
using SymmetricTensor = std::array<double, 6>;

/// Symmetric part of branch x force [J].
SymmetricTensor virialOf(const Vec3& branch, const Vec3& force);

/// Energy in the springs of bond k [J].
double elasticEnergyOf(const BondTable& table, std::size_t k, const BondMaterial& material);

/// Elastic force on sphere 1 of bond k [N].
Vec3 elasticForce(const BondTable& table, std::size_t k, const BondMaterial& material);

/// Adds to the owned spheres' rows, from `column` on, their share of each bond's virial [J], tension positive.
void addBondVirial(const BondTable& table, const BondMaterial& material, int owned, double* const* rows, int column);

/// One line of the events file.
struct BondEvent {
    double time; ///< [s]
    int id1, id2, shear;
    double x, y, z;    ///< bond centre [m]
    double sigma, tau; ///< [Pa]
};

/// Of bond k, which has just broken; x1: position of sphere 1 [m].
BondEvent eventOf(const BondTable& table, std::size_t k, const BondMaterial& material, bool shear, double time,
                  const Vec3& x1);

/// Writes events in the order of time and ids, with the header if the file is empty. False if the file cannot be
/// written.
bool writeEvents(const std::string& path, bool append, std::vector<BondEvent>& events);

} // namespace frazil

#endif
