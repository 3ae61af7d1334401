/* fix ID group couple/foam: frazilDem's end of the coupling with frazilFoam. Documentation: doc/fix_couple_foam.md.

   At the end of the DEM step that reaches the fluid's time (and at the set-up of the first run) particles and bodies
   go to the fluid ranks and the coefficients of the fluid force come back; then both programs advance at once. The
   coefficients are held for the fluid step; the force is renewed at every DEM step, implicit in the particle's
   velocity and acceleration (fluid_push.h) where the force moves the particle; where a fix prescribes its motion, with
   the acceleration that it performs (particle_drive.h).

   Impulse: velocity Verlet applies half of each step's force before and half after the positions move, so what a
   particle received since the last exchange is the trapezoidal sum of its drag and added-mass forces. It travels
   with the particle (migration, restart) until the next exchange.
   Cost per DEM step: one pass over the own particles. Parallel: the exchange is collective, DemLink.h. */

#ifndef LMP_FIX_COUPLE_FOAM_H
#define LMP_FIX_COUPLE_FOAM_H

#include <memory>
#include <string>
#include <vector>

#include "CoarseGrid.h"
#include "DemLink.h"
#include "carried_particle.h"
#include "fix.h"
#include "particle_drive.h"

namespace LAMMPS_NS
{

class FixCoupleFoam : public Fix
{
  public:
    FixCoupleFoam(class LAMMPS*, int, char**);
    ~FixCoupleFoam() override;

    int setmask() override;
    void init() override;
    void setup(int) override;
    void post_force(int) override;
    void end_of_step() override;
    void reset_timestep(bigint newStep, bigint oldStep) override;

    double compute_vector(int) override;
    double memory_usage() override;
    void grow_arrays(int) override;
    void copy_arrays(int, int, int) override;
    void set_arrays(int) override;
    int pack_exchange(int, double*) override;
    int unpack_exchange(int, double*) override;

    void write_restart(FILE*) override;
    void restart(char*) override;
    int pack_restart(int, double*) override;
    void unpack_restart(int, int) override;
    int size_restart(int) override;
    int maxsize_restart() override;

  private:
    static const int CARRIED = sizeof(frazil::CarriedParticle) / sizeof(double);
    static const int FORCES = 6; // columns of array_atom

    // fix_couple_foam.cpp: input, what the script has, hooks
    void readWords(int narg, char** arg);
    void declareResults();
    void findPartners();
    class Fix* findShielding();
    void findDrive();
    void requireLastForce();
    void endRun();
    void printTimers();
    double fluidTimeNow() const;
    [[noreturn]] void stop(const std::string& message);

    // fix_couple_foam_force.cpp: the force of each DEM step
    void applyFluid(double impulseWeight);
    void noteMotion(int i);
    inline frazil::Vec3 reactionOn(int i) const;
    inline frazil::Vec3 torqueOn(int i) const;
    frazil::Vec3 prescribedAcceleration(int i) const;
    void rememberVelocity(int i);
    inline void push(int i);
    void repeatFluid();

    // fix_couple_foam_exchange.cpp: handshake and exchange
    void startCoupling();
    frazil::DemHello hello();
    void measureParticles(frazil::DemHello& hello);
    void exchange();
    frazil::StepReport report();
    void checkClock(const frazil::StepOrder& order);
    void writeRestart();
    bool leftBox(const double* x) const;
    void gatherRecords();
    frazil::ParticleRecord recordFrom(int i);
    frazil::ParticleMotion motionOf(int i);
    bool isLoose(int i) const;
    void takeReplies();
    void takeBodyLoads();

    std::string shieldingId_, restartFile_;
    std::string historyFile_ = "history.csv"; // empty: none
    int fragmentEvery_ = 10;
    double ramp_ = 0.01; // time in which an inserted particle displaces its volume [s]

    std::unique_ptr<frazil::DemLink> link_;
    std::unique_ptr<frazil::CoarseGrid> grid_;
    std::unique_ptr<class CouplingHistory> history_;
    std::vector<class CoupledBody*> bodies_;
    class Fix* shielding_ = nullptr;
    std::vector<class Fix*> bonds_; // every fix bond/parallel
    ParticleDrive drive_;

    frazil::StepOrder order_;  // of the fluid step being taken
    bigint exchangeStep_ = -1; // DEM step of the last exchange
    bool first_ = true;        // no exchange yet in this process and none before a restart
    double lastDeltaT_ = 0;    // fluid step that ends with the exchange under way [s]
    double dt_ = 0;            // DEM time step agreed at the handshake [s]
    double restartTime_ = -1;  // fluid time of the restart file [s], negative without one
    frazil::Vec3 impulse_;     // of this rank's particles since the last exchange, lost ones included [N s]

    std::vector<frazil::CarriedParticle> carried_;
    std::vector<frazil::ParticleRecord> records_;
    std::vector<int> recordOf_; // particle of each record
    std::vector<frazil::ParticleReply> replies_;

    bigint forceStep_ = -1;                                   // of total_
    double total_[3];                                         // fluid force on all particles [N]
    double startWall_ = 0, exchangeWall_ = 0, forceWall_ = 0; // [s]
};

} // namespace LAMMPS_NS

#endif
