#include "continuation.H"
#include "fvMesh.H"
#include "surfaceFields.H"

namespace Foam
{

namespace
{

template<class Type>
void continueByOneLayer
(
    GeometricField<Type, fvPatchField, volMesh>& vf,
    const scalarField& closed,
    const volVectorField& normal
)
{
    const fvMesh& mesh = vf.mesh();
    vf.correctBoundaryConditions();
    Field<Type> sum(mesh.nCells(), Zero);
    scalarField weights(mesh.nCells(), Zero);

    auto take = [&](const label celli, const Type& value, const scalar outward)
    {
        if (closed[celli] > 0.5 && outward > 0)
        {
            sum[celli] += outward*value;
            weights[celli] += outward;
        }
    };

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const label own = mesh.owner()[facei];
        const label nei = mesh.neighbour()[facei];
        const vector& S = mesh.Sf()[facei];
        take(own, vf[nei], normal[own] & S);
        take(nei, vf[own], -(normal[nei] & S));
    }
    for (const fvPatchField<Type>& pvf : vf.boundaryField())
    {
        if (pvf.coupled())
        {
            const Field<Type> other(pvf.patchNeighbourField());
            forAll(other, i)
            {
                const label celli = pvf.patch().faceCells()[i];
                take(celli, other[i], normal[celli] & pvf.patch().Sf()[i]);
            }
        }
    }
    forAll(sum, celli)
    {
        if (weights[celli] > 0)
        {
            vf[celli] = sum[celli]/weights[celli];
        }
    }
}

} // End anonymous namespace


template<class Type>
void continueInto
(
    GeometricField<Type, fvPatchField, volMesh>& vf,
    const scalarField& closed,
    const volVectorField& normal,
    const label layers
)
{
    for (label layer = 0; layer < layers; ++layer)
    {
        continueByOneLayer(vf, closed, normal);
    }
    vf.correctBoundaryConditions();
}


template void continueInto(volScalarField&, const scalarField&, const volVectorField&, const label);
template void continueInto(volVectorField&, const scalarField&, const volVectorField&, const label);

} // End namespace Foam
