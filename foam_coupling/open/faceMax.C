#include "faceMax.H"
#include "surfaceInterpolate.H"

namespace Foam
{

tmp<surfaceScalarField> faceMax(const volScalarField& vf)
{
    tmp<surfaceScalarField> tmax(fvc::interpolate(vf));
    surfaceScalarField& fmax = tmax.ref();

    forAll(fmax, facei)
    {
        fmax[facei] = max(vf[vf.mesh().owner()[facei]], vf[vf.mesh().neighbour()[facei]]);
    }
    forAll(fmax.boundaryField(), patchi)
    {
        const fvPatchScalarField& pvf = vf.boundaryField()[patchi];
        fmax.boundaryFieldRef()[patchi] =
            pvf.coupled()
          ? max(pvf.patchInternalField(), pvf.patchNeighbourField())
          : pvf.patchInternalField();
    }
    return tmax;
}

} // End namespace Foam
