/* fix couple/foam: the fluid's force in each DEM step, implicit in the particle's motion (fluid_push.h). */

#include "fix_couple_foam.h"

#include "fluid_push.h"
#include "host_vector.h"

#include "atom.h"
#include "update.h"

using namespace LAMMPS_NS;
using frazil::vec;
using frazil::Vec3;

namespace
{

const double momentOfInertia = 0.4; // of a sphere, in units of m r^2, as fix nve/sphere has it

void add(double* a, const Vec3& b)
{
    a[0] += b.x;
    a[1] += b.y;
    a[2] += b.z;
}

} // namespace

/// impulseWeight: share of the step's force that acts before and after the positions move, dt/2; 0 in a set-up,
/// which only renews the force for the step to come.
void FixCoupleFoam::applyFluid(double impulseWeight)
{
    for (int i = 0; i < atom->nlocal; i++) {
        if (!(atom->mask[i] & groupbit))
            continue;
        frazil::CarriedParticle& p = carried_[i];
        const Vec3 reaction = reactionOn(i), spin = torqueOn(i), force = p.fluid.passiveForce + reaction;
        if (impulseWeight > 0)
            noteMotion(i);
        const Vec3 received = impulseWeight * (p.reaction + reaction);
        p.impulse += received;
        impulse_ += received;
        p.reaction = reaction;
        if (impulseWeight > 0 && drive_.accelerates(atom->mask[i]))
            rememberVelocity(i);

        double* shown = array_atom[i];
        shown[0] = force.x, shown[1] = force.y, shown[2] = force.z;
        shown[3] = spin.x, shown[4] = spin.y, shown[5] = spin.z;
        push(i);
    }
}

/// Over the fluid step: impulse of all other forces, and way; the velocity is that of the half step, with which the
/// Positions have moved
void FixCoupleFoam::noteMotion(int i)
{
    carried_[i].others += update->dt * vec(atom->f[i]);
    carried_[i].path += update->dt * vec(atom->v[i]);
}

/// Drag and added-mass force, axis by axis: a fix may prescribe the motion along some of them
Vec3 FixCoupleFoam::reactionOn(int i) const
{
    const frazil::Interaction& fluid = carried_[i].fluid;
    const Vec3 v = vec(atom->v[i]);
    const int mask = atom->mask[i];
    const Vec3 moving = frazil::reactionOnMoving(fluid, vec(atom->f[i]), v, atom->rmass[i], update->dt);
    if (drive_.free(mask))
        return moving;
    Vec3 reaction = frazil::reactionOnPrescribed(fluid, v, prescribedAcceleration(i));
    for (int axis = 0; axis < 3; axis++)
        if (drive_.free(mask, axis))
            reaction[axis] = moving[axis];
    return reaction;
}

Vec3 FixCoupleFoam::torqueOn(int i) const
{
    const frazil::Interaction& fluid = carried_[i].fluid;
    const Vec3 w = vec(atom->omega[i]);
    if (!drive_.spins(atom->mask[i]))
        return frazil::torqueOnPrescribed(fluid, w);
    const double inertia = momentOfInertia * atom->rmass[i] * atom->radius[i] * atom->radius[i];
    return frazil::torqueOnMoving(fluid, vec(atom->torque[i]), w, inertia, update->dt);
}

/// Of the last DEM step. Its first step of all counts as unaccelerated: the jump from the script's initial velocity
/// into the motion is the script's, and no kick to the fluid.
Vec3 FixCoupleFoam::prescribedAcceleration(int i) const
{
    const frazil::CarriedParticle& p = carried_[i];
    if (!drive_.accelerates(atom->mask[i]) || !p.velocityKnown)
        return Vec3();
    return (vec(atom->v[i]) - p.velocity) / update->dt;
}

void FixCoupleFoam::rememberVelocity(int i)
{
    carried_[i].velocity = vec(atom->v[i]);
    carried_[i].velocityKnown = 1;
}

/// A particle whose force fix freeze has cleared would move if it were given one now
void FixCoupleFoam::push(int i)
{
    if (drive_.cleared(atom->mask[i]))
        return;
    add(atom->f[i], vec(array_atom[i]));
    add(atom->torque[i], vec(array_atom[i] + 3));
}

/// The first half step of a continued run takes the force that it would have taken without the break.
void FixCoupleFoam::repeatFluid()
{
    for (int i = 0; i < atom->nlocal; i++)
        if (atom->mask[i] & groupbit)
            push(i);
}
