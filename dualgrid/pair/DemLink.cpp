#include "DemLink.h"

#include <fmt/format.h>

#include "InputError.h"

namespace frazil
{

DemLink::DemLink() : Link(Side::dem) {}

FoamHello DemLink::handshake(const DemHello& mine)
{
    patience_.setLimit(handshakeSeconds(), "FRAZIL_HANDSHAKE_SECONDS in the environment");
    send(helloTag, pack(mine));
    const FoamHello partner = unpackFoamHello(receive(helloTag, "greet (it may still be reading its mesh)"));
    // All ranks compare what rank 0 said, so that all of them refuse or none.
    std::vector<char> said = pack(mine);
    long long length = static_cast<long long>(said.size());
    MPI_Bcast(&length, 1, MPI_LONG_LONG, 0, world_.own());
    said.resize(length);
    MPI_Bcast(said.data(), int(length), MPI_BYTE, 0, world_.own());
    compare(unpackDemHello(said), partner);
    patience_.setLimit(partner.watchdog, watchdogKey);
    return partner;
}

StepOrder DemLink::swap(const StepReport& report)
{
    sendList(stepTag, std::vector<StepReport>{report});
    const StepOrder order = receiveList<StepOrder>(stepTag, "order the next step").at(0);
    int reportEnds = report.finish != 0;
    MPI_Bcast(&reportEnds, 1, MPI_INT, 0, world_.own());
    noteStep(order.time, order.finish || reportEnds);
    return order;
}

void DemLink::sendParticles(const std::vector<ParticleRecord>& records, const CoarseGrid& grid)
{
    findOwners(records, grid);
    packByOwner(records);
    expectReplies();
    deliver();
}

void DemLink::findOwners(const std::vector<ParticleRecord>& records, const CoarseGrid& grid)
{
    first_.assign(world_.partnerSize() + 1, 0);
    owner_.resize(records.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Vec3& p = records[i].position;
        owner_[i] = grid.ownerOf(p);
        if (owner_[i] < 0) {
            const Box& box = grid.box();
            throw InputError(
                "constant/couplingProperties", "coarseGrid",
                fmt::format("({:g} {:g} {:g}) to ({:g} {:g} {:g})", box.min.x, box.min.y, box.min.z, box.max.x,
                            box.max.y, box.max.z),
                fmt::format("particle {} has left it, at ({:g} {:g} {:g}) m", records[i].id, p.x, p.y, p.z),
                "widen coarseGrid min and max, or give LIGGGHTS a smaller box that deletes particles "
                "(boundary f) before they leave the coarse grid");
        }
        ++first_[owner_[i] + 1];
    }
    for (std::size_t o = 1; o < first_.size(); ++o) {
        first_[o] += first_[o - 1];
    }
}

void DemLink::packByOwner(const std::vector<ParticleRecord>& records)
{
    outgoing_.resize(records.size());
    place_.resize(records.size());
    std::vector<std::size_t> next(first_);
    for (std::size_t i = 0; i < records.size(); ++i) {
        place_[i] = next[owner_[i]]++;
        outgoing_[place_[i]] = records[i];
    }
}

// Posted before the particles leave, so that a reply never waits for its buffer.
void DemLink::expectReplies()
{
    incoming_.resize(outgoing_.size());
    for (int o = 0; o < world_.partnerSize(); ++o) {
        if (countFor(o) > 0) {
            replies_.emplace_back();
            MPI_Irecv(incoming_.data() + first_[o], int(countFor(o) * sizeof(ParticleReply)), MPI_BYTE,
                      world_.partnerRank(o), replyTag, world_.all(), &replies_.back());
        }
    }
}

void DemLink::deliver()
{
    const int tag = particleTag + parity_;
    for (int o = 0; o < world_.partnerSize(); ++o) {
        if (countFor(o) > 0) {
            sends_.emplace_back();
            MPI_Issend(outgoing_.data() + first_[o], int(countFor(o) * sizeof(ParticleRecord)), MPI_BYTE,
                       world_.partnerRank(o), tag, world_.all(), &sends_.back());
        }
    }
    waitForAll("take its particles", sends_);
    MPI_Request barrier;
    MPI_Ibarrier(world_.all(), &barrier);
    patience_.forRequest("take all particles", barrier);
    // A slow fluid rank may still probe for this exchange when a fast DEM rank sends for the next one.
    parity_ = 1 - parity_;
}

void DemLink::receiveReplies(std::vector<ParticleReply>& replies)
{
    waitForAll("send the forces on the particles", replies_);
    replies.resize(place_.size());
    for (std::size_t i = 0; i < place_.size(); ++i) {
        replies[i] = incoming_[place_[i]];
    }
}

std::vector<BodyLoad> DemLink::receiveBodyLoads()
{
    return receiveList<BodyLoad>(loadTag, "send the loads on the bodies");
}

void DemLink::finish(double time)
{
    if (!finished()) {
        StepReport report;
        report.time = time;
        report.finish = 1;
        swap(report);
    }
}

} // namespace frazil
