/// frazilDem's end of the pair. All calls are collective over its ranks. The calls of one exchange, in this order:
///
///     order = swap(report)                          who goes on, how far
///     sendParticles, sendBodies                     to the fluid ranks that own them
///     receiveReplies, receiveBodyLoads              the way back
///
/// Particles travel straight from the DEM rank that holds them to the fluid rank that owns their coarse cell. Which
/// fluid ranks have news is found by the sparse exchange of Hoefler, Siebert & Lumsdaine (PPoPP 2010, "NBX"):
/// synchronous sends, probes, and a non-blocking barrier when one's own sends have been received. Cost: O(own particles
/// + neighbours), no collective that grows with the particles.
/// Errors: std::runtime_error, InputError for what the user can mend. Every wait is under the watchdog.
#pragma once

#include <vector>

#include "CoarseGrid.h"
#include "Hello.h"
#include "Link.h"
#include "Messages.h"

namespace frazil {

class DemLink : public Link
{
  public:
    /// Throws InputError naming the mpirun command if there is no partner.
    DemLink();

    /// Throws InputError with both values and the cure if the two do not fit together. Only rank 0's hello counts.
    FoamHello handshake(const DemHello& mine);
    /// Only rank 0's report counts. After an order or a report with `finish`, the link is finished().
    StepOrder swap(const StepReport& report);
    /// Throws InputError naming the particle that is outside of the grid.
    void sendParticles(const std::vector<ParticleRecord>& records, const CoarseGrid& grid);
    /// Only rank 0's states count.
    void sendBodies(const std::vector<BodyState>& bodies);
    /// One reply per record of the last sendParticles, in its order.
    void receiveReplies(std::vector<ParticleReply>& replies);
    std::vector<BodyLoad> receiveBodyLoads();
    /// Ends the coupling unless it has ended: waits for the partner's next swap and tells it. Then goodbye.
    void finish(double time = 0);

  private:
    void sortByOwner(const std::vector<ParticleRecord>& records, const CoarseGrid& grid);
    void postParticles();

    std::vector<int> owner_;             ///< per record
    std::vector<std::size_t> first_;     ///< per owner: first place in outgoing_
    std::vector<std::size_t> place_;     ///< per record: place in outgoing_
    std::vector<ParticleRecord> outgoing_;
    std::vector<ParticleReply> incoming_;
    std::vector<MPI_Request> requests_;
    int parity_ = 0;
};

} // namespace frazil
