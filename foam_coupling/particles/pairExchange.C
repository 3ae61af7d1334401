#include "pairExchange.H"
#include "coarsePieces.H"
#include "conversions.H"
#include "InputError.h"
#include "Pstream.H"
#include "Time.H"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>
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


void Foam::pairExchange::openLedger()
{
    if (!Pstream::master())
    {
        return;
    }

    const std::string header = frazil::Ledger::csvHeader() + transportLedger::header();
    std::string before = header;
    if (restarted_)
    {
        std::ifstream file("ledger.csv");
        std::getline(file, before);
    }
    if (before != header)
    {
        throw frazil::InputError
        (
            "ledger.csv", "", "",
            "it has other columns than this frazilFoam writes, so that a continued run cannot append to it",
            "Continue with the program that began the run, or move ledger.csv away"
        );
    }
    ledger_.reset
    (
        new OFstream
        (
            fileName("ledger.csv"),
            IOstream::ASCII,
            IOstream::currentVersion,
            IOstream::UNCOMPRESSED,
            restarted_
        )
    );

    if (!restarted_)
    {
        ledger_() << header.c_str() << endl;
    }
}


void Foam::pairExchange::writeCoarse()
{
    const frazil::CoarseField<double>& solid = step_.solidVolume();
    const frazil::CoarseField<frazil::CoarseFluid>& fluid = step_.fluid();

    const label owned = step_.cells().ownedCount();
    std::vector<double> solidFraction(owned), water(owned);
    std::vector<frazil::Vec3> velocity(owned);
    for (label cell = 0; cell < owned; ++cell)
    {
        solidFraction[cell] = solid[cell]/grid_.cellVolume();
        water[cell] = fluid[cell].wetFraction();
        velocity[cell] = fluid[cell].velocity();
    }

    snapshots_->begin(coarseIndex_, order_.time);
    snapshots_->coarse
    (
        "coarse",
        grid_,
        {
            {"solid fraction", 1, solidFraction.data()},
            {"water fraction", 1, water.data()},
            {"velocity", 3, reinterpret_cast<const double*>(velocity.data())}
        }
    );
    snapshots_->end();
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
    restarted_
    (
        mesh.time().timeIndex() > 0 && std::filesystem::exists("ledger.csv")
    ),
    carriedImpulse_
    (
        IOobject
        (
            "carriedImpulse",
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    startTime_(wallTime())
{
    const scalar watchdog = settings.positive("watchdog", 600);
    settings.finish();

    cutFineCells();
    takeCarried();
    step_.setLocator
    (
        [&mesh](const frazil::Vec3& p)
        {
            return mesh.findCell(point(p.x, p.y, p.z));
        }
    );
    connect(gravity, bodies, watchdog);

    using frazil::SnapshotFile;
    snapshots_.reset
    (
        new SnapshotFile
        (
            "coarse.h5",
            frazil::World::instance().own(),
            restarted_ ? SnapshotFile::Mode::append : SnapshotFile::Mode::create
        )
    );
    openLedger();
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
    const frazil::Vec3& held
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
    link_.sendBodyLoads(bodyLoads_);

    const std::string columns = transport_.line(report_, particles_->view());
    if (ledger_.valid())
    {
        ledger_() << ledger.csvLine(order_.time).c_str() << columns.c_str() << endl;
    }
    keepCarried(ledger);
    watchSwing(ledger);

    if (writesCoarse_)
    {
        writeCoarse();
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


void Foam::pairExchange::keepCarried(const frazil::Ledger& ledger)
{
    if (!(norm(ledger.unplaced) > 0))
    {
        carriedImpulse_.clear();
        return;
    }
    List<scalarList> rows(Pstream::nProcs());
    DynamicList<scalar> mine;
    for (const frazil::CarriedImpulse& waiting : step_.carried())
    {
        for (const scalar word : {scalar(waiting.cell), waiting.impulse.x, waiting.impulse.y, waiting.impulse.z})
        {
            mine.append(word);
        }
    }
    rows[Pstream::myProcNo()] = mine;
    Pstream::gatherList(rows);
    Pstream::scatterList(rows);
    carriedImpulse_.clear();
    for (const scalarList& row : rows)
    {
        carriedImpulse_.append(row);
    }
}


void Foam::pairExchange::takeCarried()
{
    std::vector<frazil::CarriedImpulse> waiting;
    for (label row = 0; row + carriedWords <= carriedImpulse_.size(); row += carriedWords)
    {
        const scalar* word = carriedImpulse_.cdata() + row;
        waiting.push_back({std::int64_t(word[0]), {word[1], word[2], word[3]}});
    }
    step_.setCarried(waiting);
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
