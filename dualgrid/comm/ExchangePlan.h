/// Who sends what to whom for the ghost cells of one communicator. Built once, used for any field on the same cells.
///
///   update      owner -> ghosts: every copy gets the owner's value
///   accumulate  ghosts -> owner: the owner adds the copies' contributions in rank order, so that the sum does not
///               depend on the arrival of messages;
///               the ghosts keep theirs. Adjoint of update.
///
/// Values lie as in LocalCells: owned first, ghosts after, in the order of the lists given here.
/// Cost: one message per neighbour; building asks each owner once (sparse exchange, DemLink.h). No allocation in use
/// once the buffers have grown. Parallel: collective.
#pragma once

#include <cstdint>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include <mpi.h>

#include "LocalCells.h"

namespace frazil
{

class ExchangePlan
{
  public:
    /// @param owned    global ids that this rank owns
    /// @param ghosts   global ids that it holds copies of
    /// @param ownerOf  rank that owns a global id
    ExchangePlan(const std::vector<std::int64_t>& owned, const std::vector<std::int64_t>& ghosts,
                 const std::function<int(std::int64_t)>& ownerOf, MPI_Comm comm);
    ExchangePlan(const LocalCells& cells, MPI_Comm comm);

    /// T: double or a struct of doubles, count() of them.
    template <class T> void update(T* values) { update(asDoubles(values), width<T>()); }
    template <class T> void accumulate(T* values) { accumulate(asDoubles(values), width<T>()); }

    int count() const { return ownedCount_ + int(ghostPlace_.size()); }

  private:
    struct Neighbour {
        int rank;
        int first, count; ///< range of ownedPlace_ or ghostPlace_
    };

    template <class T> static constexpr int width()
    {
        static_assert(std::is_trivially_copyable<T>::value && sizeof(T) % sizeof(double) == 0, "T is made of doubles");
        return int(sizeof(T) / sizeof(double));
    }
    template <class T> static double* asDoubles(T* values) { return reinterpret_cast<double*>(values); }

    void listGhosts(const std::vector<std::int64_t>& ghosts, const std::function<int(std::int64_t)>& ownerOf);
    void askOwners(const std::vector<std::int64_t>& owned, const std::vector<std::int64_t>& ghosts);
    void listHolders(const std::vector<std::int64_t>& owned,
                     std::vector<std::pair<int, std::vector<std::int64_t>>>& asked);
    void update(double* values, int width);
    void accumulate(double* values, int width);
    void transfer(const std::vector<Neighbour>& to, const std::vector<Neighbour>& from, int width);

    MPI_Comm comm_;
    int ownedCount_;
    std::vector<Neighbour> ghostOwners_;  ///< ranks that own my ghosts
    std::vector<Neighbour> ghostHolders_; ///< ranks that hold copies of my cells, in rank order
    std::vector<int> ghostPlace_;         ///< per ghost owner: places of the ghosts in the values
    std::vector<int> ownedPlace_;         ///< per ghost holder: places of the owned cells in the values
    std::vector<double> outgoing_, incoming_;
    std::vector<MPI_Request> requests_;
};

} // namespace frazil
