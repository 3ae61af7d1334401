/*---------------------------------------------------------------------------*\
    Frazil: LIGGGHTS-OpenFOAM coupling. GPL-3.0-or-later, see LICENSE.

Application
    partsOnMesh

Description
    One part of frazilFoam on a real mesh, chosen by -part: against closed forms (a fatal error at the first
    difference), or as the case's dictionaries have it, for run.py to read.
\*---------------------------------------------------------------------------*/

#include "parts.H"
#include "checkCoupledCase.H"

#include <exception>
#include <map>
#include <string>

namespace Foam
{

surfaceScalarField fluxOf(const fvMesh& mesh, const knownVelocity& u)
{
    surfaceScalarField phi("phi", mesh.magSf()*dimensionedScalar(dimVelocity, Zero));
    phi.setOriented();
    forAll(phi, facei)
    {
        phi[facei] = u(mesh.Cf()[facei]) & mesh.Sf()[facei];
    }
    for (fvsPatchScalarField& patch : phi.boundaryFieldRef())
    {
        forAll(patch, i)
        {
            patch[i] = u(patch.patch().Cf()[i]) & patch.patch().Sf()[i];
        }
    }
    return phi;
}


boolList deep(const fvMesh& mesh, const label layers)
{
    const plainMesh plain(mesh);
    labelList inner(mesh.nCells(), 1);
    for (label layer = 0; layer < layers; ++layer)
    {
        labelList next(inner);
        const List<label> wide(plain.cells(Field<label>(inner)));
        for (const plainFace& f : plain.faces())
        {
            const bool outer = f.boundary || !wide[f.owner] || !wide[f.neighbour];
            next[f.owner] = outer ? 0 : next[f.owner];
            if (outer && f.neighbour < mesh.nCells())
            {
                next[f.neighbour] = 0;
            }
        }
        inner = next;
    }
    boolList result(mesh.nCells(), false);
    forAll(result, celli)
    {
        result[celli] = inner[celli];
    }
    return result;
}


//- The parts that compare with closed forms on a mesh that stands still
const std::map<std::string, void (*)(const fvMesh&)> closedForms
{
    {"pressureGradient", testPressureGradient},
    {"flowAtParticles", testFlowAtParticles},
    {"compression", testCompression},
    {"faceMax", testFaceMax},
    {"bodyCellSize", testBodyCellSize}
};


void run(const word& part, Time& runTime, dynamicFvMesh& mesh, const argList& args)
{
    if (part == "accelerationShare")
    {
        testAccelerationShare(runTime, mesh);
    }
    else if (part == "offCentring")
    {
        printOffCentring(runTime, mesh, args.getOrDefault<label>("subCycles", 1));
    }
    else if (part == "coupledCase")
    {
        checkCoupledCase(mesh, args.found("localTime"));
        Info<< "accepted" << endl;
    }
    else
    {
        closedForms.at(part)(mesh);
    }
}

} // End namespace Foam


int main(int argc, char* argv[])
{
    argList::addOption("part", "name", "what to test");
    argList::addOption("subCycles", "N", "for offCentring");
    argList::addBoolOption("localTime", "for coupledCase: as if the case had local time steps");
    #include "setRootCase.H"
    #include "createTime.H"
    autoPtr<dynamicFvMesh> mesh(dynamicFvMesh::New(args, runTime));
    try
    {
        run(args.get<word>("part"), runTime, mesh(), args);
    }
    catch (const std::exception& error)
    {
        FatalErrorInFunction << error.what() << exit(FatalError);
    }
    Info<< "End" << endl;
    return 0;
}


// ************************************************************************* //
