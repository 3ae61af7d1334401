#include "closedFaces.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Of one face, inside the mesh or on its boundary
static void setFace(Foam::surfaceScalarField& theta, const Foam::label facei, const Foam::scalar open)
{
    using namespace Foam;
    const fvMesh& mesh = theta.mesh();
    if (facei < mesh.nInternalFaces())
    {
        theta.primitiveFieldRef()[facei] = open;
        return;
    }
    const label patchi = mesh.boundaryMesh().whichPatch(facei);
    fvsPatchScalarField& ptheta = theta.boundaryFieldRef()[patchi];
    if (ptheta.size())
    {
        ptheta[facei - mesh.boundaryMesh()[patchi].start()] = open;
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::closedFaces::reset(const label nFaces)
{
    share.setSize(nFaces);
    share = 0;
    faces.clear();
}


void Foam::closedFaces::clear()
{
    for (const label facei : faces)
    {
        share[facei] = 0;
    }
    faces.clear();
}


void Foam::closedFaces::add(const bodyCut& cut)
{
    forAll(cut.faces, i)
    {
        scalar& closed = share[cut.faces[i]];
        closed = min(closed + cut.closed[i], scalar(1));
        faces.append(cut.faces[i]);
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::setOpenShares
(
    surfaceScalarField& theta,
    const closedFaces& start,
    const closedFaces& end
)
{
    theta.primitiveFieldRef() = 1;
    for (fvsPatchScalarField& ptheta : theta.boundaryFieldRef())
    {
        ptheta = 1;
    }
    for (const closedFaces* closed : {&start, &end})
    {
        for (const label facei : closed->faces)
        {
            setFace(theta, facei, 1 - 0.5*(start.share[facei] + end.share[facei]));
        }
    }
}


// ************************************************************************* //
