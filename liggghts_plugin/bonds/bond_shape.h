/* What a row of the table has from its two spheres, and need not travel with the bond. */

#ifndef FRAZIL_BOND_SHAPE_H
#define FRAZIL_BOND_SHAPE_H

#include "bond_options.h"
#include "bond_table.h"

#include <algorithm>

namespace frazil
{

struct BondedSphere {
    double radius, mass; ///< [m], [kg]
};

inline void completeRow(BondTable& table, std::size_t k, const BondOptions& options, const BondedSphere& one,
                        const BondedSphere& two)
{
    table.radius[k] = options.radiusFactor * std::min(one.radius, two.radius);
    table.share[k] = one.radius / (one.radius + two.radius);
    table.strength[k] = options.weibullModulus > 0
                            ? weibullFactor(table.id1[k], table.id2[k], options.weibullModulus, options.weibullSeed)
                            : 1;
    const double j1 = 0.4 * one.mass * one.radius * one.radius, j2 = 0.4 * two.mass * two.radius * two.radius;
    table.reducedMass[k] = one.mass * two.mass / (one.mass + two.mass);
    table.reducedInertia[k] = j1 * j2 / (j1 + j2);
}

} // namespace frazil

#endif
