#include "fix_couple_foam.h"

#include <cmath>
#include <cstring>

#include "InputError.h"
#include "atom.h"
#include "coupled_body.h"
#include "coupling_history.h"
#include "error.h"
#include "fluid_push.h"
#include "memory.h"
#include "modify.h"
#include "output.h"
#include "script_words.h"
#include "signal_handling.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using frazil::Vec3;

namespace
{

const double momentOfInertia = 0.4; // of a sphere, in units of m r^2, as fix nve/sphere has it

Vec3 vec(const double* a)
{
    return {a[0], a[1], a[2]};
}

void add(double* a, const Vec3& b)
{
    a[0] += b.x;
    a[1] += b.y;
    a[2] += b.z;
}

} // namespace

/* ---------------------------------------------------------------------- */

FixCoupleFoam::FixCoupleFoam(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg), historyFile_("history.csv"), fragmentEvery_(10), ramp_(0.01), shielding_(NULL),
      exchangeStep_(-1), first_(true), lastDeltaT_(0), dt_(0), restartTime_(-1), forceStep_(-1), startWall_(0),
      exchangeWall_(0), forceWall_(0)
{
    try {
        readKeywords(narg, arg);
    } catch (const frazil::InputError& wrong) {
        error->fix_error(FLERR, this, wrong.what());
    }
    if (!atom->radius_flag || !atom->rmass_flag)
        error->fix_error(FLERR, this, "needs spheres with mass and radius. Use atom_style granular");
    if (modify->n_fixes_style_strict("couple/foam") > 0)
        error->fix_error(FLERR, this, "a script can have only one. Couple all particles through one group");
    try {
        link_.reset(new frazil::DemLink);
    } catch (const std::exception& e) {
        error->fix_error(FLERR, this, e.what());
    }

    nevery = 1;
    vector_flag = 1;
    size_vector = 5;
    global_freq = 1;
    extvector = 0;
    peratom_flag = 1;
    size_peratom_cols = FORCES;
    peratom_freq = 1;
    create_attribute = 1;
    restart_global = 1;
    restart_peratom = 1;

    grow_arrays(atom->nmax);
    atom->add_callback(0);
    atom->add_callback(1);
    for (int i = 0; i < atom->nlocal; i++)
        set_arrays(i);
}

/* ----------------------------------------------------------------------
   collective: unfix, clear or the end of LIGGGHTS, which by now has deleted comm, update and output
------------------------------------------------------------------------- */

