/* fix ID all body/rigid: a closed surface mesh that moves as a rigid body with six degrees of freedom under
   contact with particles, gravity and the load of the fluid. Documentation: doc/fix_body_rigid.md.

   Equations and integration: RigidMotion.h. Order within one DEM step:
     initial_integrate  half kick with the old forces; pose advances; mesh nodes, node velocities "v" (those of the
                        half step, as the particles') and the torque's reference point follow
     pre_force          the mesh zeroes its force (stock)
     post_force         fix wall/gran adds particle contacts to the mesh (stock)
     final_integrate    the mesh sums force and torque over the ranks (stock), then second half kick
     end_of_step        fix couple/foam reads the state and renews the fluid load
   So this fix must come after its mesh fix, and its results hold at the end of the step.
   Cost: one pass over the local triangles per step. Parallel: all ranks integrate the same numbers; the only
   communication is the mesh's own sum, and one sum of six numbers after each set-up. */

#ifndef LMP_FIX_BODY_RIGID_H
#define LMP_FIX_BODY_RIGID_H

#include "body_mesh.h"
#include "coupled_body.h"
#include "fix.h"

#include <memory>
#include <string>

namespace frazil
{
struct BodyOptions;
}

namespace LAMMPS_NS
{

class FixBodyRigid : public Fix, public CoupledBody
{
  public:
    FixBodyRigid(class LAMMPS*, int, char**);

    int setmask() override;
    void post_create() override;
    void pre_delete(bool unfixflag) override;
    void init() override;
    void setup_pre_force(int) override;
    void initial_integrate(int) override;
    void final_integrate() override;

    double compute_vector(int) override;
    void write_restart(FILE*) override;
    void restart(char*) override;

    double bodyVolume() const override;
    frazil::BodyState bodyState() const override;
    void setFluidLoad(const frazil::BodyLoad&) override;

  private:
    struct RestartState;

    [[noreturn]] void fail(const std::string& problem);
    void create(const frazil::BodyOptions&);
    void kick(double dt);

    std::unique_ptr<BodyMesh> mesh_;
    class FixGravity* gravity_ = nullptr;

    frazil::RigidMotion motion_;
    frazil::Vec3 centroidOffset_; // centroid of the surface minus centre of mass, orientation of the start [m]
    double volume_ = 0;           // of the surface [m3]
    BodyMesh::Load contact_;
    frazil::BodyLoad fluid_;
    bool contactIsLocal_ = false; // set-up computed the contacts, but nobody has summed them over the ranks yet
};

} // namespace LAMMPS_NS

#endif
