/* fix ID group bond/parallel: breakable parallel bonds between spheres. Documentation: doc/fix_bond_parallel.md.

   The bonds themselves (law, step, results, frequency) are in bonds/, without LIGGGHTS; this class gives them the
   host's spheres, messages and files. State rests with the particles (BondStore) whenever they migrate or are written
   to a restart file, and in a table (BondTable) between.
   Cost: one pass over the table per step (bond_step.h); local indices are cached between reneighbourings.
   Parallel: a bond across ranks is advanced on both, from identical data in the order lower id -> higher id, so both
   ranks break it in the same step; each keeps the force on its own sphere. No message per step beyond the host's own
   update of ghosts (position, velocity, spin). `newton` on or off makes no difference. */

#ifndef LMP_FIX_BOND_PARALLEL_H
#define LMP_FIX_BOND_PARALLEL_H

#include "bond_options.h"
#include "bond_results.h"
#include "bond_step.h"
#include "bond_table.h"
#include "fix.h"
#include "read_bond_list.h"
#include "run_clock.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS
{

class FixBondParallel : public Fix
{
  public:
    FixBondParallel(class LAMMPS*, int, char**);
    ~FixBondParallel() override;

    int setmask() override;
    void post_create() override;
    void pre_delete(bool) override;
    void init() override;
    void init_list(int, class NeighList*) override;
    void setup_pre_exchange() override;
    void setup_pre_neighbor() override;
    void setup(int) override;
    void pre_exchange() override;
    void pre_neighbor() override;
    void post_force(int) override;
    void end_of_step() override;
    void post_run() override;

    double compute_vector(int) override;
    double memory_usage() override;

    void grow_arrays(int) override;
    void copy_arrays(int, int, int) override;
    void set_arrays(int) override;
    int pack_exchange(int, double*) override;
    int unpack_exchange(int, double*) override;
    int pack_restart(int, double*) override;
    void unpack_restart(int, int) override;
    int size_restart(int) override;
    int maxsize_restart() override;
    void write_restart(FILE*) override;
    void restart(char*) override;

    int pack_comm(int, int*, double*, int, int*) override;
    void unpack_comm(int, int, double*) override;

    /// The bonds with at least one owned sphere, with current local indices.
    const frazil::BondTable& bonds() const { return table_; }
    /// Of the group's spheres when the bonds were created [m3].
    double initialVolume() const { return initialVolume_; }

  private:
    enum Count { INTACT, TENSION, SHEAR, COUNTS };
    enum Total { ELASTIC, DAMPED, RELEASED, TOTALS };

    // fix_bond_parallel.cpp: input and the step
    static frazil::BondOptions optionsFrom(int, char**, class Error&, Fix*);
    void declareResults();
    void evaluate(int);
    void noteBroken(const frazil::BrokenBond&);
    void say(const std::string&) const;

    // fix_bond_parallel_create.cpp: creation
    void create();
    void startFromRest();
    void countInitial();
    void bondNeighbours();
    void bondIfNear(int, int);
    void bondFrom(int, int);
    void checkReach();
    std::string noPairInReach(double) const;
    void bondListed();
    frazil::BondList listedBonds();
    void checkListed(const frazil::BondList&);
    std::size_t addBond(int, int, int, int);
    void completeShape(std::size_t);

    // fix_bond_parallel_state.cpp: migration, restart
    void store();
    void load();
    void loadHalf(int, const frazil::BondHalf&, std::vector<int>&);
    void dropMissing(const std::vector<int>&, bool);
    void refuseFar(const std::vector<int>&);
    void countLost();
    void countBonds();
    int largestCount() const;

    // fix_bond_parallel_output.cpp: results, events
    void reduceCounts();
    void reduceTotals();
    void tallyVirial(int);
    void stressArray();
    void scheduleStress(bigint);
    void flushEvents();
    std::vector<frazil::BondEvent> gatherEvents();
    bool writeNew(std::vector<frazil::BondEvent>);

    // fix_bond_parallel_timestep.cpp: critical time step
    void checkTimeStep();
    double largestBondFrequency();
    double largestOfDashpots();
    double contactFrequencySquared();
    double presentContacts(const double*, const double*) const;
    double newContact(const double*, const double*, double) const;
    double greatestSpeed() const;

    frazil::BondOptions options_;
    double smallestGap_ = 0, largestReach_ = 0; // of this rank's neighbours: in mean radii; [m]

    frazil::BondTable table_;
    frazil::BondStore store_;
    frazil::BondStep step_;
    bool tableNewer_ = false; // the table holds the state; otherwise the store does
    int owned_ = 0;           // owned spheres when the table was made
    bool created_ = false, restarted_ = false;
    class NeighList* list_ = nullptr;

    std::vector<frazil::BondEvent> events_; // not written yet
    bool eventsOpened_ = false;

    bigint initialBonds_ = 0, lostBonds_ = 0;    // of all ranks
    double initialVolume_ = 0;                   // [m3], of all ranks
    double brokenTension_ = 0, brokenShear_ = 0; // of this rank
    double released_ = 0;                        // [J], of this rank
    double counts_[COUNTS];                      // of all ranks, at evaluation countsAt_
    double totals_[TOTALS], use_[2];             // of all ranks, at evaluation totalsAt_
    bigint evaluations_ = 0, countsAt_ = -1, totalsAt_ = -1;
    bigint nextStress_ = -1; // step for which the contacts' per-atom virial is announced

    frazil::RunClock clock_;
    double frequency_ = 0;   // largest of the bonds when they were created or read [rad/s]; 0: not known
    double dashpotTime_ = 0; // largest dashpot over spring of the bonds then [s]
    std::vector<double>* vibration_ = nullptr; // six per owned and ghost sphere, while frequency_ is sought
    std::string stressId_; // compute that asks the pair style for its per-atom virial; empty: the user's
};

} // namespace LAMMPS_NS

#endif
