#include "fix_bond_parallel.h"

#include "InputError.h"
#include "script_words.h"

#include "atom.h"
#include "bond_kernel.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "memory.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace frazil;

namespace
{

const std::vector<Keyword> keywords = {
    {"young"},        {"stiffness_ratio"}, {"tensile_strength"}, {"shear_strength"}, {"radius_factor"}, {"moment_factor"},
    {"friction_angle"}, {"damping", 1, 4},   {"create_gap"},       {"list"},           {"weibull", 2, 2}, {"events"}};

inline Vec3 vec(const double* v)
{
    return {v[0], v[1], v[2]};
}

/// Does any bond of the block exceed its strength?
bool breaks(const BondBlock& block)
{
    int count = 0;
    for (int b = 0; b < block.count; ++b)
        count += (block.useTension[b] > 1) | (block.useShear[b] > 1);
    return count > 0;
}

} // namespace

/* ---------------------------------------------------------------------- */

FixBondParallel::FixBondParallel(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg), radiusFactor_(1), createGap_(0.01), weibullModulus_(0), weibullSeed_(0), tableNewer_(false),
      owned_(0), created_(false), restarted_(false), list_(NULL), eventsOpened_(false), initialBonds_(0), lostBonds_(0),
      initialVolume_(0), brokenTension_(0), brokenShear_(0), damped_(0), released_(0), evaluations_(0), countsAt_(-1),
      totalsAt_(-1), nextStress_(-1), timeBefore_(0), restartTime_(-1), frequency_(0), dashpotTime_(0), stressId_(NULL)
{
    if (!atom->sphere_flag || !atom->omega_flag || !atom->torque_flag)
        error->fix_error(FLERR, this, "bonds need spheres with spin and torque; cure: atom_style granular");
    try {
        parse(scriptWords(narg - 3, arg + 3, keywords));
    } catch (const InputError& wrong) {
        error->fix_error(FLERR, this, wrong.what());
    }

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
    delete[] stressId_;
}

int FixBondParallel::setmask()
{
    return PRE_EXCHANGE | PRE_NEIGHBOR | POST_FORCE | END_OF_STEP | POST_RUN;
}

/* ----------------------------------------------------------------------
   input
------------------------------------------------------------------------- */

void FixBondParallel::parse(const Settings& words)
{
    material_.young = words.positive("young");
    material_.stiffnessRatio = words.positive("stiffness_ratio");
    material_.tensileStrength = words.positive("tensile_strength");
    material_.shearStrength = words.positive("shear_strength");
    radiusFactor_ = words.positive("radius_factor", radiusFactor_);
    material_.momentFactor = words.notNegative("moment_factor", material_.momentFactor);
    createGap_ = words.notNegative("create_gap", createGap_);
    const double angle = words.notNegative("friction_angle", 0);
    if (angle >= 90)
        words.reject("friction_angle", "is no friction angle", "Give degrees, 0 or more and below 90");
    material_.frictionTan = std::tan(angle * M_PI / 180);
    eventsFile_ = words.text("events", "");
    listFile_ = words.text("list", "");
    if (words.has("list") && words.has("create_gap"))
        words.reject("list", "stands beside create_gap", "Give one of the two");
    if (words.has("weibull"))
        parseWeibull(words);
    if (words.has("damping"))
        parseDamping(words);
}

void FixBondParallel::parseWeibull(const Settings& words)
{
    const std::vector<double> given = words.numbers("weibull");
    weibullModulus_ = given[0];
    weibullSeed_ = static_cast<int>(given[1]);
    if (!(weibullModulus_ > 0))
        words.reject("weibull", "has no Weibull modulus", "Give m > 0, then the seed");
    if (given[1] != weibullSeed_ || given[1] <= 0)
        words.reject("weibull", "has no seed", "Give m, then a whole number > 0");
}

/// One fraction for all modes, or one for each.
void FixBondParallel::parseDamping(const Settings& words)
{
    std::vector<double> fractions = words.numbers("damping");
    if (fractions.size() == 1)
        fractions.resize(4, fractions[0]);
    if (fractions.size() != 4)
        words.reject("damping", "is neither one number nor four",
                     "Give one fraction for all modes, or those of normal, shear, torsion and bending");
    if (*std::min_element(fractions.begin(), fractions.end()) < 0)
        words.reject("damping", "is negative", "Give values of 0 or more");
    material_.damping = {fractions[0], fractions[1], fractions[2], fractions[3]};
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
    if (restartTime_ >= 0)
        timeBefore_ = restartTime_ - (time() - timeBefore_); // only now is the time step known
    restartTime_ = -1;
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
    // In setup nothing has moved: the loads follow from the state as it is.
    const double dt = update->setupflag ? 0 : update->dt;
    const int all = atom->nlocal + atom->nghost;
    turns_.resize(all);
    for (int i = 0; i < all; ++i)
        turns_[i] = cayleyVector(vec(atom->omega[i]), dt);

    for (std::size_t begin = 0; begin < table_.size(); begin += BondBlock::capacity)
        evaluateBlock(begin, dt);
    tableNewer_ = true; // a restart file may have been written since the last reneighbouring

    std::sort(broken_.begin(), broken_.end());
    for (; !broken_.empty(); broken_.pop_back())
        table_.remove(broken_.back());
    ++evaluations_;
    if (vflag)
        tallyVirial(vflag);
}

void FixBondParallel::evaluateBlock(std::size_t begin, double dt)
{
    BondBlock block(table_, begin, static_cast<int>(std::min<std::size_t>(BondBlock::capacity, table_.size() - begin)));
    gather(block, begin);
    advanceBlock(block, material_, dt > 0 ? 1 / dt : 0);
    if (dt == 0 && material_.damping.any())
        dampAtRest(block, begin);
    scatter(block, begin, dt);
}

