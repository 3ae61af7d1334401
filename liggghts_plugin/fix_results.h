/* fix ID group results: particles and bonds over time in one HDF5 file that ParaView opens (through its XDMF file).
   Documentation: doc/fix_results.md.

   Cost: one collective parallel write every N steps, nothing in between. Parallel: every rank writes its own
   particles; a bond is written by the rank that owns its sphere of lower id. */

#ifndef LMP_FIX_RESULTS_H
#define LMP_FIX_RESULTS_H

#include "fix.h"

#include <memory>
#include <string>
#include <vector>

namespace frazil
{
class SnapshotFile;
}

namespace LAMMPS_NS
{

class FixResults : public Fix
{
  public:
    FixResults(class LAMMPS*, int, char**);
    ~FixResults();

    int setmask();
    void init();
    void setup(int);
    void end_of_step();
    void write_restart(FILE*);
    void restart(char*);

  private:
    // per-particle columns of one snapshot, contiguous per array
    struct Column {
        std::string name;
        int components;
        std::vector<double> values;
    };

    [[noreturn]] void stop(const std::string&);      // all ranks have the error
    [[noreturn]] void stopAlone(const std::string&); // perhaps only this one
    void readWords(int, char**);
    class Fix* findFix(const std::string& keyword, const std::string& id);

    void openFile();
    void announce(bigint step);
    void write();
    void gatherParticles();
    void addVectors(const char* name, double** rows, int from);
    void addScalars(const char* name, const double* values);
    void addFluid();
    void addBonds();
    void addFragments();
    void writeBonds();
    double time() const;

    std::string file_, bondsId_, fluidId_, fragmentId_;
    std::unique_ptr<frazil::SnapshotFile> snapshots_;
    class FixBondParallel* bonds_;
    class Fix* fluid_;
    class ComputeFragment* fragment_;

    std::vector<int> members_; // local indices of the group
    std::vector<Column> columns_;
    bigint writtenAt_;
    double timeBefore_;  // what the host's clock forgot at a restart [s]
    double restartTime_; // of the restart file, until the first run knows the time step; otherwise -1 [s]
};

} // namespace LAMMPS_NS

#endif
