#include "potentialFlux.H"
#include "pimpleControl.H"
#include "fixedValueFvPatchFields.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{

namespace
{

//- The potential: zero where the pressure is fixed
volScalarField potential(const volScalarField& p_rgh)
{
    wordList types(p_rgh.boundaryField().size(), zeroGradientFvPatchScalarField::typeName);
    forAll(types, patchi)
    {
        if (p_rgh.boundaryField()[patchi].fixesValue())
        {
            types[patchi] = fixedValueFvPatchScalarField::typeName;
        }
    }
    const fvMesh& mesh = p_rgh.mesh();
    return volScalarField
    (
        IOobject("pcorr", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(p_rgh.dimensions(), Zero),
        types
    );
}

} // End anonymous namespace


void anchorPressure
(
    fvScalarMatrix& pEqn,
    const volScalarField& p_rgh,
    const surfaceScalarField& rAUf,
    const volScalarField& solid
)
{
    const fvMesh& mesh = p_rgh.mesh();
    const scalarField anchored
    (
        solid.primitiveField()
       *fvc::surfaceSum(rAUf*mesh.magSf()*mesh.deltaCoeffs())().primitiveField()
    );
    pEqn.diag() -= anchored;
    pEqn.source() -= anchored*p_rgh.primitiveField();
}


tmp<surfaceScalarField> unitConductance(const fvMesh& mesh)
{
    return tmp<surfaceScalarField>
    (
        new surfaceScalarField
        (
            IOobject("unit", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar("unit", dimTime/dimDensity, 1.0)
        )
    );
}


tmp<surfaceScalarField> potentialFlux
(
    const surfaceScalarField& conductance,
    const surfaceScalarField* phi,
    const scalarField& demand,
    const volScalarField& p_rgh,
    const volScalarField* solid,
    pimpleControl& pimple
)
{
    const fvMesh& mesh = p_rgh.mesh();
    volScalarField pcorr(potential(p_rgh));
    mesh.setFluxRequired(pcorr.name());
    const tmp<surfaceScalarField> unit(unitConductance(mesh));
    const label refCell = Pstream::master() ? 0 : -1;
    tmp<surfaceScalarField> tflux;

    while (pimple.correctNonOrthogonal())
    {
        fvScalarMatrix pcorrEqn(fvm::laplacian(conductance, pcorr));
        if (phi)
        {
            pcorrEqn -= fvc::div(*phi);
        }
        pcorrEqn.source() -= demand;
        if (solid)
        {
            anchorPressure(pcorrEqn, pcorr, unit(), *solid);
        }
        pcorrEqn.setReference(refCell, 0);
        pcorrEqn.solve(mesh.solver(pcorr.select(pimple.finalNonOrthogonalIter())));

        if (pimple.finalNonOrthogonalIter())
        {
            tflux = -pcorrEqn.flux();
        }
    }
    return tflux;
}

} // End namespace Foam
