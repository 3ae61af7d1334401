#include "fix_couple_foam.h"

#include <cmath>
#include <cstring>

#include "DidYouMean.h"
#include "InputError.h"
#include "atom.h"
#include "coupled_body.h"
#include "coupling_history.h"
#include "error.h"
#include "fix_ids.h"
#include "memory.h"
#include "modify.h"
#include "output.h"
#include "say.h"
#include "script_words.h"
#include "signal_handling.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

FixCoupleFoam::FixCoupleFoam(LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg)
{
    if (!atom->radius_flag || !atom->rmass_flag)
        error->fix_error(FLERR, this, "needs spheres with mass and radius. Use atom_style granular");
    if (modify->n_fixes_style_strict("couple/foam") > 0)
        error->fix_error(FLERR, this, "a script can have only one. Couple all particles through one group");
    try {
        readWords(narg, arg);
        link_.reset(new frazil::DemLink);
    } catch (const std::exception& e) {
        error->fix_error(FLERR, this, e.what());
    }
    declareResults();
    grow_arrays(atom->nmax);
    atom->add_callback(0);
    atom->add_callback(1);
    for (int i = 0; i < atom->nlocal; i++)
        set_arrays(i);
}

/// Collective: unfix, clear or the end of LIGGGHTS, which by now has deleted comm, update and output.
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

void FixCoupleFoam::readWords(int narg, char** arg)
{
    const frazil::Settings words =
        frazil::scriptWords(narg - 3, arg + 3, {{"shielding"}, {"history"}, {"restart"}, {"ramp"}, {"fragment_every"}});
    shieldingId_ = words.text("shielding", "");
    historyFile_ = words.text("history", historyFile_);
    if (historyFile_ == "none")
        historyFile_.clear();
    restartFile_ = words.text("restart", "");
    ramp_ = words.notNegative("ramp", ramp_);
    fragmentEvery_ = frazil::positiveInt(words, "fragment_every", fragmentEvery_);
}

void FixCoupleFoam::declareResults()
{
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
}

int FixCoupleFoam::setmask()
{
    return POST_FORCE | END_OF_STEP;
}

void FixCoupleFoam::init()
{
    if (strstr(update->integrate_style, "respa"))
        error->fix_error(FLERR, this, "does not work with run_style respa. Use run_style verlet");
    if (exchangeStep_ >= 0 && update->dt != dt_)
        error->fix_error(FLERR, this,
                         "the time step may not change after the coupling has started. Keep timestep as it was");
    findPartners();
    findDrive();
    requireLastForce();
}

void FixCoupleFoam::findPartners()
{
    bodies_.clear();
    bonds_.clear();
    for (int i = 0; i < modify->nfix; i++) {
        if (CoupledBody* body = dynamic_cast<CoupledBody*>(modify->fix[i]))
            bodies_.push_back(body);
        if (!strcmp(modify->fix[i]->style, "bond/parallel"))
            bonds_.push_back(modify->fix[i]);
    }
    shielding_ = shieldingId_.empty() ? nullptr : findShielding();
}

Fix* FixCoupleFoam::findShielding()
{
    Fix* fix = modify->find_fix_id(shieldingId_.c_str());
    if (!fix || strcmp(fix->style, "bond/parallel")) {
        const auto known = frazil::fixIds(*modify, [](Fix* f) { return !strcmp(f->style, "bond/parallel"); });
        const frazil::InputError wrong("", "shielding", shieldingId_,
                                       "there is no fix bond/parallel of this ID" +
                                           frazil::didYouMean(shieldingId_, known),
                                       "Define it before the run, or leave the keyword out");
        error->fix_error(FLERR, this, wrong.what());
    }
    return fix;
}

void FixCoupleFoam::findDrive()
{
    try {
        drive_ = ParticleDrive(*modify, this);
    } catch (const std::exception& e) {
        error->fix_error(FLERR, this, e.what());
    }
    // what a motion knew that has ended is of no use to the next one
    for (int i = 0; i < atom->nlocal; i++)
        if (!drive_.accelerates(atom->mask[i]))
            carried_[i].velocityKnown = 0;
}

/// The implicit force needs the sum of all others, so it must be added last.
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

/// frazilFoam has reached its end: the run stops after this step with its output, the script after this run.
void FixCoupleFoam::endRun()
{
    frazil::say(*lmp, "couple/foam: frazilFoam has reached its end, fluid time " + std::to_string(order_.time) +
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
    frazil::say(*lmp, table);
}

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

/// The failure may be of one rank only, so not error->all; the partner is told the reason.
void FixCoupleFoam::stop(const std::string& message)
{
    if (logfile)
        fprintf(logfile, "ERROR: Fix couple/foam (id %s): %s\n", id, message.c_str()), fflush(logfile);
    frazil::World::instance().fail("Fix couple/foam (id " + std::string(id) + "): " + message);
}
