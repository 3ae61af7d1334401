#include "smallCells.H"
#include "faceMax.H"
#include "fvMesh.H"

namespace Foam
{

namespace
{

//- From the small cell to its neighbour on the fluid's side of the surface, weighted by the angle
scalar conductance(const scalar share, const scalar cosine)
{
    return share*sqr(max(cosine, scalar(0)));
}


void mergeInside
(
    surfaceScalarField& merged,
    const volScalarField& share,
    const volVectorField& normal,
    const surfaceVectorField& Sf
)
{
    const fvMesh& mesh = merged.mesh();
    forAll(merged, facei)
    {
        const label own = mesh.owner()[facei];
        const label nei = mesh.neighbour()[facei];
        merged[facei] =
            conductance(share[own], normal[own] & Sf[facei])
          + conductance(share[nei], -(normal[nei] & Sf[facei]));
    }
}


void mergeAcrossPatches
(
    surfaceScalarField& merged,
    const volScalarField& share,
    const volVectorField& normal,
    const surfaceVectorField& Sf
)
{
    const fvMesh& mesh = merged.mesh();
    forAll(merged.boundaryField(), patchi)
    {
        if (!mesh.boundary()[patchi].coupled())
        {
            continue;
        }
        const scalarField own(share.boundaryField()[patchi].patchInternalField());
        const scalarField nei(share.boundaryField()[patchi].patchNeighbourField());
        const vectorField ownNormal(normal.boundaryField()[patchi].patchInternalField());
        const vectorField neiNormal(normal.boundaryField()[patchi].patchNeighbourField());
        const vectorField& pSf = Sf.boundaryField()[patchi];
        forAll(own, i)
        {
            merged.boundaryFieldRef()[patchi][i] =
                conductance(own[i], ownNormal[i] & pSf[i]) + conductance(nei[i], -(neiNormal[i] & pSf[i]));
        }
    }
}

} // End anonymous namespace


void mergeSmallCells
(
    surfaceScalarField& merged,
    const volScalarField& least,
    const scalar small,
    const volScalarField& solid,
    const volVectorField& normal
)
{
    const fvMesh& mesh = merged.mesh();
    const volScalarField share((1.0 - solid)*sqr(max(1.0 - least/small, scalar(0))));
    const surfaceVectorField Sf(mesh.Sf()/mesh.magSf());
    mergeInside(merged, share, normal, Sf);
    mergeAcrossPatches(merged, share, normal, Sf);
    merged *= 1.0 - faceMax(solid);
}

} // End namespace Foam
