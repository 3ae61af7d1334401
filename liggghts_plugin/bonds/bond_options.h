/* What the user says of the bonds: the words behind `bond/parallel`, read and checked. Units: SI, angles in degrees in
   the words and as their tangent here. */

#ifndef FRAZIL_BOND_OPTIONS_H
#define FRAZIL_BOND_OPTIONS_H

#include "Settings.h"
#include "parallel_bond.h"

#include <string>

namespace frazil
{

struct BondOptions {
    BondMaterial material;
    double radiusFactor = 1;   ///< disc radius over the smaller sphere's [-]
    double createGap = 0.01;   ///< largest surface gap of a bonded pair over its mean radius [-]
    double weibullModulus = 0; ///< of both strengths; 0: no scatter [-]
    int weibullSeed = 0;
    std::string listFile;   ///< pairs to bond instead of those within the gap; empty: none
    std::string eventsFile; ///< broken bonds; empty: none

    /// InputError on the first value that is missing or makes no sense.
    explicit BondOptions(const Settings& words);

  private:
    void readStrength(const Settings& words);
    void readWeibull(const Settings& words);
    void readDamping(const Settings& words);
};

} // namespace frazil

#endif
