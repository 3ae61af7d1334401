#include "stepLength.H"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::int64_t Foam::stepLength::substeps
(
    const double allowed,
    const double demDeltaT,
    const double time,
    const double left
)
{
    // Written so that a deltaT that is not a number ends here too
    if (!(allowed >= 1e-3*demDeltaT))
    {
        throw std::runtime_error
        (
            "the fluid diverges: at fluid time " + std::to_string(time)
          + " s the Courant number allows less than a thousandth of the DEM "
            "time step. Look at the last fields written; reduce maxCo or "
            "maxDeltaT in system/controlDict, or refine the mesh"
        );
    }
    // A hair more than whole, so that 10.0 DEM steps do not become 9
    const double fitting = std::floor(allowed/demDeltaT*(1 + 1e-9));
    const double untilEnd = std::max(1.0, std::round(left/demDeltaT));
    if (fitting < 1)
    {
        ++longSteps_;
    }
    return std::int64_t(std::min(std::max(1.0, fitting), untilEnd));
}


double Foam::stepLength::grown
(
    const double last,
    const double demDeltaT,
    const double courant,
    const double most
)
{
    return std::min(std::min(last + demDeltaT, courant), most);
}


// ************************************************************************* //
