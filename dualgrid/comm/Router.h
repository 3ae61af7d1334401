/// Items to any rank of one communicator, and answers back in the order of the items.
///
/// For messages without a fixed pattern: who asks whom changes every time. What arrives is ordered by sender, then as
/// sent, so the result does not depend on the arrival of messages.
/// Cost: an all-to-all of counts (one int per rank) and one message per pair of ranks that talk; what one rank sends or
/// gets must stay below 2 GB. Parallel: collective.
#pragma once

#include <cstddef>
#include <numeric>
#include <type_traits>
#include <vector>

#include <mpi.h>

namespace frazil
{

class Router
{
  public:
    explicit Router(MPI_Comm comm) : comm_(comm) {}

    /// Item n goes to rank to[n]. Returns what this rank gets.
    template <class T> std::vector<T> send(const std::vector<int>& to, const std::vector<T>& items)
    {
        plan(to);
        std::vector<T> ordered(items.size());
        for (std::size_t n = 0; n < items.size(); ++n)
            ordered[place_[n]] = items[n];
        return exchange(ordered, sent_, received_);
    }

    /// One answer per item that the last send() brought. Returns one per item that this rank sent, in their order.
    template <class T> std::vector<T> answer(const std::vector<T>& answers)
    {
        const std::vector<T> ordered = exchange(answers, received_, sent_);
        std::vector<T> inOrder(place_.size());
        for (std::size_t n = 0; n < place_.size(); ++n)
            inOrder[n] = ordered[place_[n]];
        return inOrder;
    }

  private:
    void plan(const std::vector<int>& to)
    {
        int ranks = 0;
        MPI_Comm_size(comm_, &ranks);
        sent_.assign(ranks, 0);
        received_.assign(ranks, 0);
        for (const int rank : to)
            ++sent_[rank];
        MPI_Alltoall(sent_.data(), 1, MPI_INT, received_.data(), 1, MPI_INT, comm_);
        std::vector<int> next = starts(sent_, 1);
        place_.resize(to.size());
        for (std::size_t n = 0; n < to.size(); ++n)
            place_[n] = next[to[n]]++;
    }

    static std::vector<int> starts(const std::vector<int>& counts, int width)
    {
        std::vector<int> start(counts.size(), 0);
        for (std::size_t r = 1; r < counts.size(); ++r)
            start[r] = start[r - 1] + width * counts[r - 1];
        return start;
    }

    template <class T>
    std::vector<T> exchange(const std::vector<T>& out, std::vector<int> outCounts, std::vector<int> inCounts) const
    {
        static_assert(std::is_trivially_copyable<T>::value, "T is sent as bytes");
        const int width = int(sizeof(T));
        std::vector<T> in(std::accumulate(inCounts.begin(), inCounts.end(), 0));
        const std::vector<int> outStarts = starts(outCounts, width), inStarts = starts(inCounts, width);
        for (int& count : outCounts)
            count *= width;
        for (int& count : inCounts)
            count *= width;
        MPI_Alltoallv(out.data(), outCounts.data(), outStarts.data(), MPI_BYTE, in.data(), inCounts.data(),
                      inStarts.data(), MPI_BYTE, comm_);
        return in;
    }

    MPI_Comm comm_;
    std::vector<int> sent_, received_; ///< items per rank
    std::vector<int> place_;           ///< of each item, ordered by receiver
};

} // namespace frazil
