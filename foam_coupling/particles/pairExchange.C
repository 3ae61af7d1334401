#include "pairExchange.H"
#include "coarsePieces.H"
#include "conversions.H"
#include "Pstream.H"
#include "Time.H"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

double wallTime()
{
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}


frazil::Box coarseBox(const frazil::Settings& settings)
{
    const frazil::Settings& s = settings.sub("coarseGrid");
    return {s.vec3("min"), s.vec3("max")};
}


} // End anonymous namespace


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::pairExchange::connect
(
    const frazil::Vec3& gravity,
    const std::vector<frazil::BodyHello>& bodies,
    const scalar watchdog
)
{
    frazil::FoamHello hello;
    hello.gravity = gravity;
    hello.startTime = mesh_.time().value();
    hello.endTime = mesh_.time().endTime().value();
    hello.mesh = toBox(mesh_.bounds());
    hello.coarse = grid_.box();
    hello.cellSize = grid_.cellSize();
    hello.watchdog = watchdog;
    hello.bodies = bodies;

    const frazil::DemHello dem = link_.handshake(hello);
    demDeltaT_ = dem.deltaT;

    if (dem.particles > 0)
    {
        frazil::requireReach(grid_, dem.reach);
        if (step_.dualGrid())
        {
            frazil::requireCellSize(grid_, 2*dem.largestRadius);
        }
    }

    Info<< "frazilDem: " << label(dem.particles) << " particles, "
        << label(dem.bodies.size()) << " bodies, time step " << demDeltaT_
        << " s; coarse grid " << grid_.cells()[0] << " x " << grid_.cells()[1]
        << " x " << grid_.cells()[2] << " cells of " << grid_.cellSize()
        << " m" << nl << endl;
}


void Foam::pairExchange::cutFineCells()
{
    // With dualGrid off they still say which rank has fine cells where
    step_.setParts(coarsePieces(mesh_, grid_));

    // findCell makes them when first asked. That is collective, but only ranks
    // with particles would ask
    if (!step_.dualGrid())
    {
        (void)mesh_.tetBasePtIs();
    }
}


frazil::StepOrder Foam::pairExchange::order(const scalar deltaT)
{
    const Time& time = mesh_.time();
    const scalar left = time.endTime().value() - time.value();
    frazil::StepOrder order;
    order.time = time.value();
    order.substeps = length_.substeps(deltaT, demDeltaT_, time.value(), left);
    order.deltaT = order.substeps*demDeltaT_;
    order.written = time.writeTime();
    order.waited = link_.waited();
    return order;
}


