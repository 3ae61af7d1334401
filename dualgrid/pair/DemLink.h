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
#include "Link.h"
#include "Messages.h"

namespace frazil
{

class DemLink : public Link
{
  public:
    /// Throws InputError naming the mpirun command if there is no partner.
    DemLink();

    /// Throws std::runtime_error with both values and the cure if the two do not fit. Only rank 0's hello counts.
    FoamHello handshake(const DemHello& mine);
    /// Only rank 0's report counts. After an order or a report with `finish`, the link is finished().
    StepOrder swap(const StepReport& report);
    /// Throws InputError naming the particle that is outside of the grid (on the rank that holds it only).
    void sendParticles(const std::vector<ParticleRecord>& records, const CoarseGrid& grid);
    /// Only rank 0's states count.
    void sendBodies(const std::vector<BodyState>& bodies) { sendList(bodyTag, bodies); }
    /// One reply per record of the last sendParticles, in its order.
    void receiveReplies(std::vector<ParticleReply>& replies);
    /// In any order: each load has its body's name. None, if the fluid has not computed any yet.
    std::vector<BodyLoad> receiveBodyLoads();
    /// Ends the coupling unless it has ended: waits for the partner's next swap and tells it. Then goodbye.
    /// @param time  DEM time [s]
    void finish(double time);

  private:
    void findOwners(const std::vector<ParticleRecord>& records, const CoarseGrid& grid);
    void packByOwner(const std::vector<ParticleRecord>& records);
    void expectReplies();
    void deliver();
    std::size_t countFor(int owner) const { return first_[owner + 1] - first_[owner]; }

    std::vector<int> owner_;         ///< per record
    std::vector<std::size_t> first_; ///< per owner: its first place in outgoing_; one more at the end
    std::vector<std::size_t> place_; ///< per record: its place in outgoing_ and incoming_
    std::vector<ParticleRecord> outgoing_;
    std::vector<ParticleReply> incoming_;
    std::vector<MPI_Request> sends_, replies_;
    int parity_ = 0;
};

} // namespace frazil
