#include "fix_bond_parallel.h"

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

const char* const keywords = "young, stiffness_ratio, tensile_strength, shear_strength, radius_factor, moment_factor, "
                             "friction_angle, damping, create_gap, list, weibull, events";
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

/// How many numbers follow, at least one: a word that is none is told when it is read.
int countNumbers(int first, int narg, char** arg)
{
    int count = 0;
    for (char* end = NULL; first + count < narg; ++count) {
        std::strtod(arg[first + count], &end);
        if (end == arg[first + count] || *end)
            break;
    }
    return std::max(count, 1);
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
    parse(narg, arg);

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

void FixBondParallel::require(bool fine, const std::string& keyword, const std::string& value,
                              const std::string& problem, const std::string& cure)
{
    if (fine)
        return;
    const std::string text = "keyword '" + keyword + "' has '" + value + "', which " + problem + "; cure: " + cure;
    error->fix_error(FLERR, this, text.c_str());
}

double FixBondParallel::number(const char* keyword, const char* text)
{
    char* end = NULL;
    const double value = std::strtod(text, &end);
    require(end != text && *end == '\0', keyword, text, "is not a number", "give a number in SI units");
    return value;
}

void FixBondParallel::parse(int narg, char** arg)
{
    enum Range { POSITIVE, NOT_NEGATIVE, ANGLE };
    struct Option {
        const char* keyword;
        double* value;
        Range range;
        bool needed, given;
    };
    double frictionDegrees = 0;
    Option options[] = {{"young", &material_.young, POSITIVE, true, false},
                        {"stiffness_ratio", &material_.stiffnessRatio, POSITIVE, true, false},
                        {"tensile_strength", &material_.tensileStrength, POSITIVE, true, false},
                        {"shear_strength", &material_.shearStrength, POSITIVE, true, false},
                        {"radius_factor", &radiusFactor_, POSITIVE, false, false},
                        {"moment_factor", &material_.momentFactor, NOT_NEGATIVE, false, false},
                        {"friction_angle", &frictionDegrees, ANGLE, false, false},
                        {"create_gap", &createGap_, NOT_NEGATIVE, false, false}}; // the last

    for (int iarg = 3; iarg < narg;) {
        const std::string keyword = arg[iarg];
        const int values = keyword == "weibull" ? 2 : keyword == "damping" ? countNumbers(iarg + 1, narg, arg) : 1;
        if (iarg + values >= narg)
            require(false, keyword, "nothing", "lacks its value",
                    "see doc/fix_bond_parallel.md; keywords: " + std::string(keywords));
        Option* option =
            std::find_if(std::begin(options), std::end(options), [&](const Option& o) { return keyword == o.keyword; });
        if (option != std::end(options)) {
            *option->value = number(arg[iarg], arg[iarg + 1]);
            option->given = true;
            const double v = *option->value;
            if (option->range == POSITIVE)
                require(v > 0, keyword, arg[iarg + 1], "is not positive", "give a value > 0");
            if (option->range == NOT_NEGATIVE)
                require(v >= 0, keyword, arg[iarg + 1], "is negative", "give a value >= 0");
            if (option->range == ANGLE)
                require(v >= 0 && v < 90, keyword, arg[iarg + 1], "is no friction angle",
                        "give degrees, 0 <= angle < 90");
        } else if (keyword == "weibull") {
            parseWeibull(arg + iarg + 1);
        } else if (keyword == "damping") {
            parseDamping(values, arg + iarg + 1);
        } else if (keyword == "events") {
            eventsFile_ = arg[iarg + 1];
        } else if (keyword == "list") {
            listFile_ = arg[iarg + 1];
        } else {
            error->fix_error(FLERR, this, ("unknown keyword '" + keyword + "'; known are: " + keywords).c_str());
        }
        iarg += 1 + values;
    }
    for (const Option& option : options)
        if (option.needed && !option.given)
            require(false, option.keyword, "nothing", "is needed", "add '" + std::string(option.keyword) + " <value>'");
    const bool gapGiven = std::end(options)[-1].given;
    require(listFile_.empty() || !gapGiven, "list", listFile_, "stands beside create_gap", "give one of the two");
    material_.frictionTan = std::tan(frictionDegrees * M_PI / 180);
}

void FixBondParallel::parseWeibull(char** arg)
{
    weibullModulus_ = number("weibull", arg[0]);
    const double seed = number("weibull", arg[1]);
    weibullSeed_ = static_cast<int>(seed);
    require(weibullModulus_ > 0, "weibull", arg[0], "is no Weibull modulus", "give m > 0, then the seed");
    require(seed == weibullSeed_ && seed > 0, "weibull", arg[1], "is no seed", "give a whole number > 0");
}

/// One fraction for all modes, or one for each.
void FixBondParallel::parseDamping(int count, char** arg)
{
    std::string given = arg[0];
    for (int n = 1; n < count; ++n)
        given += std::string(" ") + arg[n];
    require(count == 1 || count == 4, "damping", given, "is neither one number nor four",
            "give one fraction for all modes, or those of normal, shear, torsion and bending");
    double fractions[4];
    for (int n = 0; n < 4; ++n) {
        fractions[n] = number("damping", arg[count == 4 ? n : 0]);
        require(fractions[n] >= 0, "damping", given, "is negative", "give values >= 0");
    }
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
