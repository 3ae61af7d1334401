#include "fix_bond_parallel.h"

#include "atom.h"
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
                             "friction_angle, damping, create_gap, weibull, events";
constexpr int blockSize = 64;

/// What one block of bonds reads and writes, contiguous so that the law's loop can be vectorised.
struct Block {
    Vec3 separation[blockSize], turn1[blockSize], turn2[blockSize];
    Vec3 force[blockSize], torque1[blockSize], torque2[blockSize];
    double power[blockSize];
    BondUse use[blockSize];
};

inline Vec3 vectorAt(const std::array<std::vector<double>, BondTable::stateColumns>& state, int column, std::size_t k)
{
    return {state[column][k], state[column + 1][k], state[column + 2][k]};
}

inline void setVector(std::array<std::vector<double>, BondTable::stateColumns>& state, int column, std::size_t k,
                      const Vec3& v)
{
    state[column][k] = v.x;
    state[column + 1][k] = v.y;
    state[column + 2][k] = v.z;
}

inline void addTo(double* sum, const Vec3& v)
{
    sum[0] += v.x;
    sum[1] += v.y;
    sum[2] += v.z;
}

inline Vec3 vec(const double* v) { return {v[0], v[1], v[2]}; }

} // namespace

/* ---------------------------------------------------------------------- */

FixBondParallel::FixBondParallel(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg), radiusFactor_(1), createGap_(0.01), weibullModulus_(0), weibullSeed_(0), tableNewer_(false),
      owned_(0), created_(false), restarted_(false), list_(NULL), eventsOpened_(false), initialBonds_(0), lostBonds_(0), initialVolume_(0),
      brokenTension_(0), brokenShear_(0), damped_(0), released_(0), evaluations_(0), totalsAt_(-1), nextStress_(-1), timeBefore_(0), restartTime_(-1), frequency_(0),
      stressId_(NULL)
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
    size_vector = 8;
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
    for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
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
    if (fine) return;
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
                        {"damping", &material_.damping, NOT_NEGATIVE, false, false},
                        {"create_gap", &createGap_, NOT_NEGATIVE, false, false}};

    for (int iarg = 3; iarg < narg;) {
        const std::string keyword = arg[iarg];
        const int values = keyword == "weibull" ? 2 : 1;
        if (iarg + values >= narg)
            require(false, keyword, "nothing", "lacks its value", "see doc/fix_bond_parallel.md; keywords: " +
                    std::string(keywords));
        Option* option = std::find_if(std::begin(options), std::end(options),
                                      [&](const Option& o) { return keyword == o.keyword; });
        if (option != std::end(options)) {
            *option->value = number(arg[iarg], arg[iarg + 1]);
            option->given = true;
            const double v = *option->value;
            if (option->range == POSITIVE) require(v > 0, keyword, arg[iarg + 1], "is not positive", "give a value > 0");
            if (option->range == NOT_NEGATIVE) require(v >= 0, keyword, arg[iarg + 1], "is negative", "give a value >= 0");
            if (option->range == ANGLE)
                require(v >= 0 && v < 90, keyword, arg[iarg + 1], "is no friction angle", "give degrees, 0 <= angle < 90");
        } else if (keyword == "weibull") {
            weibullModulus_ = number("weibull", arg[iarg + 1]);
            const double seed = number("weibull", arg[iarg + 2]);
            weibullSeed_ = static_cast<int>(seed);
            require(weibullModulus_ > 0, keyword, arg[iarg + 1], "is no Weibull modulus", "give m > 0, then the seed");
            require(seed == weibullSeed_ && seed > 0, keyword, arg[iarg + 2], "is no seed", "give a whole number > 0");
        } else if (keyword == "events") {
            eventsFile_ = arg[iarg + 1];
        } else {
            error->fix_error(FLERR, this, ("unknown keyword '" + keyword + "'; known are: " + keywords).c_str());
        }
        iarg += 1 + values;
    }
    for (const Option& option : options)
        if (option.needed && !option.given)
            require(false, option.keyword, "nothing", "is needed", "add '" + std::string(option.keyword) + " <value>'");
    material_.frictionTan = std::tan(frictionDegrees * M_PI / 180);
}

