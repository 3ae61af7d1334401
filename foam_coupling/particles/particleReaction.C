#include "particleReaction.H"
#include "zeroGradientFvPatchFields.H"
#include "Time.H"

#include "FineSource.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::vector vector3(const frazil::Vec3& v)
{
    return {v.x, v.y, v.z};
}


Foam::IOobject cellValues
(
    const Foam::word& name,
    const Foam::fvMesh& mesh,
    const Foam::IOobject::readOption read
)
{
    return
    {
        name, mesh.time().timeName(), mesh, read, Foam::IOobject::AUTO_WRITE
    };
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleReaction::particleReaction(const fvMesh& mesh)
:
    mesh_(mesh),
    force_
    (
        cellValues("particleForce", mesh, IOobject::NO_READ),
        mesh,
        dimensionedVector(dimForce/dimVolume, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    prediction_
    (
        cellValues("particlePrediction", mesh, IOobject::READ_IF_PRESENT),
        mesh,
        dimensionedVector(dimForce*dimTime/dimVolume, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    held_(mesh.nCells(), Zero),
    drag_(mesh.nCells(), Zero),
    dragVelocity_(mesh.nCells(), Zero),
    addedMass_(mesh.nCells(), Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleReaction::take(const frazil::FineSource& source)
{
    const scalarField& V = mesh_.V();
    vectorField& force = force_.primitiveFieldRef();

    forAll(force, celli)
    {
        force[celli] = vector3(source.force[celli])/V[celli];
        drag_[celli] = source.drag[celli]/V[celli];
        dragVelocity_[celli] = vector3(source.dragVelocity[celli]);
        addedMass_[celli] = source.addedMass[celli]/V[celli];
    }
    force_.correctBoundaryConditions();
    held_ = prediction_.primitiveField();
}


void Foam::particleReaction::addTo
(
    fvVectorMatrix& UEqn,
    const volVectorField& U
) const
{
    const scalar rDeltaT = 1/mesh_.time().deltaTValue();
    const scalarField& V = mesh_.V();

    UEqn.diag() += V*(drag_ + rDeltaT*addedMass_);
    UEqn.source() += V*
    (
        force_.primitiveField()
      + drag_*dragVelocity_
      + rDeltaT*(addedMass_*U.oldTime().primitiveField() + held_)
    );
}


void Foam::particleReaction::predict(const volVectorField& U)
{
    const vectorField& now = U.primitiveField();

    prediction_.primitiveFieldRef() =
        mesh_.time().deltaTValue()*drag_*(now - dragVelocity_)
      + addedMass_*(now - U.oldTime().primitiveField());
    prediction_.correctBoundaryConditions();
}


Foam::tmp<Foam::vectorField> Foam::particleReaction::applied() const
{
    return force_.primitiveField() + (held_ - prediction_.primitiveField())/mesh_.time().deltaTValue();
}


Foam::vector Foam::particleReaction::ahead() const
{
    return gSum(mesh_.V()*prediction_.primitiveField());
}


// ************************************************************************* //
