#include "checkCoupledCase.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::checkCoupledCase(const dynamicFvMesh& mesh, const bool LTS)
{
    if (mesh.dynamic())
    {
        FatalErrorInFunction
            << "constant/dynamicMeshDict: a moving or refined mesh together with constant/couplingProperties"
            << " is not possible. Use dynamicFvMesh staticFvMesh, or remove couplingProperties."
            << exit(FatalError);
    }
    const word ddtAlpha(mesh.ddtScheme("ddt(alpha)"));
    const word ddtU(mesh.ddtScheme("ddt(rho,U)"));
    if (LTS || ddtAlpha != "Euler" || ddtU != "Euler")
    {
        FatalErrorInFunction
            << "system/fvSchemes: ddt(alpha) is " << ddtAlpha << " and ddt(rho,U) is " << ddtU
            << ", but with constant/couplingProperties both must be Euler." << exit(FatalError);
    }
    if (mesh.solutionDict().subOrEmptyDict("PIMPLE").lookupOrDefault("frozenFlow", false))
    {
        FatalErrorInFunction
            << "system/fvSolution: PIMPLE frozenFlow yes has no momentum equation, but with"
            << " constant/couplingProperties bodies and particles take their forces from it. Remove frozenFlow."
            << exit(FatalError);
    }
}


// ************************************************************************* //
