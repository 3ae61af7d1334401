/* What fix couple/foam needs of a rigid body that the fluid pushes.
   A body fix derives from this besides Fix; couple/foam finds it by dynamic_cast over modify->fix[],
   so neither knows the other's class. Cost: one record of 190 bytes per body and fluid step. */

#ifndef FRAZIL_COUPLED_BODY_H
#define FRAZIL_COUPLED_BODY_H

#include "Messages.h"

#include <vector>

namespace LAMMPS_NS
{

class CoupledBody
{
  public:
    virtual ~CoupledBody() {}

    /// Volume of its closed surface [m3], compared with the partner's at the handshake
    virtual double bodyVolume() const = 0;

    /// State at the current DEM step; must be the same on all ranks
    virtual frazil::BodyState bodyState() const = 0;

    /// Force [N], torque about the centre of mass [N m] and submerged share, held until the next call;
    /// called with the same values on all ranks, once per fluid step
    virtual void setFluidLoad(const frazil::BodyLoad&) = 0;
};

std::vector<frazil::BodyState> statesOf(const std::vector<CoupledBody*>& bodies);

/// Gives each body its load, by name, whatever their order. std::runtime_error on a load without a body and the other
/// way round: the handshake has compared the names, but fixes may come and go between runs.
void setLoads(const std::vector<CoupledBody*>& bodies, const std::vector<frazil::BodyLoad>& loads);

} // namespace LAMMPS_NS

#endif
