#include "fix_bond_parallel.h"

#include "InputError.h"
#include "host_vector.h"
#include "say.h"
#include "script_words.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "memory.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "update.h"

#include <cstdlib>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace frazil;

FixBondParallel::FixBondParallel(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg), options_(optionsFrom(narg, arg, *error, this))
{
    if (!atom->sphere_flag || !atom->omega_flag || !atom->torque_flag)
        error->fix_error(FLERR, this, "bonds need spheres with spin and torque; cure: atom_style granular");
    declareResults();
    if (atom->map_style == 0) { // partners are found by id; the hash costs memory per owned and ghost sphere only
        atom->map_style = 2;
        atom->map_init();
        atom->map_set();
    }
    grow_arrays(atom->nmax);
    atom->add_callback(0);
    atom->add_callback(1);
    for (int i = 0; i < atom->nlocal; ++i)
        set_arrays(i);
}

FixBondParallel::~FixBondParallel()
{
    atom->delete_callback(id, 0);
    atom->delete_callback(id, 1);
    memory->destroy(array_atom);
}

BondOptions FixBondParallel::optionsFrom(int narg, char** arg, Error& error, Fix* fix)
{
    static const std::vector<Keyword> keywords = {{"young"},          {"stiffness_ratio"}, {"tensile_strength"},
                                                  {"shear_strength"}, {"radius_factor"},   {"moment_factor"},
                                                  {"friction_angle"}, {"damping", 1, 4},   {"create_gap"},
                                                  {"list"},           {"weibull", 2, 2},   {"events"}};
    try {
        return BondOptions(scriptWords(narg - 3, arg + 3, keywords));
    } catch (const InputError& wrong) {
        error.fix_error(FLERR, fix, wrong.what());
    }
    std::abort(); // fix_error does not return, but is not declared so
}

void FixBondParallel::declareResults()
{
    restart_global = 1;
    restart_peratom = 1;
    create_attribute = 1;
    virial_flag = 1;
    nevery = 1;
    vector_flag = 1;
    size_vector = 9;
    global_freq = 1;
    extvector = 0;
    peratom_flag = 1;
    size_peratom_cols = 8;
    peratom_freq = 1;
    comm_forward = 6;
}

int FixBondParallel::setmask()
{
    return PRE_EXCHANGE | PRE_NEIGHBOR | POST_FORCE | END_OF_STEP | POST_RUN;
}

/* ----------------------------------------------------------------------
   hooks
------------------------------------------------------------------------- */

void FixBondParallel::init()
{
    if (!comm->ghost_velocity)
        error->fix_error(FLERR, this, "bonds need the velocity and spin of ghosts; cure: communicate single vel yes");
    if (domain->triclinic)
        error->fix_error(FLERR, this, "a triclinic box is not supported; cure: an orthogonal box");
    clock_.start(*update);
    if (created_)
        return;
    const int request = neighbor->request(this);
    neighbor->requests[request]->pair = 0;
    neighbor->requests[request]->fix = 1;
    neighbor->requests[request]->half = 0;
    neighbor->requests[request]->full = 1;
    neighbor->requests[request]->occasional = 1;
}

void FixBondParallel::init_list(int, NeighList* list)
{
    list_ = list;
}

void FixBondParallel::setup_pre_exchange()
{
    store();
    scheduleStress(update->ntimestep - 1);
}

void FixBondParallel::pre_exchange()
{
    store();
}

void FixBondParallel::setup_pre_neighbor()
{
    load();
}

void FixBondParallel::pre_neighbor()
{
    load();
}

void FixBondParallel::setup(int vflag)
{
    if (!created_)
        create();
    flushEvents(); // makes sure now that the file can be written
    checkTimeStep();
    evaluate(vflag);
    end_of_step();
}

void FixBondParallel::post_force(int vflag)
{
    evaluate(vflag);
}

void FixBondParallel::end_of_step()
{
    if (update->vflag_atom == update->ntimestep)
        stressArray();
    scheduleStress(update->ntimestep);
}

void FixBondParallel::post_run()
{
    flushEvents();
}

/* ----------------------------------------------------------------------
   the step
------------------------------------------------------------------------- */

void FixBondParallel::evaluate(int vflag)
{
    const int owned = atom->nlocal, all = owned + atom->nghost;
    if (all > 0) // the host's rows lie one behind the other
        step_.advance(table_, options_.material,
                      {owned, all, atom->x[0], atom->v[0], atom->omega[0], atom->f[0], atom->torque[0]}, update->dt,
                      !update->setupflag);
    tableNewer_ = true; // a restart file may have been written since the last reneighbouring
    for (const BrokenBond& bond : step_.broken())
        noteBroken(bond);
    step_.removeBroken(table_);
    ++evaluations_;
    if (vflag)
        tallyVirial(vflag);
}

/// The bond is gone from this step on. Its event, count and energy belong to the owner of the lower id.
void FixBondParallel::noteBroken(const BrokenBond& bond)
{
    const std::size_t k = bond.row;
    for (int target : {table_.target1[k], table_.target2[k]})
        if (target < atom->nlocal)
            array_atom[target][0] -= 1;
    if (table_.target1[k] >= atom->nlocal)
        return;

    const bool shear = bond.use.shear > bond.use.tension;
    (shear ? brokenShear_ : brokenTension_) += 1;
    released_ += elasticEnergyOf(table_, k, options_.material);
    if (!options_.eventsFile.empty())
        events_.push_back(
            eventOf(table_, k, options_.material, shear, clock_.now(*update), vec(atom->x[table_.target1[k]])));
}

/// A line on the screen and in the log.
void FixBondParallel::say(const std::string& what) const
{
    frazil::say(*lmp, "Fix bond/parallel (id " + std::string(id) + "): " + what + "\n");
}
