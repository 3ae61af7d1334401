#include "Wait.h"

#include <algorithm>
#include <cstdlib>
#include <sched.h>
#include <unistd.h>

#include <fmt/format.h>

#include "InputError.h"
#include "World.h"

namespace frazil
{

namespace
{

// Yield while the answer may be a matter of microseconds, then sleep: short waits stay short, long ones cost nothing.
void backOff(double elapsed)
{
    if (elapsed < 1e-3) {
        sched_yield();
    } else {
        usleep(elapsed < 0.1 ? 50 : 200);
    }
}

} // namespace

void Patience::until(const char* what, const std::function<bool()>& done)
{
    World& world = World::instance();
    // The first rank talks with the partner; the others wait for the first one and shall not give up before it.
    const double limit = limit_ + (world.ownRank() == 0 ? 0 : 5);
    const double start = PMPI_Wtime();
    double elapsed = 0;
    while (!done()) {
        world.watchForFailure();
        backOff(elapsed);
        elapsed = PMPI_Wtime() - start;
        if (elapsed > limit) {
            giveUp(what);
        }
    }
    waited_ += PMPI_Wtime() - start;
}

void Patience::forRequest(const char* what, MPI_Request& request, MPI_Status* status)
{
    until(what, [&] {
        int done;
        PMPI_Test(&request, &done, status);
        return done != 0;
    });
}

void Patience::giveUp(const char* what) const
{
    World& world = World::instance();
    const char* partner = programName(partnerOf(world.side()));
    world.fail(fmt::format("it has waited {:g} s for {} to {}. {} is stuck, or it needs longer than {} allows", limit_,
                           partner, what, partner, setBy_));
}

double handshakeSeconds()
{
    const char* text = std::getenv("FRAZIL_HANDSHAKE_SECONDS");
    if (!text) {
        return 3600;
    }
    char* end = nullptr;
    const double seconds = std::strtod(text, &end);
    if (end == text || *end || !(seconds > 0)) {
        throw InputError("the environment", "FRAZIL_HANDSHAKE_SECONDS", text, "is not a number above zero",
                         "seconds that frazilDem waits for frazilFoam to read its mesh, e.g. 3600");
    }
    return seconds;
}

} // namespace frazil
