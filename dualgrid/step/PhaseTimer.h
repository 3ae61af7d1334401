/// Wall time of the coupling's phases on this rank [s], for the table of shares at the end of a run.
#pragma once

#include <array>
#include <chrono>

namespace frazil
{

class PhaseTimer
{
  public:
    enum Phase { projection, restriction, forces, prolongation, phases };
    static const char* name(int phase)
    {
        static const char* const names[phases] = {"projection", "restriction", "forces", "prolongation"};
        return names[phase];
    }

    double seconds(int phase) const { return seconds_[phase]; }
    double total() const
    {
        double sum = 0;
        for (double s : seconds_)
            sum += s;
        return sum;
    }

    /// Adds the time of a scope to a phase.
    class Scope
    {
      public:
        Scope(PhaseTimer& timer, Phase phase) : timer_(timer), phase_(phase), start_(Clock::now()) {}
        ~Scope() { timer_.seconds_[phase_] += std::chrono::duration<double>(Clock::now() - start_).count(); }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        using Clock = std::chrono::steady_clock;
        PhaseTimer& timer_;
        Phase phase_;
        Clock::time_point start_;
    };

  private:
    std::array<double, phases> seconds_{};
};

} // namespace frazil
