#include "pairExchange.H"
#include "coarsePieces.H"
#include "Pstream.H"
#include "Time.H"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "Sum.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

double wallTime()
{
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}


//- Foam::vector and frazil::Vec3 are both three doubles in a row
const frazil::Vec3* asVec3(const Foam::vectorField& field)
{
    static_assert(sizeof(Foam::vector) == sizeof(frazil::Vec3), "layout");
    return reinterpret_cast<const frazil::Vec3*>(field.cdata());
}


frazil::Box boxOf(const Foam::boundBox& bb)
{
    return
    {
        {bb.min().x(), bb.min().y(), bb.min().z()},
        {bb.max().x(), bb.max().y(), bb.max().z()}
    };
}


frazil::Box coarseBox(const frazil::Settings& settings)
{
    const frazil::Settings& s = settings.sub("coarseGrid");
    return {s.vec3("min"), s.vec3("max")};
}


//- Names of the columns that transport() fills
const char* const transportHeader =
    ",demParticles,particlesLost,demVolume,demImpulseX,demImpulseY,demImpulseZ,"
    "demMomentumX,demMomentumY,demMomentumZ,volumeErrorTransport,impulseErrorTransport";


//- What arrived, summed over the fluid ranks
struct Arrived
{
    double particles = 0;
    double volume = 0;                 // [m3]
    frazil::Vec3 impulse;              // [N s]
    double impulseScale = 0;           // sum of the magnitudes [N s]
};


Arrived arrived(const frazil::ParticleView& particles)
{
    Arrived here;
    here.particles = double(particles.count);
    for (std::size_t p = 0; p < particles.count; ++p)
    {
        here.volume += 4.0/3.0*M_PI*std::pow(particles.radius[p], 3);
        here.impulse += particles.impulse[p];
        here.impulseScale += norm(particles.impulse[p]);
    }

    const frazil::Vec3& j = here.impulse;
    double sums[] = {here.particles, here.volume, j.x, j.y, j.z, here.impulseScale};
    frazil::sumOverRanks(sums, 6, frazil::World::instance().own());
    return {sums[0], sums[1], {sums[2], sums[3], sums[4]}, sums[5]};
}


double relative(const double difference, const double scale)
{
    return scale > 0 ? difference/scale : difference;
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
    hello.mesh = boxOf(mesh_.bounds());
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
        ledger_()
            << frazil::Ledger::csvHeader().c_str() << transportHeader << endl;
    }
}


std::string Foam::pairExchange::transport
(
    const frazil::StepReport& report,
    const frazil::ParticleView& particles
)
{
    const Arrived here = arrived(particles);
    const double before = arrivedBefore_ < 0 ? report.particles : arrivedBefore_;
    arrivedBefore_ = here.particles;
    return fmt::format
    (
        ",{},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.3g},{:.3g}",
        report.particles,
        before - here.particles,
        report.solidVolume,
        report.impulse.x,
        report.impulse.y,
        report.impulse.z,
        report.momentum.x,
        report.momentum.y,
        report.momentum.z,
        relative(std::abs(here.volume - report.solidVolume), report.solidVolume),
        relative(norm(here.impulse - report.impulse), here.impulseScale)
    );
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

    // A hair more than whole, so that 10.0 DEM steps do not become 9
    const double fitting = std::floor(deltaT/demDeltaT_*(1 + 1e-9));
    // Written so that a deltaT that is not a number ends here too
    if (!(deltaT >= 1e-3*demDeltaT_))
    {
        throw std::runtime_error
        (
            "the fluid diverges: at fluid time " + std::to_string(time.value())
          + " s the Courant number allows less than a thousandth of the DEM "
            "time step. Look at the last fields written; reduce maxCo or "
            "maxDeltaT in system/controlDict, or refine the mesh"
        );
    }
    const double untilEnd = std::max(1.0, std::round(left/demDeltaT_));

    if (fitting < 1)
    {
        ++longSteps_;
    }

    frazil::StepOrder order;
    order.time = time.value();
    order.substeps =
        std::int64_t(std::min(std::max(1.0, fitting), untilEnd));
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

    const std::string columns = transport(report_, particles_->view());
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

    if (longSteps_)
    {
        WarningInFunction
            << longSteps_ << " fluid steps were one DEM step long and still "
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
