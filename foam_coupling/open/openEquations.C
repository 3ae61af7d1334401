// What the open volume changes in the equations: openVolume.H, "Equations"
#include "openVolume.H"
#include "continuation.H"
#include "faceMax.H"
#include "gaussConvectionScheme.H"
#include "immersedBodies.H"
#include "potentialFlux.H"
#include "upwind.H"

namespace Foam
{

tmp<volScalarField> openVolume::anchoring() const
{
    return max(1.0 - 10.0*end_(), scalar(0));
}


tmp<fvVectorMatrix> openVolume::convection(const surfaceScalarField& rhoPhi, const volVectorField& U) const
{
    const word name("div(rhoPhi,U)");
    if (!active())
    {
        return fvm::div(rhoPhi, U, name);
    }

    const upwind<vector> implicitScheme(mesh_, rhoPhi);
    surfaceVectorField difference
    (
        fv::convectionScheme<vector>::New(mesh_, rhoPhi, mesh_.divScheme(name))->interpolate(rhoPhi, U)
      - implicitScheme.interpolate(U)
    );
    if (bodies_)
    {
        difference *= neg(faceMax(max(bodies_->gamma(), bodies_->gamma().oldTime())) - SMALL);
    }
    return
        fv::gaussConvectionScheme<vector>(mesh_, rhoPhi, implicitScheme).fvmDiv(rhoPhi, U)
      + fvc::surfaceIntegrate(rhoPhi*difference);
}


void openVolume::anchor(fvVectorMatrix& UEqn, const volScalarField& rho, const volVectorField& U) const
{
    if (bodies_)
    {
        const volScalarField coefficient(anchoring()*rho/mesh_.time().deltaT());
        UEqn += fvm::Sp(coefficient, U) - coefficient*U;
    }
}


void openVolume::addSweptVolume
(
    fvScalarMatrix& pEqn,
    const volScalarField& p_rgh,
    const surfaceScalarField& rAUf
) const
{
    pEqn.source() -= sweptVolume();
    if (bodies_)
    {
        anchorPressure(pEqn, p_rgh, rAUf, solid_());
    }
}


void openVolume::extendIntoBodies(volScalarField& vf) const
{
    if (active() && bodies_)
    {
        continueInto(vf, closedAtEnd(), bodies_->normal(), nExtensionLayers);
    }
}


void openVolume::extendPressure(volScalarField& p_rgh) const
{
    if (active() && bodies_)
    {
        continueInto(p_rgh, solid_(), bodies_->normal(), nExtensionLayers);
    }
}


tmp<scalarField> openVolume::closedAtEnd() const
{
    return neg(end_().primitiveField() - divisible);
}


void openVolume::blendWithBodies(volVectorField& U) const
{
    if (!active() || !bodies_)
    {
        return;
    }
    // Cells that have closed just now keep the momentum that left them; overwriting it costs 12 % of ½ρU²A in ripple
    continueInto(U, solid_(), bodies_->normal(), nExtensionLayers);

    // 0 where half of the cell is open, 1 where less than a tenth is
    const volScalarField weight(min(max((0.5 - (1.0 - bodies_->gamma()))/0.4, scalar(0)), scalar(1)));
    U += weight*bodies_->constrained(bodies_->Ub() - U);
    U.correctBoundaryConditions();
}


void openVolume::reportContinuity(const surfaceScalarField& phi, scalar& cumulative) const
{
    const scalar deltaT = mesh_.time().deltaTValue();
    volScalarField error(fvc::div(phi));
    if (active())
    {
        error += (end_() - start_())/mesh_.time().deltaT();
    }

    const scalar local = deltaT*mag(error)().weightedAverage(mesh_.V()).value();
    const scalar global = deltaT*error.weightedAverage(mesh_.V()).value();
    cumulative += global;

    Info<< "time step continuity errors : sum local = " << local
        << ", global = " << global
        << ", cumulative = " << cumulative
        << endl;
}

} // End namespace Foam
