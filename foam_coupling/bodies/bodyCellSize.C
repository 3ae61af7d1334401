#include "bodyCellSize.H"
#include "fvMesh.H"
#include "volMesh.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::cellSizeAt(const fvMesh& mesh, const placedBody& body)
{
    scalar inBox = GREAT;
    scalar anywhere = GREAT;
    forAll(mesh.V(), celli)
    {
        const scalar V = mesh.V()[celli];
        anywhere = min(anywhere, V);
        if (V < inBox && body.boxHolds(mesh.cellCentres()[celli]))
        {
            inBox = V;
        }
    }
    reduce(inBox, minOp<scalar>());
    reduce(anywhere, minOp<scalar>());
    return std::cbrt(inBox < GREAT ? inBox : anywhere);
}


Foam::scalar Foam::finestCut(const fvMesh& mesh, const bodyCut& cut)
{
    scalar least = GREAT;
    forAll(cut.cells, i)
    {
        if (cut.share[i] > 0 && cut.share[i] < 1)
        {
            least = min(least, mesh.V()[cut.cells[i]]);
        }
    }
    reduce(least, minOp<scalar>());
    return least < GREAT ? std::cbrt(least) : GREAT;
}


Foam::scalar Foam::bodyDeltaT(const volVectorField& Ub, const scalar maxBodyCo)
{
    const scalarField rate(mag(Ub.primitiveField())/cbrt(Ub.mesh().V().field()));
    return maxBodyCo/(gMax(rate) + VSMALL);
}


// ************************************************************************* //
