/* fix ID group bond/parallel: breakable parallel bonds between spheres (law and equations: parallel_bond.h).

   Algorithm, per step: Cayley vector of each sphere's rotation; then per block of bonds gather positions and
   rotations, advance the law, break what exceeds its strength, scatter forces and torques to both spheres.
   Cost: one pass over contiguous columns; local indices are cached between reneighbourings (bond_table.h).
   Parallel: a bond across ranks is advanced on both, from identical data in the order lower id -> higher id, so both
   ranks break it in the same step; each keeps the force on its own sphere. No message per step beyond the host's own
   update of ghosts (position, velocity, spin). `newton` on or off makes no difference.
   State rests with the particles (BondStore) whenever they migrate or are written to a restart file. */

#ifndef LMP_FIX_BOND_PARALLEL_H
#define LMP_FIX_BOND_PARALLEL_H

#include "Settings.h"
#include "bond_table.h"
#include "fix.h"
#include "read_bond_list.h"

#include <string>
#include <vector>

namespace frazil
{
struct BondBlock;
}

namespace LAMMPS_NS
{

class FixBondParallel : public Fix
{
  public:
    FixBondParallel(class LAMMPS*, int, char**);
    ~FixBondParallel();

    int setmask();
    void post_create();
    void pre_delete(bool);
    void init();
    void init_list(int, class NeighList*);
    void setup_pre_exchange();
    void setup_pre_neighbor();
    void setup(int);
    void pre_exchange();
    void pre_neighbor();
    void post_force(int);
    void end_of_step();
    void post_run();

    double compute_vector(int);
    double memory_usage();

    void grow_arrays(int);
    void copy_arrays(int, int, int);
    void set_arrays(int);
    int pack_exchange(int, double*);
    int unpack_exchange(int, double*);
    int pack_restart(int, double*);
    void unpack_restart(int, int);
    int size_restart(int);
    int maxsize_restart();
    void write_restart(FILE*);
    void restart(char*);

    int pack_comm(int, int*, double*, int, int*);
    void unpack_comm(int, int, double*);

    /// The bonds with at least one owned sphere, with current local indices.
    const frazil::BondTable& bonds() const { return table_; }
    /// Of the group's spheres when the bonds were created [m3].
    double initialVolume() const { return initialVolume_; }

  private:
    struct Event {
        double time; // [s]
        int id1, id2, shear;
        double x, y, z;    // bond centre [m]
        double sigma, tau; // [Pa]
    };
    enum Count { INTACT, TENSION, SHEAR, COUNTS };
    enum Total { ELASTIC, DAMPED, RELEASED, TOTALS };

    // fix_bond_parallel.cpp: input and the step
    void parse(const frazil::Settings&);
    void parseWeibull(const frazil::Settings&);
    void parseDamping(const frazil::Settings&);
    void say(const std::string&) const;
    void evaluate(int);
    void evaluateBlock(std::size_t, double);
    void gather(frazil::BondBlock&, std::size_t);
    void dampAtRest(frazil::BondBlock&, std::size_t);
    void scatter(frazil::BondBlock&, std::size_t, double);
    void breakBonds(frazil::BondBlock&, std::size_t);
    double time() const;
    void breakBond(std::size_t, const frazil::BondUse&);

    // fix_bond_parallel_create.cpp: creation
    void create();
    void bondNeighbours();
    void bondFrom(int, int);
    void checkReach();
    void bondListed();
    void checkListed(const frazil::BondList&);
    std::size_t addBond(int, int, int, int);
    void completeShape(std::size_t);

    // fix_bond_parallel_state.cpp: migration, restart
    void store();
    void load();
    void dropMissing(const std::vector<int>&, bool);
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
    bool writeEvents(std::vector<Event>&);

    // fix_bond_parallel_timestep.cpp: critical time step
    void checkTimeStep();
    double largestDashpotTime();
    double contactFrequencySquared();
    double presentContacts(const double*, const double*) const;
    double newContact(const double*, const double*, double) const;
    double greatestSpeed() const;
    double largestFrequency();
    double inertia(int, int) const;
    double massProduct(const std::vector<double>&, const std::vector<double>&);
    void stiffnessTimes(std::vector<double>&);

    frazil::BondMaterial material_;
    double radiusFactor_, createGap_;
    double weibullModulus_; // 0: no scatter
    int weibullSeed_;
    std::string eventsFile_, listFile_;
    double smallestGap_, largestReach_; // of this rank's neighbours: in mean radii; [m]

    frazil::BondTable table_;
    frazil::BondStore store_;
    bool tableNewer_; // the table holds the state; otherwise the store does
    int owned_;       // owned spheres when the table was made
    bool created_, restarted_;
    class NeighList* list_;

    std::vector<frazil::Vec3> turns_; // Cayley vector per owned and ghost sphere
    std::vector<std::size_t> broken_; // rows to remove after the step
    std::vector<Event> events_;       // not written yet
    bool eventsOpened_;

    bigint initialBonds_, lostBonds_;    // of all ranks
    double initialVolume_;               // [m3], of all ranks
    double brokenTension_, brokenShear_; // of this rank
    double damped_, released_;           // [J], of this rank
    double counts_[COUNTS];              // of all ranks, at evaluation countsAt_
    double totals_[TOTALS], use_[2];     // of all ranks, at evaluation totalsAt_
    bigint evaluations_, countsAt_, totalsAt_;
    bigint nextStress_; // step for which the contacts' per-atom virial is announced

    double timeBefore_;             // what the host's clock forgot at a restart [s]
    double restartTime_;            // of the restart file, until the first run knows the time step; otherwise -1 [s]
    double frequency_;              // largest of the bonds when they were created or read [rad/s]; 0: not known
    double dashpotTime_;            // largest dashpot over spring of the bonds then [s]
    std::vector<double> vibration_; // six per owned and ghost sphere, while frequency_ is sought
    char* stressId_;                // compute that asks the pair style for its per-atom virial
};

} // namespace LAMMPS_NS

#endif
