/* fix couple/foam: the handshake and the exchange, i.e. what travels between the programs. */

#include "fix_couple_foam.h"

#include "Sphere.h"
#include "host_vector.h"
#include "say.h"

#include <cmath>
#include <stdexcept>

#include "atom.h"
#include "coupled_body.h"
#include "coupling_history.h"
#include "domain.h"
#include "fix_gravity.h"
#include "group.h"
#include "modify.h"
#include "update.h"
#include "write_restart.h"

using namespace LAMMPS_NS;
using frazil::vec;
using frazil::Vec3;

void FixCoupleFoam::startCoupling()
{
    startWall_ = MPI_Wtime();
    dt_ = update->dt;
    const frazil::FoamHello foam = link_->handshake(hello());
    grid_.reset(new frazil::CoarseGrid(foam.coarse, foam.cellSize, int(foam.ranks), foam.gravity));
    if (!historyFile_.empty())
        history_.reset(new CouplingHistory(lmp, historyFile_, fragmentEvery_, restartTime_));
    frazil::say(*lmp, "couple/foam: coupled with frazilFoam on " + std::to_string(foam.ranks) +
                          " rank(s), coarse grid " + std::to_string(grid_->cells()[0]) + " x " +
                          std::to_string(grid_->cells()[1]) + " x " + std::to_string(grid_->cells()[2]) + " cells\n");
}

/// Collective: equal on all ranks.
frazil::DemHello FixCoupleFoam::hello()
{
    frazil::DemHello h;
    h.units = update->unit_style;
    if (Fix* gravity = modify->find_fix_style_strict("gravity", 0))
        static_cast<FixGravity*>(gravity)->get_gravity(&h.gravity.x);
    h.startTime = update->ntimestep * dt_;
    h.endTime = update->endstep * dt_;
    h.deltaT = dt_;
    h.fluidTime = restartTime_;

    measureParticles(h);
    for (const CoupledBody* body : bodies_)
        h.bodies.push_back({body->bodyState().name, body->bodyVolume()});
    return h;
}

/// Number, reach and largest radius of the group's particles. Collective.
void FixCoupleFoam::measureParticles(frazil::DemHello& h)
{
    // lower corner, negated upper corner, negated largest radius
    double low[7] = {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, 0}, lowest[7];
    for (int i = 0; i < atom->nlocal; i++) {
        if (!(atom->mask[i] & groupbit))
            continue;
        for (int d = 0; d < 3; d++) {
            low[d] = std::fmin(low[d], atom->x[i][d]);
            low[3 + d] = std::fmin(low[3 + d], -atom->x[i][d]);
        }
        low[6] = std::fmin(low[6], -atom->radius[i]);
    }
    MPI_Allreduce(low, lowest, 7, MPI_DOUBLE, MPI_MIN, world);
    h.reach = {vec(lowest), -vec(lowest + 3)};
    h.largestRadius = -lowest[6];
    h.particles = std::int64_t(group->count(igroup));
}

/// One exchange, at the end of a DEM step that reaches the fluid's time.
void FixCoupleFoam::exchange()
{
    const double start = MPI_Wtime();
    const frazil::StepOrder order = link_->swap(report());
    checkClock(order);
    if (exchangeStep_ >= 0)
        lastDeltaT_ = order_.deltaT;
    order_ = order;
    exchangeStep_ = update->ntimestep;
    if (order.written && !restartFile_.empty())
        writeRestart(); // before the impulses are handed over: a continued fluid has not seen them either
    if (!order.finish) {
        gatherRecords();
        link_->sendParticles(records_, *grid_);
        link_->sendBodies(statesOf(bodies_));
        takeReplies();
        takeBodyLoads();
    }
    exchangeWall_ += MPI_Wtime() - start;
    if (history_)
        history_->write(order_, MPI_Wtime() - startWall_, link_->waited());
    if (order.finish)
        endRun();
}

void FixCoupleFoam::writeRestart()
{
    std::string file = restartFile_;
    const std::size_t star = file.find('*');
    if (star != std::string::npos)
        file.replace(star, 1, std::to_string(update->ntimestep));
    WriteRestart(lmp).write(&file[0]);
}

