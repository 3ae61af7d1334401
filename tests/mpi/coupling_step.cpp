/// The coupling step on 1, 2 and 4 ranks against the same step on one rank (MPI_COMM_SELF): replies, fields, ledger.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "CouplingFixture.h"

using namespace frazil;

namespace
{

void expectSame(const Vec3& a, const Vec3& b, double scale)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], 1e-13 * scale);
}

/// The serial run holds all spheres in order of id, and all fine cells.
void expectSameAsSerial(const Coupling& run, const Coupling& serial)
{
    ASSERT_EQ(serial.replies.size(), 400u);
    for (std::size_t n = 0; n < run.id.size(); ++n) {
        const Interaction &a = run.replies[n], &b = serial.replies[run.id[n]];
        expectSame(a.passiveForce, b.passiveForce, 100);
        EXPECT_NEAR(a.dragCoefficient, b.dragCoefficient, 1e-13 * (1 + b.dragCoefficient));
        expectSame(a.fluidVelocity, b.fluidVelocity, 1);
        EXPECT_NEAR(a.addedMass, b.addedMass, 1e-13 * (1 + b.addedMass));
        expectSame(a.fluidAcceleration, b.fluidAcceleration, 1);
        expectSame(a.fluidSpin, b.fluidSpin, 1);
    }
    double largest = 0;
    for (const Vec3& force : serial.source.force)
        largest = std::max(largest, norm(force));
    for (std::size_t f = 0; f < run.mesh->whole.size(); ++f) {
        const int whole = run.mesh->whole[f];
        EXPECT_NEAR(run.source.solidFraction[f], serial.source.solidFraction[whole], 1e-13);
        expectSame(run.source.force[f], serial.source.force[whole], largest);
        const double drag = serial.source.drag[whole], mass = serial.source.addedMass[whole];
        EXPECT_NEAR(run.source.drag[f], drag, 1e-12 * drag);
        EXPECT_NEAR(run.source.addedMass[f], mass, 1e-12 * mass);
        expectSame(run.source.dragVelocity[f], serial.source.dragVelocity[whole], 100);
    }
    EXPECT_EQ(run.ledger.particles, 400);
    EXPECT_EQ(run.ledger.dryParticles, serial.ledger.dryParticles);
    EXPECT_EQ(run.ledger.clippedCells, serial.ledger.clippedCells);
    EXPECT_NEAR(run.ledger.clippedVolume, serial.ledger.clippedVolume, 1e-13 * serial.ledger.particleVolume);
    expectSame(run.ledger.unplaced, serial.ledger.unplaced, serial.ledger.impulseScale);
}

void expectClosed(const Ledger& ledger)
{
    EXPECT_GT(ledger.particleVolume, 0);
    EXPECT_GT(ledger.impulseScale, 0);
    EXPECT_LT(ledger.volumeErrorCoarse(), 1e-12);
    EXPECT_LT(ledger.volumeErrorFine(), 1e-12);
    EXPECT_LT(ledger.impulseErrorCoarse(), 1e-12);
    EXPECT_LT(ledger.impulseErrorFine(), 1e-12);
    EXPECT_GT(ledger.passiveScale, 0);
    EXPECT_LT(ledger.passiveError(), 1e-12);
}

/// Drag, its momentum and added mass of the replies are on the fine mesh as a whole.
void expectReactionPlaced(const Coupling& run)
{
    const Spheres spheres(run.grid, rankOf(run.comm), 0);
    double sums[5] = {}, scale[2] = {};
    for (std::size_t p = 0; p < run.replies.size(); ++p) {
        const double k = run.replies[p].dragCoefficient;
        const Vec3 momentum = k * spheres.velocity[p];
        sums[0] += k;
        sums[1] += run.replies[p].addedMass;
        for (int a = 0; a < 3; ++a)
            sums[2 + a] += momentum[a];
        scale[0] += norm(momentum);
    }
    scale[1] = sums[1];
    for (std::size_t f = 0; f < run.source.drag.size(); ++f) {
        const double k = run.source.drag[f];
        sums[0] -= k;
        sums[1] -= run.source.addedMass[f];
        for (int a = 0; a < 3; ++a)
            sums[2 + a] -= k * run.source.dragVelocity[f][a];
    }
    MPI_Allreduce(MPI_IN_PLACE, sums, 5, MPI_DOUBLE, MPI_SUM, run.comm);
    MPI_Allreduce(MPI_IN_PLACE, scale, 2, MPI_DOUBLE, MPI_SUM, run.comm);
    for (const int n : {0, 2, 3, 4})
        EXPECT_NEAR(sums[n], 0, 1e-12 * scale[0]);
    EXPECT_NEAR(sums[1], 0, 1e-12 * scale[1]);
}

