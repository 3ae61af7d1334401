#include "coupling_history.h"

#include "coupled_body.h"

#include "comm.h"
#include "compute.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "update.h"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

using namespace LAMMPS_NS;

namespace
{

using Moment = HistoryMoment;
using HistoryColumns = frazil::Columns<Moment>;

const char* const format = "{:.10g}";

/// Global vector of the body of this number, or nan.
auto body(std::size_t number, int place)
{
    return [=](const Moment& m) { return number < m.bodies.size() ? m.bodies[number]->compute_vector(place) : NAN; };
}

auto bonds(int place)
{
    return [=](const Moment& m) { return m.bonds ? m.bonds->compute_vector(place) : NAN; };
}

/// Name and place in the global vector of fix body/rigid.
void addBody(HistoryColumns& columns, std::size_t number, const std::string& prefix)
{
    static const struct {
        const char* name;
        int place;
    } list[] = {{"x", 0},         {"y", 1},           {"z", 2},           {"vx", 3},
                {"vy", 4},        {"vz", 5},          {"wx", 6},          {"wy", 7},
                {"wz", 8},        {"contact_fx", 13}, {"contact_fy", 14}, {"contact_fz", 15},
                {"fluid_fx", 19}, {"fluid_fy", 20},   {"fluid_fz", 21},   {"wetted", 25}};
    for (const auto& column : list)
        columns.add(prefix + column.name, format, body(number, column.place));
}

/// The first body has its columns whether or not there is one; further ones follow at the end under their IDs.
HistoryColumns columnsFor(const std::vector<Fix*>& bodies)
{
    HistoryColumns columns;
    columns.add("time", format, [](const Moment& m) { return m.order.time; });
    addBody(columns, 0, "");
    columns.add("bonds_intact", format, bonds(0))
        .add("broken_tension", format, bonds(2))
        .add("broken_shear", format, bonds(3))
        .add("eta", format, &Moment::largestFragment)
        .add("fluid_dt", format, [](const Moment& m) { return m.order.deltaT; })
        .add("substeps", format, [](const Moment& m) { return double(m.order.substeps); })
        .add("wall", format, &Moment::wall)
        .add("dem_waited", format, &Moment::waited)
        .add("foam_waited", format, [](const Moment& m) { return m.order.waited; });
    for (std::size_t b = 1; b < bodies.size(); b++)
        addBody(columns, b, std::string(bodies[b]->id) + "_");
    return columns;
}

/// Header and lines of a history up to a time [s]; the tolerance is for the printed digits.
std::vector<std::string> linesBefore(const std::string& file, double time)
{
    std::vector<std::string> lines;
    std::ifstream in(file.c_str());
    for (std::string line; std::getline(in, line);)
        if (lines.empty() || atof(line.c_str()) < time * (1 - 1e-9))
            lines.push_back(line);
    return lines;
}

} // namespace

CouplingHistory::CouplingHistory(LAMMPS* lmp, const std::string& file, int fragmentEvery, double continuedAt)
    : Pointers(lmp), columns_(columnsFor(bodyFixes())), fragmentEvery_(fragmentEvery), countedAt_(-fragmentEvery),
      largest_(NAN)
{
    if (comm->me == 0)
        open(file, continuedAt);
}

CouplingHistory::~CouplingHistory()
{
    if (out_)
        fclose(out_);
}

void CouplingHistory::open(const std::string& file, double continuedAt)
{
    std::vector<std::string> lines;
    if (continuedAt >= 0)
        lines = linesBefore(file, continuedAt);
    if (lines.empty())
        lines.push_back(columns_.header());
    out_ = fopen(file.c_str(), "w");
    if (!out_) {
        const std::string message = "Fix couple/foam: cannot write history file " + file + ": " + strerror(errno) +
                                    ". Give another name with the keyword history";
        error->one(FLERR, message.c_str());
    }
    for (const std::string& line : lines)
        print(line);
}

void CouplingHistory::print(const std::string& line)
{
    fprintf(out_, "%s\n", line.c_str());
    fflush(out_);
}

std::vector<Fix*> CouplingHistory::bodyFixes() const
{
    std::vector<Fix*> list;
    for (int i = 0; i < modify->nfix; i++)
        if (dynamic_cast<CoupledBody*>(modify->fix[i]))
            list.push_back(modify->fix[i]);
    return list;
}

void CouplingHistory::write(const frazil::StepOrder& order, double wall, double waited)
{
    Fix* bonds = modify->find_fix_style_strict("bond/parallel", 0);
    const std::string line = columns_.line({order, wall, waited, largestFragment(bonds), bodyFixes(), bonds});
    lines_++;
    if (out_)
        print(line);
}

/// η of now, or of the last count.
double CouplingHistory::largestFragment(Fix* bonds)
{
    const double broken = bonds ? bonds->compute_vector(2) + bonds->compute_vector(3) : 0;
    Compute* fragments = modify->find_compute_style_strict("fragment", 0);
    if (!fragments || broken == brokenThen_ || lines_ < countedAt_ + fragmentEvery_)
        return largest_;
    if (fragments->invoked_vector != update->ntimestep)
        fragments->compute_vector();
    largest_ = fragments->vector[1];
    brokenThen_ = broken;
    countedAt_ = lines_;
    return largest_;
}
