/* IDs of the script's fixes, for a "did you mean". */

#ifndef FRAZIL_FIX_IDS_H
#define FRAZIL_FIX_IDS_H

#include "fix.h"
#include "modify.h"

#include <string>
#include <vector>

namespace frazil
{

/// Of the fixes for which `matches(fix)` holds.
template <class Matches> std::vector<std::string> fixIds(const LAMMPS_NS::Modify& modify, Matches matches)
{
    std::vector<std::string> ids;
    for (int n = 0; n < modify.nfix; ++n)
        if (matches(modify.fix[n]))
            ids.push_back(modify.fix[n]->id);
    return ids;
}

} // namespace frazil

#endif
