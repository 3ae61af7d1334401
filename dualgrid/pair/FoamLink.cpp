#include "FoamLink.h"

#include <stdexcept>

#include <fmt/format.h>

namespace frazil
{

FoamLink::FoamLink() : Link(Side::foam) {}

DemHello FoamLink::handshake(FoamHello mine)
{
    mine.ranks = world_.ownSize();
    // All ranks compare what rank 0 said, so that all of them refuse or none.
    std::vector<char> said = pack(mine);
    long long length = static_cast<long long>(said.size());
    MPI_Bcast(&length, 1, MPI_LONG_LONG, 0, world_.own());
    said.resize(length);
    MPI_Bcast(said.data(), int(length), MPI_BYTE, 0, world_.own());
    send(helloTag, said);
    patience_.setLimit(mine.watchdog, watchdogKey);
    const DemHello partner =
        unpackDemHello(receive(helloTag, "greet (it does so at its first run with fix couple/foam)"));
    compare(partner, unpackFoamHello(said));
    return partner;
}

StepReport FoamLink::swap(const StepOrder& order)
{
    sendList(stepTag, std::vector<StepOrder>{order});
    const StepReport report = receiveList<StepReport>(stepTag, "reach the end of the step").at(0);
    int orderEnds = order.finish != 0;
    MPI_Bcast(&orderEnds, 1, MPI_INT, 0, world_.own());
    noteStep(order.time, report.finish || orderEnds);
    return report;
}

const ParticleInbox& FoamLink::receiveParticles()
{
    records_.clear();
    senders_.clear();
    const int tag = Link::particleTag + parity_;
    MPI_Request barrier;
    MPI_Ibarrier(world_.all(), &barrier);
    patience_.until("send its particles", [&] {
        while (receiveOne(tag)) {}
        int done;
        MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
        return done != 0;
    });
    parity_ = 1 - parity_;
    inbox_.fill(records_);
    return inbox_;
}

bool FoamLink::receiveOne(int tag)
{
    int found = 0, bytes = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, tag, world_.all(), &found, &status);
    if (!found) {
        return false;
    }
    MPI_Get_count(&status, MPI_BYTE, &bytes);
    const Sender sender{status.MPI_SOURCE, records_.size(), bytes / sizeof(ParticleRecord)};
    records_.resize(sender.first + sender.count);
    MPI_Recv(records_.data() + sender.first, bytes, MPI_BYTE, sender.rank, tag, world_.all(), MPI_STATUS_IGNORE);
    senders_.push_back(sender);
    return true;
}

std::vector<BodyState> FoamLink::receiveBodies()
{
    return receiveList<BodyState>(bodyTag, "send the states of the bodies");
}

void FoamLink::sendReplies(const std::vector<ParticleReply>& replies)
{
    if (replies.size() != inbox_.count()) {
        throw std::logic_error(fmt::format("{} replies for {} particles", replies.size(), inbox_.count()));
    }
    inbox_.unsort(replies, outgoing_);
    for (const Sender& sender : senders_) {
        requests_.emplace_back();
        MPI_Isend(outgoing_.data() + sender.first, int(sender.count * sizeof(ParticleReply)), MPI_BYTE, sender.rank,
                  replyTag, world_.all(), &requests_.back());
    }
    // A large message moves only while its sender is inside MPI: left on its own, it would reach the partner after
    // the fluid's whole step, and the two programs would take turns.
    waitForAll("take the forces on its particles", requests_);
}

void FoamLink::finish(double time, bool written)
{
    if (!finished()) {
        StepOrder order;
        order.time = time;
        order.finish = 1;
        order.written = written;
        order.waited = waited();
        swap(order);
    }
}

} // namespace frazil
