/*---------------------------------------------------------------------------*\
Application
    bodyGeometry

Description
    Moves the immersed bodies of a case through its mesh, checks in every step
    what immersedBodies guarantees, and prints sums that must not depend on the
    number of ranks. Ends with a fatal error at the first broken guarantee.

    -refine: the mesh is treated as new in each step, as after refinement
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "cpuTime.H"
#include "follow.H"
#include "immersedBodies.H"
#include "bodyCellSize.H"
#include "syncTools.H"

#include <exception>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Edge of the finest cell that a body cuts [m]
scalar finest(const immersedBodies& bodies, const fvMesh& mesh)
{
    scalar least = GREAT;
    for (label i = 0; i < bodies.size(); ++i)
    {
        least = min(least, finestCut(mesh, bodies.cutOf(i)));
    }
    return least;
}


void require(const bool holds, const char* what)
{
    if (returnReduce(!holds, orOp<bool>()))
    {
        FatalErrorInFunction << "does not hold: " << what << exit(FatalError);
    }
}


//- θ of all faces of the rank, boundary included
scalarField onAllFaces(const surfaceScalarField& theta)
{
    const fvMesh& mesh = theta.mesh();
    scalarField all(mesh.nFaces(), 1);
    forAll(theta, facei)
    {
        all[facei] = theta[facei];
    }
    forAll(theta.boundaryField(), patchi)
    {
        const fvsPatchScalarField& ptheta = theta.boundaryField()[patchi];
        forAll(ptheta, i)
        {
            all[ptheta.patch().start() + i] = ptheta[i];
        }
    }
    return all;
}


void checkGuarantees(const immersedBodies& bodies)
{
    const fvMesh& mesh = bodies.gamma().mesh();
    const scalarField& end = bodies.gamma().primitiveField();
    const scalarField& start = bodies.gamma().oldTime().primitiveField();
    const scalarField theta(onAllFaces(bodies.theta()));

    require(min(end) >= 0 && max(end) <= 1, "0 <= gamma <= 1");
    require(min(theta) >= 0 && max(theta) <= 1, "0 <= theta <= 1");

    scalarField other(SubList<scalar>(theta, mesh.nFaces() - mesh.nInternalFaces(), mesh.nInternalFaces()));
    syncTools::swapBoundaryFaceList(mesh, other);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        for (label i = 0; patch.coupled() && i < patch.size(); ++i)
        {
            const label facei = patch.start() + i;
            require(theta[facei] == other[facei - mesh.nInternalFaces()], "theta equal on both sides");
        }
    }

    bool solidIsClosed = true, openIsOpen = true;
    forAll(mesh.cells(), celli)
    {
        scalar open = 0;
        for (const label facei : mesh.cells()[celli])
        {
            open = max(open, theta[facei]);
        }
        const bool solid = start[celli] == 1 && end[celli] == 1;
        solidIsClosed = solidIsClosed && (!solid || open == 0);
        openIsOpen = openIsOpen && (solid || open >= 5e-5);
    }
    require(solidIsClosed, "a cell solid at both ends is closed");
    require(openIsOpen, "a cell open at either end has an open face");
}


void report(const immersedBodies& bodies, const volScalarField& alpha1)
{
    const fvMesh& mesh = alpha1.mesh();
    const scalarField& gamma = bodies.gamma().primitiveField();
    const scalarField& V = mesh.V();
    const scalar volume = gSum(scalarField(gamma*V));
    const scalar old = gSum(scalarField(bodies.gamma().oldTime().primitiveField()*V));
    const scalarField theta(onAllFaces(bodies.theta()));

    scalar openArea = 0, distance = 0;
    vector normal(Zero);
    forAll(mesh.cells(), celli)
    {
        for (const label facei : mesh.cells()[celli])
        {
            openArea += theta[facei]*mag(mesh.faceAreas()[facei]);
        }
        if (bodies.bodyOf()[celli] >= 0)
        {
            distance += mag(bodies.distance()[celli])*V[celli];
            // In cut cells only: in the middle of a body round-off decides
            normal += gamma[celli]*(1 - gamma[celli])*bodies.normal()[celli]*V[celli];
        }
    }
    reduce(openArea, sumOp<scalar>());
    reduce(distance, sumOp<scalar>());
    reduce(normal, sumOp<vector>());

    Info<< "sums " << volume << ' ' << old << ' '
        << gSum(scalarField(sqr(gamma)*V)) << ' ' << openArea << ' '
        << distance << ' ' << normal.x() << ' ' << normal.y() << ' '
        << normal.z();
    for (label i = 0; i < bodies.size(); ++i)
    {
        Info<< ' ' << bodies.volume(i) << ' ' << bodies.volumeCut(i)
            << ' ' << bodies.submergedShare(i, alpha1, vector(0, 0, 1));
    }
    Info<< endl;
}


void run
(
    Time& runTime,
    const fvMesh& mesh,
    const label steps,
    const bool refine
)
{
    const IOdictionary properties
    (
        IOobject("couplingProperties", runTime.constant(), mesh, IOobject::MUST_READ)
    );
    immersedBodies bodies(mesh, properties.subDict("bodies"));

    const volScalarField alpha1
    (
        IOobject("alpha.water", runTime.timeName(), mesh),
        pos(dimensionedScalar("level", dimLength, 0.02) - mesh.C().component(2))
    );

    const vector velocity(properties.get<vector>("velocity"));
    const vector omega(properties.get<vector>("omega"));
    std::vector<frazil::BodyState> states(bodies.asLoaded());
    for (frazil::BodyState& state : states)
    {
        state.velocity = toVec3(velocity);
        state.angularVelocity = toVec3(omega);
    }
    bodies.place(states);
    checkGuarantees(bodies);
    report(bodies, alpha1);

    scalar spent = 0;
    for (label step = 0; step < steps; ++step)
    {
        ++runTime;
        const scalar deltaT = 0.3*finest(bodies, mesh)/(mag(velocity) + mag(omega)*0.02); // no point is 20 mm off the centre
        const scalarField last(bodies.gamma().primitiveField());
        cpuTime clock;
        if (refine)
        {
            bodies.updateMesh();
        }
        bodies.move(states, deltaT);
        spent += clock.cpuTimeIncrement();

        require(max(mag(bodies.gamma().oldTime().primitiveField() - last)) == 0, "old gamma is the last one");
        checkGuarantees(bodies);
        report(bodies, alpha1);
        follow(states, bodies);
    }
    const scalarField& gamma = bodies.gamma().primitiveField();
    const scalar nCut = gSum(scalarField(pos(gamma)*pos(1 - gamma)));
    Info<< "CPU time per step " << 1000*spent/max(steps, label(1)) << " ms, near cells "
        << returnReduce(bodies.size() ? bodies.cutOf(0).cells.size() : 0, sumOp<label>())
        << ", cut cells " << nCut << endl;
}


// * * * * * * * * * * * * * * * * * Main  * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    argList::addOption("steps", "N", "steps to take, default 20");
    argList::addBoolOption("refine", "treat the mesh as new in each step");
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    IOstream::defaultPrecision(12);
    Info().precision(12);
    try
    {
        run
        (
            runTime,
            mesh,
            args.getOrDefault<label>("steps", 20),
            args.found("refine")
        );
    }
    catch (const std::exception& error)
    {
        // Returning from main would end with code 0: argList's destructor exits
        FatalErrorInFunction << error.what() << exit(FatalError);
    }
    Info<< "End" << endl;
    return 0;
}


// ************************************************************************* //
