/// A stand-in for frazilDem: particles at pseudo-random places that change their rank at every exchange. Checks that
/// each gets the reply meant for it, and that the end is clean. Arguments: steps, particles, ends=dem, hang=STEP,
/// gravity (to provoke a refusal).
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

#include "DemLink.h"
#include "ToyArguments.h"

using namespace frazil;

namespace
{

double fraction(std::int64_t seed, std::int64_t salt)
{
    const double x = std::sin(double(seed) * 12.9898 + double(salt) * 78.233) * 43758.5453;
    return x - std::floor(x);
}

std::vector<ParticleRecord> myParticles(int particles, int step, const Box& box)
{
    const World& world = World::instance();
    std::vector<ParticleRecord> records;
    for (std::int64_t id = particles; id >= 1; --id) {
        if ((id + step) % world.ownSize() == world.ownRank()) {
            ParticleRecord r;
            r.id = id;
            for (int axis = 0; axis < 3; ++axis) {
                r.position[axis] = box.min[axis] + fraction(id + 1000 * step, axis) * box.size()[axis];
            }
            r.impulse = {double(id), double(step), 0};
            records.push_back(r);
        }
    }
    return records;
}

void require(bool holds, const char* what)
{
    if (!holds) {
        World::instance().fail(std::string("toy_dem: ") + what);
    }
}

} // namespace

int main(int argc, char** argv)
{
    World::declare(Side::dem);
    MPI_Init(&argc, &argv);
    const ToyArguments arguments(argc, argv);
    const int particles = int(arguments.number("particles", 500)), steps = int(arguments.number("steps", 1000));

    DemLink link;
    DemHello hello;
    hello.gravity = {0, arguments.number("gravity", -9.81), 0};
    hello.deltaT = 1e-3;
    hello.endTime = 1e3;
    hello.largestRadius = 0.01;
    hello.bodies = {{"cone", 1e-6}};
    const FoamHello foam = link.handshake(hello);
    const CoarseGrid grid(foam.coarse, foam.cellSize, int(foam.ranks), foam.gravity);

    std::vector<ParticleReply> replies;
    for (int step = 0; step < steps; ++step) {
        const StepOrder order = link.swap({
            step * 1e-3,
            0,
            {},
            {},
            particles,
            0,
        });
        if (order.finish) {
            break;
        }
        if (step == int(arguments.number("hang", -1))) {
            sleep(600);
        }
        const std::vector<ParticleRecord> records = myParticles(particles, step, grid.box());
        link.sendParticles(records, grid);
        BodyState state;
        state.velocity.y = step;
        link.sendBodies({state});
        link.receiveReplies(replies);
        require(replies.size() == records.size(), "one reply per record");
        for (std::size_t i = 0; i < records.size(); ++i) {
            require(replies[i].dragCoefficient == double(records[i].id), "the reply of its own particle");
            require(norm(replies[i].fluidVelocity - records[i].position) == 0, "the reply to its present position");
        }
        require(link.receiveBodyLoads().at(0).force.y == 2.0 * step, "the load of this step");
    }
    link.finish(0);
    std::printf("toy_dem ends, waited %s\n", link.waited() >= 0 ? "sensibly" : "backwards");
    MPI_Finalize();
}
