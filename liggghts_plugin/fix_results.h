/* fix ID group results: particles and bonds over time in one HDF5 file that ParaView opens (through its XDMF file).
   Documentation: doc/fix_results.md.

   Cost: one collective parallel write every N steps, nothing in between. Parallel: every rank writes its own
   particles; a bond is written by the rank that owns its sphere of lower id. */

#ifndef LMP_FIX_RESULTS_H
#define LMP_FIX_RESULTS_H

#include "fix.h"
#include "run_clock.h"

#include <functional>
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
    ~FixResults() override;

    int setmask() override;
    void init() override;
    void setup(int) override;
    void end_of_step() override;
    void write_restart(FILE*) override;
    void restart(char*) override;

  private:
    /// An array of the particles: its name, the numbers of each particle and where they stand.
    struct Column {
        const char* name;
        int components;
        std::function<const double*(int)> of;
    };

    [[noreturn]] void stop(const std::string& problem);      // all ranks have it
    [[noreturn]] void stopAlone(const std::string& problem); // perhaps only this one
    void readWords(int, char**);
    class Fix* findFix(const std::string& keyword, const std::string& id);
    void findFragments();

    void openFile();
    void announce(bigint step);
    std::vector<Column> columns() const;
    void write();
    void writeParticles();
    void writeBonds();

    std::string file_ = "particles.h5", bondsId_, fluidId_, fragmentId_;
    std::unique_ptr<frazil::SnapshotFile> snapshots_;
    class FixBondParallel* bonds_ = nullptr;
    class Fix* fluid_ = nullptr;
    class ComputeFragment* fragment_ = nullptr;
    bigint writtenAt_ = -1;
    frazil::RunClock clock_;
};

} // namespace LAMMPS_NS

#endif
