/// Sum of a few numbers over all ranks: one Allreduce whose size depends on neither particles nor cells.
#pragma once

#include <mpi.h>

namespace frazil {

inline void sumOverRanks(double* values, int count, MPI_Comm comm)
{
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, comm);
}

inline int rankIn(MPI_Comm comm)
{
    int rank = 0;
    MPI_Comm_rank(comm, &rank);
    return rank;
}

} // namespace frazil
