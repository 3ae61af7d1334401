#include "compute_fragment.h"

#include "DidYouMean.h"
#include "InputError.h"
#include "Sphere.h"
#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_bond_parallel.h"
#include "fix_ids.h"
#include "memory.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <numeric>

using namespace LAMMPS_NS;

ComputeFragment::ComputeFragment(LAMMPS* lmp, int& iarg, int narg, char** arg) : Compute(lmp, iarg, narg, arg)
{
    if (narg != iarg + 1) {
        const frazil::InputError wrong("Compute fragment (id " + std::string(id) + ")", "", "",
                                       narg > iarg + 1 ? "has too many words" : "lacks the ID of a fix bond/parallel",
                                       "Write compute ID group fragment BONDFIX");
        error->all(FLERR, wrong.what());
    }
    bondFixId_ = arg[iarg++];
    peratom_flag = 1;
    size_peratom_cols = 0;
    vector_flag = 1;
    size_vector = 3;
    extvector = 0;
    comm_forward = 1;
    vector = new double[size_vector];
}

ComputeFragment::~ComputeFragment()
{
    memory->destroy(label_);
    delete[] vector;
}

void ComputeFragment::init()
{
    const int ifix = modify->find_fix(bondFixId_.c_str());
    bonds_ = ifix < 0 ? nullptr : dynamic_cast<FixBondParallel*>(modify->fix[ifix]);
    if (bonds_)
        return;
    const auto known = frazil::fixIds(*modify, [](Fix* fix) { return dynamic_cast<FixBondParallel*>(fix) != nullptr; });
    const frazil::InputError wrong("Compute fragment (id " + std::string(id) + ")", "", bondFixId_,
                                   "there is no fix bond/parallel of the ID '" + bondFixId_ + "'" +
                                       frazil::didYouMean(bondFixId_, known),
                                   "Give the ID of the bond fix");
    error->all(FLERR, wrong.what());
}

void ComputeFragment::compute_peratom()
{
    invoked_peratom = update->ntimestep;
    if (atom->nmax > nmax_) {
        memory->destroy(label_);
        nmax_ = atom->nmax;
        memory->create(label_, nmax_, "fragment:label");
        vector_atom = label_;
    }
    joinBonded();
    for (int i = 0; i < atom->nlocal + atom->nghost; ++i)
        label_[i] = atom->mask[i] & groupbit ? atom->tag[i] : 0;
    int changed = 1;
    while (changed) {
        const int here = lowerLabels();
        MPI_Allreduce(&here, &changed, 1, MPI_INT, MPI_MAX, world);
        if (changed)
            comm->forward_comm_compute(this);
    }
}

/// Union-find over the bonds that this rank knows; fragments of other ranks touch ours through ghosts.
void ComputeFragment::joinBonded()
{
    parent_.resize(atom->nlocal + atom->nghost);
    std::iota(parent_.begin(), parent_.end(), 0);
    const frazil::BondTable& table = bonds_->bonds();
    for (std::size_t k = 0; k < table.size(); ++k) {
        const int i = table.target1[k], j = table.target2[k];
        if (!(atom->mask[i] & groupbit) || !(atom->mask[j] & groupbit))
            continue;
        parent_[rootOf(i)] = rootOf(j);
    }
}

int ComputeFragment::rootOf(int i)
{
    while (parent_[i] != i)
        i = parent_[i] = parent_[parent_[i]];
    return i;
}

/// Gives every sphere of a piece the piece's smallest label; says whether an owned one changed.
bool ComputeFragment::lowerLabels()
{
    const int all = atom->nlocal + atom->nghost;
    for (int i = 0; i < all; ++i) {
        const int root = rootOf(i);
        label_[root] = std::min(label_[root], label_[i]);
    }
    bool changed = false;
    for (int i = 0; i < all; ++i) {
        const double lowest = label_[rootOf(i)];
        if (i < atom->nlocal && lowest < label_[i])
            changed = true;
        label_[i] = lowest;
    }
    return changed;
}

void ComputeFragment::compute_vector()
{
    invoked_vector = update->ntimestep;
    if (invoked_peratom != update->ntimestep)
        compute_peratom();
    double here = 0, fragments;
    for (int i = 0; i < atom->nlocal; ++i)
        if (atom->mask[i] & groupbit && label_[i] == atom->tag[i])
            here += 1;
    MPI_Allreduce(&here, &fragments, 1, MPI_DOUBLE, MPI_SUM, world);
    vector[0] = fragments;
    const double initial = bonds_->initialVolume();
    vector[1] = initial > 0 ? largestVolume() / initial : 0;
    vector[2] = 1 - vector[1];
}

/// Volume of the largest fragment [m3].
double ComputeFragment::largestVolume()
{
    std::unordered_map<int, double> mine, whole;
    for (int i = 0; i < atom->nlocal; ++i)
        if (atom->mask[i] & groupbit)
            mine[static_cast<int>(label_[i])] += frazil::volumeOf(atom->radius[i]);
    for (const FragmentPart& part : partsOfThisRank(mine))
        whole[static_cast<int>(part.label)] += part.volume;
    double here = 0, largest = 0;
    for (const auto& entry : whole)
        here = std::max(here, entry.second);
    MPI_Allreduce(&here, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
    return largest;
}

/// Each part of a fragment goes to the rank given by its label modulo the ranks; returns what came from all ranks.
std::vector<FragmentPart> ComputeFragment::partsOfThisRank(const std::unordered_map<int, double>& mine)
{
    const int ranks = comm->nprocs;
    std::vector<int> out(ranks), in(ranks), outStart(ranks + 1), inStart(ranks + 1);
    for (const auto& entry : mine)
        out[entry.first % ranks] += sizeof(FragmentPart);
    MPI_Alltoall(out.data(), 1, MPI_INT, in.data(), 1, MPI_INT, world);
    std::partial_sum(out.begin(), out.end(), outStart.begin() + 1);
    std::partial_sum(in.begin(), in.end(), inStart.begin() + 1);
    std::vector<FragmentPart> send(mine.size()), received(inStart[ranks] / sizeof(FragmentPart));
    std::vector<int> next(outStart);
    for (const auto& entry : mine) {
        int& at = next[entry.first % ranks];
        send[at / sizeof(FragmentPart)] = {double(entry.first), entry.second};
        at += sizeof(FragmentPart);
    }
    MPI_Alltoallv(send.data(), out.data(), outStart.data(), MPI_BYTE, received.data(), in.data(), inStart.data(),
                  MPI_BYTE, world);
    return received;
}

int ComputeFragment::pack_comm(int n, int* list, double* buffer, int, int*)
{
    for (int a = 0; a < n; ++a)
        buffer[a] = label_[list[a]];
    return 1;
}

void ComputeFragment::unpack_comm(int n, int first, double* buffer)
{
    std::copy_n(buffer, n, label_ + first);
}

double ComputeFragment::memory_usage()
{
    return nmax_ * sizeof(double) + parent_.capacity() * sizeof(int);
}
