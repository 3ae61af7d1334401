#include "ExchangePlan.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

#include <fmt/format.h>

namespace frazil
{

namespace
{

constexpr int askTag = 201, valueTag = 202;

int rankIn(MPI_Comm comm)
{
    int rank;
    MPI_Comm_rank(comm, &rank);
    return rank;
}

} // namespace

ExchangePlan::ExchangePlan(const std::vector<std::int64_t>& owned, const std::vector<std::int64_t>& ghosts,
                           const std::function<int(std::int64_t)>& ownerOf, MPI_Comm comm)
    : comm_(comm), ownedCount_(int(owned.size()))
{
    listGhosts(ghosts, ownerOf);
    askOwners(owned, ghosts);
}

ExchangePlan::ExchangePlan(const LocalCells& cells, MPI_Comm comm)
    : ExchangePlan(
          cells.ownedIds(), cells.ghostIds(), [&](std::int64_t id) { return cells.grid().ownerOf(id); }, comm)
{
}

// Groups the ghosts by owner, in rank order.
void ExchangePlan::listGhosts(const std::vector<std::int64_t>& ghosts, const std::function<int(std::int64_t)>& ownerOf)
{
    std::vector<std::pair<int, int>> order(ghosts.size());
    for (int g = 0; g < int(ghosts.size()); ++g) {
        order[g] = {ownerOf(ghosts[g]), g};
    }
    std::sort(order.begin(), order.end());
    for (int k = 0; k < int(order.size()); ++k) {
        if (ghostOwners_.empty() || ghostOwners_.back().rank != order[k].first) {
            ghostOwners_.push_back({order[k].first, k, 0});
        }
        ++ghostOwners_.back().count;
        ghostPlace_.push_back(ownedCount_ + order[k].second);
    }
}

// Tells every owner which of its cells are wanted here, and learns who wants which of mine.
void ExchangePlan::askOwners(const std::vector<std::int64_t>& owned, const std::vector<std::int64_t>& ghosts)
{
    std::vector<std::int64_t> wanted;
    for (int place : ghostPlace_) {
        wanted.push_back(ghosts[place - ownedCount_]);
    }
    std::vector<MPI_Request> asking(ghostOwners_.size());
    for (std::size_t n = 0; n < ghostOwners_.size(); ++n) {
        const Neighbour& owner = ghostOwners_[n];
        MPI_Issend(wanted.data() + owner.first, owner.count, MPI_INT64_T, owner.rank, askTag, comm_, &asking[n]);
    }
    std::vector<std::pair<int, std::vector<std::int64_t>>> asked;
    MPI_Request barrier = MPI_REQUEST_NULL;
    for (int over = 0, sent = 0; !over;) {
        int found;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, askTag, comm_, &found, &status);
        if (found) {
            int count;
            MPI_Get_count(&status, MPI_INT64_T, &count);
            asked.emplace_back(status.MPI_SOURCE, std::vector<std::int64_t>(count));
            MPI_Recv(asked.back().second.data(), count, MPI_INT64_T, status.MPI_SOURCE, askTag, comm_,
                     MPI_STATUS_IGNORE);
        }
        if (sent) {
            MPI_Test(&barrier, &over, MPI_STATUS_IGNORE);
        } else {
            MPI_Testall(int(asking.size()), asking.data(), &sent, MPI_STATUSES_IGNORE);
            if (sent) {
                MPI_Ibarrier(comm_, &barrier);
            }
        }
    }
    // Two plans in a row: nobody may probe for the first while another already asks for the second.
    MPI_Barrier(comm_);
    listHolders(owned, asked);
}

void ExchangePlan::listHolders(const std::vector<std::int64_t>& owned,
                               std::vector<std::pair<int, std::vector<std::int64_t>>>& asked)
{
    std::unordered_map<std::int64_t, int> place;
    for (int i = 0; i < int(owned.size()); ++i) {
        place[owned[i]] = i;
    }
    std::sort(asked.begin(), asked.end());
    for (const auto& [rank, ids] : asked) {
        ghostHolders_.push_back({rank, int(ownedPlace_.size()), int(ids.size())});
        for (std::int64_t id : ids) {
            const auto found = place.find(id);
            if (found == place.end()) {
                throw std::logic_error(
                    fmt::format("ExchangePlan: rank {} wants cell {} from rank {}, which does not own it", rank, id,
                                rankIn(comm_)));
            }
            ownedPlace_.push_back(found->second);
        }
    }
}

void ExchangePlan::update(double* values, int width)
{
    outgoing_.resize(ownedPlace_.size() * width);
    incoming_.resize(ghostPlace_.size() * width);
    for (std::size_t k = 0; k < ownedPlace_.size(); ++k) {
        std::copy_n(values + std::size_t(ownedPlace_[k]) * width, width, outgoing_.data() + k * width);
    }
    transfer(ghostHolders_, ghostOwners_, width);
    for (std::size_t k = 0; k < ghostPlace_.size(); ++k) {
        std::copy_n(incoming_.data() + k * width, width, values + std::size_t(ghostPlace_[k]) * width);
    }
}

void ExchangePlan::accumulate(double* values, int width)
{
    outgoing_.resize(ghostPlace_.size() * width);
    incoming_.resize(ownedPlace_.size() * width);
    for (std::size_t k = 0; k < ghostPlace_.size(); ++k) {
        std::copy_n(values + std::size_t(ghostPlace_[k]) * width, width, outgoing_.data() + k * width);
    }
    transfer(ghostOwners_, ghostHolders_, width);
    for (std::size_t k = 0; k < ownedPlace_.size(); ++k) {
        for (int c = 0; c < width; ++c) {
            values[std::size_t(ownedPlace_[k]) * width + c] += incoming_[k * width + c];
        }
    }
}

void ExchangePlan::transfer(const std::vector<Neighbour>& to, const std::vector<Neighbour>& from, int width)
{
    requests_.resize(to.size() + from.size());
    MPI_Request* request = requests_.data();
    for (const Neighbour& n : from) {
        MPI_Irecv(incoming_.data() + std::size_t(n.first) * width, n.count * width, MPI_DOUBLE, n.rank, valueTag, comm_,
                  request++);
    }
    for (const Neighbour& n : to) {
        MPI_Isend(outgoing_.data() + std::size_t(n.first) * width, n.count * width, MPI_DOUBLE, n.rank, valueTag, comm_,
                  request++);
    }
    MPI_Waitall(int(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
}

} // namespace frazil
