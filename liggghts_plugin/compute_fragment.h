/* compute ID group fragment BONDFIX: connected pieces of the bonded structure.

   Per-atom vector: id of the fragment = smallest particle id in it; a sphere without bonds is its own fragment;
   0 outside the group. Global vector: 1 fragments, 2 eta = solid volume of the largest fragment over that of the bond
   fix's group when its bonds were created, 3 loss 1 - eta.
   Algorithm: union-find over the bonds within a rank; across ranks, the smallest id seen by a piece travels over the
   ghosts until nothing changes anywhere. Cost: one pass over the bonds, then one message per rank boundary that an id
   must cross. Volumes are summed on the rank given by the fragment's id modulo the ranks, so that no array has the
   size of all particles. */

#ifndef LMP_COMPUTE_FRAGMENT_H
#define LMP_COMPUTE_FRAGMENT_H

#include "compute.h"

#include <string>
#include <unordered_map>
#include <vector>

namespace LAMMPS_NS
{

/// What one rank holds of a fragment.
struct FragmentPart {
    double label, volume; ///< id of the fragment, [m3]
};

class ComputeFragment : public Compute
{
  public:
    ComputeFragment(class LAMMPS*, int&, int, char**);
    ~ComputeFragment() override;

    void init() override;
    void compute_vector() override;
    void compute_peratom() override;
    int pack_comm(int, int*, double*, int, int*) override;
    void unpack_comm(int, int, double*) override;
    double memory_usage() override;

  private:
    void joinBonded();
    int rootOf(int);
    bool lowerLabels();
    double largestVolume();
    std::vector<FragmentPart> partsOfThisRank(const std::unordered_map<int, double>& mine);

    std::string bondFixId_;
    class FixBondParallel* bonds_ = nullptr;
    int nmax_ = 0;
    double* label_ = nullptr; // per owned and ghost sphere; ids are exact in doubles
    std::vector<int> parent_; // union-find over owned and ghost spheres
};

} // namespace LAMMPS_NS

#endif
