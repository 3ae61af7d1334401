/*---------------------------------------------------------------------------*\
    Frazil: LIGGGHTS-OpenFOAM coupling. GPL-3.0-or-later, see LICENSE.

Application
    frazilFoam

Description
    Water and air with particles and immersed rigid bodies: interFoam's volume-of-fluid equations with the open
    volume fraction ε = αf (1 - γ) in every one of them (openVolume.H), one equation per file.

    Without constant/couplingProperties it is interFoam: every stock case runs unmodified with the same result.
    Equations, dictionary and limits: foam_coupling/doc/frazilFoam.md.
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "CMULES.H"
#include "subCycle.H"
#include "immiscibleIncompressibleTwoPhaseMixture.H"
#include "turbulentTransportModel.H"
#include "pimpleControl.H"
#include "fvOptions.H"
#include "CorrectPhi.H"
#include "fvcSmooth.H"
#include "alphaScheme.H"
#include "bodyCellSize.H"
#include "bodyLoads.H"
#include "checkCoupledCase.H"
#include "flowAtParticles.H"
#include "fluidCoupling.H"
#include "joinPair.H"
#include "momentumBudget.H"
#include "openVolume.H"
#include "stepLength.H"

int main(int argc, char *argv[])
{
    joinPair(argc, argv);

    argList::addNote("Water, air, particles and immersed rigid bodies; interFoam without constant/couplingProperties");

    #include "postProcess.H"

    #include "addCheckCaseOptions.H"
    #include "setRootCaseLists.H"
    #include "createSolver.H"

    Info<< "\nStarting time loop\n" << endl;

    while (runTime.run())
    {
        #include "chooseDeltaT.H"

        autoPtr<flowOnParticles> flow;
        if (coupling.valid())
        {
            #include "beginStep.H"
        }

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        if (coupling.valid())
        {
            coupling->update(flow());
            open.update();
            open.correctFlux(phi, p_rgh, pimple);
        }

        #include "solveStep.H"

        if (coupling.valid())
        {
            #include "endStep.H"
        }

        runTime.write();
        runTime.printExecutionTime(Info);
    }

    if (coupling.valid())
    {
        coupling->finish();
    }

    Info<< "End\n" << endl;

    return 0;
}
