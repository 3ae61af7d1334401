#include "fix_body_rigid.h"

#include "Hello.h"
#include "body_options.h"
#include "host_vector.h"
#include "say.h"
#include "script_words.h"

#include "comm.h"
#include "error.h"
#include "fix_gravity.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

using namespace LAMMPS_NS;
using namespace FixConst;
using frazil::Vec3;

namespace
{

std::string text(double value)
{
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%g", value);
    return buffer;
}

std::string text(const Vec3& v)
{
    return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")";
}

} // namespace

FixBodyRigid::FixBodyRigid(LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg)
{
    if (std::strlen(id) >= sizeof(frazil::BodyState::name))
        fail("the fix's ID names the body on the fluid side and may have at most 63 letters");
    static const std::vector<frazil::Keyword> keywords = {{"mesh"},           {"density"},     {"mass"},
                                                          {"velocity", 3, 3}, {"omega", 3, 3}, {"com", 3, 3},
                                                          {"inertia", 6, 6},  {"lock", 1, 6}};
    try {
        create(frazil::BodyOptions(frazil::scriptWords(narg - 3, arg + 3, keywords)));
    } catch (const std::exception& problem) {
        fail(problem.what());
    }
    restart_global = 1;
    vector_flag = 1;
    size_vector = 26;
    global_freq = 1;
    extvector = 0;
}

void FixBodyRigid::create(const frazil::BodyOptions& options)
{
    mesh_.reset(new BodyMesh(lmp, options.mesh));
    const std::vector<frazil::Triangle> surface = mesh_->triangles();
    frazil::checkClosed(surface, "'" + mesh_->id() + "'", "mesh");
    const frazil::MassProperties solid = frazil::massProperties(surface, options.density > 0 ? options.density : 1.0);
    volume_ = solid.volume;
    motion_ = startMotion(options, solid);
    centroidOffset_ = solid.centre - motion_.centre;
}

void FixBodyRigid::fail(const std::string& problem)
{
    error->fix_error(FLERR, this, problem.c_str());
    std::abort(); // fix_error does not return, but is not declared so
}

int FixBodyRigid::setmask()
{
    return INITIAL_INTEGRATE | PRE_FORCE | FINAL_INTEGRATE;
}

void FixBodyRigid::post_create()
{
    mesh_->take();
    frazil::say(*lmp, std::string("Body ") + id + ": mass " + text(motion_.mass) + " kg, volume " + text(volume_) +
                          " m3, centre " + text(motion_.centre) + " m, velocity " + text(motion_.velocity) + " m/s\n");
}

void FixBodyRigid::pre_delete(bool unfixflag)
{
    if (unfixflag && mesh_->stillThere())
        mesh_->release();
}

void FixBodyRigid::init()
{
    if (!std::strstr(update->integrate_style, "verlet"))
        fail("needs 'run_style verlet'");
    if (!mesh_->stillThere())
        fail("its mesh '" + mesh_->id() + "' was deleted or replaced: unfix the body first");
    if (modify->find_fix(mesh_->id().c_str()) > modify->find_fix(id))
        fail("it must come after its mesh '" + mesh_->id() + "' in the input script");
    if (!mesh_->isWall() && comm->me == 0)
        error->warning(FLERR, "fix body/rigid: no fix wall/gran uses the body's mesh, so it feels no contact");
    gravity_ = static_cast<FixGravity*>(modify->find_fix_style_strict("gravity", 0));
}

/* ----------------------------------------------------------------------
   the step
------------------------------------------------------------------------- */

/// After the mesh has spread its elements over the ranks. The set-up of fix wall/gran follows and adds this rank's
/// contacts to the mesh's force, which the mesh itself neither zeroes nor sums there.
void FixBodyRigid::setup_pre_force(int)
{
    mesh_->clearLoad();
    contactIsLocal_ = true;
    mesh_->setVelocities(motion_);
}

