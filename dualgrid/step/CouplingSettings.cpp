#include "CouplingSettings.h"

#include "Catalogue.h"

namespace frazil
{

namespace
{

ProlongationSettings readProlongation(const Settings& settings)
{
    ProlongationSettings prolongation;
    prolongation.exponent = settings.positive("exponent", 2);
    prolongation.limitToCells = settings.word("limiter", {"cell", "none"}, "cell") == "cell";
    return prolongation;
}

double readSmallestFluidFraction(const Settings& settings)
{
    const double smallest = settings.positive("min", 0.25);
    if (smallest >= 1)
        settings.reject("min", "leaves no room for particles", "Use 0.25, just below that of the densest packing");
    return smallest;
}

} // namespace

CouplingSettings CouplingSettings::read(const Settings& settings)
{
    CouplingSettings coupling;
    coupling.dualGrid = settings.flag("dualGrid", true);
    coupling.kernel = Catalogue<Kernel>::choose(settings, "kernel");
    coupling.prolongation = readProlongation(settings.sub("prolongation"));
    coupling.smallestFluidFraction = readSmallestFluidFraction(settings.sub("voidFraction"));
    coupling.momentumExchange = settings.flag("momentumExchange", true);
    return coupling;
}

} // namespace frazil
