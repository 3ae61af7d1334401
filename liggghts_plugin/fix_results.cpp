#include "fix_results.h"

#include "DidYouMean.h"
#include "InputError.h"
#include "SnapshotFile.h"
#include "World.h"
#include "compute_fragment.h"
#include "fix_bond_parallel.h"
#include "fix_ids.h"
#include "host_vector.h"
#include "script_words.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "update.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

using namespace LAMMPS_NS;
using frazil::InputError;
using frazil::SnapshotArray;
using frazil::SnapshotFile;

FixResults::FixResults(LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg)
{
    try {
        readWords(narg, arg);
    } catch (const InputError& wrong) {
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
    nevery = frazil::positiveInt(steps, "N");
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

/* ----------------------------------------------------------------------
   what it writes: other fixes and a compute
------------------------------------------------------------------------- */

void FixResults::init()
{
    fluid_ = findFix("fluid", fluidId_);
    if (fluid_ && strcmp(fluid_->style, "couple/foam") != 0)
        stop("fluid " + fluidId_ + ": is a fix " + fluid_->style + ", must be a fix couple/foam");
    Fix* bonds = findFix("bonds", bondsId_);
    bonds_ = dynamic_cast<FixBondParallel*>(bonds);
    if (bonds && !bonds_)
        stop("bonds " + bondsId_ + ": is a fix " + bonds->style + ", must be a fix bond/parallel");
    findFragments();
}

Fix* FixResults::findFix(const std::string& keyword, const std::string& id)
{
    if (id.empty())
        return nullptr;
    const int index = modify->find_fix(id.c_str());
    if (index >= 0)
        return modify->fix[index];
    const auto known = frazil::fixIds(*modify, [](Fix*) { return true; });
    stop(InputError("", keyword, id, "there is no fix of this ID" + frazil::didYouMean(id, known),
                    "Define it before the run")
             .what());
}

void FixResults::findFragments()
{
    if (fragmentId_.empty())
        return;
    const int index = modify->find_compute(fragmentId_.c_str());
    if (index < 0) {
        std::vector<std::string> known;
        for (int n = 0; n < modify->ncompute; ++n)
            known.push_back(modify->compute[n]->id);
        stop(InputError("", "fragment", fragmentId_,
                        "there is no compute of this ID" + frazil::didYouMean(fragmentId_, known),
                        "Define it before the run")
                 .what());
    }
    fragment_ = dynamic_cast<ComputeFragment*>(modify->compute[index]);
    if (!fragment_)
        stop("fragment " + fragmentId_ + ": is a compute " + modify->compute[index]->style +
             ", must be a compute fragment");
}

/* ----------------------------------------------------------------------
   when it writes
------------------------------------------------------------------------- */

void FixResults::setup(int)
{
    clock_.start(*update);
    if (!snapshots_)
        openFile();
    if (update->ntimestep % nevery == 0)
        write();
    announce(update->ntimestep + nevery - update->ntimestep % nevery);
}

void FixResults::end_of_step()
{
    write();
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

void FixResults::write_restart(FILE* file)
{
    const double now = clock_.now(*update);
    if (comm->me)
        return;
    const int size = sizeof now;
    fwrite(&size, sizeof size, 1, file);
    fwrite(&now, sizeof now, 1, file);
}

void FixResults::restart(char* buffer)
{
    double time;
    memcpy(&time, buffer, sizeof time);
    clock_.restored(time);
}

/* ----------------------------------------------------------------------
   a snapshot
------------------------------------------------------------------------- */

/// The arrays of the particles, in the order of the file.
std::vector<FixResults::Column> FixResults::columns() const
{
    std::vector<Column> list = {{"radius", 1, [this](int i) { return &atom->radius[i]; }},
                                {"velocity", 3, [this](int i) { return atom->v[i]; }},
                                {"angular velocity", 3, [this](int i) { return atom->omega[i]; }}};
    if (fluid_ && fluid_->array_atom)
        list.push_back({"fluid force", 3, [this](int i) { return fluid_->array_atom[i]; }});
    if (bonds_ && bonds_->array_atom) {
        list.push_back({"intact bonds", 1, [this](int i) { return bonds_->array_atom[i]; }});
        list.push_back({"stress", 6, [this](int i) { return bonds_->array_atom[i] + 2; }});
    }
    if (fragment_)
        list.push_back({"fragment", 1, [this](int i) { return &fragment_->vector_atom[i]; }});
    return list;
}

void FixResults::write()
{
    if (update->ntimestep == writtenAt_)
        return;
    writtenAt_ = update->ntimestep;
    if (fragment_ && fragment_->invoked_peratom != update->ntimestep)
        fragment_->compute_peratom();
    try {
        snapshots_->begin(update->ntimestep, clock_.now(*update));
        writeParticles();
        if (bonds_)
            writeBonds();
        snapshots_->end();
    } catch (const std::exception& e) {
        stopAlone(e.what());
    }
    announce(update->ntimestep + nevery);
}

void FixResults::writeParticles()
{
    const std::vector<Column> list = columns();
    std::vector<std::vector<double>> values(list.size());
    std::vector<std::int64_t> ids;
    std::vector<frazil::Vec3> position;
    for (int i = 0; i < atom->nlocal; i++) {
        if (!(atom->mask[i] & groupbit))
            continue;
        ids.push_back(atom->tag[i]);
        position.push_back(frazil::vec(atom->x[i]));
        for (std::size_t c = 0; c < list.size(); c++) {
            const double* row = list[c].of(i);
            values[c].insert(values[c].end(), row, row + list[c].components);
        }
    }
    std::vector<SnapshotArray> arrays;
    for (std::size_t c = 0; c < list.size(); c++)
        arrays.push_back({list[c].name, list[c].components, values[c].data()});
    snapshots_->particles("particles", ids, position.data(), arrays);
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

void FixResults::stop(const std::string& problem)
{
    error->fix_error(FLERR, this, problem.c_str());
    std::abort(); // fix_error does not return, but is not declared so
}

/// Not error->all: it waits for all ranks, and the others may be inside HDF5. Not error->one: its text is often lost on
/// the way through mpirun.
void FixResults::stopAlone(const std::string& problem)
{
    frazil::World::instance().fail("Fix results (id " + std::string(id) + "): " + problem);
}
