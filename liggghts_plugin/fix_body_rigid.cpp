#include "fix_body_rigid.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <numeric>
#include <vector>

#include "DidYouMean.h"
#include "InputError.h"
#include "comm.h"
#include "error.h"
#include "fix_gravity.h"
#include "fix_mesh_surface.h"
#include "force.h"
#include "mesh_module_stress.h"
#include "modify.h"
#include "script_words.h"
#include "tri_mesh.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using frazil::Vec3;

namespace {

typedef MultiVectorContainer<double, 3, 3> NodeVectors;

Vec3 vector(const double *v) { return {v[0], v[1], v[2]}; }

std::string text(double value)
{
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%g", value);
  return buffer;
}

std::string text(const Vec3 &v) { return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")"; }

}

/* ---------------------------------------------------------------------- */

struct FixBodyRigid::Options {
  std::string mesh;
  double density = 0, mass = 0;
  Vec3 velocity, omega, com;
  frazil::Inertia inertia{};
  bool hasCom = false, hasInertia = false;
  bool lock[6] = {false, false, false, false, false, false};

  explicit Options(const frazil::Settings &words)
  {
    mesh = words.text("mesh");
    if (words.has("density")) density = words.positive("density");
    if (words.has("mass")) mass = words.positive("mass");
    velocity = words.vec3("velocity", velocity);
    omega = words.vec3("omega", omega);
    hasCom = words.has("com");
    com = words.vec3("com", com);
    if (words.has("inertia")) readInertia(words);
    if (words.has("lock")) readLock(words);
    if (density <= 0 && mass <= 0)
      words.reject("mesh", "gives the body no mass", "Add 'density RHO' [kg/m3] or 'mass M' [kg], above zero");
    if (hasCom && !hasInertia)
      words.reject("com", "moves the centre of mass away from the surface's centroid, so its inertia is not known",
                   "Add 'inertia XX YY ZZ XY XZ YZ' about that centre [kg m2]");
  }

 private:
  void readInertia(const frazil::Settings &words)
  {
    const std::vector<double> given = words.numbers("inertia");
    std::copy(given.begin(), given.end(), inertia.begin());
    if (!frazil::positiveDefinite(inertia))
      words.reject("inertia", "is not a positive definite tensor",
                   "Its order is XX YY ZZ XY XZ YZ [kg m2], with XY = -sum of m x y");
    hasInertia = true;
  }

  void readLock(const frazil::Settings &words)
  {
    const std::vector<std::string> name = {"x", "y", "z", "rx", "ry", "rz"};
    for (const std::string &word : words.words("lock")) {
      const auto found = std::find(name.begin(), name.end(), word);
      if (found == name.end())
        words.reject("lock", word + " is no direction" + frazil::didYouMean(word, name), "Choose from: x y z rx ry rz");
      lock[found - name.begin()] = true;
    }
  }
};

/* ---------------------------------------------------------------------- */

FixBodyRigid::FixBodyRigid(LAMMPS *lmp, int narg, char **arg)
  : Fix(lmp, narg, arg), fixMesh_(NULL), mesh_(NULL), stress_(NULL), gravity_(NULL), volume_(0),
    contactIsLocal_(false)
{
  if (std::strlen(id) >= sizeof(frazil::BodyState::name))
    fail("the fix's ID names the body on the fluid side and may have at most 63 letters");
  const Options options = readWords(narg, arg);
  findMesh(options.mesh);
  setMass(options);
  for (int axis = 0; axis < 3; axis++) {
    motion_.lockMove[axis] = options.lock[axis];
    motion_.lockTurn[axis] = options.lock[axis + 3];
  }

  restart_global = 1;
  vector_flag = 1;
  size_vector = 26;
  global_freq = 1;
  extvector = 0;
}

/* ---------------------------------------------------------------------- */

FixBodyRigid::~FixBodyRigid() {}

/* ---------------------------------------------------------------------- */

