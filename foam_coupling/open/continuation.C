#include "continuation.H"
#include "fvMesh.H"
#include "surfaceFields.H"

namespace Foam
{

namespace
{

//- Means over the neighbours on the fluid's side, for closed cells
template<class Type>
struct outwardMean
{
    const scalarField& closed;
    Field<Type> sum;
    scalarField weights;

    explicit outwardMean(const scalarField& closedCells)
    :
        closed(closedCells),
        sum(closedCells.size(), Zero),
        weights(closedCells.size(), Zero)
    {}

    //- A neighbour's value; outward: the normal times the area towards it [m2]
    void take(const label celli, const Type& value, const scalar outward)
    {
        if (closed[celli] > 0.5 && outward > 0)
        {
            sum[celli] += outward*value;
            weights[celli] += outward;
        }
    }

    void setIn(Field<Type>& values) const
    {
        forAll(sum, celli)
        {
            if (weights[celli] > 0)
            {
                values[celli] = sum[celli]/weights[celli];
            }
        }
    }
};


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
    outwardMean<Type> mean(closed);

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const label own = mesh.owner()[facei];
        const label nei = mesh.neighbour()[facei];
        const vector& S = mesh.Sf()[facei];
        mean.take(own, vf[nei], normal[own] & S);
        mean.take(nei, vf[own], -(normal[nei] & S));
    }
    for (const fvPatchField<Type>& pvf : vf.boundaryField())
    {
        if (pvf.coupled())
        {
            const Field<Type> other(pvf.patchNeighbourField());
            forAll(other, i)
            {
                const label celli = pvf.patch().faceCells()[i];
                mean.take(celli, other[i], normal[celli] & pvf.patch().Sf()[i]);
            }
        }
    }
    mean.setIn(vf.primitiveFieldRef());
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
