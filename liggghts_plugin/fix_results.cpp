#include "fix_results.h"

#include "compute_fragment.h"
#include "fix_bond_parallel.h"

#include "InputError.h"
#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "script_words.h"
#include "update.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "SnapshotFile.h"
#include "World.h"

using namespace LAMMPS_NS;
using frazil::SnapshotArray;
using frazil::SnapshotFile;

/* ---------------------------------------------------------------------- */

FixResults::FixResults(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg), file_("particles.h5"), bonds_(NULL), fluid_(NULL), fragment_(NULL), writtenAt_(-1),
      timeBefore_(0), restartTime_(-1)
{
    try {
        readWords(narg, arg);
    } catch (const frazil::InputError& wrong) {
        stop(wrong.what());
    }
    restart_global = 1;
}

FixResults::~FixResults() {}

void FixResults::readWords(int narg, char** arg)
{
    frazil::Settings steps("", "", frazil::Settings::Form::script);
    if (narg > 3)
        steps.set("N", arg[3]);
    nevery = int(steps.integer("N"));
    if (nevery <= 0)
        steps.reject("N", "must be above zero", "Give the number of DEM steps between snapshots");
    const frazil::Settings words =
        frazil::scriptWords(narg - 4, arg + 4, {{"file"}, {"bonds"}, {"fluid"}, {"fragment"}});
    file_ = words.text("file", file_);
    bondsId_ = words.text("bonds", "");
    fluidId_ = words.text("fluid", "");
    fragmentId_ = words.text("fragment", "");
}

int FixResults::setmask()
{
    return FixConst::END_OF_STEP;
}

Fix* FixResults::findFix(const std::string& keyword, const std::string& id)
{
    if (id.empty())
        return NULL;
    const int index = modify->find_fix(id.c_str());
    if (index < 0)
        stop(keyword + " " + id + ": there is no fix of this ID; define it before the run");
    return modify->fix[index];
}

void FixResults::init()
{
    fluid_ = findFix("fluid", fluidId_);
    if (fluid_ && strcmp(fluid_->style, "couple/foam") != 0)
        stop("fluid " + fluidId_ + ": is a fix " + fluid_->style + ", must be a fix couple/foam");
    Fix* bonds = findFix("bonds", bondsId_);
    bonds_ = dynamic_cast<FixBondParallel*>(bonds);
    if (bonds && !bonds_)
        stop("bonds " + bondsId_ + ": is a fix " + bonds->style + ", must be a fix bond/parallel");

    if (fragmentId_.empty())
        return;
    const int index = modify->find_compute(fragmentId_.c_str());
    if (index < 0)
        stop("fragment " + fragmentId_ + ": there is no compute of this ID; define it before the run");
    fragment_ = dynamic_cast<ComputeFragment*>(modify->compute[index]);
    if (!fragment_)
        stop("fragment " + fragmentId_ + ": is a compute " + modify->compute[index]->style +
             ", must be a compute fragment");
}

void FixResults::setup(int)
{
    if (restartTime_ >= 0)
        timeBefore_ = restartTime_ - (time() - timeBefore_); // only now is the time step known
    restartTime_ = -1;
    if (!snapshots_)
        openFile();
    if (update->ntimestep % nevery == 0)
        write();
    announce(update->ntimestep + nevery - update->ntimestep % nevery);
}

void FixResults::openFile()
{
    // a continued run goes on in its file
    const SnapshotFile::Mode mode = update->ntimestep > 0 ? SnapshotFile::Mode::append : SnapshotFile::Mode::create;
    try {
        snapshots_.reset(new SnapshotFile(file_, world, mode));
    } catch (const std::exception& e) {
        stopAlone(e.what());
    }
}

/// Next snapshot: the bond fix computes its stress only on steps for which the contacts' virial was asked for.
void FixResults::announce(bigint step)
{
    if (fragment_)
        fragment_->addstep(step);
    const int virial = bonds_ ? modify->find_compute((bondsId_ + "_contact_virial").c_str()) : -1;
    if (virial >= 0)
        modify->compute[virial]->addstep(step);
}

void FixResults::end_of_step()
{
    write();
}

/* ---------------------------------------------------------------------- */