FixCoupleFoam::~FixCoupleFoam()
{
    if (link_ && exchangeStep_ >= 0 && !link_->finished()) {
        link_->finish(order_.time);
        printTimers();
    }
    atom->delete_callback(id, 0);
    atom->delete_callback(id, 1);
    memory->destroy(array_atom);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::readKeywords(int narg, char** arg)
{
    const frazil::Settings words =
        frazil::scriptWords(narg - 3, arg + 3, {{"shielding"}, {"history"}, {"restart"}, {"ramp"}, {"fragment_every"}});
    shieldingId_ = words.text("shielding", "");
    historyFile_ = words.text("history", historyFile_);
    if (historyFile_ == "none")
        historyFile_.clear();
    restartFile_ = words.text("restart", "");
    ramp_ = words.notNegative("ramp", ramp_);
    fragmentEvery_ = int(words.integer("fragment_every", fragmentEvery_));
    if (fragmentEvery_ < 1)
        words.reject("fragment_every", "must be above zero", "Give a number of fluid steps");
}

int FixCoupleFoam::setmask()
{
    return POST_FORCE | END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::init()
{
    if (strstr(update->integrate_style, "respa"))
        error->fix_error(FLERR, this, "does not work with run_style respa. Use run_style verlet");
    if (exchangeStep_ >= 0 && update->dt != dt_)
        error->fix_error(FLERR, this,
                         "the time step may not change after the coupling has started. Keep timestep as it was");
    findPartners();
    findMotion();
    requireLastForce();
}

void FixCoupleFoam::findPartners()
{
    bodies_.clear();
    for (int i = 0; i < modify->nfix; i++)
        if (CoupledBody* body = dynamic_cast<CoupledBody*>(modify->fix[i]))
            bodies_.push_back(body);

    bonds_.clear();
    for (int i = 0; i < modify->nfix; i++)
        if (!strcmp(modify->fix[i]->style, "bond/parallel"))
            bonds_.push_back(modify->fix[i]);

    shielding_ = NULL;
    if (shieldingId_.empty())
        return;
    shielding_ = modify->find_fix_id(shieldingId_.c_str());
    if (!shielding_ || strcmp(shielding_->style, "bond/parallel")) {
        const std::string message = "shielding " + shieldingId_ + ": there is no fix bond/parallel of this ID. " +
                                    "Define it before the run, or leave the keyword out";
        error->fix_error(FLERR, this, message.c_str());
    }
}

void FixCoupleFoam::findMotion()
{
    try {
        motion_ = ParticleMotion(*modify, this);
    } catch (const std::exception& e) {
        error->fix_error(FLERR, this, e.what());
    }
    // what a motion knew that has ended is of no use to the next one
    for (int i = 0; i < atom->nlocal; i++)
        if (!motion_.accelerates(atom->mask[i]))
            carried_[i].velocityKnown = 0;
}

/* ----------------------------------------------------------------------
   the implicit force needs the sum of all others, so it must be added last
------------------------------------------------------------------------- */

void FixCoupleFoam::requireLastForce()
{
    for (int i = modify->my_index(this) + 1; i < modify->nfix; i++) {
        const Fix* fix = modify->fix[i];
        const bool harmless = !strcmp(fix->style, "freeze") || !strncmp(fix->style, "store", 5) ||
                              !strncmp(fix->style, "massflow", 8) || dynamic_cast<const CoupledBody*>(fix);
        if ((modify->fmask[i] & POST_FORCE) && !harmless) {
            const std::string message = std::string("fix ") + fix->id + " (" + fix->style +
                                        ") comes later and changes forces. " +
                                        "Write fix couple/foam after it: it needs the sum of all other forces";
            error->fix_error(FLERR, this, message.c_str());
        }
    }
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::setup(int)
{
    const bool continues = exchangeStep_ >= 0 || restartTime_ >= 0;
    forceStep_ = -1;
    // `run 0` only asks for the forces; the coupling starts with the first run that moves
    if (exchangeStep_ < 0 && update->nsteps > 0) {
        try {
            startCoupling();
            exchange();
        } catch (const std::exception& e) {
            stop(e.what());
        }
    }
    if (continues)
        repeatFluid();
    else
        applyFluid(0);
}

void FixCoupleFoam::post_force(int)
{
    const double start = MPI_Wtime();
    applyFluid(0.5 * update->dt);
    forceWall_ += MPI_Wtime() - start;
}

void FixCoupleFoam::end_of_step()
{
    if (exchangeStep_ < 0 || link_->finished() || update->ntimestep < exchangeStep_ + order_.substeps)
        return;
    try {
        exchange();
    } catch (const std::exception& e) {
        stop(e.what());
    }
}

void FixCoupleFoam::reset_timestep(bigint newStep, bigint oldStep)
{
    if (exchangeStep_ >= 0)
        exchangeStep_ += newStep - oldStep;
}

/* ----------------------------------------------------------------------
   impulseWeight: share of the step's force that acts before and after the positions move, dt/2; 0 in a set-up,
   which only renews the force for the step to come
------------------------------------------------------------------------- */

void FixCoupleFoam::applyFluid(double impulseWeight)
{
    for (int i = 0; i < atom->nlocal; i++) {
        if (!(atom->mask[i] & groupbit))
            continue;
        Carried& p = carried_[i];
        const Vec3 reaction = reactionOn(i), spin = torqueOn(i), force = p.fluid.passiveForce + reaction;
        if (impulseWeight > 0)
            noteMotion(i);
        const Vec3 received = impulseWeight * (p.reaction + reaction);
        p.impulse += received;
        impulse_ += received;
        p.reaction = reaction;
        if (impulseWeight > 0 && motion_.accelerates(atom->mask[i]))
            rememberVelocity(i);

        double* shown = array_atom[i];
        shown[0] = force.x, shown[1] = force.y, shown[2] = force.z;
        shown[3] = spin.x, shown[4] = spin.y, shown[5] = spin.z;
        push(i);
    }
}

// over the fluid step: impulse of all other forces, and way; the velocity is that of the half step, with which the
// positions have moved
void FixCoupleFoam::noteMotion(int i)
{
    carried_[i].others += update->dt * vec(atom->f[i]);
    carried_[i].path += update->dt * vec(atom->v[i]);
}

// drag and added-mass force, axis by axis: a fix may prescribe the motion along some of them
Vec3 FixCoupleFoam::reactionOn(int i) const
{
    const frazil::Interaction& fluid = carried_[i].fluid;
    const Vec3 v = vec(atom->v[i]);
    const int mask = atom->mask[i];
    const Vec3 moving = frazil::reactionOnMoving(fluid, vec(atom->f[i]), v, atom->rmass[i], update->dt);
    if (motion_.free(mask))
        return moving;
    Vec3 reaction = frazil::reactionOnPrescribed(fluid, v, prescribedAcceleration(i));
    for (int axis = 0; axis < 3; axis++)
        if (motion_.free(mask, axis))
            reaction[axis] = moving[axis];
    return reaction;
}

Vec3 FixCoupleFoam::torqueOn(int i) const
{
    const frazil::Interaction& fluid = carried_[i].fluid;
    const Vec3 w = vec(atom->omega[i]);
    if (!motion_.spins(atom->mask[i]))
        return frazil::torqueOnPrescribed(fluid, w);
    const double inertia = momentOfInertia * atom->rmass[i] * atom->radius[i] * atom->radius[i];
    return frazil::torqueOnMoving(fluid, vec(atom->torque[i]), w, inertia, update->dt);
}

/* ----------------------------------------------------------------------
   of the last DEM step. Its first step of all counts as unaccelerated: the jump from the script's initial velocity into
   the motion is the script's, and no kick to the fluid
------------------------------------------------------------------------- */

Vec3 FixCoupleFoam::prescribedAcceleration(int i) const
{
    const Carried& p = carried_[i];
    if (!motion_.accelerates(atom->mask[i]) || !p.velocityKnown)
        return Vec3();
    return (vec(atom->v[i]) - p.velocity) / update->dt;
}

void FixCoupleFoam::rememberVelocity(int i)
{
    carried_[i].velocity = vec(atom->v[i]);
    carried_[i].velocityKnown = 1;
}

// a particle whose force fix freeze has cleared would move if it were given one now
void FixCoupleFoam::push(int i)
{
    if (motion_.cleared(atom->mask[i]))
        return;
    add(atom->f[i], vec(array_atom[i]));
    add(atom->torque[i], vec(array_atom[i] + 3));
}

/* ----------------------------------------------------------------------
   the first half step of a continued run takes the force that it would have taken without the break
------------------------------------------------------------------------- */

void FixCoupleFoam::repeatFluid()
{
    for (int i = 0; i < atom->nlocal; i++)
        if (atom->mask[i] & groupbit)
            push(i);
}

/* ----------------------------------------------------------------------
   frazilFoam has reached its end: the run stops after this step with its output, the script after this run
------------------------------------------------------------------------- */

void FixCoupleFoam::endRun()
{
    say("couple/foam: frazilFoam has reached its end, fluid time " + std::to_string(order_.time) +
        " s. The run ends here\n");
    SignalHandler::request_quit = true;
    output->next = output->next_thermo = update->ntimestep;
    update->nsteps = int(update->ntimestep - update->firststep);
    printTimers();
}

void FixCoupleFoam::printTimers()
{
    double mine[4] = {MPI_Wtime() - startWall_, exchangeWall_, link_->waited(), forceWall_}, longest[4];
    MPI_Reduce(mine, longest, 4, MPI_DOUBLE, MPI_MAX, 0, world);
    const double total = longest[0], work = std::fmax(longest[1] - longest[2], 0);
    char table[800];
    snprintf(table, sizeof table,
             "couple/foam: wall time of frazilDem since the handshake (longest of all ranks)\n"
             "  whole run            %10.3f s\n"
             "  waiting for the fluid%10.3f s  %5.1f %%\n"
             "  exchange             %10.3f s  %5.1f %%\n"
             "  fluid force          %10.3f s  %5.1f %%\n"
             "FRAZIL_TIMERS side=dem wall=%.4f waiting=%.4f exchange=%.4f force=%.4f\n",
             total, longest[2], 100 * longest[2] / total, work, 100 * work / total, longest[3],
             100 * longest[3] / total, total, longest[2], work, longest[3]);
    say(table);
}

/* ---------------------------------------------------------------------- */

double FixCoupleFoam::fluidTimeNow() const
{
    if (exchangeStep_ < 0)
        return restartTime_;
    return order_.time + (update->ntimestep - exchangeStep_) * dt_;
}

double FixCoupleFoam::compute_vector(int n)
{
    if (n == 0)
        return fluidTimeNow();
    if (n == 1)
        return double(order_.substeps);
    if (forceStep_ != update->ntimestep) {
        double mine[3] = {0, 0, 0};
        for (int i = 0; i < atom->nlocal; i++)
            if (atom->mask[i] & groupbit)
                for (int d = 0; d < 3; d++)
                    mine[d] += array_atom[i][d];
        MPI_Allreduce(mine, total_, 3, MPI_DOUBLE, MPI_SUM, world);
        forceStep_ = update->ntimestep;
    }
    return total_[n - 2];
}

void FixCoupleFoam::say(const std::string& message)
{
    if (frazil::World::instance().ownRank() != 0)
        return;
    if (screen)
        fputs(message.c_str(), screen), fflush(screen);
    if (logfile)
        fputs(message.c_str(), logfile), fflush(logfile);
}

/* ----------------------------------------------------------------------
   the failure may be of one rank only, so not error->all; the partner is told the reason
------------------------------------------------------------------------- */

void FixCoupleFoam::stop(const std::string& message)
{
    if (logfile)
        fprintf(logfile, "ERROR: Fix couple/foam (id %s): %s\n", id, message.c_str()), fflush(logfile);
    frazil::World::instance().fail("Fix couple/foam (id " + std::string(id) + "): " + message);
}