frazil::StepReport FixCoupleFoam::report()
{
    double mine[8] = {0, impulse_.x, impulse_.y, impulse_.z, 0, 0, 0, 0}, sum[8];
    for (int i = 0; i < atom->nlocal; i++) {
        if (!(atom->mask[i] & groupbit))
            continue;
        mine[0] += frazil::volumeOf(atom->radius[i]);
        mine[4] += 1;
        for (int d = 0; d < 3; d++)
            mine[5 + d] += atom->rmass[i] * atom->v[i][d];
    }
    MPI_Allreduce(mine, sum, 8, MPI_DOUBLE, MPI_SUM, world);
    frazil::StepReport r;
    r.time = update->ntimestep * dt_;
    r.solidVolume = sum[0];
    r.impulse = vec(sum + 1);
    r.particles = std::int64_t(sum[4]);
    r.momentum = vec(sum + 5);
    return r;
}

/// Both count the same steps; a drift would be a fault of one of the programs.
void FixCoupleFoam::checkClock(const frazil::StepOrder& order)
{
    const double expected = exchangeStep_ < 0 ? order.time : order_.time + order_.substeps * dt_;
    if (std::fabs(order.time - expected) > 0.5 * dt_)
        throw std::runtime_error("frazilFoam stands at " + std::to_string(order.time) + " s, frazilDem at " +
                                 std::to_string(expected) +
                                 " s of fluid time. The fluid's step must be a whole number of " + "DEM steps");
    if (!order.finish && order.substeps < 1)
        throw std::runtime_error("frazilFoam ordered a step of " + std::to_string(order.substeps) + " DEM steps");
}

/// Beyond a fixed boundary: LIGGGHTS deletes the particle at its next neighbour list.
bool FixCoupleFoam::leftBox(const double* x) const
{
    for (int d = 0; d < 3; d++) {
        if (domain->boundary[d][0] == 1 && x[d] < domain->boxlo[d])
            return true;
        if (domain->boundary[d][1] == 1 && x[d] > domain->boxhi[d])
            return true;
    }
    return false;
}

void FixCoupleFoam::gatherRecords()
{
    records_.clear();
    recordOf_.clear();
    for (int i = 0; i < atom->nlocal; i++) {
        if (!(atom->mask[i] & groupbit))
            continue;
        if (leftBox(atom->x[i])) {
            carried_[i] = frazil::CarriedParticle();
            continue;
        }
        records_.push_back(recordFrom(i));
        recordOf_.push_back(i);
        carried_[i].clearSums();
    }
    impulse_ = Vec3();
    first_ = false;
}

frazil::ParticleRecord FixCoupleFoam::recordFrom(int i)
{
    // between two neighbour lists a particle may stick out of a periodic box
    double x[3] = {atom->x[i][0], atom->x[i][1], atom->x[i][2]};
    domain->remap(x);
    frazil::ParticleRecord r;
    r.id = atom->tag[i];
    r.position = vec(x);
    r.velocity = vec(atom->v[i]);
    r.angularVelocity = vec(atom->omega[i]);
    r.impulse = carried_[i].impulse;
    r.radius = atom->radius[i];
    if (shielding_) {
        const double* bonds = shielding_->array_atom[i]; // intact, initial
        r.exposure = bonds[1] > 0 ? 1 - bonds[0] / bonds[1] : 1;
    }
    r.motion = motionOf(i);
    return r;
}

/// Never bonded: bonds answer to a force as springs do, so that the forces of the last step say nothing of those of the
/// next; nor do those on a sphere that has broken loose and is pushed among bonded ones.
bool FixCoupleFoam::isLoose(int i) const
{
    for (const Fix* bonds : bonds_)
        if (bonds->array_atom[i][1] > 0) // initial bonds
            return false;
    return true;
}

/// How the particle moved over the fluid step that ends, for the prediction of its answer to the pressure.
frazil::ParticleMotion FixCoupleFoam::motionOf(int i)
{
    frazil::CarriedParticle& p = carried_[i];
    frazil::ParticleMotion motion;
    motion.mass = drive_.free(atom->mask[i]) && isLoose(i) ? atom->rmass[i] : 0;
    motion.displacing = p.displacing(ramp_);
    if (first_ || p.age == 0) {
        p.speed[0] = p.speed[1] = vec(atom->v[i]);
        if (first_)
            motion.otherForce = vec(atom->f[i]); // a set-up has just summed them
    } else {
        p.endStep(lastDeltaT_, motion);
    }
    p.age += order_.deltaT;
    return motion;
}

void FixCoupleFoam::takeReplies()
{
    link_->receiveReplies(replies_);
    for (std::size_t k = 0; k < replies_.size(); k++)
        carried_[recordOf_[k]].fluid = replies_[k];
}

/// None yet: bodies keep the load of their restart file, or start without one.
void FixCoupleFoam::takeBodyLoads()
{
    const std::vector<frazil::BodyLoad> loads = link_->receiveBodyLoads();
    if (!loads.empty())
        setLoads(bodies_, loads);
}
