#include "coupling_history.h"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "comm.h"
#include "compute.h"
#include "coupled_body.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace
{

// places in the global vector of a body fix: centre, velocity, spin, contact force, fluid force, wetted fraction
const int bodyColumns[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 13, 14, 15, 19, 20, 21, 25};
const char* const bodyNames[] = {"x",        "y",        "z",        "vx",         "vy",         "vz",
                                 "wx",       "wy",       "wz",       "contact_fx", "contact_fy", "contact_fz",
                                 "fluid_fx", "fluid_fy", "fluid_fz", "wetted"};

// header and lines of a history up to a time [s]; the tolerance is for the printed digits
std::vector<std::string> linesBefore(const std::string& file, double time)
{
    std::vector<std::string> lines;
    std::ifstream in(file.c_str());
    for (std::string line; std::getline(in, line);)
        if (lines.empty() || atof(line.c_str()) < time * (1 - 1e-9))
            lines.push_back(line);
    return lines;
}

// places in the global vector of fix bond/parallel: intact, broken in tension, broken in shear
const int bondColumns[] = {0, 2, 3};

} // namespace

CouplingHistory::CouplingHistory(LAMMPS* lmp, const std::string& file, int fragmentEvery, double continuedAt)
    : Pointers(lmp), out_(NULL), fragmentEvery_(fragmentEvery), lines_(0), countedAt_(-fragmentEvery), brokenThen_(-1),
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
    const std::vector<std::string> before =
        continuedAt < 0 ? std::vector<std::string>() : linesBefore(file, continuedAt);
    out_ = fopen(file.c_str(), "w");
    if (!out_) {
        const std::string message = "Fix couple/foam: cannot write history file " + file + ": " + strerror(errno) +
                                    ". Give another name with the keyword history";
        error->one(FLERR, message.c_str());
    }
    if (before.empty())
        writeHeader();
    for (const std::string& line : before)
        fprintf(out_, "%s\n", line.c_str());
    fflush(out_);
}

void CouplingHistory::writeHeader()
{
    const size_t bodies = bodyFixes().size();
    fprintf(out_, "time");
    for (const char* name : bodyNames)
        fprintf(out_, ",%s", name);
    fprintf(out_, ",bonds_intact,broken_tension,broken_shear,eta,fluid_dt,substeps,wall,dem_waited,foam_waited");
    for (size_t b = 1; b < bodies; b++)
        for (const char* name : bodyNames)
            fprintf(out_, ",%s_%s", bodyFixes()[b]->id, name);
    fprintf(out_, "\n");
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
    const std::vector<Fix*> bodies = bodyFixes();
    std::vector<double> row(1, order.time);
    for (int c : bodyColumns)
        row.push_back(bodies.empty() ? NAN : bodies[0]->compute_vector(c));

    Fix* bonds = modify->find_fix_style_strict("bond/parallel", 0);
    for (int c : bondColumns)
        row.push_back(bonds ? bonds->compute_vector(c) : NAN);
    countFragments(bonds ? row[row.size() - 2] + row[row.size() - 1] : 0);
    row.push_back(largest_);

    row.push_back(order.deltaT);
    row.push_back(double(order.substeps));
    row.push_back(wall);
    row.push_back(waited);
    row.push_back(order.waited);
    for (size_t b = 1; b < bodies.size(); b++)
        for (int c : bodyColumns)
            row.push_back(bodies[b]->compute_vector(c));
    lines_++;

    if (!out_)
        return;
    for (size_t i = 0; i < row.size(); i++)
        fprintf(out_, i ? ",%.10g" : "%.10g", row[i]);
    fprintf(out_, "\n");
    fflush(out_);
}

void CouplingHistory::countFragments(double broken)
{
    Compute* fragments = modify->find_compute_style_strict("fragment", 0);
    if (!fragments || broken == brokenThen_ || lines_ < countedAt_ + fragmentEvery_)
        return;
    if (fragments->invoked_vector != update->ntimestep)
        fragments->compute_vector();
    largest_ = fragments->vector[1];
    brokenThen_ = broken;
    countedAt_ = lines_;
}
