/* history.csv: one line per fluid step, what a user plots first. Columns: header() in the source.
   Values of the body and of the bonds come from the global vectors of their fixes, which may sum over ranks: write()
   is collective, rank 0 owns the file. The fragments are counted only when bonds have broken, and not more often
   than every `fragmentEvery` lines, since that visits every bond. */

#ifndef FRAZIL_COUPLING_HISTORY_H
#define FRAZIL_COUPLING_HISTORY_H

#include <cstdio>
#include <string>
#include <vector>

#include "Messages.h"
#include "pointers.h"

namespace LAMMPS_NS
{

class CouplingHistory : protected Pointers
{
  public:
    // continuedAt: fluid time of the restart [s], negative without one. A continued run goes on in its file, after
    // the lines before this time.
    CouplingHistory(LAMMPS*, const std::string& file, int fragmentEvery, double continuedAt);
    ~CouplingHistory();

    // line for the exchange at the order's time; wall: seconds since the handshake; waited: seconds of them
    // that frazilDem has waited
    void write(const frazil::StepOrder& order, double wall, double waited);

  private:
    void open(const std::string& file, double continuedAt);
    void writeHeader();
    std::vector<class Fix*> bodyFixes() const;
    void countFragments(double broken);

    FILE* out_;
    int fragmentEvery_;
    long lines_, countedAt_;
    double brokenThen_, largest_;
};

} // namespace LAMMPS_NS

#endif
