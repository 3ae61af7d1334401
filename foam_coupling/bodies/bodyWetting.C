#include "bodyWetting.H"
#include "bodyCellSize.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

constexpr label mostSlices = 400;


//- Area of the body's surface in a cell: what its open faces do not balance [m2]
scalar surfaceIn(const fvMesh& mesh, const label celli, const UList<scalar>& closed)
{
    vector open(Zero);
    for (const label facei : mesh.cells()[celli])
    {
        const vector& S = mesh.faceAreas()[facei];
        const scalar sign = mesh.faceOwner()[facei] == celli ? 1 : -1;
        open += sign*(1 - closed[facei])*S;
    }
    return mag(open);
}


//- Sums over the slices: solid volume, Σ A ε, Σ α A ε
struct sliceSums
{
    scalarField volume, weight, wet;

    explicit sliceSums(const label n)
    :
        volume(n, Zero),
        weight(n, Zero),
        wet(n, Zero)
    {}

    void add(const scalar at, scalar solid, scalar w, scalar alpha)
    {
        const label low = max(label(0), min(label(at), volume.size() - 2));
        const scalar upper = min(max(at - low, scalar(0)), scalar(1));
        for (const label side : {0, 1})
        {
            const scalar part = side ? upper : 1 - upper;
            volume[low + side] += part*solid;
            weight[low + side] += part*w;
            wet[low + side] += part*w*alpha;
        }
    }

    //- Share of wet volume, slices without surface like the nearest with it
    scalar submerged() const
    {
        scalar sum = 0;
        const scalar least = 1e-6*max(weight);
        forAll(volume, i)
        {
            label from = -1;
            for (label away = 0; from < 0 && away < volume.size(); ++away)
            {
                for (const label j : {i - away, i + away})
                {
                    if (j >= 0 && j < volume.size() && weight[j] > least)
                    {
                        from = j;
                    }
                }
            }
            sum += from < 0 ? 0 : volume[i]*wet[from]/weight[from];
        }
        return sum/max(Foam::sum(volume), VSMALL);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::submergedShare
(
    const volScalarField& alpha1,
    const bodyCut& cut,
    const UList<scalar>& closed,
    const point& centre,
    const scalar reach,
    const vector& up
)
{
    const fvMesh& mesh = alpha1.mesh();
    const scalar height = finestCut(mesh, cut);
    const label n =
        2 + max(label(0), min(mostSlices, label(2*reach/height)));
    const vector direction(mag(up) > VSMALL ? up/mag(up) : vector(0, 0, 1));

    sliceSums sums(n);
    forAll(cut.cells, i)
    {
        const label celli = cut.cells[i];
        const scalar share = cut.share[i];
        const scalar weight =
            share < 1 ? (1 - share)*surfaceIn(mesh, celli, closed) : 0;
        const scalar level = (mesh.C()[celli] - centre) & direction;
        sums.add
        (
            0.5*(n - 1)*(1 + level/reach),
            share*mesh.V()[celli], weight, alpha1[celli]
        );
    }
    for (scalarField* field : {&sums.volume, &sums.weight, &sums.wet})
    {
        Pstream::listCombineGather(*field, plusEqOp<scalar>());
        Pstream::listCombineScatter(*field);
    }
    return sums.submerged();
}


// ************************************************************************* //
