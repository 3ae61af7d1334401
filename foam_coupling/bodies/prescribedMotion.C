#include "prescribedMotion.H"
#include "couplingSettings.H"
#include "quaternion.H"
#include "vector.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Orientation q after turning with omega [rad/s] for deltaT [s]
void turn(double (&q)[4], const frazil::Vec3& omega, const Foam::scalar deltaT)
{
    using Foam::quaternion;
    using Foam::vector;

    const Foam::scalar angle = frazil::norm(omega)*deltaT;
    if (angle < Foam::VSMALL)
    {
        return;
    }

    const vector axis(omega.x, omega.y, omega.z);
    const quaternion turned =
        quaternion(axis/mag(axis), angle)
       *quaternion(q[0], vector(q[1], q[2], q[3]));

    q[0] = turned.w();
    q[1] = turned.v().x();
    q[2] = turned.v().y();
    q[3] = turned.v().z();
}

} // End anonymous namespace


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
        turn(body.orientation, body.angularVelocity, deltaT);
    }
}


// ************************************************************************* //
