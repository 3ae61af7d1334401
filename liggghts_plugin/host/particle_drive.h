/* What moves each particle along each axis: its force, or a fix that prescribes the motion. Found from the fixes of the
   script at the set-up of each run:

     nve, nve/limit, nve/sph          the force; nothing turns the particle
     nve/sphere                       the force; the torque turns it
     move                             prescribed; by the force along axes that are NULL; the torque turns nothing
     nve/noforce, nve/sph/stationary  prescribed, at constant velocity
     freeze                           no force acts, whatever integrates
   A particle of several groups: a prescribed motion goes before freeze, and freeze before the force. A style that is
   not in this list is refused: taken for the other kind, it would be given, and would give to the fluid, the added-mass
   force of an acceleration that it does not have.
   Cost: a few bit operations per particle and question. Parallel: the same on all ranks. */

#ifndef FRAZIL_PARTICLE_DRIVE_H
#define FRAZIL_PARTICLE_DRIVE_H

namespace LAMMPS_NS
{

class ParticleDrive
{
  public:
    ParticleDrive() {}

    // throws std::runtime_error with fix and cure; the force of `last` is added at its place among the fixes
    ParticleDrive(const class Modify& modify, const class Fix* last);

    // does the force move a particle of this mask along the axis, or along all of them?
    bool free(int mask, int axis) const { return (mask & free_[axis]) && !(mask & (prescribed_[axis] | frozen_)); }
    bool free(int mask) const { return free(mask, 0) && free(mask, 1) && free(mask, 2); }
    bool spins(int mask) const { return (mask & spins_) && !(mask & frozen_); }
    // is its velocity prescribed, and not constant?
    bool accelerates(int mask) const { return mask & accelerates_; }
    // has a freeze already cleared its force, so that what is added now would move it?
    bool cleared(int mask) const { return mask & cleared_; }

  private:
    void add(const class Fix* fix, bool beforeLast);
    bool addKnownIntegrator(const class Fix* fix);
    void addMove(const class FixMove* fix);

    int free_[3] = {0, 0, 0}, prescribed_[3] = {0, 0, 0}; // bits of groups
    int spins_ = 0, accelerates_ = 0, frozen_ = 0, cleared_ = 0;
};

} // namespace LAMMPS_NS

#endif
