#include "flowAtParticles.H"
#include "fluidCoupling.H"
#include "openVolume.H"

namespace Foam
{

tmp<volVectorField> pressureGradient
(
    const openVolume& open,
    const volScalarField& p_rgh,
    const volScalarField& rho,
    const surfaceScalarField& ghf,
    const dimensionedVector& g
)
{
    return open.reconstruct((fvc::snGrad(p_rgh) + ghf*fvc::snGrad(rho))*p_rgh.mesh().magSf()) + rho*g;
}


tmp<volVectorField> viscousForce
(
    incompressible::turbulenceModel& turbulence,
    const volScalarField& rho,
    volVectorField& U
)
{
    return -(turbulence.divDevRhoReff(rho, U) & U);
}


tmp<volVectorField> materialDerivative(const volVectorField& U, const volVectorField& ddtU)
{
    return (U & fvc::grad(U)) + ddtU;
}


scalarField accelerationShare(const fluidCoupling& coupling)
{
    if (!coupling.hasBodies())
    {
        return scalarField();
    }
    const volScalarField& gamma = coupling.bodies()->gamma();
    return neg(max(gamma.primitiveField(), gamma.oldTime().primitiveField()) - 0.5);
}


tmp<volVectorField> vorticity(const volVectorField& U)
{
    return fvc::curl(U);
}

} // End namespace Foam
