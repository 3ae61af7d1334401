/* The surface mesh of a rigid body: a fix mesh/surface/stress that the body moves, and whose contact force it takes.

   LIGGGHTS's contact law reads the velocity of the mesh's nodes from the element property "v" and adds the contacts to
   the mesh's force and torque, which the mesh zeroes before the forces and sums over the ranks after them; in a set-up
   it does neither. Cost: one pass over the local triangles per step. Parallel: all ranks move the same body. */

#ifndef FRAZIL_BODY_MESH_H
#define FRAZIL_BODY_MESH_H

#include "ClosedSurface.h"
#include "RigidMotion.h"
#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS
{

class BodyMesh : protected Pointers
{
  public:
    /// std::runtime_error, with the cure, if there is no such mesh or something else moves it.
    BodyMesh(class LAMMPS*, const std::string& fixId);

    const std::string& id() const { return id_; }
    bool stillThere() const;
    /// Does a fix wall/gran use it?
    bool isWall() const;

    /// All triangles in the order of the file, on every rank. Collective.
    std::vector<frazil::Triangle> triangles() const;

    /// Takes over the mesh's motion, and gives it back.
    void take();
    void release();

    void follow(const frazil::RigidMotion::Step& step, const frazil::Vec3& centre);
    /// Velocities of the nodes, and the point about which the mesh's torque counts.
    void setVelocities(const frazil::RigidMotion& motion);

    struct Load {
        frazil::Vec3 force, torque; ///< [N], [N m] about the reference point
    };

    void clearLoad();
    /// Of the contacts of the last step; sumOverRanks where the mesh has not done it.
    Load load(bool sumOverRanks) const;

  private:
    std::vector<frazil::Triangle> localTriangles(std::vector<int>& ids) const;

    std::string id_;
    class FixMeshSurface* fix_;
    class TriMesh* mesh_;
    class MeshModuleStress* stress_ = nullptr;
};

} // namespace LAMMPS_NS

#endif
