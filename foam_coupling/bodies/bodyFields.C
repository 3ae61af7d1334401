#include "bodyFields.H"
#include "bodyEdges.H"
#include "fvMesh.H"
#include "Time.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

using namespace Foam;

//- Only γ is written
IOobject bodyField(const fvMesh& mesh, const word& name, IOobject::writeOption write = IOobject::NO_WRITE)
{
    return IOobject(name, mesh.time().timeName(), mesh, IOobject::NO_READ, write);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyFields::bodyFields(const fvMesh& mesh)
:
    gamma
    (
        bodyField(mesh, "gamma", IOobject::AUTO_WRITE),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    Ub
    (
        bodyField(mesh, "bodyVelocity"),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    normal
    (
        bodyField(mesh, "bodyNormal"),
        mesh,
        dimensionedVector(dimless, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    distance
    (
        bodyField(mesh, "bodyDistance"),
        mesh,
        dimensionedScalar("far", dimLength, GREAT),
        zeroGradientFvPatchScalarField::typeName
    ),
    bodyOf(mesh.nCells(), -1),
    edge(mesh.nCells(), Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bodyFields::reset()
{
    gamma == dimensionedScalar(dimless, Zero);
    Ub == dimensionedVector(dimVelocity, Zero);
    normal == dimensionedVector(dimless, Zero);
    distance == dimensionedScalar("far", dimLength, GREAT);
    bodyOf.setSize(gamma.size());
    bodyOf = -1;
    edge.setSize(gamma.size());
    edge = 0;
}


void Foam::bodyFields::clear(const PtrList<bodyCut>& cuts)
{
    scalarField& shares = gamma.primitiveFieldRef();
    scalarField& distances = distance.primitiveFieldRef();
    vectorField& normals = normal.primitiveFieldRef();
    vectorField& velocities = Ub.primitiveFieldRef();

    for (const bodyCut& cut : cuts)
    {
        for (const label celli : cut.cells)
        {
            shares[celli] = 0;
            distances[celli] = GREAT;
            normals[celli] = Zero;
            velocities[celli] = Zero;
            bodyOf[celli] = -1;
        }
    }
}


void Foam::bodyFields::add(const label bodyi, const bodyCut& cut, const bodyPose& pose)
{
    const vectorField& centres = gamma.mesh().cellCentres();
    scalarField& shares = gamma.primitiveFieldRef();
    scalarField& distances = distance.primitiveFieldRef();
    vectorField& normals = normal.primitiveFieldRef();
    vectorField& velocities = Ub.primitiveFieldRef();

    forAll(cut.cells, i)
    {
        const label celli = cut.cells[i];
        shares[celli] += cut.share[i];
        if (cut.distance[i] < distances[celli])
        {
            distances[celli] = cut.distance[i];
            normals[celli] = cut.normal[i];
            velocities[celli] = pose.velocityAt(centres[celli]);
            bodyOf[celli] = bodyi;
        }
    }
}


void Foam::bodyFields::finish(const PtrList<bodyCut>& cuts)
{
    scalarField& shares = gamma.primitiveFieldRef();
    for (const bodyCut& cut : cuts)
    {
        for (const label celli : cut.cells)
        {
            shares[celli] = min(shares[celli], scalar(1));
        }
    }
    gamma.correctBoundaryConditions();
    Ub.correctBoundaryConditions();
    normal.correctBoundaryConditions();
    distance.correctBoundaryConditions();
    for (const bodyCut& cut : cuts)
    {
        findEdges(distance, cut.cells, edge);
    }
}


// ************************************************************************* //
