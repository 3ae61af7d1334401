/// A stand-in for frazilFoam: a uniform flow over the whole coarse grid.
///
/// With `echo=1` (partner: toy_dem) each reply repeats what came in, so that the partner can check that it is its own.
/// Else every particle gets drag K (times its exposure) towards `u`, added mass `ma` with fluid acceleration `dudt`,
/// and the passive force `passive`, all along x; the impulse that the particles report is summed up and printed at the
/// end. A body `body` of volume `volume` gets the force `load` along x, from the second exchange on, as from frazilFoam,
/// under its name or that of `load_of`.
/// fails=exit|finalize|abort|throw|hang at=STEP: how it leaves early. late=SECONDS: comes to the handshake
/// late. quiet ends: steps, or the partner's end.
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <unistd.h>

#include "CoarseGrid.h"
#include "FoamLink.h"
#include "ToyArguments.h"

using namespace frazil;

namespace
{

FoamHello greeting(const ToyArguments& arguments)
{
    FoamHello hello;
    hello.gravity = {0, arguments.number("gravity", -9.81), 0};
    hello.startTime = arguments.number("start_time", 0);
    hello.endTime = hello.startTime + arguments.number("steps", 20) * arguments.number("deltaT", 1e-3);
    hello.coarse = hello.mesh = {{0, 0, 0}, {0.6, 0.4, 0.5}};
    hello.cellSize = 0.05;
    hello.watchdog = arguments.number("watchdog", 60);
    if (arguments.number("echo", 0)) {
        hello.bodies = {{"cone", 1e-6}};
    } else if (!arguments.word("body").empty()) {
        hello.bodies = {{arguments.word("body"), arguments.number("volume", 0)}};
    }
    return hello;
}

void failAsAsked(const std::string& how)
{
    if (how == "exit") {
        std::exit(0);
    } else if (how == "finalize") {
        MPI_Finalize();
        std::exit(1);
    } else if (how == "abort") {
        MPI_Abort(MPI_COMM_WORLD, 3);
    } else if (how == "throw") {
        throw std::runtime_error("the toy was told to throw");
    } else if (how == "hang") {
        sleep(600);
    } else if (how == "kill") {
        std::abort();
    }
}

Interaction reply(const ToyArguments& arguments, const ParticleView& particles, std::size_t i)
{
    Interaction r;
    if (arguments.number("echo", 0)) {
        r.dragCoefficient = double(particles.id[i]);
        r.fluidVelocity = particles.position[i];
    } else {
        r.dragCoefficient = arguments.number("K", 0) * particles.exposure[i];
        r.fluidVelocity = {arguments.number("u", 0), 0, 0};
        r.addedMass = arguments.number("ma", 0);
        r.fluidAcceleration = {arguments.number("dudt", 0), 0, 0};
        r.passiveForce = {arguments.number("passive", 0), 0, 0};
        r.spinCoefficient = arguments.number("C", 0);
        r.fluidSpin = {0, 0, arguments.number("spin", 0)};
    }
    return r;
}

void requireOrder(const ParticleView& particles, const CoarseGrid& grid)
{
    for (std::size_t i = 0; i < particles.count; ++i) {
        if (i > 0 && particles.id[i - 1] >= particles.id[i]) {
            throw std::runtime_error("inbox not sorted by id");
        }
        if (grid.ownerOf(particles.position[i]) != World::instance().ownRank()) {
            throw std::runtime_error("a particle of another owner");
        }
    }
}

} // namespace

int main(int argc, char** argv)
{
    World::declare(Side::foam);
    MPI_Init(&argc, &argv);
    const ToyArguments arguments(argc, argv);
    const double deltaT = arguments.number("deltaT", 1e-3);
    const int steps = int(arguments.number("steps", 20));

    FoamLink link;
    sleep(unsigned(arguments.number("late", 0)));
    const FoamHello mine = greeting(arguments);
    const DemHello dem = link.handshake(mine);
    const World& world = World::instance();
    const CoarseGrid grid(mine.coarse, mine.cellSize, world.ownSize(), mine.gravity);

    Vec3 impulse, reported;
    std::vector<Interaction> replies;
    double time = mine.startTime;
    for (int step = 0; step <= steps; ++step, time += deltaT) {
        if (step == int(arguments.number("at", -1))) {
            failAsAsked(arguments.word("fails"));
        }
        StepOrder order;
        order.time = time;
        order.deltaT = deltaT;
        order.substeps = std::int64_t(deltaT / dem.deltaT + 0.5);
        order.finish = step == steps;
        order.written = step == int(arguments.number("written", -1));
        const StepReport report = link.swap(order);
        reported += report.impulse;
        if (link.finished()) {
            break;
        }
        const ParticleInbox& inbox = link.receiveParticles();
        const ParticleView particles = inbox.view();
        requireOrder(particles, grid);
        replies.resize(particles.count);
        for (std::size_t i = 0; i < particles.count; ++i) {
            impulse += particles.impulse[i];
            replies[i] = reply(arguments, particles, i);
        }
        const std::vector<BodyState> bodies = link.receiveBodies();
        std::vector<BodyLoad> loads;
        for (const BodyState& body : bodies) {
            BodyLoad load;
            const std::string& name = arguments.word("load_of");
            std::snprintf(load.name, sizeof load.name, "%s", name.empty() ? body.name : name.c_str());
            load.force = {arguments.number("load", 0), 2 * body.velocity.y, 0};
            if (arguments.number("echo", 0) || step > 0) {
                loads.push_back(load);
            }
        }
        link.sendReplies(replies);
        link.sendBodyLoads(loads);
    }
    link.finish(time, false);

    Vec3 total;
    MPI_Reduce(&impulse.x, &total.x, 3, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) {
        std::printf("toy_foam ends at %.9g, impulse of the records %.15g, of the reports %.15g\n", time, total.x,
                    reported.x);
    }
    MPI_Finalize();
}
