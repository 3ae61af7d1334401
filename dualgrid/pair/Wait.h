/// Waiting for the partner: never blind, never burning a core.
///
/// Open MPI's blocking calls spin, which starves the partner when both share a core, and they say nothing when the
/// partner is stuck. Here a wait is a loop of MPI_Test with a back-off from yielding to sleeps of at most 0.2 ms, and
/// a watchdog that ends the pair after the set time, saying who has waited for whom to do what.
#pragma once

#include <functional>
#include <string>

#include <mpi.h>

namespace frazil
{

class Patience
{
  public:
    /// Longest time to wait for the partner [s]. `setBy` tells the user what to change: "`watchdog` in ...".
    void setLimit(double seconds, const std::string& setBy)
    {
        limit_ = seconds;
        setBy_ = setBy;
    }
    double limit() const { return limit_; }

    /// Returns when done() does. `what` completes "... has waited 600 s for frazilFoam to".
    void until(const char* what, const std::function<bool()>& done);
    void forRequest(const char* what, MPI_Request& request, MPI_Status* status = MPI_STATUS_IGNORE);

    /// Time spent in all waits [s].
    double waited() const { return waited_; }

  private:
    [[noreturn]] void giveUp(const char* what) const;

    double limit_ = 600;
    std::string setBy_;
    double waited_ = 0;
};

/// FRAZIL_HANDSHAKE_SECONDS of the environment, 3600 without it: how long frazilDem waits for frazilFoam's first word,
/// which comes when the mesh has been read [s]. Throws InputError if it is no number above zero.
double handshakeSeconds();

} // namespace frazil
