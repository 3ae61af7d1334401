#include "particle_drive.h"

#include <array>
#include <cstring>
#include <stdexcept>
#include <string>

#include "coupled_body.h"
#include "fix_move.h"
#include "fix_nve_sphere.h"
#include "modify.h"
#include "private_member.h"

using namespace LAMMPS_NS;

namespace
{

enum Integrator { FORCE, FORCE_AND_TORQUE, CONSTANT_VELOCITY };
const struct {
    const char* style;
    Integrator kind;
} knownIntegrators[] = {{"nve", FORCE},
                        {"nve/limit", FORCE},
                        {"nve/sph", FORCE},
                        {"nve/sphere", FORCE_AND_TORQUE},
                        {"nve/noforce", CONSTANT_VELOCITY},
                        {"nve/sph/stationary", CONSTANT_VELOCITY}};

// fix move: its styles of motion as it numbers them, and what tells for three of them whether an axis is prescribed
enum MoveStyle { LINEAR, WIGGLE, ROTATE, VARIABLE };
typedef int FixMove::*Flag;
typedef char* FixMove::*Word;
std::array<Flag, 7> moveFlags(); // the style, then the axes of LINEAR, of WIGGLE
std::array<Word, 6> moveWords(); // VARIABLE: names of the displacements, of the velocities
template <Flag... member> struct MoveFlags {
    friend std::array<Flag, 7> moveFlags() { return {{member...}}; }
};
template <Word... member> struct MoveWords {
    friend std::array<Word, 6> moveWords() { return {{member...}}; }
};
template struct MoveFlags<&FixMove::mstyle, &FixMove::vxflag, &FixMove::vyflag, &FixMove::vzflag, &FixMove::axflag,
                          &FixMove::ayflag, &FixMove::azflag>;
template struct MoveWords<&FixMove::xvarstr, &FixMove::yvarstr, &FixMove::zvarstr, &FixMove::vxvarstr,
                          &FixMove::vyvarstr, &FixMove::vzvarstr>;

int moveStyle(const FixMove& move)
{
    return move.*moveFlags()[0];
}

bool prescribes(const FixMove& move, int axis)
{
    switch (moveStyle(move)) {
    case LINEAR:
        return move.*moveFlags()[1 + axis];
    case WIGGLE:
        return move.*moveFlags()[4 + axis];
    case VARIABLE:
        return move.*moveWords()[axis] || move.*moveWords()[3 + axis];
    default:
        return true;
    }
}

// the fluid sees the velocity, which fix move leaves as it was where it has a displacement only
bool hidesVelocity(const FixMove& move, int axis)
{
    return moveStyle(move) == VARIABLE && move.*moveWords()[axis] && !(move.*moveWords()[3 + axis]);
}

struct OwnAddedMass {
    typedef bool FixNVESphere::*Member;
    friend Member memberOf(OwnAddedMass);
};
template struct PrivateMember<OwnAddedMass, &FixNVESphere::useAM_>;

[[noreturn]] void refuse(const Fix* fix, const std::string& why)
{
    throw std::runtime_error(std::string("fix ") + fix->id + " (" + fix->style + ") " + why);
}

} // namespace

ParticleDrive::ParticleDrive(const Modify& modify, const Fix* last)
{
    bool before = true;
    for (int i = 0; i < modify.nfix; i++) {
        if (modify.fix[i] == last)
            before = false;
        add(modify.fix[i], before);
    }
}

void ParticleDrive::add(const Fix* fix, bool beforeLast)
{
    if (!strncmp(fix->style, "multisphere", 11) || !strncmp(fix->style, "rigid", 5))
        refuse(fix, "moves clumps of spheres, which cannot be coupled. Bond the spheres with fix bond/parallel");
    if (!strcmp(fix->style, "freeze")) {
        frozen_ |= fix->groupbit;
        if (beforeLast)
            cleared_ |= fix->groupbit;
    }
    if (!fix->time_integrate || dynamic_cast<const CoupledBody*>(fix))
        return;
    if (const FixMove* move = dynamic_cast<const FixMove*>(fix))
        addMove(move);
    else if (!addKnownIntegrator(fix))
        refuse(fix, "integrates in a way that fix couple/foam does not know: is it the force that moves its particles? "
                    "Known: nve, nve/limit, nve/sph, nve/sphere (the force), move, nve/noforce, nve/sph/stationary "
                    "(prescribed). Use one of these");
}

bool ParticleDrive::addKnownIntegrator(const Fix* fix)
{
    for (const auto& known : knownIntegrators) {
        if (strcmp(fix->style, known.style))
            continue;
        for (int axis = 0; axis < 3; axis++)
            (known.kind == CONSTANT_VELOCITY ? prescribed_ : free_)[axis] |= fix->groupbit;
        if (known.kind == FORCE_AND_TORQUE) {
            spins_ |= fix->groupbit;
            if (static_cast<const FixNVESphere*>(fix)->*memberOf(OwnAddedMass()))
                refuse(fix,
                       "has CAddRhoFluid: together with fix couple/foam particles would have their added mass twice. "
                       "Leave CAddRhoFluid out");
        }
        return true;
    }
    return false;
}

void ParticleDrive::addMove(const FixMove* fix)
{
    for (int axis = 0; axis < 3; axis++) {
        (prescribes(*fix, axis) ? prescribed_ : free_)[axis] |= fix->groupbit;
        if (hidesVelocity(*fix, axis))
            refuse(fix, "gives a displacement without a velocity along an axis: the fluid would not see the motion. "
                        "Give the variable of the velocity too");
    }
    if (moveStyle(*fix) != LINEAR)
        accelerates_ |= fix->groupbit;
}
