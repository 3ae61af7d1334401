#include "body_mesh.h"

#include "host_vector.h"

#include "comm.h"
#include "fix_mesh_surface.h"
#include "mesh_module_stress.h"
#include "modify.h"
#include "tri_mesh.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

using namespace LAMMPS_NS;
using frazil::Triangle;
using frazil::vec;
using frazil::Vec3;

namespace
{

using NodeVectors = MultiVectorContainer<double, 3, 3>;

void require(bool fine, const std::string& problem)
{
    if (!fine)
        throw std::runtime_error(problem);
}

} // namespace

BodyMesh::BodyMesh(LAMMPS* lmp, const std::string& fixId) : Pointers(lmp), id_(fixId)
{
    Fix* found = modify->find_fix_id(id_.c_str());
    require(found, "there is no fix '" + id_ +
                       "', so the body has no mesh: define it before this fix, for example 'fix " + id_ +
                       " all mesh/surface/stress file body.stl type 1'");
    fix_ = dynamic_cast<FixMeshSurface*>(found);
    if (fix_)
        stress_ = dynamic_cast<MeshModuleStress*>(fix_->get_module("stress"));
    require(stress_, "fix '" + id_ + "' is of style " + found->style +
                         ", which does not add up contact forces: make it a mesh/surface/stress");
    mesh_ = fix_->triMesh();
    require(stress_->trackStress(), "mesh '" + id_ + "' has 'stress off': the body would feel no contact, remove it");
    require(!fix_->surfaceVel(),
            "mesh '" + id_ + "' has a surface velocity: remove surface_vel and surface_ang_vel, the body sets it");
    require(!mesh_->isMoving(), "mesh '" + id_ + "' is already moved by another fix: remove one of the two");
}

bool BodyMesh::stillThere() const
{
    return modify->find_fix_id(id_.c_str()) == fix_;
}

bool BodyMesh::isWall() const
{
    return fix_->hasNeighList();
}

std::vector<Triangle> BodyMesh::localTriangles(std::vector<int>& ids) const
{
    const int local = mesh_->sizeLocal();
    std::vector<Triangle> mine(local);
    ids.resize(local);
    for (int i = 0; i < local; ++i) {
        double node[3];
        for (int j = 0; j < 3; ++j) {
            mesh_->node_slow(i, j, node);
            mine[i][j] = vec(node);
        }
        ids[i] = mesh_->id_slow(i);
    }
    return mine;
}

/// Before the mesh's first set-up every rank holds all triangles, afterwards its own share.
std::vector<Triangle> BodyMesh::triangles() const
{
    std::vector<int> myIds;
    const std::vector<Triangle> mine = localTriangles(myIds);
    if (!mesh_->isParallel() || comm->nprocs == 1)
        return mine;

    const int local = static_cast<int>(mine.size());
    std::vector<int> count(comm->nprocs), start(comm->nprocs, 0);
    MPI_Allgather(&local, 1, MPI_INT, count.data(), 1, MPI_INT, world);
    std::partial_sum(count.begin(), count.end() - 1, start.begin() + 1);
    const int total = start.back() + count.back();
    std::vector<Triangle> all(total), sorted(total);
    std::vector<int> ids(total);
    MPI_Allgatherv(myIds.data(), local, MPI_INT, ids.data(), count.data(), start.data(), MPI_INT, world);
    MPI_Datatype triangle;
    MPI_Type_contiguous(9, MPI_DOUBLE, &triangle);
    MPI_Type_commit(&triangle);
    MPI_Allgatherv(mine.data(), local, triangle, all.data(), count.data(), start.data(), triangle, world);
    MPI_Type_free(&triangle);
    for (int i = 0; i < total; ++i)
        sorted[ids[i]] = all[i];
    return sorted;
}

void BodyMesh::take()
{
    mesh_->registerMove(false, true, true);
    if (!mesh_->prop().getElementProperty<NodeVectors>("v"))
        mesh_->prop().addElementProperty<NodeVectors>("v", "comm_exchange_borders", "frame_invariant", "restart_no");
    mesh_->prop().getElementProperty<NodeVectors>("v")->setAll(0.);
}

void BodyMesh::release()
{
    mesh_->prop().getElementProperty<NodeVectors>("v")->setAll(0.);
    mesh_->unregisterMove(false, true, true);
}

void BodyMesh::follow(const frazil::RigidMotion::Step& step, const Vec3& centre)
{
    mesh_->move(&step.displacement.x);
    const double angle = norm(step.rotation);
    if (angle > 0)
        mesh_->rotate(angle, &step.rotation.x, &centre.x);
}

void BodyMesh::setVelocities(const frazil::RigidMotion& motion)
{
    const Vec3 omega = motion.omega();
    double*** v = mesh_->prop().getElementProperty<NodeVectors>("v")->begin();
    const int all = mesh_->sizeLocal() + mesh_->sizeGhost();
    for (int i = 0; i < all; ++i)
        for (int j = 0; j < 3; ++j) {
            double node[3];
            mesh_->node_slow(i, j, node);
            const Vec3 at = motion.velocity + cross(omega, vec(node) - motion.centre);
            for (int axis = 0; axis < 3; ++axis)
                v[i][j][axis] = at[axis];
        }
    Vec3 centre = motion.centre; // the mesh copies it, but does not say so
    stress_->set_p_ref(&centre.x);
}

void BodyMesh::clearLoad()
{
    std::fill_n(stress_->f_total_ptr(), 3, 0.0);
    std::fill_n(stress_->torque_total_ptr(), 3, 0.0);
}

BodyMesh::Load BodyMesh::load(bool sumOverRanks) const
{
    double load[6];
    stress_->f_total(load);
    stress_->torque_total(load + 3);
    if (sumOverRanks)
        MPI_Allreduce(MPI_IN_PLACE, load, 6, MPI_DOUBLE, MPI_SUM, world);
    return {vec(load), vec(load + 3)};
}