void compareThreeSteps(const Settings& settings)
{
    Coupling run(MPI_COMM_WORLD, settings), serial(MPI_COMM_SELF, settings);
    const double lengths[] = {4.6, 3.2, 6}; // the mesh shrinks, then floods what was dry
    Vec3 carried;
    for (int step = 0; step < 3; ++step) {
        run.advance(lengths[step], step);
        serial.advance(lengths[step], step);
        expectSameAsSerial(run, serial);
        expectClosed(run.ledger);
        expectReactionPlaced(run);
        expectSame(run.ledger.carriedIn, carried, run.ledger.impulseScale);
        carried = run.ledger.unplaced;
        EXPECT_GT(run.ledger.clippedVolume, 0) << "the heap does not fit";
        EXPECT_EQ(run.ledger.dryParticles > 0, step < 2 || !run.step.dualGrid());
    }
    if (run.step.dualGrid()) {
        EXPECT_EQ(norm(carried), 0) << "all impulse has found its fluid";
    }
}

/// On the other ranks: only what fails.
class FailurePrinter : public ::testing::EmptyTestEventListener
{
    void OnTestPartResult(const ::testing::TestPartResult& result) override
    {
        if (result.failed())
            printf("rank %d: %s\n", rankOf(MPI_COMM_WORLD), result.summary());
    }
};

} // namespace

TEST(CouplingStep, DualGridAsInSerial)
{
    compareThreeSteps(Settings("constant/couplingProperties", ""));
}

TEST(CouplingStep, DualGridWithoutLimiterAsInSerial)
{
    Settings settings("constant/couplingProperties", "");
    settings.addSub("prolongation").set("limiter", "none");
    compareThreeSteps(settings);
}

TEST(CouplingStep, CentreKernelAsInSerial)
{
    Settings settings("constant/couplingProperties", "");
    settings.set("kernel", "centre");
    compareThreeSteps(settings);
}

TEST(CouplingStep, DirectAsInSerial)
{
    Settings settings("constant/couplingProperties", "");
    settings.set("dualGrid", "off");
    compareThreeSteps(settings);
}

TEST(CouplingStep, StillWaterGivesBuoyancyAlone)
{
    const Settings settings("constant/couplingProperties", "");
    Coupling run(MPI_COMM_WORLD, settings);
    run.advance(6, 0);
    const Spheres spheres(run.grid, rankOf(MPI_COMM_WORLD), 0);
    const double displaced = 4.0 / 3 * 3.14159265358979323846 * 9.81;
    for (std::size_t n = 0; n < spheres.id.size(); ++n) {
        if (spheres.position[n].z > 0.5)
            continue; // well below the surface: only water in the stencil
        const double r = spheres.radius[n];
        const Vec3 low = spheres.position[n] - Vec3{r, r, r}, high = spheres.position[n] + Vec3{r, r, r};
        if (!box.contains(low) || !box.contains(high))
            continue; // sticks out of the mesh
        const double viscousX = run.replies[n].passiveForce.x;
        const double buoyancy = displaced * water.density * r * r * r;
        EXPECT_NEAR(run.replies[n].passiveForce.z - displaced / 9.81 * r * r * r, buoyancy, 1e-13 * buoyancy);
        EXPECT_GT(viscousX, 0);
    }
}

/// A fluid of single cells that does what the host does: u from the reported impulse and the prediction.
struct PredictedFluid {
    std::vector<Vec3> velocity, held; ///< per fine cell [m/s], [N s]