/* ----------------------------------------------------------------------
   hooks
------------------------------------------------------------------------- */

void FixBondParallel::init()
{
    if (!comm->ghost_velocity)
        error->fix_error(FLERR, this, "bonds need the velocity and spin of ghosts; cure: communicate single vel yes");
    if (domain->triclinic) error->fix_error(FLERR, this, "a triclinic box is not supported; cure: an orthogonal box");
    if (restartTime_ >= 0) timeBefore_ = restartTime_ - (time() - timeBefore_); // only now is the time step known
    restartTime_ = -1;
    if (created_) return;
    const int request = neighbor->request(this);
    neighbor->requests[request]->pair = 0;
    neighbor->requests[request]->fix = 1;
    neighbor->requests[request]->half = 0;
    neighbor->requests[request]->full = 1;
    neighbor->requests[request]->occasional = 1;
}

void FixBondParallel::init_list(int, NeighList* list) { list_ = list; }

void FixBondParallel::setup_pre_exchange()
{
    store();
    scheduleStress(update->ntimestep - 1);
}

void FixBondParallel::pre_exchange() { store(); }

void FixBondParallel::setup_pre_neighbor() { load(); }

void FixBondParallel::pre_neighbor() { load(); }

void FixBondParallel::setup(int vflag)
{
    if (!created_) create();
    flushEvents(); // makes sure now that the file can be written
    checkTimeStep();
    evaluate(vflag);
    end_of_step();
}

void FixBondParallel::post_force(int vflag) { evaluate(vflag); }

void FixBondParallel::end_of_step()
{
    if (update->vflag_atom == update->ntimestep) stressArray();
    scheduleStress(update->ntimestep);
}

void FixBondParallel::post_run() { flushEvents(); }

/* ----------------------------------------------------------------------
   the step
------------------------------------------------------------------------- */

void FixBondParallel::evaluate(int vflag)
{
    // In setup nothing has moved: the loads follow from the state as it is.
    const double dt = update->setupflag ? 0 : update->dt;
    const int all = atom->nlocal + atom->nghost;
    turns_.resize(all);
    for (int i = 0; i < all; ++i) turns_[i] = cayleyVector(vec(atom->omega[i]), dt);

    if (material_.damping > 0) evaluateAll<true>(dt);
    else evaluateAll<false>(dt);

    std::sort(broken_.begin(), broken_.end());
    for (; !broken_.empty(); broken_.pop_back()) table_.remove(broken_.back());
    ++evaluations_;
    if (vflag) tallyVirial(vflag);
}

template <bool Damped> void FixBondParallel::evaluateAll(double dt)
{
    for (std::size_t begin = 0; begin < table_.size(); begin += blockSize)
        evaluateBlock<Damped>(begin, static_cast<int>(std::min<std::size_t>(blockSize, table_.size() - begin)), dt);
}