double FixResults::time() const
{
    return timeBefore_ + update->atime + (update->ntimestep - update->atimestep) * update->dt;
}

/// The host's clock starts anew at a restart, at zero.
void FixResults::write_restart(FILE* file)
{
    const double now = time();
    if (comm->me)
        return;
    const int size = sizeof now;
    fwrite(&size, sizeof size, 1, file);
    fwrite(&now, sizeof now, 1, file);
}

void FixResults::restart(char* buffer)
{
    memcpy(&restartTime_, buffer, sizeof restartTime_);
}

void FixResults::write()
{
    if (update->ntimestep == writtenAt_)
        return;
    writtenAt_ = update->ntimestep;

    gatherParticles();
    std::vector<std::int64_t> ids;
    std::vector<frazil::Vec3> position;
    for (int i : members_) {
        ids.push_back(atom->tag[i]);
        position.push_back({atom->x[i][0], atom->x[i][1], atom->x[i][2]});
    }
    std::vector<SnapshotArray> arrays;
    for (const Column& c : columns_)
        arrays.push_back({c.name, c.components, c.values.data()});

    try {
        snapshots_->begin(update->ntimestep, time());
        snapshots_->particles("particles", ids, position.data(), arrays);
        if (bonds_)
            writeBonds();
        snapshots_->end();
    } catch (const std::exception& e) {
        stopAlone(e.what());
    }
    announce(update->ntimestep + nevery);
}

void FixResults::gatherParticles()
{
    members_.clear();
    for (int i = 0; i < atom->nlocal; i++)
        if (atom->mask[i] & groupbit)
            members_.push_back(i);

    columns_.clear();
    addScalars("radius", atom->radius);
    addVectors("velocity", atom->v, 0);
    addVectors("angular velocity", atom->omega, 0);
    addFluid();
    addBonds();
    addFragments();
}

void FixResults::addVectors(const char* name, double** rows, int from)
{
    columns_.push_back({name, 3, {}});
    std::vector<double>& values = columns_.back().values;
    for (int i : members_)
        values.insert(values.end(), rows[i] + from, rows[i] + from + 3);
}

void FixResults::addScalars(const char* name, const double* values)
{
    columns_.push_back({name, 1, {}});
    for (int i : members_)
        columns_.back().values.push_back(values[i]);
}

void FixResults::addFluid()
{
    if (fluid_ && fluid_->array_atom)
        addVectors("fluid force", fluid_->array_atom, 0);
}

void FixResults::addBonds()
{
    if (!bonds_ || !bonds_->array_atom)
        return;
    Column intact = {"intact bonds", 1, {}}, stress = {"stress", 6, {}};
    for (int i : members_) {
        const double* row = bonds_->array_atom[i];
        intact.values.push_back(row[0]);
        stress.values.insert(stress.values.end(), row + 2, row + 8);
    }
    columns_.push_back(intact);
    columns_.push_back(stress);
}

void FixResults::addFragments()
{
    if (!fragment_)
        return;
    if (fragment_->invoked_peratom != update->ntimestep)
        fragment_->compute_peratom();
    addScalars("fragment", fragment_->vector_atom);
}

void FixResults::writeBonds()
{
    const frazil::BondTable& table = bonds_->bonds();
    std::vector<std::array<std::int64_t, 2>> ends;
    std::vector<double> strength;
    for (std::size_t k = 0; k < table.size(); k++) {
        if (table.target1[k] >= atom->nlocal)
            continue;
        ends.push_back({{table.id1[k], table.id2[k]}});
        strength.push_back(table.strength[k]);
    }
    snapshots_->bonds("bonds", ends, {{"strength", 1, strength.data()}});
}

void FixResults::stop(const std::string& message)
{
    const std::string text = std::string("fix ") + id + " results: " + message;
    error->all(FLERR, text.c_str());
    abort(); // error->all does not return, but is not declared so
}

/// Not error->all: it waits for all ranks, and the others may be inside HDF5.
void FixResults::stopAlone(const std::string& message)
{
    // not error->one: its text is often lost on the way through mpirun
    frazil::World::instance().fail(std::string("fix ") + id + " results: " + message);
}
