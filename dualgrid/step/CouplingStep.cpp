#include "CouplingStep.h"

#include "DirectScheme.h"
#include "DualGridScheme.h"

namespace frazil
{

namespace
{

ProlongationSettings readProlongation(const Settings& settings)
{
    ProlongationSettings prolongation;
    prolongation.exponent = settings.positive("exponent", 2);
    prolongation.limitToCells = settings.word("limiter", {"cell", "none"}, "cell") == "cell";
    return prolongation;
}

double readSmallestFluidFraction(const Settings& settings)
{
    const double smallest = settings.positive("min", 0.25);
    if (smallest >= 1)
        settings.reject("min", "leaves no room for particles", "Use 0.25, just below that of the densest packing");
    return smallest;
}

CouplingSettings readCoupling(const Settings& settings)
{
    settings.word("kernel", {"trilinear"}, "trilinear");
    CouplingSettings coupling;
    coupling.prolongation = readProlongation(settings.sub("prolongation"));
    coupling.smallestFluidFraction = readSmallestFluidFraction(settings.sub("voidFraction"));
    coupling.momentumExchange = settings.flag("momentumExchange", true);
    return coupling;
}

} // namespace

CouplingStep::CouplingStep(const Settings& settings, const CoarseGrid& grid, const Phase& water, const Phase& air,
                           const Vec3& gravity, MPI_Comm comm)
    : dualGrid_(settings.flag("dualGrid", true))
{
    const CouplingSettings coupling = readCoupling(settings);
    const ForceModel forces(settings.sub("forces"));
    if (dualGrid_) {
        scheme_ = std::make_unique<DualGridScheme>(coupling, forces, water, air, gravity, grid, comm);
    } else {
        scheme_ = std::make_unique<DirectScheme>(coupling, forces, water, air, grid, comm);
    }
}

CouplingStep::~CouplingStep() = default;

void CouplingStep::setParts(const std::vector<FinePiece>& pieces)
{
    scheme_->setParts(pieces);
}

void CouplingStep::setLocator(std::function<int(const Vec3&)> fineCellAt)
{
    scheme_->setLocator(std::move(fineCellAt));
}

Ledger CouplingStep::advance(const ParticleView& particles, const FineFlow& flow, double deltaT,
                             std::vector<Interaction>& replies, FineSource& source)
{
    return scheme_->advance(particles, flow, deltaT, replies, source);
}

} // namespace frazil
