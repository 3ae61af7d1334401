#include "bodyPoses.H"
#include "Time.H"

#include <fmt/format.h>

#include "InputError.h"

Foam::bodyPoses::bodyPoses(const fvMesh& mesh, const label bodies)
:
    rows_
    (
        IOobject
        (
            "bodyPoses",
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    read_(rows_.size() > 0)
{
    if (read_ && rows_.size() != bodies*words)
    {
        throw frazil::InputError
        (
            std::string(mesh.time().timeName()) + "/uniform/bodyPoses", "", "",
            fmt::format("it has {} numbers, {} bodies need {}", rows_.size(), bodies, bodies*words),
            "Continue with the bodies that the run began with, or remove the file to place them anew."
        );
    }
    rows_.setSize(bodies*words, Zero);
}


void Foam::bodyPoses::place(const label bodyi, const bodyPose& pose)
{
    pose.put(rows_.data() + bodyi*words);
    setEnd(bodyi, pose);
}


void Foam::bodyPoses::startStep()
{
    for (label row = 0; row < rows_.size(); row += words)
    {
        std::copy_n(rows_.cdata() + row + bodyPose::words, int(bodyPose::words), rows_.data() + row);
    }
}


void Foam::bodyPoses::setEnd(const label bodyi, const bodyPose& pose)
{
    pose.put(rows_.data() + bodyi*words + bodyPose::words);
}


void Foam::bodyPoses::setCellSize(const label bodyi, const scalar size)
{
    rows_[(bodyi + 1)*words - 1] = size;
}


// ************************************************************************* //
