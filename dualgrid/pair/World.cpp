#include "World.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <unistd.h>
#include <vector>

#include "InputError.h"

namespace frazil
{

namespace
{

// Last words travel on their own tag, looked for in every wait.
constexpr int lastWordsTag = 99;
// Long enough for a partner that waits to read them, short enough for "ends within seconds" [s].
constexpr double grace = 1.5;

World* world = nullptr;
Side declaredSide = Side::dem;

bool mpiIsRunning()
{
    int initialised = 0, finalised = 0;
    PMPI_Initialized(&initialised);
    PMPI_Finalized(&finalised);
    return initialised && !finalised;
}

void sleepFor(double seconds)
{
    usleep(static_cast<useconds_t>(seconds * 1e6));
}

// exit() without MPI_Finalize: OpenFOAM in serial, both in the end and after a fatal error.
void atExit()
{
    if (!mpiIsRunning()) {
        return;
    }
    world->leaving("it called exit()");
    PMPI_Finalize();
}

void atTerminate()
{
    std::string reason = "std::terminate";
    try {
        if (std::exception_ptr current = std::current_exception()) {
            std::rethrow_exception(current);
        }
    } catch (const std::exception& e) {
        reason = e.what();
    } catch (...) {
        reason = "an unknown exception";
    }
    if (mpiIsRunning()) {
        world->fail(reason);
    }
    std::abort();
}

InputError noPartner(Side side)
{
    return InputError("", "", "", std::string(programName(side)) + " has no partner: it was started alone",
                      "start both in one command: mpirun -np 1 frazilDem -in SCRIPT : -np 1 frazilFoam -case CASE "
                      "(with -parallel behind CASE if frazilFoam gets more than one rank)");
}

void printLine(const std::string& line)
{
    std::fflush(stdout);
    std::fprintf(stderr, "\n%s\n", line.c_str());
    std::fflush(stderr);
}

} // namespace

const char* programName(Side side)
{
    return side == Side::dem ? "frazilDem" : "frazilFoam";
}

void World::declare(Side side)
{
    declaredSide = side;
}

bool World::startedByMpirun()
{
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMIX_RANK"}) {
        if (std::getenv(name)) {
            return true;
        }
    }
    return false;
}

bool World::started()
{
    return world != nullptr;
}

World& World::instance()
{
    if (!world) {
        throw noPartner(declaredSide);
    }
    return *world;
}

World& World::coupledInstance()
{
    World& here = instance();
    if (!here.coupled_) {
        throw noPartner(here.side_);
    }
    here.linked_ = true;
    return here;
}

void World::split()
{
    if (world) {
        return;
    }
    // Lives until the process ends: the handlers below use it.
    world = new World;
    world->side_ = declaredSide;
    world->readSizes();
    std::set_terminate(atTerminate);
    if (world->coupled_) {
        std::atexit(atExit);
    }
}

void World::readSizes()
{
    int worldRank, worldSize, isFoam = side_ == Side::foam, foamRanks;
    PMPI_Comm_rank(MPI_COMM_WORLD, &worldRank);
    PMPI_Comm_size(MPI_COMM_WORLD, &worldSize);
    PMPI_Allreduce(&isFoam, &foamRanks, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    coupled_ = foamRanks > 0 && foamRanks < worldSize;
    if (coupled_) {
        // frazilDem's ranks first, so that each program's ranks are a range of all()
        PMPI_Comm_split(MPI_COMM_WORLD, isFoam, worldRank, &own_);
        PMPI_Comm_split(MPI_COMM_WORLD, 0, isFoam * worldSize + worldRank, &all_);
        partnerFirst_ = isFoam ? 0 : worldSize - foamRanks;
    } else {
        own_ = all_ = MPI_COMM_WORLD;
    }
    PMPI_Comm_rank(own_, &ownRank_);
    PMPI_Comm_size(own_, &ownSize_);
    partnerSize_ = worldSize - ownSize_;
}

void World::leaving(const std::string& how)
{
    if (!coupled_ || goodbye_) {
        return;
    }
    if (linked_) {
        fail(how + " before the coupling had ended; its own last message says why");
    }
    fail(how + " without ever coupling; " +
         (side_ == Side::dem ? "either its own last message says why, or its input script has no fix couple/foam"
                             : "either its own last message says why, or its case has no constant/couplingProperties"));
}

void World::fail(const std::string& reason)
{
    // A failure while failing (an error in a destructor, a second call from exit) must not start over.
    if (!failing_) {
        failing_ = true;
        // Errors are mostly raised on all ranks at once: the first one speaks, the others only if it does not.
        if (ownRank_ != 0) {
            sleepFor(2 * grace);
        }
        const std::string where = coupled_ ? " (" + position_ + ")" : "";
        const std::string words = std::string(programName(side_)) + " failed" + where + ": " + reason;
        printLine(words);
        if (coupled_) {
            tellPartner(words);
        } else {
            sleepFor(grace); // mpirun may drop what it has not forwarded when a rank aborts
        }
    }
    PMPI_Abort(MPI_COMM_WORLD, 1);
    std::_Exit(1);
}

void World::tellPartner(const std::string& words)
{
    std::vector<MPI_Request> requests(partnerSize_);
    for (int r = 0; r < partnerSize_; ++r) {
        PMPI_Isend(words.data(), int(words.size()), MPI_CHAR, partnerRank(r), lastWordsTag, all_, &requests[r]);
    }
    const double end = PMPI_Wtime() + grace;
    while (PMPI_Wtime() < end) {
        int done;
        PMPI_Testall(partnerSize_, requests.data(), &done, MPI_STATUSES_IGNORE);
        sleepFor(0.01);
    }
}

void World::watchForFailure()
{
    if (!coupled_ || failing_) {
        return;
    }
    int found = 0, length = 0;
    MPI_Status status;
    PMPI_Iprobe(MPI_ANY_SOURCE, lastWordsTag, all_, &found, &status);
    if (!found) {
        return;
    }
    PMPI_Get_count(&status, MPI_CHAR, &length);
    std::string words(length, ' ');
    PMPI_Recv(&words[0], length, MPI_CHAR, status.MPI_SOURCE, lastWordsTag, all_, MPI_STATUS_IGNORE);
    endAfterPartner(words);
}

void World::endAfterPartner(const std::string& words)
{
    failing_ = true;
    // The first rank writes this program's log. The partner is about to abort both; the call below is for the case
    // that it does not get there.
    if (ownRank_ == 0) {
        printLine(std::string(programName(side_)) + " ends (" + position_ + ") because " + words);
    }
    sleepFor(2 * grace);
    PMPI_Abort(MPI_COMM_WORLD, 1);
    std::_Exit(1);
}

} // namespace frazil
