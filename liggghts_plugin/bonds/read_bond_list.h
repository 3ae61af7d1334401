/* File of bonds: two particle ids per line, blanks between; the rest of a line after # and empty lines do not count. */

#ifndef FRAZIL_READ_BOND_LIST_H
#define FRAZIL_READ_BOND_LIST_H

#include <string>
#include <vector>

namespace frazil
{

struct ListedBond {
    int id1, id2, line; ///< id1 < id2; line of the file
};

using BondList = std::vector<ListedBond>;

/// Reads all pairs, in the file's order. Returns what is wrong with the file, or nothing.
std::string readBondList(const std::string& path, BondList& pairs);

} // namespace frazil

#endif
