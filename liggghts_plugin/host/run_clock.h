/* Simulated time that goes on over restart files, while LIGGGHTS's own starts anew at zero. */

#ifndef FRAZIL_RUN_CLOCK_H
#define FRAZIL_RUN_CLOCK_H

#include "update.h"

namespace frazil
{

class RunClock
{
  public:
    /// [s]
    double now(const LAMMPS_NS::Update& update) const
    {
        return before_ + update.atime + (update.ntimestep - update.atimestep) * update.dt;
    }

    /// The restart file was written at this time [s].
    void restored(double time) { restored_ = time; }

    /// To be called at the set-up of a run: only then is the time step known.
    void start(const LAMMPS_NS::Update& update)
    {
        if (restored_ >= 0)
            before_ = restored_ - (now(update) - before_);
        restored_ = -1;
    }

  private:
    double before_ = 0;    ///< what the host's clock has forgotten [s]
    double restored_ = -1; ///< time of the restart file until the first run, otherwise negative [s]
};

} // namespace frazil

#endif