template <bool Damped> void FixBondParallel::evaluateBlock(std::size_t begin, int count, double dt)
{
    Block block;
    double** x = atom->x;
    for (int b = 0; b < count; ++b) {
        const int i = table_.at1[begin + b], j = table_.at2[begin + b];
        block.separation[b] = vec(x[j]) - vec(x[i]);
        block.turn1[b] = turns_[i];
        block.turn2[b] = turns_[j];
    }

    for (int b = 0; b < count; ++b) {
        const std::size_t k = begin + b;
        BondState state{vectorAt(table_.state, BondTable::separation, k), vectorAt(table_.state, BondTable::shear, k),
                        vectorAt(table_.state, BondTable::bending, k), table_.state[BondTable::torsion][k]};
        const BondShape shape = table_.shapeOf(k);
        const BondStiffness stiffness = stiffnessOf(material_, shape.restLength, shape.radius);
        const BondState before = state;
        BondIncrement motion =
            advance(state, stiffness, shape.share, block.separation[b], block.turn1[b], block.turn2[b]);
        BondLoad load = elasticLoad(state, stiffness, shape.restLength);
        if (Damped) {
            double rate = 1 / dt;
            if (dt == 0) { // setup: the rates come from the velocities, as over a step that ends here
                const int i = table_.at1[k], j = table_.at2[k];
                BondState copy = before;
                copy.separation = block.separation[b] - update->dt * (vec(atom->v[j]) - vec(atom->v[i]));
                motion = advance(copy, stiffness, shape.share, block.separation[b],
                                 cayleyVector(vec(atom->omega[i]), update->dt),
                                 cayleyVector(vec(atom->omega[j]), update->dt));
                rate = 1 / update->dt;
            }
            const BondDashpots dashpots =
                dashpotsOf(stiffness, material_.damping, table_.reducedMass[k], table_.reducedInertia[k]);
            const Vec3 n = state.separation * (1 / norm(state.separation));
            const BondLoad viscous = viscousLoad(motion, dashpots, n, rate);
            load.force += viscous.force;
            load.moment += viscous.moment;
            block.power[b] = viscousPower(motion, dashpots, rate);
        }
        block.use[b] = useOf(state, stiffness, shape, material_);
        const Vec3 lever = cross(state.separation, load.force);
        block.force[b] = load.force;
        block.torque1[b] = shape.share * lever + load.moment;
        block.torque2[b] = (1 - shape.share) * lever - load.moment;
        setVector(table_.state, BondTable::separation, k, state.separation);
        setVector(table_.state, BondTable::shear, k, state.shear);
        setVector(table_.state, BondTable::bending, k, state.bending);
        table_.state[BondTable::torsion][k] = state.torsion;
    }

    double** f = atom->f;
    double** torque = atom->torque;
    for (int b = 0; b < count; ++b) {
        const std::size_t k = begin + b;
        if (block.use[b].tension > 1 || block.use[b].shear > 1) {
            breakBond(k, block.use[b]);
            continue;
        }
        // What is added to a ghost is never read: its owner has its own copy of the bond.
        const int i = table_.target1[k], j = table_.target2[k];
        addTo(f[i], block.force[b]);
        addTo(f[j], -block.force[b]);
        addTo(torque[i], block.torque1[b]);
        addTo(torque[j], block.torque2[b]);
        if (Damped) damped_ += dt * block.power[b] * 0.5 * ((i < atom->nlocal) + (j < atom->nlocal));
    }
}

/// Simulated time [s], also after a restart.
double FixBondParallel::time() const
{
    return timeBefore_ + update->atime + (update->ntimestep - update->atimestep) * update->dt;
}

/// The bond is gone from this step on. Its events, counts and energy belong to the owner of the lower id.
void FixBondParallel::breakBond(std::size_t k, const BondUse& use)
{
    broken_.push_back(k);
    for (int target : {table_.target1[k], table_.target2[k]})
        if (target < atom->nlocal) array_atom[target][0] -= 1;
    if (table_.target1[k] >= atom->nlocal) return;

    const bool shear = use.shear > use.tension;
    (shear ? brokenShear_ : brokenTension_) += 1;
    const BondState state = table_.stateOf(k);
    const BondShape shape = table_.shapeOf(k);
    const BondStiffness stiffness = stiffnessOf(material_, shape.restLength, shape.radius);
    released_ += elasticEnergy(state, stiffness, shape.restLength);
    if (eventsFile_.empty()) return;
    const BondStress stress = stressOf(state, stiffness, shape, material_.momentFactor);
    const Vec3 centre = vec(atom->x[table_.target1[k]]) + shape.share * state.separation;
    events_.push_back(
        {time(), table_.id1[k], table_.id2[k], shear, centre.x, centre.y, centre.z, stress.sigma, stress.tau});
}
