#include "Link.h"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace frazil
{

Link::Link(Side side) : world_(World::coupledInstance())
{
    if (world_.side() != side) {
        throw std::logic_error(fmt::format("{} took the link of {}", programName(world_.side()), programName(side)));
    }
}

void Link::send(Tag tag, std::vector<char> bytes)
{
    if (world_.ownRank() != 0) {
        return;
    }
    patience_.forRequest("take the last message", sending_);
    sent_ = std::move(bytes);
    MPI_Isend(sent_.data(), int(sent_.size()), MPI_BYTE, world_.partnerRank(0), tag, world_.all(), &sending_);
}

std::vector<char> Link::receive(Tag tag, const char* what)
{
    std::vector<char> bytes;
    if (world_.ownRank() == 0) {
        int length = 0;
        MPI_Status status;
        patience_.until(what, [&] {
            int found;
            MPI_Iprobe(world_.partnerRank(0), tag, world_.all(), &found, &status);
            return found != 0;
        });
        MPI_Get_count(&status, MPI_BYTE, &length);
        bytes.resize(length);
        MPI_Recv(bytes.data(), length, MPI_BYTE, status.MPI_SOURCE, tag, world_.all(), MPI_STATUS_IGNORE);
    }
    shareWithOwn(bytes, what);
    return bytes;
}

void Link::shareWithOwn(std::vector<char>& bytes, const char* what)
{
    if (world_.ownSize() == 1) {
        return;
    }
    MPI_Request request;
    long long length = static_cast<long long>(bytes.size());
    MPI_Ibcast(&length, 1, MPI_LONG_LONG, 0, world_.own(), &request);
    patience_.forRequest(what, request);
    bytes.resize(length);
    MPI_Ibcast(bytes.data(), int(length), MPI_BYTE, 0, world_.own(), &request);
    patience_.forRequest(what, request);
}

void Link::waitForAll(const char* what, std::vector<MPI_Request>& requests)
{
    patience_.until(what, [&] {
        int done;
        MPI_Testall(int(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
        return done != 0;
    });
    requests.clear();
}

void Link::compare(const DemHello& dem, const FoamHello& foam) const
{
    const std::string differences = mismatch(dem, foam);
    if (!differences.empty()) {
        throw std::runtime_error("frazilDem and frazilFoam do not fit together:\n" + differences);
    }
}

void Link::noteStep(double time, bool last)
{
    ++step_;
    world_.setPosition(fmt::format("fluid time {:.6g} s, fluid step {}", time, step_));
    if (last) {
        patience_.forRequest("take the last message", sending_);
        finished_ = true;
        world_.sayGoodbye();
    }
}

} // namespace frazil
