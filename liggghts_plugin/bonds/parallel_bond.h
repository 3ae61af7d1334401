/* Parallel bond of Potyondy & Cundall (2004), Int. J. Rock Mech. Min. Sci. 41, 1329-1364: a cemented disc between
   the centres of two spheres. Pure functions of state and motion: no host, no MPI, no memory.

   Equations, for the pair 1 -> 2 (separation d = x2 - x1, n = d/|d|, rest length L, disc radius Rb):
     A = pi Rb^2, I = A Rb^2/4, J = A Rb^2/2, kn = E/L, ks = kn/kappa
     force on 1:   F = kn A (|d| - L) n + S,         dS = ks A dU       (U: slip of 2 past 1 at the bond centre)
     moment on 1:  M = T n + B,                      dT = ks J dtheta_n, dB = kn I dtheta_s   (theta of 2 less that of 1)
     on 2 the opposite; each sphere also receives the lever-arm torque of F about its own centre.
     sigma = Fn/A + beta |B| Rb/I (tension positive, signed), tau = |S|/A + beta |T| Rb/J

   Objectivity: S and B are carried from the old to the new bond direction by the shortest rotation, then turned about
   the bond by the pair's mean spin along it. Rotations over a step enter as Cayley vectors 2 tan(theta/2) w/|w|: with
   them slip is exactly zero and the carried vectors are exactly co-rotated in any rigid rotation, however large the
   step (swing-twist decomposition of the rotation). Increments act half before and half after the turn; while the pair
   itself turns by theta in a step they are too large by theta^2/4 (1e-8 of them for ice spheres at 1000 rad/s).
   The slip uses positions, not velocities, so any motion of the spheres is seen and nothing drifts.

   Cost: about 250 flops and 5 square roots per bond, branch-free. Units: SI throughout. */

#ifndef FRAZIL_PARALLEL_BOND_H
#define FRAZIL_PARALLEL_BOND_H

#include "Vec3.h"

