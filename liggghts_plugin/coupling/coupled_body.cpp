#include "coupled_body.h"

#include <stdexcept>
#include <string>

using namespace LAMMPS_NS;
using frazil::BodyLoad;
using frazil::BodyState;

namespace
{

void requireBody(const std::string& name, const std::vector<CoupledBody*>& bodies)
{
    for (const CoupledBody* body : bodies)
        if (name == body->bodyState().name)
            return;
    throw std::runtime_error("frazilFoam sent the load of a body " + name + ", which the script does not have (fix " +
                             "body/rigid of this ID). Was it removed after the coupling had started? Keep it");
}

const BodyLoad& loadOf(const std::string& name, const std::vector<BodyLoad>& loads)
{
    for (const BodyLoad& load : loads)
        if (name == load.name)
            return load;
    throw std::runtime_error("frazilFoam sent no load of the body " + name + " (fix body/rigid of this ID). Was it " +
                             "added after the coupling had started? Define all bodies before the first run");
}

} // namespace

std::vector<BodyState> LAMMPS_NS::statesOf(const std::vector<CoupledBody*>& bodies)
{
    std::vector<BodyState> states;
    for (const CoupledBody* body : bodies)
        states.push_back(body->bodyState());
    return states;
}

void LAMMPS_NS::setLoads(const std::vector<CoupledBody*>& bodies, const std::vector<BodyLoad>& loads)
{
    for (const BodyLoad& load : loads)
        requireBody(load.name, bodies);
    for (CoupledBody* body : bodies)
        body->setFluidLoad(loadOf(body->bodyState().name, loads));
}
