/* One time step of all bonds of a rank: Cayley vector of each sphere's rotation; then per block of bonds gather
   positions and rotations, advance the law (bond_kernel.h), note what exceeds its strength, add forces and torques to
   both spheres.

   A bond that breaks gives no load in that step any more. Both ranks of a bond across them see the same numbers, so
   both break it in the same step without a message.
   Cost: one pass over contiguous columns. Parallel: no messages; what is added to a ghost is never read, because its
   owner has its own copy of the bond. */

#ifndef FRAZIL_BOND_STEP_H
#define FRAZIL_BOND_STEP_H

#include "bond_kernel.h"

#include <vector>

namespace frazil
{

/// The spheres as the host holds them: rows of three numbers one behind the other, those that the rank owns first.
struct BondSpheres {
    int owned, all;         ///< spheres that the rank owns, and these with its ghosts
    const double* position; ///< [m]
    const double* velocity; ///< [m/s]
    const double* spin;     ///< angular velocity [rad/s]
    double* force;          ///< added to [N]
    double* torque;         ///< added to [N m]
};

/// A bond that has exceeded its strength; its row stays in the table until the end of the step.
struct BrokenBond {
    std::size_t row;
    BondUse use;
};

class BondStep
{
  public:
    double damped = 0; ///< energy that the dashpots have taken so far, of the owned spheres' halves [J]

    /// A step of dt [s]. Where nothing has moved (a set-up), loads follow from the state as it is, and those of the
    /// dashpots from the velocities, as over a step that ends here.
    void advance(BondTable& table, const BondMaterial& material, const BondSpheres& spheres, double dt, bool moved);

    /// Bonds that broke in the last step, in the order of their rows.
    const std::vector<BrokenBond>& broken() const { return broken_; }

    /// Takes the rows of the broken bonds out of the table, which renumbers others.
    void removeBroken(BondTable& table);

  private:
    void advanceRows(BondTable& table, std::size_t begin, double dt, bool moved);
    void gather(BondBlock& block, const BondTable& table, std::size_t begin) const;
    void dampAtRest(BondBlock& block, const BondTable& table, std::size_t begin, double dt) const;
    void breakExcess(BondBlock& block, std::size_t begin);
    void scatter(const BondBlock& block, const BondTable& table, std::size_t begin) const;
    void countPower(const BondBlock& block, const BondTable& table, std::size_t begin, double dt);

    const BondMaterial* material_ = nullptr; ///< both of the step under way
    const BondSpheres* spheres_ = nullptr;
    std::vector<Vec3> turns_; ///< Cayley vector per owned and ghost sphere
    std::vector<BrokenBond> broken_;
};

} // namespace frazil

#endif
