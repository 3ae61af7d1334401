#include "prescribedMotion.H"
#include "couplingSettings.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::prescribedMotion::prescribedMotion
(
    const dictionary& bodies,
    const std::vector<frazil::BodyState>& states
)
:
    states_(states)
{
    for (frazil::BodyState& body : states_)
    {
        const frazil::Settings motion
        (
            couplingSettings
            (
                bodies.subDict(body.name).subOrEmptyDict("motion"),
                "bodies." + std::string(body.name) + ".motion"
            )
        );
        body.velocity = motion.vec3("velocity", {});
        body.angularVelocity = motion.vec3("omega", {});
        motion.finish();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::prescribedMotion::advance(const scalar deltaT)
{
    for (frazil::BodyState& body : states_)
    {
        body.centre += deltaT*body.velocity;
        body.orientation = normalised(frazil::rotationBy(deltaT*body.angularVelocity)*body.orientation);
    }
}


// ************************************************************************* //
