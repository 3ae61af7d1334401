/* history.csv: one line per fluid step, what a user plots first. Columns: columnsFor() in the source, one line each.

   Values of the bodies and of the bonds come from the global vectors of their fixes, which may sum over ranks: write()
   is collective, rank 0 owns the file. The fragments are counted only when bonds have broken, and not more often
   than every `fragmentEvery` lines, since that visits every bond. */

#ifndef FRAZIL_COUPLING_HISTORY_H
#define FRAZIL_COUPLING_HISTORY_H

#include "Columns.h"
#include "Messages.h"
#include "pointers.h"

#include <cstdio>
#include <string>
#include <vector>

namespace LAMMPS_NS
{

/// What a line is made of.
struct HistoryMoment {
    frazil::StepOrder order;        ///< of the exchange at its time
    double wall;                    ///< since the handshake [s]
    double waited;                  ///< of them, by frazilDem [s]
    double largestFragment;         ///< η [-]; nan without a compute fragment
    std::vector<class Fix*> bodies; ///< in the order of the script
    class Fix* bonds;               ///< first fix bond/parallel, or none
};

class CouplingHistory : protected Pointers
{
  public:
    /// continuedAt: fluid time of the restart [s], negative without one. A continued run goes on in its file, after
    /// the lines before this time.
    CouplingHistory(LAMMPS*, const std::string& file, int fragmentEvery, double continuedAt);
    ~CouplingHistory();

    /// Line for the exchange at the order's time; wall, waited: HistoryMoment. Collective.
    void write(const frazil::StepOrder& order, double wall, double waited);

  private:
    void open(const std::string& file, double continuedAt);
    void print(const std::string& line);
    std::vector<class Fix*> bodyFixes() const;
    double largestFragment(class Fix* bonds);

    frazil::Columns<HistoryMoment> columns_;
    FILE* out_ = nullptr;
    int fragmentEvery_;
    long lines_ = 0, countedAt_;
    double brokenThen_ = -1, largest_;
};

} // namespace LAMMPS_NS

#endif
