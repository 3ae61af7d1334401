#include "alphaScheme.H"
#include "CrankNicolsonDdtScheme.H"
#include "EulerDdtScheme.H"
#include "immiscibleIncompressibleTwoPhaseMixture.H"
#include "localEulerDdtScheme.H"
#include "openVolume.H"

namespace Foam
{

scalar alphaOffCentring(const fvMesh& mesh, const label nSubCycles, const bool restarted)
{
    const tmp<fv::ddtScheme<scalar>> tscheme(fv::ddtScheme<scalar>::New(mesh, mesh.ddtScheme("ddt(alpha)")));
    const fv::ddtScheme<scalar>& scheme = tscheme();

    if (isType<fv::EulerDdtScheme<scalar>>(scheme) || isType<fv::localEulerDdtScheme<scalar>>(scheme))
    {
        return 0;
    }
    if (!isType<fv::CrankNicolsonDdtScheme<scalar>>(scheme))
    {
        FatalErrorInFunction
            << "system/fvSchemes: ddt(alpha) is " << scheme.type()
            << ", but the water fraction can only use Euler, localEuler or CrankNicolson" << exit(FatalError);
    }
    if (nSubCycles > 1)
    {
        FatalErrorInFunction
            << "system/fvSolution: nAlphaSubCycles is " << nSubCycles
            << ", but ddt(alpha) CrankNicolson works with 1 only" << exit(FatalError);
    }

    const bool hasOldFlux = restarted || mesh.time().timeIndex() > mesh.time().startTimeIndex() + 1;
    return hasOldFlux ? refCast<const fv::CrankNicolsonDdtScheme<scalar>>(scheme).ocCoeff() : 0;
}


tmp<surfaceScalarField> compressionVelocity
(
    const immiscibleIncompressibleTwoPhaseMixture& mixture,
    const volVectorField& U,
    const surfaceScalarField& phi,
    const scalar icAlpha,
    const scalar scAlpha
)
{
    const fvMesh& mesh = U.mesh();
    tmp<surfaceScalarField> tphic(new surfaceScalarField(mixture.cAlpha()*mag(phi/mesh.magSf())));
    surfaceScalarField& phic = tphic.ref();

    if (icAlpha > 0)
    {
        phic *= (1.0 - icAlpha);
        phic += (mixture.cAlpha()*icAlpha)*fvc::interpolate(mag(U));
    }
    if (scAlpha > 0)
    {
        phic += scAlpha*mag(mesh.delta() & fvc::interpolate(symm(fvc::grad(U))));
    }

    for (fvsPatchScalarField& patchPhic : phic.boundaryFieldRef())
    {
        if (!patchPhic.coupled())
        {
            patchPhic == 0;
        }
    }
    return tphic;
}


tmp<fvScalarMatrix> ddtAlpha(const geometricOneField&, const volScalarField& alpha, const bool LTS)
{
    const fvMesh& mesh = alpha.mesh();
    return LTS
        ? fv::localEulerDdtScheme<scalar>(mesh).fvmDdt(alpha)
        : fv::EulerDdtScheme<scalar>(mesh).fvmDdt(alpha);
}


tmp<fvScalarMatrix> ddtAlpha(const volScalarField& epsilon, const volScalarField& alpha, const bool)
{
    return fv::EulerDdtScheme<scalar>(alpha.mesh()).fvmDdt(epsilon, alpha);
}


void reportAlpha(const volScalarField& alpha, const openVolume& open)
{
    Info<< "Phase-1 volume fraction = " << open.mean(alpha)
        << "  Min(" << alpha.name() << ") = " << min(alpha).value()
        << "  Max(" << alpha.name() << ") = " << max(alpha).value()
        << endl;
}

} // End namespace Foam
