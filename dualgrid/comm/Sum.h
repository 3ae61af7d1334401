/// A few numbers over all ranks: collectives whose size depends on neither particles nor cells.
#pragma once

#include <cstdint>

#include <mpi.h>

namespace frazil
{

inline void sumOverRanks(double* values, int count, MPI_Comm comm)
{
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, comm);
}

/// Where this rank's items lie in the list of all ranks' items, in rank order.
struct Share {
    std::int64_t first = 0, total = 0;
};

inline Share shareOf(std::int64_t count, MPI_Comm comm)
{
    Share share;
    MPI_Scan(&count, &share.first, 1, MPI_INT64_T, MPI_SUM, comm);
    MPI_Allreduce(&count, &share.total, 1, MPI_INT64_T, MPI_SUM, comm);
    share.first -= count;
    return share;
}

inline int rankIn(MPI_Comm comm)
{
    int rank = 0;
    MPI_Comm_rank(comm, &rank);
    return rank;
}

inline int ranksIn(MPI_Comm comm)
{
    int ranks = 1;
    MPI_Comm_size(comm, &ranks);
    return ranks;
}

} // namespace frazil