void FixBondParallel::gather(BondBlock& block, std::size_t begin)
{
    const double* x = atom->x[0]; // the host's rows lie one behind the other
    const int *at1 = &table_.at1[begin], *at2 = &table_.at2[begin];
    for (int b = 0; b < block.count; ++b) {
        const double *x1 = x + 3 * at1[b], *x2 = x + 3 * at2[b];
        const Vec3 &turn1 = turns_[at1[b]], &turn2 = turns_[at2[b]];
        for (int axis = 0; axis < 3; ++axis) {
            block.separation[axis][b] = x2[axis] - x1[axis];
            block.turn1[axis][b] = turn1[axis];
            block.turn2[axis][b] = turn2[axis];
        }
    }
}

/// In setup there is no step behind the dashpots: their rates come from the velocities, as over a step that ends here.
void FixBondParallel::dampAtRest(BondBlock& block, std::size_t begin)
{
    const double dt = update->dt;
    for (int b = 0; b < block.count; ++b) {
        const std::size_t k = begin + b;
        const int i = table_.at1[k], j = table_.at2[k];
        const BondShape shape = table_.shapeOf(k);
        const BondStiffness stiffness = stiffnessOf(material_, shape.restLength, shape.radius);
        BondState before = table_.stateOf(k);
        const Vec3 d = before.separation;
        before.separation -= dt * (vec(atom->v[j]) - vec(atom->v[i]));
        const BondIncrement motion = advance(before, stiffness, shape.share, d, cayleyVector(vec(atom->omega[i]), dt),
                                             cayleyVector(vec(atom->omega[j]), dt));
        const BondLoad load = viscousLoad(
            motion, dashpotsOf(stiffness, material_.damping, table_.reducedMass[k], table_.reducedInertia[k]),
            d / norm(d), 1 / dt);
        const Vec3 lever = cross(d, load.force);
        for (int axis = 0; axis < 3; ++axis) {
            block.force[axis][b] += load.force[axis];
            block.torque1[axis][b] += shape.share * lever[axis] + load.moment[axis];
            block.torque2[axis][b] += (1 - shape.share) * lever[axis] - load.moment[axis];
        }
    }
}

void FixBondParallel::scatter(BondBlock& block, std::size_t begin, double dt)
{
    if (breaks(block))
        breakBonds(block, begin);
    double *f = atom->f[0], *torque = atom->torque[0];
    const int *target1 = &table_.target1[begin], *target2 = &table_.target2[begin];
    for (int b = 0; b < block.count; ++b) {
        // What is added to a ghost is never read: its owner has its own copy of the bond.
        const int i = 3 * target1[b], j = 3 * target2[b];
        for (int axis = 0; axis < 3; ++axis) {
            f[i + axis] += block.force[axis][b];
            f[j + axis] -= block.force[axis][b];
            torque[i + axis] += block.torque1[axis][b];
            torque[j + axis] += block.torque2[axis][b];
        }
    }
    if (!material_.damping.any())
        return;
    for (int b = 0; b < block.count; ++b)
        damped_ += dt * block.power[b] * 0.5 * ((target1[b] < atom->nlocal) + (target2[b] < atom->nlocal));
}

/// A line on the screen and in the log.
void FixBondParallel::say(const std::string& what) const
{
    if (comm->me)
        return;
    const std::string line = "Fix bond/parallel (id " + std::string(id) + "): " + what + "\n";
    if (screen)
        fputs(line.c_str(), screen);
    if (logfile)
        fputs(line.c_str(), logfile);
}

/// Simulated time [s], also after a restart.
double FixBondParallel::time() const
{
    return timeBefore_ + update->atime + (update->ntimestep - update->atimestep) * update->dt;
}

/// Breaks what exceeds its strength; it gives no load any more.
void FixBondParallel::breakBonds(BondBlock& block, std::size_t begin)
{
    for (int b = 0; b < block.count; ++b) {
        if (!(block.useTension[b] > 1 || block.useShear[b] > 1))
            continue;
        breakBond(begin + b, {block.useTension[b], block.useShear[b]});
        for (int axis = 0; axis < 3; ++axis)
            block.force[axis][b] = block.torque1[axis][b] = block.torque2[axis][b] = 0;
        block.power[b] = 0;
    }
}

/// The bond is gone from this step on. Its events, counts and energy belong to the owner of the lower id.
void FixBondParallel::breakBond(std::size_t k, const BondUse& use)
{
    broken_.push_back(k);
    for (int target : {table_.target1[k], table_.target2[k]})
        if (target < atom->nlocal)
            array_atom[target][0] -= 1;
    if (table_.target1[k] >= atom->nlocal)
        return;

    const bool shear = use.shear > use.tension;
    (shear ? brokenShear_ : brokenTension_) += 1;
    const BondState state = table_.stateOf(k);
    const BondShape shape = table_.shapeOf(k);
    const BondStiffness stiffness = stiffnessOf(material_, shape.restLength, shape.radius);
    released_ += elasticEnergy(state, stiffness, shape.restLength);
    if (eventsFile_.empty())
        return;
    const BondStress stress = stressOf(state, stiffness, shape, material_.momentFactor);
    const Vec3 centre = vec(atom->x[table_.target1[k]]) + shape.share * state.separation;
    events_.push_back(
        {time(), table_.id1[k], table_.id2[k], shear, centre.x, centre.y, centre.z, stress.sigma, stress.tau});
}
