/* fix ID group couple/foam: frazilDem's end of the coupling with frazilFoam. Documentation: doc/fix_couple_foam.md.

   At the end of the DEM step that reaches the fluid's time (and at the set-up of the first run) particles and bodies
   go to the fluid ranks and the coefficients of the fluid force come back; then both programs advance at once. The
   coefficients are held for the fluid step; the force is renewed at every DEM step, implicit in the particle's
   velocity and acceleration (fluid_push.h) where the force moves the particle; where a fix prescribes its motion, with
   the acceleration that it performs (particle_motion.h).

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
#include "fix.h"
#include "particle_motion.h"

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
    // what a particle carries from one exchange to the next
    struct Carried {
        frazil::Interaction fluid;
        frazil::Vec3 impulse;  // drag and added mass, received since the last exchange [N s]
        frazil::Vec3 reaction; // drag and added-mass force of the last DEM step [N]
        frazil::Vec3 others;   // impulse of all other forces since the last exchange [N s]
        frazil::Vec3 path;     // way since the last exchange [m]
        frazil::Vec3 speed[2]; // mean velocity over the last fluid step and the one before [m/s]
        double age = 0;        // time in the coupling [s], for the ramp of inserted particles
        // where a fix prescribes a motion that accelerates: velocity of the last DEM step [m/s], and 1 if there was one
        frazil::Vec3 velocity;
        double velocityKnown = 0;
    };
    static const int CARRIED = sizeof(Carried) / sizeof(double);
    static const int FORCES = 6; // columns of array_atom

    [[noreturn]] void stop(const std::string& message);
    void say(const std::string& message);
    void readKeywords(int narg, char** arg);

    void findPartners();
    void findMotion();
    void requireLastForce();

    void startCoupling();
    frazil::DemHello hello();
    void exchange();
    frazil::StepReport report();
    void checkClock(const frazil::StepOrder& order);
    bool leftBox(const double* x) const;
    void noteMotion(int i);
    frazil::ParticleMotion motionOf(int i);
    bool isLoose(int i) const;
    void gatherRecords();
    void sendBodies();
    void takeReplies();
    void takeBodyLoads();
    void requireBody(const std::string& name) const;
    const frazil::BodyLoad& loadOf(const std::string& name, const std::vector<frazil::BodyLoad>& loads) const;
    void endRun();
    void printTimers();

    void applyFluid(double impulseWeight);
    // of one particle, in the loop of applyFluid
    inline frazil::Vec3 reactionOn(int i) const;
    inline frazil::Vec3 torqueOn(int i) const;
    frazil::Vec3 prescribedAcceleration(int i) const;
    void rememberVelocity(int i);
    inline void push(int i);
    void repeatFluid();
    double fluidTimeNow() const;

    std::string shieldingId_, historyFile_, restartFile_;
    int fragmentEvery_;
    double ramp_; // time in which an inserted particle displaces its volume [s]

    std::unique_ptr<frazil::DemLink> link_;
    std::unique_ptr<frazil::CoarseGrid> grid_;
    std::unique_ptr<class CouplingHistory> history_;
    std::vector<class CoupledBody*> bodies_;
    class Fix* shielding_;
    std::vector<class Fix*> bonds_; // every fix bond/parallel
    ParticleMotion motion_;

    frazil::StepOrder order_; // of the fluid step being taken
    bigint exchangeStep_;     // DEM step of the last exchange
    bool first_;              // no exchange yet in this process and none before a restart
    double lastDeltaT_;       // fluid step that ends with the exchange under way [s]
    double dt_;               // DEM time step agreed at the handshake [s]
    double restartTime_;      // fluid time of the restart file [s], negative without one
    frazil::Vec3 impulse_;    // of this rank's particles since the last exchange, lost ones included [N s]

    std::vector<Carried> carried_;
    std::vector<frazil::ParticleRecord> records_;
    std::vector<int> recordOf_; // particle of each record
    std::vector<frazil::ParticleReply> replies_;

    bigint forceStep_;                            // of total_
    double total_[3];                             // fluid force on all particles [N]
    double startWall_, exchangeWall_, forceWall_; // [s]
};

} // namespace LAMMPS_NS

#endif
