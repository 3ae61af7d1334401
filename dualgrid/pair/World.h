/// The one mpirun that both programs share, and this program's part of it.
///
///     mpirun -np 2 frazilDem ... : -np 4 frazilFoam ...
///
/// MPI_COMM_WORLD then holds six ranks. `own` is this program's part, split by what each process declared itself to be
/// (so a program may appear in several parts of the command line, as on machines with unlike nodes); the shim
/// (WorldShim.cpp) shows it to the host's libraries as if it were the world, because LIGGGHTS's timing, VTK and
/// OpenFOAM v1912 know nothing else. A program that runs alone gets own = world and nothing is changed.
///
/// Ends: whoever leaves before the coupling has said goodbye has failed. That may be MPI_Finalize (LIGGGHTS's
/// error->all), MPI_Abort (OpenFOAM in parallel), exit() (OpenFOAM in serial) or an exception. All come to fail(),
/// which prints who failed, tells the partner so that it can say the same in its own log, and aborts the pair. A killed
/// process is noticed by mpirun.
///
/// Cost: one MPI_Comm_split and one MPI_Comm_dup at the start.
#pragma once

#include <string>

#include <mpi.h>

namespace frazil
{

/// The two programs of a pair.
enum class Side { dem, foam };

/// "frazilDem" or "frazilFoam".
const char* programName(Side side);
inline Side partnerOf(Side side)
{
    return side == Side::dem ? Side::foam : Side::dem;
}

class World
{
  public:
    /// Says which program this is. First line of main, before MPI starts: the split follows inside MPI_Init or
    /// MPI_Init_thread, whoever calls it (LIGGGHTS's main, OpenFOAM's Pstream).
    static void declare(Side side);
    /// Was this process started by mpirun? A serial OpenFOAM program never starts MPI by itself; it must
    /// (UPstream::initNull) if it is to find a partner.
    static bool startedByMpirun();
    /// Throws InputError with the command to use if MPI has not been initialised (a serial program, not under mpirun).
    static World& instance();
    /// For the links: throws InputError with the command to use if there is no partner. From now on leaving is a
    /// failure of a running coupling, not of a program that never coupled.
    static World& coupledInstance();
    static bool started();
    /// Splits the world; called by the shim's MPI_Init and MPI_Init_thread.
    static void split();

    Side side() const { return side_; }
    /// Are there two programs?
    bool coupled() const { return coupled_; }
    /// Ranks of this program, numbered from 0. The whole world if it runs alone.
    MPI_Comm own() const { return own_; }
    /// Ranks of both programs; a communicator of the pair's own, so its messages meet nobody else's.
    MPI_Comm all() const { return all_; }
    int ownRank() const { return ownRank_; }
    int ownSize() const { return ownSize_; }
    int partnerSize() const { return partnerSize_; }
    /// Rank in all() of the partner's rank r.
    int partnerRank(int r) const { return partnerFirst_ + r; }

    /// Where the coupling stands, for messages: "fluid time 0.0013 s, step 27".
    void setPosition(const std::string& position) { position_ = position; }
    const std::string& position() const { return position_; }
    /// From now on leaving is no failure: both sides have agreed on the end (the links call it).
    void sayGoodbye() { goodbye_ = true; }
    /// Prints "<program> failed ...: <reason>", tells the partner, aborts both programs. Any rank may call it.
    [[noreturn]] void fail(const std::string& reason);
    /// Fails if this program is part of a running coupling; else returns.
    void leaving(const std::string& how);
    /// Has the partner told us that it failed? Then prints its reason and ends this program too.
    void watchForFailure();

  private:
    World() = default;
    void readSizes();
    void tellPartner(const std::string& words);
    [[noreturn]] void endAfterPartner(const std::string& words);

    Side side_ = Side::dem;
    bool coupled_ = false, linked_ = false, goodbye_ = false, failing_ = false;
    MPI_Comm own_ = MPI_COMM_NULL, all_ = MPI_COMM_NULL;
    int ownRank_ = 0, ownSize_ = 1;
    int partnerSize_ = 0, partnerFirst_ = 0;
    std::string position_ = "before the handshake";
};

} // namespace frazil