    void advance(const FineFlow& flow, const FineSource& source, double deltaT)
    {
        velocity.resize(flow.count);
        held.resize(flow.count);
        for (std::size_t f = 0; f < flow.count; ++f) {
            const double mass = flow.density[f] * flow.fluidShare[f] * flow.volume[f];
            if (!(mass > 0))
                continue;
            const double drag = deltaT * source.drag[f], added = source.addedMass[f];
            const Vec3 old = velocity[f];
            const Vec3 given = deltaT * source.force[f] + held[f] + drag * source.dragVelocity[f] + added * old;
            velocity[f] = (1 / (mass + drag + added)) * (mass * old + given);
            held[f] = drag * (velocity[f] - source.dragVelocity[f]) + added * (velocity[f] - old);
        }
    }
};

Vec3 sumOver(MPI_Comm comm, Vec3 v)
{
    MPI_Allreduce(MPI_IN_PLACE, &v, 3, MPI_DOUBLE, MPI_SUM, comm);
    return v;
}

/// Spheres that are held at rest and densely packed in a stream, in a mesh without bodies, under water as a whole.
struct HeldSpheres {
    Coupling run;
    FineMesh mesh;
    PredictedFluid fluid;
    std::vector<std::int64_t> id;
    std::vector<Vec3> position, zero, impulse, before;
    std::vector<double> radius, exposure;

    HeldSpheres(MPI_Comm comm, const Settings& settings)
        : run(comm, settings, syrup), mesh(rankOf(comm), sizeOf(comm), box.max.x)
    {
        std::fill(mesh.wet.begin(), mesh.wet.end(), 1.0);
        std::fill(mesh.density.begin(), mesh.density.end(), syrup.density);
        std::fill(mesh.open.begin(), mesh.open.end(), 1.0);
        std::fill(mesh.epsilon.begin(), mesh.epsilon.end(), 0.35);
        fluid.velocity.assign(mesh.volume.size(), Vec3{0, 0, 2});
        fluid.held.resize(mesh.volume.size());
        before = fluid.velocity;
        run.step.setParts(mesh.pieces(run.grid));
        run.step.setLocator([this](const Vec3& p) { return mesh.cellAt(p); });
        const int n[3] = {24, 20, 20}; // αs = 0.52
        for (int s = 0; s < n[0] * n[1] * n[2]; ++s) {
            const Vec3 p = 0.25 * Vec3{s % n[0] + 0.5, s / n[0] % n[1] + 0.5, s / n[0] / n[1] + 0.5};
            if (run.grid.ownerOf(p) != rankOf(comm))
                continue;
            id.push_back(s);
            position.push_back(p);
        }
        zero.resize(id.size());
        impulse.resize(id.size());
        radius.assign(id.size(), 0.125);
        exposure.assign(id.size(), 1);
    }
    void advance(double deltaT)
    {
        mesh.velocity = fluid.velocity;
        for (std::size_t f = 0; f < before.size(); ++f)
            mesh.acceleration[f] = (1 / deltaT) * (fluid.velocity[f] - before[f]);
        before = fluid.velocity;
        const ParticleView view{id.size(),   id.data(),     position.data(), zero.data(),
                                zero.data(), radius.data(), exposure.data(), impulse.data()};
        run.ledger = run.step.advance(view, mesh.flow(), deltaT, run.replies, run.source);
        fluid.advance(mesh.flow(), run.source, deltaT);
        for (std::size_t p = 0; p < id.size(); ++p) {
            const Interaction& r = run.replies[p];
            impulse[p] = deltaT * (r.dragCoefficient * r.fluidVelocity + r.addedMass * r.fluidAcceleration);
        }
    }
    Vec3 momentum() const
    {
        Vec3 sum;
        const FineFlow flow = mesh.flow();
        for (std::size_t f = 0; f < flow.count; ++f)
            sum += flow.density[f] * flow.fluidShare[f] * flow.volume[f] * fluid.velocity[f];
        return sumOver(run.comm, sum);
    }
    Vec3 held() const
    {
        Vec3 sum;
        for (const Vec3& h : fluid.held)
            sum += h;
        return sumOver(run.comm, sum);
    }
};