#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace frazil
{

/// Damping of the four modes, fractions of critical [-].
struct BondFractions {
    double normal = 0, shear = 0, torsion = 0, bending = 0;

    bool any() const { return normal > 0 || shear > 0 || torsion > 0 || bending > 0; }
};

/// Material of the bonds, as given by the user.
struct BondMaterial {
    double young = 0;           ///< E_b [Pa]
    double stiffnessRatio = 1;  ///< kappa = kn/ks [-]
    double tensileStrength = 0; ///< sigma_c [Pa]
    double shearStrength = 0;   ///< tau_c, the cohesion if frictionTan > 0 [Pa]
    double frictionTan = 0;     ///< tan of the friction angle: tau_c grows by it times the compressive stress [-]
    double momentFactor = 1;    ///< beta, share of the moments in the stresses [-]
    BondFractions damping;
};

/// What does not change while the bond lives.
struct BondShape {
    double restLength; ///< L [m]
    double radius;     ///< Rb of the disc [m]
    double share;      ///< distance of the bond centre from sphere 1, fraction of the separation [-]
    double strength;   ///< factor on both strengths (Weibull scatter) [-]
};

/// What the bond remembers from step to step.
struct BondState {
    Vec3 separation; ///< x2 - x1 at the last evaluation [m]
    Vec3 shear;      ///< S, on sphere 1 [N]
    Vec3 bending;    ///< B, on sphere 1 [N m]
    double torsion;  ///< T, on sphere 1 along n [N m]
};

/// Stiffness of the four modes.
struct BondStiffness {
    double area;    ///< A [m2]
    double normal;  ///< kn A [N/m]
    double shear;   ///< ks A [N/m]
    double torsion; ///< ks J [N m]
    double bending; ///< kn I [N m]
};

/// Relative motion of 2 and 1 over a step, in the four modes.
struct BondIncrement {
    double stretch; ///< [m]
    Vec3 slip;      ///< [m]
    double twist;   ///< [rad]
    Vec3 bend;      ///< [rad]
};

/// Force and moment on sphere 1 at the bond centre; sphere 2 receives the opposite.
struct BondLoad {
    Vec3 force;  ///< [N]
    Vec3 moment; ///< [N m]
};

/// Viscous coefficients of the four modes [N s/m], [N m s].
struct BondDashpots {
    double normal, shear, torsion, bending;
};

struct BondStress {
    double sigma; ///< largest tensile stress in the disc, compression negative [Pa]
    double tau;   ///< largest shear stress in the disc [Pa]
};

inline BondStiffness stiffnessOf(const BondMaterial& material, double restLength, double radius)
{
    const double area = M_PI * radius * radius;
    const double kn = material.young / restLength;
    const double ks = kn / material.stiffnessRatio;
    const double quarter = 0.25 * radius * radius;
    return {area, kn * area, ks * area, 2 * quarter * ks * area, quarter * kn * area};
}

/// Cayley vector 2 tan(theta/2) w/|w| of the rotation with angular velocity w [rad/s] over dt [s], theta = |w| dt.
/// Series of tan: exact to 1e-12 up to 0.05 rad per step, to 1e-6 at 0.5 rad.
inline Vec3 cayleyVector(const Vec3& omega, double dt)
{
    const double q = 0.25 * dt * dt * dot(omega, omega);
    return omega * (dt * (1 + q * (1. / 3 + q * (2. / 15 + q * (17. / 315 + q * 62. / 2835)))));
}

/// The turn of a bond over a step: from direction n0 to n1 the short way, then by its spin about n1.
struct BondTurn {
    Vec3 sum;       ///< n0 + n1
    Vec3 n1;        ///< new direction
    double inverse; ///< 1/(1 + n0.n1)
    double cosine, sine;

    BondTurn(const Vec3& n0, const Vec3& n1, const Vec3& meanTurn)
        : sum(n0 + n1), n1{n1.x, n1.y, n1.z}, inverse(1 / (1 + dot(n0, n1)))
    {
        const double tangent = 0.25 * dot(meanTurn, sum); // of half the spin angle
        const double scale = 1 / (1 + tangent * tangent);
        cosine = (1 - tangent * tangent) * scale;
        sine = 2 * tangent * scale;
    }

    /// Part of a vector perpendicular to the mid-step direction.
    Vec3 across(const Vec3& v) const { return v - sum * (0.5 * inverse * dot(v, sum)); }

    /// Vector perpendicular to n0, turned, with an increment that arrives evenly over the step; perpendicular to n1.
    Vec3 carry(const Vec3& v, const Vec3& increment) const
    {
        Vec3 w = v + 0.5 * increment;
        w -= sum * (inverse * dot(w, n1));
        w = cosine * w + sine * cross(n1, w) + 0.5 * increment;
        return w - n1 * dot(w, n1);
    }
};

/// Takes the bond through one step: new separation [m], Cayley vectors of both spheres' rotations over the step.
inline BondIncrement advance(BondState& state, const BondStiffness& k, double share, const Vec3& separation,
                             const Vec3& turn1, const Vec3& turn2)
{
    const double length0 = norm(state.separation), length1 = norm(separation);
    const Vec3 n0 = state.separation * (1 / length0), n1 = separation * (1 / length1);
    const BondTurn turn(n0, n1, 0.5 * (turn1 + turn2));

    const Vec3 middle = 0.5 * (state.separation + separation);
    const Vec3 carried = cross(share * turn1 + (1 - share) * turn2, middle);
    const Vec3 relative = turn2 - turn1;

    BondIncrement increment;
    increment.stretch = length1 - length0;
    increment.slip = turn.across(separation - state.separation - carried);
    increment.twist = 0.5 * dot(relative, turn.sum);
    increment.bend = turn.across(relative);

    state.separation = separation;
    state.shear = turn.carry(state.shear, k.shear * increment.slip);
    state.bending = turn.carry(state.bending, k.bending * increment.bend);
    state.torsion += k.torsion * increment.twist;
    return increment;
}

/// Elastic load on sphere 1.
inline BondLoad elasticLoad(const BondState& state, const BondStiffness& k, double restLength)
{
    const double length = norm(state.separation);
    const Vec3 n = state.separation * (1 / length);
    return {k.normal * (length - restLength) * n + state.shear, state.torsion * n + state.bending};
}

/// Viscous load on sphere 1, from the motion over a step of 1/rate seconds.
inline BondLoad viscousLoad(const BondIncrement& motion, const BondDashpots& c, const Vec3& n, double rate)
{
    return {rate * (c.normal * motion.stretch * n + c.shear * motion.slip),
            rate * (c.torsion * motion.twist * n + c.bending * motion.bend)};
}

/// Power taken by the dashpots [W]; never negative.
inline double viscousPower(const BondIncrement& motion, const BondDashpots& c, double rate)
{
    return rate * rate *
           (c.normal * motion.stretch * motion.stretch + c.shear * dot(motion.slip, motion.slip) +
            c.torsion * motion.twist * motion.twist + c.bending * dot(motion.bend, motion.bend));
}

/// Dashpots at fractions of critical: c = 2 zeta sqrt(k m), with the pair's reduced mass [kg] and inertia [kg m2].
inline BondDashpots dashpotsOf(const BondStiffness& k, const BondFractions& zeta, double reducedMass,
                               double reducedInertia)
{
    return {2 * zeta.normal * std::sqrt(k.normal * reducedMass), 2 * zeta.shear * std::sqrt(k.shear * reducedMass),
            2 * zeta.torsion * std::sqrt(k.torsion * reducedInertia),
            2 * zeta.bending * std::sqrt(k.bending * reducedInertia)};
}

/// Tension positive normal stress of the disc without moments [Pa].
inline double axialStress(const BondState& state, const BondStiffness& k, double restLength)
{
    return k.normal * (norm(state.separation) - restLength) / k.area;
}

inline BondStress stressOf(const BondState& state, const BondStiffness& k, const BondShape& shape, double momentFactor)
{
    const double perForce = 1 / k.area;
    const double perMoment = momentFactor * perForce / shape.radius;
    return {axialStress(state, k, shape.restLength) + 4 * perMoment * norm(state.bending),
            perForce * norm(state.shear) + 2 * perMoment * std::fabs(state.torsion)};
}

/// Stress over strength in tension and in shear: above 1 the bond breaks.
struct BondUse {
    double tension, shear;
};

inline BondUse useOf(const BondState& state, const BondStiffness& k, const BondShape& shape,
                     const BondMaterial& material)
{
    const BondStress stress = stressOf(state, k, shape, material.momentFactor);
    const double axial = axialStress(state, k, shape.restLength);
    const double compression = 0.5 * (std::fabs(axial) - axial); // without a branch
    return {stress.sigma / (shape.strength * material.tensileStrength),
            stress.tau / (shape.strength * material.shearStrength + material.frictionTan * compression)};
}

/// Energy stored in the four springs [J].
inline double elasticEnergy(const BondState& state, const BondStiffness& k, double restLength)
{
    const double stretch = norm(state.separation) - restLength;
    return 0.5 * (k.normal * stretch * stretch + dot(state.shear, state.shear) / k.shear +
                  state.torsion * state.torsion / k.torsion + dot(state.bending, state.bending) / k.bending);
}

/// Weibull factor on the strengths of bond id1 < id2, of mean 1 and modulus m. It depends on the ids and the seed
/// alone, so it is the same on any number of ranks and after a restart. (Hash: the finaliser of splitmix64, Steele,
/// Lea & Flood 2014.)
inline double weibullFactor(std::int64_t id1, std::int64_t id2, double modulus, std::int64_t seed)
{
    std::uint64_t h = static_cast<std::uint64_t>(seed);
    for (std::int64_t word : {id1, id2}) {
        h += static_cast<std::uint64_t>(word) + 0x9E3779B97F4A7C15ull;
        h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9ull;
        h = (h ^ (h >> 27)) * 0x94D049BB133111EBull;
        h ^= h >> 31;
    }
    const double uniform = (static_cast<double>(h >> 11) + 0.5) * 0x1p-53; // inside (0, 1)
    return std::pow(-std::log(uniform), 1 / modulus) / std::tgamma(1 + 1 / modulus);
}

} // namespace frazil

#endif
