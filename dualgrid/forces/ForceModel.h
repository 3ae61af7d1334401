/// The forces of the fluid on a particle (model A: Zhou et al., J. Fluid Mech. 661 (2010) 482, set II).
///
///   drag               K (u - up), K from the drag law
///   pressure gradient  -V ∇p with the total pressure: buoyancy is in it
///   viscous            V ∇·τ
///   added mass         Ca ρf V (Du/Dt - dup/dt), Ca = ½ (Auton, Hunt & Prud'homme 1988)
///   rotational drag    π μ D³ (½ ∇×u - ωp)
///   shielding          drag and added mass times the particle's exposure (share of its bonds that are broken)
///
/// At a surface each fluid acts on the share w of the sphere that is in it, with its own velocity and acceleration:
/// w f(water) + (1-w) f(air). A mixture's ν = μ/ρ would be that of neither, and the mean velocity of a wind and of the
/// still water below would push a submerged sphere with 800 times the wind's density.
/// Cost: a few pow per particle. The drag law is chosen once per loop (withDrag), not per particle.
#pragma once

#include "DragLaws.h"
#include "Interaction.h"
#include "LocalFlow.h"
#include "Settings.h"
#include "Sphere.h"

namespace frazil
{

class ForceModel
{
  public:
    /// Reads the sub-dictionary `forces`:
    ///   drag              a name of DragLaws.h; DiFelice (default)
    ///   pressureGradient  on (default): without it nothing floats
    ///   viscous           on (default)
    ///   addedMass         on (default): Ca = 0.5 | off | a value of Ca
    ///   rotationalDrag    off (default)
    ///   shielding         off (default: the study); on: interior spheres of an intact plate feel no drag
    explicit ForceModel(const Settings& forces);

    bool pressureGradient() const { return pressureGradient_; }
    bool viscous() const { return viscous_; }

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
    template <class Law>
    Interaction interact(const Law& law, const LocalFlow& flow, const ParticleState& particle, const Phase& water,
                         const Phase& air) const;

    DragLaw drag_;
    bool pressureGradient_, viscous_, rotationalDrag_, shielding_;
    double addedMass_; ///< Ca [-]
};

/// K [kg/s] of a sphere of diameter D [m] that moves at `speed` [m/s] against the fluid.
template <class Law>
double dragCoefficient(const Law& law, const Phase& fluid, double diameter, double speed, double fluidFraction)
{
    const double re = fluidFraction * fluid.density * diameter * speed / fluid.viscosity;
    return 3 * pi * fluid.viscosity * diameter * law(re, fluidFraction);
}

template <class Law>
Interaction ForceModel::interact(const Law& law, const LocalFlow& flow, const ParticleState& particle,
                                 const Phase& water, const Phase& air) const
{
    const double d = 2 * particle.radius, volume = particle.presence * pi / 6 * d * d * d;
    const double exposure = particle.presence * (shielding_ ? particle.exposure : 1);

    Interaction result;
    auto act = [&](double share, const PhaseFlow& fluid, const Phase& phase) {
        if (!(share > 0))
            return; // a law is only asked about a fluid that is there
        const double speed = norm(fluid.velocity - particle.velocity);
        const double k = share * exposure * dragCoefficient(law, phase, d, speed, fluid.fluidFraction);
        const double mass = share * exposure * addedMass_ * (pi / 6 * d * d * d) * phase.density;
        result.dragCoefficient += k;
        result.fluidVelocity += k * fluid.velocity;
        result.addedMass += mass;
        result.fluidAcceleration += mass * fluid.acceleration;
        const double spin = rotationalDrag_ ? share * particle.presence * pi * d * d * d * phase.viscosity : 0;
        result.spinCoefficient += spin;
        result.fluidSpin += (0.5 * spin) * fluid.vorticity;
    };
    act(flow.wetShare, flow.water, water);
    act(1 - flow.wetShare, flow.air, air);
    auto toMean = [](Vec3& sum, double weight) { sum *= weight > 0 ? 1 / weight : 0; };
    toMean(result.fluidVelocity, result.dragCoefficient);
    toMean(result.fluidAcceleration, result.addedMass);
    toMean(result.fluidSpin, result.spinCoefficient);
    if (pressureGradient_)
        result.passiveForce -= volume * flow.pressureGradient;
    if (viscous_)
        result.passiveForce += volume * flow.viscousForce;
    return result;
}

} // namespace frazil
