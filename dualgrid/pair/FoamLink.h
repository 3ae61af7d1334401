/// frazilFoam's end of the pair; see DemLink.h for the order of the calls and the algorithm. Mirror image:
///
///     report = swap(order)
///     receiveParticles, receiveBodies
///     sendReplies, sendBodyLoads
#pragma once

#include <vector>

#include "Link.h"
#include "Messages.h"
#include "ParticleInbox.h"

namespace frazil
{

class FoamLink : public Link
{
  public:
    /// Throws InputError naming the mpirun command if there is no partner.
    FoamLink();

    /// `ranks` is filled in here. Only rank 0's hello counts. Throws on a mismatch, same text as the partner.
    DemHello handshake(FoamHello mine);
    /// Only rank 0's order counts. After an order or a report with `finish`, the link is finished().
    StepReport swap(const StepOrder& order);
    /// The particles whose coarse cell this rank owns, sorted by id; valid until the next call.
    const ParticleInbox& receiveParticles();
    std::vector<BodyState> receiveBodies();
    /// One reply per particle of the inbox, in its order.
    void sendReplies(const std::vector<ParticleReply>& replies);
    /// In any order, each with its body's name. Only rank 0's loads count (so sum them over the fluid ranks).
    void sendBodyLoads(const std::vector<BodyLoad>& loads) { sendList(loadTag, loads); }
    /// Ends the coupling unless it has ended: waits for the partner's next swap and tells it. Then goodbye.
    /// @param time     fluid time [s]
    /// @param written  fields were written at this time, so frazilDem writes a restart file
    void finish(double time, bool written);

  private:
    struct Sender {
        int rank;          ///< in World::all()
        std::size_t first; ///< place of its first record
        std::size_t count;
    };
    bool receiveOne(int tag);

    ParticleInbox inbox_;
    std::vector<Sender> senders_;
    std::vector<ParticleRecord> records_;
    std::vector<ParticleReply> outgoing_;
    std::vector<MPI_Request> requests_;
    int parity_ = 0;
};

} // namespace frazil
