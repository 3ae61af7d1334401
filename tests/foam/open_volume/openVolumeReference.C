/*---------------------------------------------------------------------------*\
    Frazil: LIGGGHTS-OpenFOAM coupling. GPL-3.0-or-later, see LICENSE.

Application
    openVolumeReference

Description
    Moves the bodies of a case through its mesh, with an αf, a flow and a pressure that vary in space and time, and
    compares in every step what openVolume and its files compute with the slow reference (openReference.H). Then the
    same without bodies, and without anything. Ends with a fatal error at the first difference.

    Nothing is solved in time: each step's fields are functions of place and step.

    -closed: a tank without an outlet, αf the same everywhere, so that the bodies' motion asks for no volume on the whole
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "pimpleControl.H"
#include "follow.H"
#include "immersedBodies.H"
#include "openVolume.H"
#include "faceMax.H"
#include "potentialFlux.H"

#include <exception>

#include "compare.H"
#include "openTest.H"

namespace Foam
{

//- Relative; round-off of sums over some faces, and what a solver of linear equations leaves
constexpr scalar exact = 1e-12;
constexpr scalar solved = 1e-11;


// * * * * * * * * * * * * * * * The comparisons * * * * * * * * * * * * * * //

void openTest::takeState()
{
    const scalarField none(f_.mesh.nCells(), Zero);
    const vectorField noVector(f_.mesh.nCells(), Zero);
    state_.fluidStart = mesh_.cells(f_.fluidFraction.oldTime().primitiveField());
    state_.fluid = mesh_.cells(f_.fluidFraction.primitiveField());
    state_.gammaStart = mesh_.cells(bodies_ ? bodies_->gamma().oldTime().primitiveField() : none);
    state_.gamma = mesh_.cells(bodies_ ? bodies_->gamma().primitiveField() : none);
    state_.Ub = mesh_.cells(bodies_ ? bodies_->Ub().primitiveField() : noVector);
    state_.normal = mesh_.cells(bodies_ ? bodies_->normal().primitiveField() : noVector);
    state_.distance = bodies_ ? mesh_.cells(bodies_->distance().primitiveField()) : none;
    state_.slips = slips();
    state_.theta = bodies_ ? mesh_.onFaces(bodies_->theta()) : scalarField(f_.mesh.nFaces(), 1);
    state_.V = f_.mesh.V();
    state_.deltaT = f_.mesh.time().deltaTValue();
}


//- The step has cells of every kind
void openTest::checkCoverage() const
{
    label solid = 0, cut = 0, small = 0, opens = 0;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        const scalar least = 1 - max(state_.gammaStart[celli], state_.gamma[celli]);
        solid += reference_.solid()[celli];
        cut += least > 0 && least < 1;
        small += least > 0 && least < 0.3;
        opens += state_.gammaStart[celli] == 1 && state_.gamma[celli] < 1;
    }
    for (label* n : {&solid, &cut, &small, &opens})
    {
        reduce(*n, sumOp<label>());
        require(*n > 0, "the step has cells of every kind");
    }
    Info<< "    cells: " << solid << " solid, " << cut << " cut, " << small << " small, " << opens << " opening" << endl;
}


void openTest::checkCells()
{
    const scalarField start(reference_.epsilonStart());
    const scalarField end(reference_.epsilon());
    compare("fraction", open_.fraction().primitiveField(), end, exact);
    compare("epsilon of the step", open_.epsilon().primitiveField(), max(end, scalar(1e-9))(), exact);

    open_.partOfStep(1, 4);
    compare("epsilon after half of it", open_.epsilon().primitiveField(), max(0.5*(start + end), scalar(1e-9))(), exact);
    compare("epsilon after a quarter", open_.epsilon().oldTime().primitiveField(),
        max(0.75*start + 0.25*end, scalar(1e-9))(), exact);
    open_.wholeStep();
    compare("epsilon at its start", open_.epsilon().oldTime().primitiveField(), max(start, scalar(1e-9))(), exact);

    const scalarField weight(max(end, scalar(1e-6)));
    const scalarField weighted(weight*f_.rho.primitiveField());
    compare("inCells, scalar", open_.inCells(f_.rho)().primitiveField(), weighted, exact);
    compare("inCells, temporary", open_.inCells(tmp<volScalarField>(1.0*f_.rho))().primitiveField(), weighted, exact);
    compare("inCells, vector", open_.inCells(tmp<volVectorField>(1.0*f_.U))().primitiveField(),
        (end*f_.U.primitiveField())(), exact);
}


void openTest::checkSums()
{
    const scalarField end(reference_.epsilon());
    const scalarField open(end*state_.V);
    const scalarField phi(mesh_.onFaces(f_.phi));
    compare("mean", open_.mean(f_.alpha), gSum(scalarField(open*f_.alpha))/gSum(open), exact);
    compare("courantNumber", open_.courantNumber(f_.phi), reference_.courantNumber(phi), exact);

    // Relative to the sum of magnitudes: the defects of a closed tank sum up to nothing
    const scalarField defect(mesh_.outflow(phi) - reference_.sweptVolume());
    const scalar local = state_.deltaT*gSumMag(defect)/gSum(state_.V);
    const scalar global = state_.deltaT*gSum(defect)/gSum(state_.V);
    scalar cumulative = local;
    open_.reportContinuity(f_.phi, cumulative);
    compare("reportContinuity", cumulative, local + global, exact);
}


void openTest::checkMomentumInCells()
{
    const scalarField start(reference_.epsilonStart());
    const scalarField end(reference_.epsilon());
    const volScalarField& density = open_.density(f_.rho);
    const scalarField now(end*f_.rho.primitiveField());
    const scalarField before(start*f_.rho.oldTime().primitiveField());
    compare("density", density.primitiveField(), now, exact);
    compare("density at the start", density.oldTime().primitiveField(), before, exact);
    compare("momentumChange", open_.momentumChange(f_.U)(),
        vectorField((now*f_.U.primitiveField() - before*f_.U.oldTime().primitiveField())/state_.deltaT), exact);

    const dimensionedScalar nu("nu", dimViscosity, 1);
    const volVectorField force(fvm::laplacian(nu, f_.U) & f_.U);
    const volVectorField inOpen(open_.inCells(fvm::laplacian(nu, f_.U)) & f_.U);
    compare("inCells, matrix", inOpen.primitiveField(), (end*force.primitiveField())(), exact);
}


void openTest::checkFaces() const
{
    const scalarField open(reference_.openFaces());
    const scalarField rA(mesh_.onFaces(f_.rAUf));
    const scalarField phig(mesh_.onFaces(f_.phig));
    compare("throughFaces", onFaces(open_.throughFaces(1.0*f_.phig)), (open*phig)(), exact);
    compare("faceCoefficient", onFaces(open_.faceCoefficient(f_.rAUf)),
        ((open + reference_.mergedFaces())*rA)(), exact);
    compare("betweenLargeCells", onFaces(open_.betweenLargeCells(1.0*f_.phig)),
        (reference_.betweenLargeCells()*phig)(), exact);
    compare("reconstruct", open_.reconstruct(1.0*f_.phig)().primitiveField(), reference_.reconstruct(phig), exact);

    const scalarField wide(mesh_.cells(f_.alpha.primitiveField()));
    scalarField largest(f_.mesh.nFaces());
    forAll(largest, facei)
    {
        largest[facei] = max(wide[mesh_.faces()[facei].owner], wide[mesh_.faces()[facei].neighbour]);
    }
    compare("faceMax", onFaces(faceMax(f_.alpha)), largest, exact);
}


//- Σ φ = -V Δε/Δt after correctFlux, by a potential flux and no other
void openTest::checkCorrectedFlux()
{
    const scalarField conductance(reference_.openFaces() + reference_.mergedFaces());
    scalarField kept(mesh_.onFaces(f_.phi));
    forAll(kept, facei)
    {
        kept[facei] = conductance[facei] > 0 ? kept[facei] : 0;
    }
    surfaceScalarField phi(f_.phi);
    open_.correctFlux(phi, f_.p_rgh, pimple_);

    const scalarField swept(reference_.sweptVolume());
    compare("continuity after correctFlux", mesh_.outflow(mesh_.onFaces(phi)), swept, solved);
    compare("correctFlux", mesh_.onFaces(phi), (kept
      + reference_.potentialFlux(fixed(), (swept - mesh_.outflow(kept))()))(), solved);
}


//- The equation of pEqn.H: what closeFaces, faceCoefficient and addSweptVolume make of it conserves volume
void openTest::checkPressure()
{
    surfaceScalarField phi(f_.phiHbyA);
    open_.closeFaces(phi, f_.phig);
    const scalarField cutting(reference_.potentialFlux(fixed(), reference_.cuttingDemand()));
    compare("closeFaces", mesh_.onFaces(phi), (reference_.openFaces()*mesh_.onFaces(f_.phiHbyA)
      + reference_.mergedFaces()*mesh_.onFaces(f_.phig) + cutting)(), solved);

    volScalarField p(f_.p_rgh);
    fvScalarMatrix pEqn(fvm::laplacian(open_.faceCoefficient(f_.rAUf), p) == fvc::div(phi));
    open_.addSweptVolume(pEqn, p, f_.rAUf);
    pEqn.setReference(Pstream::master() ? 0 : -1, 0);
    pEqn.solve(f_.mesh.solver("p_rgh"));
    phi -= pEqn.flux();
    compare("continuity after the pressure", mesh_.outflow(mesh_.onFaces(phi)), reference_.sweptVolume(), solved);

    open_.setWholeFaceFlux(phi);
    compare("wholeFaceFlux", mesh_.onFaces(open_.wholeFaceFlux(f_.phi)), mesh_.onFaces(phi), exact);
}


void openTest::checkConvection() const
{
    const volVectorField got(open_.convection(f_.rhoPhi, f_.U) & f_.U);
    const scalarField rhoPhi(mesh_.onFaces(f_.rhoPhi));
    compare("convection", got.primitiveField(),
        reference_.convection(rhoPhi, mesh_.cells(f_.U.primitiveField())), exact);

    // What is implicit is upwind: a neighbour's coefficient is what flows in from it
    const tmp<fvVectorMatrix> matrix(open_.convection(f_.rhoPhi, f_.U));
    const scalarField inner(SubField<scalar>(rhoPhi, f_.mesh.nInternalFaces()));
    compare("convection, upper triangle", matrix().upper(), min(inner, scalar(0))(), exact);
    compare("convection, lower triangle", matrix().lower(), (-max(inner, scalar(0)))(), exact);
}


void openTest::checkAnchors() const
{
    const scalarField end(reference_.epsilon());
    fvVectorMatrix momentum(f_.U, dimForce);
    open_.anchor(momentum, f_.rho, f_.U);
    const scalarField held(max(1 - 10*end, scalar(0))*f_.rho.primitiveField()*state_.V/state_.deltaT);
    compare("anchor, diagonal", momentum.diag(), held, exact);
    compare("anchor, source", momentum.source(), (held*f_.U.primitiveField())(), exact);

    fvScalarMatrix pressure(f_.p_rgh, dimVolume/dimTime);
    open_.addSweptVolume(pressure, f_.p_rgh, f_.rAUf);
    const scalarField rA(mesh_.onFaces(f_.rAUf));
    scalarField anchored(f_.mesh.nCells(), Zero);
    const boolList solid(reference_.solid());
    forAll(anchored, celli)
    {
        for (const label facei : mesh_.facesOf(celli))
        {
            const plainFace& f = mesh_.faces()[facei];
            anchored[celli] += solid[celli] ? rA[facei]*f.area/f.distance : 0;
        }
    }
    compare("addSweptVolume, diagonal", pressure.diag(), (-anchored)(), exact);
    compare("addSweptVolume, source", pressure.source(),
        (-reference_.sweptVolume() - anchored*f_.p_rgh.primitiveField())(), exact);
}


void openTest::checkInsideBodies() const
{
    volScalarField alpha(f_.alpha);
    open_.extendIntoBodies(alpha);
    compare("extendIntoBodies", alpha.primitiveField(),
        reference_.continued(f_.alpha.primitiveField(), reference_.closed()), exact);

    volScalarField p(f_.p_rgh);
    open_.extendPressure(p);
    compare("extendPressure", p.primitiveField(),
        reference_.continued(f_.p_rgh.primitiveField(), reference_.solid()), exact);

    volVectorField U(f_.U);
    open_.blendWithBodies(U);
    compare("blendWithBodies", U.primitiveField(), reference_.blended(f_.U.primitiveField()), exact);
}


void openTest::check()
{
    takeState();
    checkCells();
    checkSums();
    checkMomentumInCells();
    checkFaces();
    checkCorrectedFlux();
    checkPressure();
    checkConvection();
    if (bodies_)
    {
        checkCoverage();
        checkAnchors();
        checkInsideBodies();
    }
}


//- Without particles and bodies every function hands on its argument
void checkInactive(const stepFields& f)
{
    openVolume open(f.mesh);
    const tmp<surfaceScalarField> flux(new surfaceScalarField(f.phig));
    const tmp<volVectorField> vectors(new volVectorField(f.U));
    require(!open.active() && !open.hasBodies(), "nothing is open or closed without use()");
    require(&open.density(f.rho) == &f.rho, "density is rho");
    require(&open.inCells(f.rho)() == &f.rho, "inCells is its argument");
    require(&open.inCells(vectors)() == &vectors(), "inCells of a vector is its argument");
    require(&open.throughFaces(flux)() == &flux(), "throughFaces is its argument");
    require(&open.betweenLargeCells(flux)() == &flux(), "betweenLargeCells is its argument");
    require(&open.faceCoefficient(f.rAUf)() == &f.rAUf, "faceCoefficient is its argument");
    require(&open.wholeFaceFlux(f.phi) == &f.phi, "wholeFaceFlux is phi");
}


// * * * * * * * * * * * * * * * * The steps * * * * * * * * * * * * * * * * //

//- Bodies where their files have them, moving as the case says
std::vector<frazil::BodyState> movingStates(const immersedBodies& bodies, const dictionary& properties)
{
    std::vector<frazil::BodyState> states(bodies.asLoaded());
    for (frazil::BodyState& state : states)
    {
        state.velocity = toVec3(properties.get<vector>("velocity"));
        state.angularVelocity = toVec3(properties.get<vector>("omega"));
    }
    return states;
}


//- The comparisons of a step, with bodies and without; in a closed tank nothing moves without them
void checkStep(stepFields& f, openVolume& both, openVolume& particles, const immersedBodies& bodies, pimpleControl& pimple)
{
    both.update();
    particles.update();
    Info<< "Particles and bodies" << endl;
    openTest(f, both, &bodies, pimple).check();
    if (!f.closed)
    {
        Info<< "Particles" << endl;
        openTest(f, particles, nullptr, pimple).check();
    }
}


void run(Time& runTime, const fvMesh& mesh, pimpleControl& pimple, const argList& args)
{
    const IOdictionary properties(IOobject("couplingProperties", runTime.constant(), mesh, IOobject::MUST_READ));
    // Made by all ranks at once, as frazilFoam's first gradients do; only ranks with a body's surface would ask for them
    mesh.nonOrthDeltaCoeffs();
    immersedBodies bodies(mesh, properties.subDict("bodies"));
    std::vector<frazil::BodyState> states(movingStates(bodies, properties));
    bodies.place(states);

    stepFields fields(mesh, args.found("closed"));
    openVolume both(mesh);
    openVolume particles(mesh);
    both.use(fields.fluidFraction, &bodies, fields.phi, fields.rho);
    particles.use(fields.fluidFraction, nullptr, fields.phi, fields.rho);
    for (label step = 1; step <= args.getOrDefault<label>("steps", 3); ++step)
    {
        ++runTime;
        Info<< "Step " << step << endl;
        fields.set(step);
        bodies.move(states, runTime.deltaTValue());
        checkStep(fields, both, particles, bodies, pimple);
        follow(states, bodies);
    }
    checkInactive(fields);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * * Main  * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    argList::addOption("steps", "N", "steps to take, default 3");
    argList::addBoolOption("closed", "a tank without an outlet");
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"
    pimpleControl pimple(mesh);
    try
    {
        run(runTime, mesh, pimple, args);
    }
    catch (const std::exception& error)
    {
        FatalErrorInFunction << error.what() << exit(FatalError);
    }
    Info<< "End" << endl;
    return 0;
}


// ************************************************************************* //
