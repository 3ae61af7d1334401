#include "ForceModel.h"

#include "Catalogue.h"

namespace frazil
{

namespace
{

double addedMassCoefficient(const Settings& forces)
{
    const std::string word = forces.text("addedMass", "on");
    if (word == "on")
        return 0.5;
    if (word == "off")
        return 0;
    const double coefficient = forces.number("addedMass");
    if (coefficient < 0 || coefficient > 5) {
        forces.reject("addedMass", "is not a coefficient of added mass", "Use on (0.5, spheres), off or a coefficient");
    }
    return coefficient;
}

} // namespace

ForceModel::ForceModel(const Settings& forces)
    : drag_(Catalogue<DragLaw>::choose(forces, "drag")), pressureGradient_(forces.flag("pressureGradient", true)),
      viscous_(forces.flag("viscous", true)), rotationalDrag_(forces.flag("rotationalDrag", false)),
      shielding_(forces.flag("shielding", false)), addedMass_(addedMassCoefficient(forces))
{
}

Interaction ForceModel::operator()(const LocalFlow& flow, const ParticleState& particle, const Phase& water,
                                   const Phase& air) const
{
    return std::visit([&](const auto& drag) { return interact(drag, flow, particle, water, air); }, drag_);
}

} // namespace frazil