FixBodyRigid::Options FixBodyRigid::readWords(int narg, char **arg)
{
  try {
    return Options(frazil::scriptWords(narg - 3, arg + 3,
                                       {{"mesh"}, {"density"}, {"mass"}, {"velocity", 3, 3}, {"omega", 3, 3},
                                        {"com", 3, 3}, {"inertia", 6, 6}, {"lock", 1, 6}}));
  } catch (const frazil::InputError &wrong) {
    fail(wrong.what());
    throw;
  }
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::fail(const std::string &problem) { error->fix_error(FLERR, this, problem.c_str()); }

/* ---------------------------------------------------------------------- */

void FixBodyRigid::findMesh(const std::string &meshId)
{
  meshId_ = meshId;
  Fix *found = modify->find_fix_id(meshId.c_str());
  if (!found)
    fail("there is no fix '" + meshId + "', so the body has no mesh: define it before this fix, for example "
         "'fix " + meshId + " all mesh/surface/stress file body.stl type 1'");
  fixMesh_ = dynamic_cast<FixMeshSurface *>(found);
  if (fixMesh_) stress_ = dynamic_cast<MeshModuleStress *>(fixMesh_->get_module("stress"));
  if (!stress_)
    fail("fix '" + meshId + "' is of style " + found->style + ", which does not add up contact forces: "
         "make it a mesh/surface/stress");
  mesh_ = fixMesh_->triMesh();
  if (!stress_->trackStress()) fail("mesh '" + meshId + "' has 'stress off': the body would feel no contact, remove it");
  if (fixMesh_->surfaceVel())
    fail("mesh '" + meshId + "' has a surface velocity: remove surface_vel and surface_ang_vel, the body sets it");
  if (mesh_->isMoving()) fail("mesh '" + meshId + "' is already moved by another fix: remove one of the two");
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::setMass(const Options &options)
{
  frazil::MassProperties solid;
  try {
    const std::vector<frazil::Triangle> surface = triangles();
    frazil::checkClosed(surface, "'" + meshId_ + "'", "mesh");
    solid = frazil::massProperties(surface, options.density > 0 ? options.density : 1.0);
  } catch (const std::exception &problem) {
    fail(problem.what());
  }
  volume_ = solid.volume;
  motion_.mass = options.mass > 0 ? options.mass : solid.mass;
  motion_.centre = options.hasCom ? options.com : solid.centre;
  centroidOffset_ = solid.centre - motion_.centre;
  motion_.inertia = options.hasInertia ? options.inertia : solid.inertia;
  if (!options.hasInertia)
    for (double &component : motion_.inertia) component *= motion_.mass / solid.mass;
  motion_.velocity = options.velocity;
  motion_.setOmega(options.omega);
}

/* ----------------------------------------------------------------------
   all triangles of the mesh, in the order of the file, on every rank: before the mesh's first set-up every rank
   holds all of them, afterwards its own share
------------------------------------------------------------------------- */

std::vector<frazil::Triangle> FixBodyRigid::triangles()
{
  const int local = mesh_->sizeLocal();
  std::vector<frazil::Triangle> mine(local);
  std::vector<int> myId(local);
  for (int i = 0; i < local; i++) {
    double node[3];
    for (int j = 0; j < 3; j++) {
      mesh_->node_slow(i, j, node);
      mine[i][j] = vector(node);
    }
    myId[i] = mesh_->id_slow(i);
  }
  if (!mesh_->isParallel() || comm->nprocs == 1) return mine;

  std::vector<int> count(comm->nprocs), start(comm->nprocs, 0);
  MPI_Allgather(&local, 1, MPI_INT, count.data(), 1, MPI_INT, world);
  std::partial_sum(count.begin(), count.end() - 1, start.begin() + 1);
  const int total = start.back() + count.back();
  std::vector<frazil::Triangle> all(total), sorted(total);
  std::vector<int> id(total);
  MPI_Allgatherv(myId.data(), local, MPI_INT, id.data(), count.data(), start.data(), MPI_INT, world);
  MPI_Datatype triangle;
  MPI_Type_contiguous(9, MPI_DOUBLE, &triangle);
  MPI_Type_commit(&triangle);
  MPI_Allgatherv(mine.data(), local, triangle, all.data(), count.data(), start.data(), triangle, world);
  MPI_Type_free(&triangle);
  for (int i = 0; i < total; i++) sorted[id[i]] = all[i];
  return sorted;
}

/* ---------------------------------------------------------------------- */

int FixBodyRigid::setmask() { return INITIAL_INTEGRATE | PRE_FORCE | FINAL_INTEGRATE; }

/* ---------------------------------------------------------------------- */

void FixBodyRigid::post_create()
{
  mesh_->registerMove(false, true, true);
  if (!mesh_->prop().getElementProperty<NodeVectors>("v"))
    mesh_->prop().addElementProperty<NodeVectors>("v", "comm_exchange_borders", "frame_invariant", "restart_no");
  mesh_->prop().getElementProperty<NodeVectors>("v")->setAll(0.);
  if (comm->me == 0) {
    const std::string line = std::string("Body ") + id + ": mass " + text(motion_.mass) + " kg, volume " + text(volume_) +
                             " m3, centre " + text(motion_.centre) + " m, velocity " + text(motion_.velocity) + " m/s\n";
    if (screen) fputs(line.c_str(), screen);
    if (logfile) fputs(line.c_str(), logfile);
  }
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::pre_delete(bool unfixflag)
{
  if (!unfixflag || modify->find_fix_id(meshId_.c_str()) != fixMesh_) return;
  mesh_->prop().getElementProperty<NodeVectors>("v")->setAll(0.);
  mesh_->unregisterMove(false, true, true);
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::init()
{
  if (!std::strstr(update->integrate_style, "verlet")) fail("needs 'run_style verlet'");
  if (modify->find_fix_id(meshId_.c_str()) != fixMesh_)
    fail("its mesh '" + meshId_ + "' was deleted or replaced: unfix the body first");
  if (modify->find_fix(meshId_.c_str()) > modify->find_fix(id))
    fail("it must come after its mesh '" + meshId_ + "' in the input script");
  if (!fixMesh_->hasNeighList() && comm->me == 0)
    error->warning(FLERR, "fix body/rigid: no fix wall/gran uses the body's mesh, so it feels no contact");
  gravity_ = static_cast<FixGravity *>(modify->find_fix_style_strict("gravity", 0));
}

/* ----------------------------------------------------------------------
   after the mesh has spread its elements over the ranks. The set-up of fix wall/gran follows and adds this rank's
   contacts to the mesh's force, which the mesh itself neither zeroes nor sums there
------------------------------------------------------------------------- */

void FixBodyRigid::setup_pre_force(int)
{
  std::fill_n(stress_->f_total_ptr(), 3, 0.0);
  std::fill_n(stress_->torque_total_ptr(), 3, 0.0);
  contactIsLocal_ = true;
  setNodeVelocities();
  setReferencePoint();
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::initial_integrate(int)
{
  if (contactIsLocal_) takeContactForce(true);
  contactIsLocal_ = false;
  kick(0.5 * update->dt);
  moveMesh(motion_.drift(update->dt));
  setNodeVelocities();
  setReferencePoint();
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::final_integrate()
{
  takeContactForce(false);
  kick(0.5 * update->dt);
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::takeContactForce(bool sumOverRanks)
{
  double load[6];
  stress_->f_total(load);
  stress_->torque_total(load + 3);
  if (sumOverRanks) MPI_Allreduce(MPI_IN_PLACE, load, 6, MPI_DOUBLE, MPI_SUM, world);
  contactForce_ = vector(load);
  contactTorque_ = vector(load + 3);
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::kick(double dt)
{
  Vec3 force = contactForce_ + fluid_.force;
  if (gravity_) {
    double g[3];
    gravity_->get_gravity(g);
    force += motion_.mass * vector(g);
  }
  motion_.kick(force, contactTorque_ + fluid_.torque, dt);
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::moveMesh(const frazil::RigidMotion::Step &step)
{
  mesh_->move(&step.displacement.x);
  const double angle = norm(step.rotation);
  if (angle > 0) mesh_->rotate(angle, &step.rotation.x, &motion_.centre.x);
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::setNodeVelocities()
{
  const Vec3 omega = motion_.omega();
  double ***v = mesh_->prop().getElementProperty<NodeVectors>("v")->begin();
  const int all = mesh_->sizeLocal() + mesh_->sizeGhost();
  for (int i = 0; i < all; i++)
    for (int j = 0; j < 3; j++) {
      double node[3];
      mesh_->node_slow(i, j, node);
      const Vec3 at = motion_.velocity + cross(omega, vector(node) - motion_.centre);
      for (int axis = 0; axis < 3; axis++) v[i][j][axis] = at[axis];
    }
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::setReferencePoint() { stress_->set_p_ref(&motion_.centre.x); }

/* ----------------------------------------------------------------------
   f_ID[1..26]: centre, velocity, omega, quaternion, contact force and torque, fluid force and torque, wetted fraction
------------------------------------------------------------------------- */

double FixBodyRigid::compute_vector(int n)
{
  const frazil::Quaternion &q = motion_.orientation;
  const double quaternion[4] = {q.w, q.x, q.y, q.z};
  if (n < 3) return motion_.centre[n];
  if (n < 6) return motion_.velocity[n - 3];
  if (n < 9) return motion_.omega()[n - 6];
  if (n < 13) return quaternion[n - 9];
  if (n < 16) return contactForce_[n - 13];
  if (n < 19) return contactTorque_[n - 16];
  if (n < 22) return fluid_.force[n - 19];
  if (n < 25) return fluid_.torque[n - 22];
  return fluid_.wetFraction;
}

/* ----------------------------------------------------------------------
   the mesh fix stores the nodes where they are; this is what they cannot tell
------------------------------------------------------------------------- */

namespace {

struct RestartState {
  double mass, volume;
  frazil::Inertia inertia;
  Vec3 centroidOffset, centre, velocity, angularMomentum, lockedOmega, contactForce, contactTorque;
  frazil::Quaternion orientation;
  frazil::BodyLoad fluid;
};

}

void FixBodyRigid::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  const RestartState state = {motion_.mass,   volume_,          motion_.inertia,         centroidOffset_,
                              motion_.centre, motion_.velocity, motion_.angularMomentum, motion_.lockedOmega,
                              contactForce_,  contactTorque_,   motion_.orientation,     fluid_};
  const int size = sizeof(state);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&state, size, 1, fp);
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::restart(char *buffer)
{
  RestartState state;
  std::memcpy(&state, buffer, sizeof(state));
  if (std::abs(state.volume - volume_) > 1e-6 * state.volume)
    fail("the restart file's body has a volume of " + text(state.volume) + " m3, the mesh '" + meshId_ + "' one of " +
         text(volume_) + " m3: continue with the surface that the run was started with");
  motion_.mass = state.mass;
  volume_ = state.volume;
  motion_.inertia = state.inertia;
  centroidOffset_ = state.centroidOffset;
  motion_.centre = state.centre;
  motion_.velocity = state.velocity;
  motion_.angularMomentum = state.angularMomentum;
  motion_.lockedOmega = state.lockedOmega;
  contactForce_ = state.contactForce;
  contactTorque_ = state.contactTorque;
  motion_.orientation = state.orientation;
  fluid_ = state.fluid;
}

/* ---------------------------------------------------------------------- */

frazil::BodyState FixBodyRigid::bodyState() const
{
  frazil::BodyState state;
  std::snprintf(state.name, sizeof(state.name), "%s", id);
  state.centre = motion_.centre;
  state.velocity = motion_.velocity;
  state.angularVelocity = motion_.omega();
  const frazil::Quaternion &q = motion_.orientation;
  const double quaternion[4] = {q.w, q.x, q.y, q.z};
  std::copy_n(quaternion, 4, state.orientation);
  state.centroidOffset = centroidOffset_;
  state.volume = volume_;
  return state;
}

/* ---------------------------------------------------------------------- */

void FixBodyRigid::setFluidLoad(const frazil::BodyLoad &load) { fluid_ = load; }
