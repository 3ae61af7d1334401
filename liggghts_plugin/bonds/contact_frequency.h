/* Frequencies of sphere contacts, bounds for the time step. With Hertz-Mindlin's tangents kn = 2 E* sqrt(R* d) and
   kt = 8 G* sqrt(R* d) at the overlap d, a pair's largest frequency squared is

     max(kn/m*, kt (1/m* + R1^2/I1 + R2^2/I2)).

   A sphere of mass m that comes at the speed V is driven to the overlap d = (15 m V^2/(16 E* sqrt(R)))^0.4 (Hertz).
   Source: Johnson, Contact Mechanics (1985), ch. 4, 7, 11. Cost: a square root per contact. */

#ifndef FRAZIL_CONTACT_FREQUENCY_H
#define FRAZIL_CONTACT_FREQUENCY_H

#include <algorithm>
#include <cmath>

namespace frazil
{

/// Hertz-Mindlin's moduli of two materials [Pa].
struct ContactModuli {
    double normal, tangential; ///< E*, G*

    ContactModuli(double young1, double poisson1, double young2, double poisson2)
        : normal(1 / ((1 - poisson1 * poisson1) / young1 + (1 - poisson2 * poisson2) / young2)),
          tangential(0.5 / ((2 - poisson1) * (1 + poisson1) / young1 + (2 - poisson2) * (1 + poisson2) / young2))
    {
    }

    /// Square of the largest frequency of a pair [1/s2]: radius R* and overlap [m], sum of 1/m [1/kg] and of R^2/I
    /// [1/kg].
    double frequencySquared(double radius, double overlap, double perMass, double perInertia) const
    {
        const double root = std::sqrt(radius * overlap);
        return root * std::max(2 * normal * perMass, 8 * tangential * (perMass + perInertia));
    }

    /// Greatest overlap [m] of a sphere with a wall, or something heavy, that it meets at `speed` [m/s].
    double impactOverlap(double mass, double radius, double speed) const
    {
        return std::pow(15 * mass * speed * speed / (16 * normal * std::sqrt(radius)), 0.4);
    }
};

} // namespace frazil

#endif
