/// The MPI calls of both hosts' libraries, with the world replaced by this program's part of it.
///
/// LIGGGHTS's timing (finish.cpp), VTK's parallel dumps (vtkMPIController) and all of OpenFOAM v1912 use
/// MPI_COMM_WORLD. With two programs in one mpirun they would wait for each other's collectives for ever. MPI's
/// profiling interface exists for this: a program may define any MPI_X itself and reach the library's own by PMPI_X.
/// Here every call that takes a communicator and that one of these libraries makes passes `ours(comm)` on, which is the
/// program's own part when the caller says world, and what the caller said otherwise. A program that runs alone passes
/// the world itself.
///
/// The executable must export these symbols (-rdynamic, CMake ENABLE_EXPORTS), so that libraries loaded before Open MPI
/// find them first. This file is an object library for that reason: from an archive the linker might leave it out.
/// Cost: one comparison per call.
#include <mpi.h>

#include "World.h"

namespace
{

inline MPI_Comm ours(MPI_Comm comm)
{
    return comm == MPI_COMM_WORLD && frazil::World::started() ? frazil::World::instance().own() : comm;
}

} // namespace

extern "C" {

// ---- Begin and end ----

int MPI_Init(int* argc, char*** argv)
{
    const int code = PMPI_Init(argc, argv);
    frazil::World::split();
    return code;
}

int MPI_Init_thread(int* argc, char*** argv, int required, int* provided)
{
    const int code = PMPI_Init_thread(argc, argv, required, provided);
    frazil::World::split();
    return code;
}

// LIGGGHTS's error->all finalises and exits: before the goodbye that is a failure of the pair.
int MPI_Finalize()
{
    if (frazil::World::started()) {
        frazil::World::instance().leaving("it called MPI_Finalize");
    }
    return PMPI_Finalize();
}

// OpenFOAM in parallel and LIGGGHTS's error->one. The world on purpose: the partner cannot go on alone.
int MPI_Abort(MPI_Comm comm, int code)
{
    if (frazil::World::started()) {
        frazil::World::instance().leaving("it called MPI_Abort");
    }
    return PMPI_Abort(frazil::World::started() && frazil::World::instance().coupled() ? MPI_COMM_WORLD : comm, code);
}

// ---- Every other call: FORWARD(name, (parameters), (arguments)) ----

#define FORWARD(name, parameters, arguments)                                                                           \
    int MPI_##name parameters                                                                                          \
    {                                                                                                                  \
        return PMPI_##name arguments;                                                                                  \
    }

// Communicators (VTK duplicates the world, LIGGGHTS splits it and lays a Cartesian grid over it)
FORWARD(Comm_size, (MPI_Comm comm, int* size), (ours(comm), size))
FORWARD(Comm_rank, (MPI_Comm comm, int* rank), (ours(comm), rank))
FORWARD(Comm_group, (MPI_Comm comm, MPI_Group* group), (ours(comm), group))
FORWARD(Comm_create, (MPI_Comm comm, MPI_Group group, MPI_Comm* made), (ours(comm), group, made))
FORWARD(Comm_dup, (MPI_Comm comm, MPI_Comm* made), (ours(comm), made))
FORWARD(Comm_split, (MPI_Comm comm, int colour, int key, MPI_Comm* made), (ours(comm), colour, key, made))
FORWARD(Comm_compare, (MPI_Comm a, MPI_Comm b, int* result), (ours(a), ours(b), result))
FORWARD(Comm_set_errhandler, (MPI_Comm comm, MPI_Errhandler handler), (ours(comm), handler))
FORWARD(Cart_create, (MPI_Comm comm, int dims, const int sizes[], const int periods[], int reorder, MPI_Comm* made),
        (ours(comm), dims, sizes, periods, reorder, made))

// Collectives
FORWARD(Barrier, (MPI_Comm comm), (ours(comm)))
FORWARD(Bcast, (void* data, int n, MPI_Datatype type, int root, MPI_Comm comm), (data, n, type, root, ours(comm)))
FORWARD(Reduce, (const void* in, void* out, int n, MPI_Datatype type, MPI_Op op, int root, MPI_Comm comm),
        (in, out, n, type, op, root, ours(comm)))
FORWARD(Allreduce, (const void* in, void* out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
        (in, out, n, type, op, ours(comm)))
FORWARD(Iallreduce, (const void* in, void* out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm, MPI_Request* r),
        (in, out, n, type, op, ours(comm), r))
FORWARD(Reduce_scatter, (const void* in, void* out, const int n[], MPI_Datatype type, MPI_Op op, MPI_Comm comm),
        (in, out, n, type, op, ours(comm)))
FORWARD(Scan, (const void* in, void* out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
        (in, out, n, type, op, ours(comm)))
FORWARD(Alltoall, (const void* in, int n, MPI_Datatype type, void* out, int m, MPI_Datatype outType, MPI_Comm comm),
        (in, n, type, out, m, outType, ours(comm)))
FORWARD(Alltoallv,
        (const void* in, const int n[], const int from[], MPI_Datatype type, void* out, const int m[], const int to[],
         MPI_Datatype outType, MPI_Comm comm),
        (in, n, from, type, out, m, to, outType, ours(comm)))
FORWARD(Gather,
        (const void* in, int n, MPI_Datatype type, void* out, int m, MPI_Datatype outType, int root, MPI_Comm comm),
        (in, n, type, out, m, outType, root, ours(comm)))
FORWARD(Gatherv,
        (const void* in, int n, MPI_Datatype type, void* out, const int m[], const int to[], MPI_Datatype outType,
         int root, MPI_Comm comm),
        (in, n, type, out, m, to, outType, root, ours(comm)))
FORWARD(Allgather, (const void* in, int n, MPI_Datatype type, void* out, int m, MPI_Datatype outType, MPI_Comm comm),
        (in, n, type, out, m, outType, ours(comm)))
FORWARD(Allgatherv,
        (const void* in, int n, MPI_Datatype type, void* out, const int m[], const int to[], MPI_Datatype outType,
         MPI_Comm comm),
        (in, n, type, out, m, to, outType, ours(comm)))
FORWARD(Scatter,
        (const void* in, int n, MPI_Datatype type, void* out, int m, MPI_Datatype outType, int root, MPI_Comm comm),
        (in, n, type, out, m, outType, root, ours(comm)))
FORWARD(Scatterv,
        (const void* in, const int n[], const int from[], MPI_Datatype type, void* out, int m, MPI_Datatype outType,
         int root, MPI_Comm comm),
        (in, n, from, type, out, m, outType, root, ours(comm)))

// Messages
FORWARD(Send, (const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm),
        (data, n, type, to, tag, ours(comm)))
FORWARD(Bsend, (const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm),
        (data, n, type, to, tag, ours(comm)))
FORWARD(Ssend, (const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm),
        (data, n, type, to, tag, ours(comm)))
FORWARD(Rsend, (const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm),
        (data, n, type, to, tag, ours(comm)))
FORWARD(Isend, (const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* r),
        (data, n, type, to, tag, ours(comm), r))
FORWARD(Issend, (const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* r),
        (data, n, type, to, tag, ours(comm), r))
FORWARD(Recv, (void* data, int n, MPI_Datatype type, int from, int tag, MPI_Comm comm, MPI_Status* status),
        (data, n, type, from, tag, ours(comm), status))
FORWARD(Irecv, (void* data, int n, MPI_Datatype type, int from, int tag, MPI_Comm comm, MPI_Request* r),
        (data, n, type, from, tag, ours(comm), r))
FORWARD(Sendrecv,
        (const void* data, int n, MPI_Datatype type, int to, int tag, void* in, int m, MPI_Datatype inType, int from,
         int inTag, MPI_Comm comm, MPI_Status* status),
        (data, n, type, to, tag, in, m, inType, from, inTag, ours(comm), status))
FORWARD(Probe, (int from, int tag, MPI_Comm comm, MPI_Status* status), (from, tag, ours(comm), status))
FORWARD(Iprobe, (int from, int tag, MPI_Comm comm, int* found, MPI_Status* status),
        (from, tag, ours(comm), found, status))

#undef FORWARD
}
