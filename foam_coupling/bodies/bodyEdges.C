#include "bodyEdges.H"
#include "fvMesh.H"
#include "surfaceFields.H"
#include "syncTools.H"

namespace Foam
{

namespace
{

//- κ h from which a cell begins to hold an edge, and from which it does in full
constexpr scalar smooth = 0.5;
constexpr scalar sharp = 1;

//- Cells whose velocity is prescribed are closer than this, in cells
constexpr scalar reach = 1.5;


//- Area over distance between cells of any face [m]
scalar conductance(const fvMesh& mesh, const label facei)
{
    if (mesh.isInternalFace(facei))
    {
        return mesh.magSf()[facei]*mesh.nonOrthDeltaCoeffs()[facei];
    }
    const label patchi = mesh.boundaryMesh().whichPatch(facei);
    const label i = facei - mesh.boundaryMesh()[patchi].start();
    const fvsPatchScalarField& area = mesh.magSf().boundaryField()[patchi];
    return area.empty() ? 0 : area[i]*mesh.nonOrthDeltaCoeffs().boundaryField()[patchi][i];
}


//- κ h of a cell [-]; beyond: the distance in the cells behind the mesh's boundary faces [m]
scalar turnWithin(const volScalarField& distance, const scalarList& beyond, const label celli)
{
    const fvMesh& mesh = distance.mesh();
    scalar sum = 0;
    for (const label facei : mesh.cells()[celli])
    {
        const scalar other =
            !mesh.isInternalFace(facei) ? beyond[facei - mesh.nInternalFaces()]
          : mesh.faceOwner()[facei] == celli ? distance[mesh.faceNeighbour()[facei]]
          : distance[mesh.faceOwner()[facei]];
        sum += (other - distance[celli])*conductance(mesh, facei);
    }
    return sum/sqr(cbrt(mesh.V()[celli]));
}

} // End anonymous namespace


void findEdges
(
    const volScalarField& distance,
    const labelUList& cells,
    scalarField& edge
)
{
    const fvMesh& mesh = distance.mesh();
    // Behind patches that are not coupled: the cell's own
    scalarList beyond;
    syncTools::swapBoundaryCellList(mesh, distance.primitiveField(), beyond);
    // By all ranks: made when first asked for, which takes part of all of them
    (void)mesh.nonOrthDeltaCoeffs();
    for (const label celli : cells)
    {
        edge[celli] = 0;
        if (mag(distance[celli]) < reach*cbrt(mesh.V()[celli]))
        {
            const scalar turn = turnWithin(distance, beyond, celli);
            edge[celli] = min(max((turn - smooth)/(sharp - smooth), scalar(0)), scalar(1));
        }
    }
}

} // End namespace Foam
