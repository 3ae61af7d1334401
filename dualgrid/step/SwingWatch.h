/// Notices when particles and fluid answer each other with growing amplitude, before the run fails of it.
///
/// Fed once per exchange with the force of ∇p and ∇·τ on all particles. It warns when, over the last eight exchanges,
///
///   the force along any axis has turned at least four times,
///   its range is twice that of the eight exchanges before, and above three times the weight of the water displaced.
///
/// An impact makes a force large, but not turn; waves turn it, but not within steps. Cost: nothing. No MPI: the ledger's
/// sums are equal on all ranks.
#pragma once

#include <algorithm>
#include <deque>

#include "Vec3.h"

namespace frazil
{

class SwingWatch
{
  public:
    /// @param force  on all particles [N]
    /// @param scale  weight of the water that they displace [N]
    /// @return true if the swing grows
    bool grows(const Vec3& force, double scale)
    {
        history_.push_back(force);
        if (history_.size() > 2 * window)
            history_.pop_front();
        if (history_.size() < 2 * window)
            return false;
        for (int axis = 0; axis < 3; ++axis) {
            const double now = range(axis, window), before = range(axis, 0);
            if (turns(axis) >= 4 && now > 2 * before && now > 3 * scale)
                return true;
        }
        return false;
    }

  private:
    static constexpr std::size_t window = 8;

    double range(int axis, std::size_t first) const
    {
        double low = history_[first][axis], high = low;
        for (std::size_t n = first; n < first + window; ++n) {
            low = std::min(low, history_[n][axis]);
            high = std::max(high, history_[n][axis]);
        }
        return high - low;
    }
    int turns(int axis) const
    {
        int count = 0;
        for (std::size_t n = window; n + 2 < 2 * window; ++n) {
            const double a = history_[n][axis], b = history_[n + 1][axis], c = history_[n + 2][axis];
            count += (b - a) * (c - b) < 0;
        }
        return count;
    }

    std::deque<Vec3> history_;
};

} // namespace frazil
