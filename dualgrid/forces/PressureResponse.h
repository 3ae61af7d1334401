/// How the fluid in a coarse cell will answer to the particles that move in the coming step: the part of the pressure
/// gradient, and of drag and added mass, that the exchange would otherwise bring a step late.
///
/// Fluid between dense particles cannot move away: where they advance it must flow back, ε u = -αs v. The pressure that
/// this takes is an inertia of theirs. The particles of the coming step feel the ∇p that belongs to an acceleration of
/// two steps ago; explicit, that is unstable for ρf αs/(ρp ε) above about 1.2, at any Δt. With the volume V of the free
/// particles in the cell, m, Ma and K their sums of mass, added mass and drag coefficient, and a_ref the acceleration
/// that the present ∇p belongs to,
///
///   M = ρf V αs/ε + Ma (1/ε² - 1),   B = K (1/ε² - 1)
///   (m + Ma + M + (K + B) Δt) a = ΣF_other + ΣF_passive + ΣK (u - v) + ΣMa Du/Dt + M a_ref
///   R = -M (a - a_ref) - B Δt a                                                          [N]
///
/// M and B are exact for fluid that is shut in; free fluid has less inertia (Kelvin's minimum of kinetic energy), so M is an
/// upper bound, and then the iteration a_ref -> a contracts. R vanishes with Δt and where the acceleration is steady,
/// up to first order. ΣF_other (contacts, bonds, gravity) is that of the last step: particles that are locked in a bed
/// answer nothing and get nothing. R/V is spread over the particles as a part of ∇p: no reaction, the fluid carries it
/// in its own ∇p a step later.
/// Stability of the whole exchange, by eigenvalues: dualgrid/doc/stability.md. Cost: some 40 flops per cell.
/// Source: the idea of a Robin condition with the fluid's inertia is that of Badia, Nobile & Vergara, J. Comput. Phys.
/// 227 (2008) 7027; the closed form follows from the equations above.
#pragma once

#include "Vec3.h"

namespace frazil
{

/// Sums over the particles of a cell that forces can move. Doubles only: it travels through the halo as such.
struct ResponseSums {
    double volume = 0;    ///< V [m3]
    double mass = 0;      ///< m [kg]
    double addedMass = 0; ///< Ma [kg]
    double drag = 0;      ///< K [kg/s]
    double displaced = 0; ///< ρf V [kg]
    Vec3 drive;           ///< ΣF_other + ΣF_passive + ΣK (u - v) + ΣMa Du/Dt [N]
    Vec3 reference;       ///< Σ V a_ref [m4/s2]

    ResponseSums& operator+=(const ResponseSums& b)
    {
        volume += b.volume, mass += b.mass, addedMass += b.addedMass, drag += b.drag, displaced += b.displaced;
        drive += b.drive, reference += b.reference;
        return *this;
    }
};

inline ResponseSums operator*(double share, ResponseSums sums)
{
    for (double* number : {&sums.volume, &sums.mass, &sums.addedMass, &sums.drag, &sums.displaced})
        *number *= share;
    sums.drive *= share, sums.reference *= share;
    return sums;
}

/// R/V [N/m3]; zero without free particles. @param fluidFraction ε, above 0 [-]; @param deltaT [s]
inline Vec3 pressureResponse(const ResponseSums& sums, double fluidFraction, double deltaT)
{
    if (!(sums.volume > 0))
        return {};
    const double e = fluidFraction, shutIn = 1 / (e * e) - 1;
    const double inertia = sums.displaced * (1 - e) / e + sums.addedMass * shutIn, friction = sums.drag * shutIn;
    const Vec3 reference = sums.reference / sums.volume;
    const double resistance = sums.mass + sums.addedMass + inertia + (sums.drag + friction) * deltaT;
    const Vec3 a = (sums.drive + inertia * reference) / resistance;
    return (inertia * (reference - a) - friction * deltaT * a) / sums.volume;
}

} // namespace frazil
