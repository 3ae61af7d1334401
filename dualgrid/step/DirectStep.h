/// `dualGrid off`, the conventional scheme: each particle couples with the fine cell that holds its centre.
///
/// The fine cell's own values act on the particle; its whole volume and impulse go into that cell. Meant for
/// comparison: as soon as a fine cell is not much larger than a particle, the solid does not fit and is clipped (see
/// the ledger).
///
/// Algorithm: the owner of the particle's coarse cell knows which ranks have fine cells there; it asks them for the
/// centre (the lowest rank that finds it wins), sends the particle there and gets the Interaction back. A centre in no
/// fluid cell: no force; volume listed as clipped; its impulse waits in the coarse cell for the next particle there.
/// Cost: two round trips of the particles' records among the fluid ranks. Parallel: collective; particles are sorted by
/// id before anything is summed.
#pragma once

#include <functional>
#include <vector>

#include "CoarseState.h"
#include "CouplingSettings.h"
#include "FineSource.h"
#include "Interaction.h"
#include "Ledger.h"
#include "Overlap.h"
#include "ParticleView.h"
#include "PressureResponse.h"
#include "Router.h"

namespace frazil
{

class DirectStep
{
  public:
    /// Both references must outlive it.
    DirectStep(const CouplingModel& model, CoarseState& state, MPI_Comm comm);

    // As those of CouplingStep
    void setParts(const std::vector<FinePiece>& pieces);
    void setLocator(std::function<int(const Vec3&)> fineCellAt) { fineCellAt_ = std::move(fineCellAt); }
    Ledger advance(const ParticleView& particles, const FineFlow& flow, double deltaT,
                   std::vector<Interaction>& replies, FineSource& source);

  private:
    /// A particle on its way to the rank that has its fine cell.
    struct Visitor {
        std::int64_t id;
        int fineCell;
        double volume;
        Vec3 impulse;
        ParticleState state;
        ParticleMotion motion;
    };
    struct Place {
        int rank = -1, fineCell = -1;
    };

    std::vector<Place> locate(const ParticleView& particles, const FineFlow& flow);
    std::vector<Visitor> depart(const ParticleView& particles, const std::vector<Place>& places, std::vector<int>& to,
                                std::vector<std::size_t>& who, Ledger& ledger);
    void settle(const std::vector<Visitor>& visitors, const FineFlow& flow, double deltaT, FineSource& source,
                Ledger& ledger) const;
    void react(const std::vector<Visitor>& visitors, const std::vector<Interaction>& answers, FineSource& source) const;
    void fitSolid(const FineFlow& flow, FineSource& source, Ledger& ledger) const;
    std::vector<Interaction> interact(const std::vector<Visitor>& visitors, const FineFlow& flow, FineSource& source,
                                      Ledger& ledger) const;
    void giveBack(const std::vector<Visitor>& visitors, const std::vector<Interaction>& answers, const FineFlow& flow,
                  FineSource& source, Ledger& ledger) const;
    void respond(const std::vector<Visitor>& visitors, const FineFlow& flow, const FineSource& source, double deltaT,
                 std::vector<Interaction>& answers, Ledger& ledger);

    const CouplingModel& model_;
    CoarseState& state_;
    MPI_Comm comm_;
    Router router_;
    std::function<int(const Vec3&)> fineCellAt_;
    std::vector<std::vector<int>> holders_; ///< per owned coarse cell: ranks with fine cells in it, ascending
    std::vector<ResponseSums> sums_;        ///< per fine cell
};

} // namespace frazil