void FixBodyRigid::initial_integrate(int)
{
    if (contactIsLocal_)
        contact_ = mesh_->load(true);
    contactIsLocal_ = false;
    kick(0.5 * update->dt);
    mesh_->follow(motion_.drift(update->dt), motion_.centre);
    mesh_->setVelocities(motion_);
}

void FixBodyRigid::final_integrate()
{
    contact_ = mesh_->load(false);
    kick(0.5 * update->dt);
}

void FixBodyRigid::kick(double dt)
{
    Vec3 force = contact_.force + fluid_.force;
    if (gravity_) {
        double g[3];
        gravity_->get_gravity(g);
        force += motion_.mass * frazil::vec(g);
    }
    motion_.kick(force, contact_.torque + fluid_.torque, dt);
}

/* ----------------------------------------------------------------------
   results, restart, coupling
------------------------------------------------------------------------- */

/// f_ID[1..26]: centre, velocity, omega, quaternion, contact force and torque, fluid force and torque, submerged share.
double FixBodyRigid::compute_vector(int n)
{
    const frazil::Quaternion& q = motion_.orientation;
    const double quaternion[4] = {q.w, q.x, q.y, q.z};
    if (n < 3)
        return motion_.centre[n];
    if (n < 6)
        return motion_.velocity[n - 3];
    if (n < 9)
        return motion_.omega()[n - 6];
    if (n < 13)
        return quaternion[n - 9];
    const Vec3 loads[4] = {contact_.force, contact_.torque, fluid_.force, fluid_.torque};
    return n < 25 ? loads[(n - 13) / 3][(n - 13) % 3] : fluid_.submergedShare;
}

/// The mesh fix stores the nodes where they are; this is what they cannot tell.
struct FixBodyRigid::RestartState {
    double mass, volume;
    frazil::Inertia inertia;
    Vec3 centroidOffset, centre, velocity, angularMomentum, lockedOmega, contactForce, contactTorque;
    frazil::Quaternion orientation;
    frazil::BodyLoad fluid;
};

void FixBodyRigid::write_restart(FILE* fp)
{
    if (comm->me != 0)
        return;
    const RestartState state = {motion_.mass,   volume_,          motion_.inertia,         centroidOffset_,
                                motion_.centre, motion_.velocity, motion_.angularMomentum, motion_.lockedOmega,
                                contact_.force, contact_.torque,  motion_.orientation,     fluid_};
    const int size = sizeof(state);
    fwrite(&size, sizeof(int), 1, fp);
    fwrite(&state, size, 1, fp);
}

void FixBodyRigid::restart(char* buffer)
{
    RestartState state;
    std::memcpy(&state, buffer, sizeof(state));
    if (!frazil::sameVolume(volume_, state.volume))
        fail("the restart file's body has a volume of " + text(state.volume) + " m3, the mesh '" + mesh_->id() +
             "' one of " + text(volume_) + " m3: continue with the surface that the run was started with");
    motion_.mass = state.mass;
    volume_ = state.volume;
    motion_.inertia = state.inertia;
    centroidOffset_ = state.centroidOffset;
    motion_.centre = state.centre;
    motion_.velocity = state.velocity;
    motion_.angularMomentum = state.angularMomentum;
    motion_.lockedOmega = state.lockedOmega;
    contact_ = {state.contactForce, state.contactTorque};
    motion_.orientation = state.orientation;
    fluid_ = state.fluid;
}

double FixBodyRigid::bodyVolume() const
{
    return volume_;
}

frazil::BodyState FixBodyRigid::bodyState() const
{
    frazil::BodyState state;
    std::snprintf(state.name, sizeof(state.name), "%s", id);
    state.centre = motion_.centre;
    state.velocity = motion_.velocity;
    state.angularVelocity = motion_.omega();
    state.orientation = motion_.orientation;
    state.centroidOffset = centroidOffset_;
    return state;
}

void FixBodyRigid::setFluidLoad(const frazil::BodyLoad& load)
{
    fluid_ = load;
}
