/// The forces of the fluid on a particle (model A: Zhou et al., J. Fluid Mech. 661 (2010) 482, set II).
///
///   drag               K (u - up), K from the drag law
///   pressure gradient  -V ∇p with the total pressure: buoyancy is in it
///   viscous            V ∇·τ
///   added mass         Ca ρf V (Du/Dt - dup/dt), Ca = ½ (Auton, Hunt & Prud'homme 1988)
///   rotational drag    π μ D³ (½ ∇×u - ωp)
///   shielding          drag and added mass times the particle's exposure (share of its bonds that are broken)
///
/// Where a particle sees both fluids the forces are blended, α1 f(water) + (1-α1) f(air): a mixture's ν = μ/ρ would be
/// that of neither. Cost: a few pow per particle. The drag law is chosen once per loop (withDrag), not per particle.
#pragma once

#include <utility>
#include <variant>

#include "DragLaws.h"
#include "Interaction.h"
#include "LocalFlow.h"
#include "Settings.h"

namespace frazil
{

/// No drag at all: to see what the other forces do.
struct NoDrag {
    double operator()(double, double) const { return 0; }
};

class ForceModel
{
  public:
    /// Reads the sub-dictionary `forces`:
    ///   drag              DiFelice (default) | Gidaspow | SchillerNaumann | KochHill | Beetstra | none
    ///   pressureGradient  on (default): without it nothing floats
    ///   viscous           on (default)
    ///   addedMass         on (default): Ca = 0.5 | off | a value of Ca
    ///   rotationalDrag    off (default)
    ///   shielding         off (default: the study); on: interior spheres of an intact plate feel no drag
    explicit ForceModel(const Settings& forces);

    /// Calls loop(interact), where interact(flow, particle, water, air) returns the Interaction.
    template <class Loop> void withDrag(Loop&& loop) const
    {
        std::visit(
            [&](const auto& drag) {
                loop([&](const LocalFlow& flow, const ParticleState& particle, const Phase& water, const Phase& air) {
                    return interact(drag, flow, particle, water, air);
                });
            },
            drag_);
    }

    Interaction operator()(const LocalFlow& flow, const ParticleState& particle, const Phase& water,
                           const Phase& air) const;

  private:
    using Drag = std::variant<DiFelice, Gidaspow, SchillerNaumann, KochHill, Beetstra, NoDrag>;

    template <class Law>
    Interaction interact(const Law& law, const LocalFlow& flow, const ParticleState& particle, const Phase& water,
                         const Phase& air) const;

    Drag drag_;
    bool pressureGradient_, viscous_, rotationalDrag_, shielding_;
    double addedMass_; ///< Ca [-]
};

/// K [kg/s] of a sphere of diameter D [m] that moves at `speed` [m/s] against the fluid.
template <class Law>
double dragCoefficient(const Law& law, const Phase& fluid, double diameter, double speed, double fluidFraction)
{
    const double pi = 3.14159265358979323846;
    const double re = fluidFraction * fluid.density * diameter * speed / fluid.viscosity;
    return 3 * pi * fluid.viscosity * diameter * law(re, fluidFraction);
}

template <class Law>
Interaction ForceModel::interact(const Law& law, const LocalFlow& flow, const ParticleState& particle,
                                 const Phase& water, const Phase& air) const
{
    const double pi = 3.14159265358979323846;
    const double d = 2 * particle.radius, volume = pi / 6 * d * d * d;
    const double wet = flow.wetFraction, dry = 1 - wet;
    const double exposure = shielding_ ? particle.exposure : 1;
    const double speed = norm(flow.velocity - particle.velocity);

    Interaction result;
    double k = 0; // a law is only asked about a fluid that is there
    if (wet > 0)
        k += wet * dragCoefficient(law, water, d, speed, flow.fluidFraction);
    if (dry > 0)
        k += dry * dragCoefficient(law, air, d, speed, flow.fluidFraction);
    result.dragCoefficient = exposure * k;
    result.fluidVelocity = flow.velocity;
    if (pressureGradient_)
        result.passiveForce -= volume * flow.pressureGradient;
    if (viscous_)
        result.passiveForce += volume * flow.viscousForce;
    result.addedMass = exposure * addedMass_ * volume * (wet * water.density + dry * air.density);
    result.fluidAcceleration = flow.acceleration;
    if (rotationalDrag_)
        result.spinCoefficient = pi * d * d * d * (wet * water.viscosity + dry * air.viscosity);
    result.fluidSpin = 0.5 * flow.vorticity;
    return result;
}

} // namespace frazil
