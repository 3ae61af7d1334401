#include "bodyPose.H"
#include "conversions.H"

Foam::bodyPose::bodyPose(const frazil::BodyState& state, const point& centroid)
:
    centre(toVector(state.centre)),
    rotation(toTensor(normalised(state.orientation))),
    velocity(toVector(state.velocity)),
    omega(toVector(state.angularVelocity)),
    reference(centroid - toVector(state.centroidOffset))
{}


Foam::bodyPose::bodyPose(const scalar* row)
:
    centre(row[0], row[1], row[2]),
    rotation
    (
        row[3], row[4], row[5], row[6], row[7], row[8], row[9], row[10], row[11]
    ),
    velocity(row[12], row[13], row[14]),
    omega(row[15], row[16], row[17]),
    reference(row[18], row[19], row[20])
{}


void Foam::bodyPose::put(scalar* row) const
{
    for (const vector& v : {centre, rotation.x(), rotation.y(), rotation.z(), velocity, omega, reference})
    {
        for (direction c = 0; c < 3; ++c)
        {
            *row++ = v[c];
        }
    }
}


Foam::bodyPose Foam::bodyPose::after(const scalar deltaT) const
{
    bodyPose later(*this);
    later.centre += deltaT*velocity;
    later.rotation = toTensor(frazil::rotationBy(toVec3(deltaT*omega))) & rotation;
    return later;
}


// ************************************************************************* //