frazil::FineFlow Foam::pairExchange::fineFlow
(
    const flowOnParticles& flow,
    const scalarField& open
) const
{
    frazil::FineFlow fine;
    fine.count = mesh_.nCells();
    fine.volume = mesh_.V().cdata();
    fine.fluidShare = flow.fluidShare.cdata();
    fine.openFraction = open.empty() ? nullptr : open.cdata();
    fine.density = flow.rho.cdata();
    fine.wetFraction = flow.alpha1.cdata();
    fine.velocity = asVec3(flow.U);
    fine.pressureGradient = asVec3(flow.gradP);
    fine.viscousForce = asVec3(flow.viscousForce);
    fine.acceleration = asVec3(flow.acceleration);
    fine.vorticity = asVec3(flow.vorticity);
    if (!flow.accelerationShare.empty())
    {
        fine.accelerationShare = flow.accelerationShare.cdata();
    }
    return fine;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pairExchange::pairExchange
(
    const fvMesh& mesh,
    const frazil::Settings& settings,
    const frazil::Phase& water,
    const frazil::Phase& air,
    const frazil::Vec3& gravity,
    const std::vector<frazil::BodyHello>& bodies
)
:
    mesh_(mesh),
    grid_
    (
        coarseBox(settings),
        settings.sub("coarseGrid").positive("cellSize"),
        frazil::World::instance().ownSize(),
        gravity
    ),
    step_(settings, grid_, water, air, gravity, frazil::World::instance().own()),
    waterWeight_(water.density*norm(gravity)),
    link_(),
    carried_(mesh),
    startTime_(wallTime())
{
    const scalar watchdog = settings.positive("watchdog", 600);
    settings.finish();

    cutFineCells();
    carried_.restore(step_);
    step_.setLocator([&mesh](const frazil::Vec3& p) { return mesh.findCell(toVector(p)); });
    connect(gravity, bodies, watchdog);

    const bool continued = mesh.time().timeIndex() > 0 && std::filesystem::exists("ledger.csv");
    ledger_.reset(new ledgerFile(continued));
    snapshots_.reset(new coarseSnapshots(grid_, continued));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pairExchange::learnKeys(const frazil::Settings& settings)
{
    for (const char* key : {"dualGrid", "kernel", "momentumExchange", "watchdog"})
    {
        settings.has(key);
    }
    for (const char* key : {"min", "max", "cellSize"})
    {
        settings.sub("coarseGrid").has(key);
    }
    for (const char* key : {"exponent", "limiter"})
    {
        settings.sub("prolongation").has(key);
    }
    settings.sub("voidFraction").has("min");
    for
    (
        const char* key
      : {
            "drag", "pressureGradient", "viscous", "addedMass",
            "rotationalDrag", "shielding"
        }
    )
    {
        settings.sub("forces").has(key);
    }
}


Foam::scalar Foam::pairExchange::agree(const scalar deltaT)
{
    const double start = wallTime();
    order_ = order(deltaT);
    writesCoarse_ = mesh_.time().writeTime() || mesh_.time().timeIndex() == 0;
    coarseIndex_ = mesh_.time().timeIndex();
    report_ = link_.swap(order_);
    exchangeTime_ += wallTime() - start;
    return report_.finish ? 0 : order_.deltaT;
}


const std::vector<frazil::BodyState>& Foam::pairExchange::receive()
{
    const double start = wallTime();
    particles_ = &link_.receiveParticles();
    bodyStates_ = link_.receiveBodies();
    exchangeTime_ += wallTime() - start;
    return bodyStates_;
}


void Foam::pairExchange::advance
(
    const flowOnParticles& flow,
    const scalarField& open,
    const frazil::Vec3& held,
    const std::vector<frazil::BodyLoad>& loads
)
{
    const double start = wallTime();
    if (mesh_.changing())
    {
        cutFineCells();
    }

    frazil::Ledger ledger = step_.advance
    (
        particles_->view(), fineFlow(flow, open), order_.deltaT, replies_, source_
    );
    ledger.held = held;

    link_.sendReplies(replies_);
    link_.sendBodyLoads(loads);

    ledger_->write(order_.time, ledger, report_, particles_->view());
    carried_.keep(step_, norm(ledger.unplaced) > 0);
    watchSwing(ledger);

    if (writesCoarse_)
    {
        snapshots_->write(step_, coarseIndex_, order_.time);
    }

    exchangeTime_ += wallTime() - start;
}


void Foam::pairExchange::watchSwing(const frazil::Ledger& ledger)
{
    if (!swing_.grows(ledger.passiveReceived, waterWeight_*ledger.particleVolume))
    {
        return;
    }
    if (swings_++ % 20 == 0)
    {
        WarningInFunction
            << "particles and fluid answer each other with growing amplitude: "
            << "the force of the pressure on all particles is now ("
            << ledger.passiveReceived.x << ' ' << ledger.passiveReceived.y
            << ' ' << ledger.passiveReceived.z << ") N. Where soft bonds hold "
            << "them: stiffer bonds, larger coarse cells or smaller fluid "
            << "steps (dualgrid/doc/stability.md)" << endl;
    }
}


void Foam::pairExchange::finish()
{
    link_.finish(mesh_.time().value(), mesh_.time().writeTime());

    if (length_.longSteps())
    {
        WarningInFunction
            << length_.longSteps() << " fluid steps were one DEM step long and still "
            << "above the Courant number asked for: reduce the DEM time step"
            << endl;
    }

    const frazil::PhaseTimer& timer = step_.timer();
    const double total = wallTime() - startTime_;
    Info<< nl << "Coupling, wall time on the first fluid rank [s] and share of "
        << "the run [%]" << nl;
    for (int phase = 0; phase < frazil::PhaseTimer::phases; ++phase)
    {
        Info<< "    " << frazil::PhaseTimer::name(phase) << ' '
            << timer.seconds(phase) << ' '
            << 100*timer.seconds(phase)/total << nl;
    }
    const double rest = exchangeTime_ - timer.total() - link_.waited();
    Info<< "    exchange " << rest << ' ' << 100*rest/total << nl
        << "    waiting for frazilDem " << link_.waited() << ' '
        << 100*link_.waited()/total << nl << endl;
}


// ************************************************************************* //