/// Dense spheres at rest stop a stream: no momentum but what they report and what is held, and it dies out.
void stopAStream(const Settings& settings, double deltaT)
{
    HeldSpheres stream(MPI_COMM_WORLD, settings), serial(MPI_COMM_SELF, settings);
    const double start = norm(stream.momentum());
    const Vec3 first = stream.momentum();
    Vec3 reported;
    double last = start, scale = 0;
    for (int step = 0; step < 40; ++step) {
        stream.advance(deltaT);
        serial.advance(deltaT);
        EXPECT_LT(stream.run.ledger.impulseErrorFine(), 1e-12);
        reported += stream.run.ledger.received + deltaT * stream.run.ledger.passiveReturned;
        scale += stream.run.ledger.impulseScale;
        const Vec3 momentum = stream.momentum();
        EXPECT_LT(norm(momentum + reported + stream.held() - first), 1e-12 * (start + scale)) << "step " << step;
        expectSame(momentum, serial.momentum(), 10 * (start + scale));
        EXPECT_LE(norm(momentum), 1.01 * start) << "step " << step;
        last = norm(momentum);
    }
    EXPECT_LT(last, 0.2 * start);
}

/// ΣK Δt over the mass of the fluid: far below, near and far above 1.
const double dragSteps[] = {5e-6, 3e-5, 1e-3};

TEST(CouplingStep, PredictionConservesAndDamps)
{
    for (const double deltaT : dragSteps)
        stopAStream(Settings("constant/couplingProperties", ""), deltaT);
}

TEST(CouplingStep, DirectPredictionConservesAndDamps)
{
    Settings settings("constant/couplingProperties", "");
    settings.set("dualGrid", "off");
    for (const double deltaT : dragSteps)
        stopAStream(settings, deltaT);
}

TEST(CouplingStep, OneWayGivesTheFluidNothing)
{
    Settings settings("constant/couplingProperties", "");
    settings.set("momentumExchange", "off");
    Coupling run(MPI_COMM_WORLD, settings);
    run.advance(6, 0);
    for (std::size_t f = 0; f < run.source.force.size(); ++f) {
        EXPECT_EQ(norm(run.source.force[f]), 0);
        EXPECT_EQ(run.source.drag[f], 0);
        EXPECT_EQ(run.source.addedMass[f], 0);
    }
    EXPECT_EQ(norm(run.ledger.given), 0);
}

/// Impulse that waits for fluid goes on from a list as a restart file has it: of all ranks, in any order.
TEST(CouplingStep, WaitingImpulseSurvivesARestart)
{
    const Settings settings("constant/couplingProperties", "");
    Coupling before(MPI_COMM_WORLD, settings), after(MPI_COMM_WORLD, settings);
    before.advance(3.2, 0); // a part of the grid is dry
    Vec3 waiting;
    for (const CarriedImpulse& one : before.step.carried())
        waiting += one.impulse;
    waiting = sumOver(MPI_COMM_WORLD, waiting);
    expectSame(waiting, before.ledger.unplaced, before.ledger.impulseScale);
    EXPECT_GT(norm(waiting), 0);

    std::vector<CarriedImpulse> list = before.step.carried();
    list.push_back({1000000, {1, 1, 1}}); // another rank's cell: not ours
    after.step.setCarried(list);
    after.advance(6, 1);
    expectSame(after.ledger.carriedIn, waiting, before.ledger.impulseScale);
}

TEST(CouplingStep, NamesTheParticleThatIsNotHere)
{
    const Settings settings("constant/couplingProperties", "");
    Coupling run(MPI_COMM_SELF, settings);
    const std::int64_t id = 17;
    const Vec3 outside{7, 1, 1}, zero;
    const double radius = 0.1, exposure = 1;
    const ParticleView one{1, &id, &outside, &zero, &zero, &radius, &exposure, &zero};
    try {
        run.step.advance(one, FineFlow{}, deltaT, run.replies, run.source);
        FAIL();
    } catch (const std::exception& error) {
        EXPECT_STREQ(
            error.what(),
            "constant/couplingProperties: coarseGrid: particle 17 at (7 1 1) is outside of this rank's share of "
            "the box (0 0 0) - (6 5 5). Move min and max outwards until the particles' reach lies inside.");
    }
}

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    ::testing::InitGoogleTest(&argc, argv);
    if (rankOf(MPI_COMM_WORLD) > 0) {
        auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new FailurePrinter);
    }
    int failed = RUN_ALL_TESTS();
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    MPI_Finalize();
    return failed;
}
