/// The particles that one fluid rank received, as contiguous arrays sorted by id, and the way back for the replies.
///
/// Sorting makes every sum over the particles independent of how the DEM ranks share them.
/// Cost: one sort of 16-byte keys per exchange; no allocation once the arrays have grown.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "Messages.h"
#include "ParticleView.h"

namespace frazil
{

class ParticleInbox
{
  public:
    std::size_t count() const { return id_.size(); }
    ParticleView view() const;

    /// @param records  as received, one sender after the other
    void fill(const std::vector<ParticleRecord>& records);
    /// Replies from the order of the arrays to the order of the records.
    void unsort(const std::vector<ParticleReply>& replies, std::vector<ParticleReply>& asReceived) const;

  private:
    void resize(std::size_t count);

    std::vector<std::pair<std::int64_t, std::int64_t>> order_; ///< id, index among the records
    std::vector<std::int64_t> id_;
    std::vector<Vec3> position_, velocity_, angularVelocity_, impulse_;
    std::vector<double> radius_, exposure_;
    std::vector<ParticleMotion> motion_;
};

} // namespace frazil
