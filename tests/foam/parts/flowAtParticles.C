// particles/flowAtParticles.H: the flow on particles, from linear fields in every cell and from quadratic ones away from
// the boundary, where one-sided differences do not know the second derivative
#include "parts.H"
#include "flowAtParticles.H"
#include "fluidCoupling.H"
#include "immiscibleIncompressibleTwoPhaseMixture.H"
#include "openVolume.H"

namespace Foam
{

namespace
{

constexpr scalar exact = 1e-12;

const dimensionedVector g("g", dimAcceleration, vector(3, -9, 2));


surfaceScalarField heightOf(const fvMesh& mesh)
{
    return surfaceScalarField("ghf", g & mesh.Cf());
}


//- ∇p = ∇p_rgh + (g·x)∇ρ + ρ g
void testLinearPressure(const fvMesh& mesh)
{
    const knownScalar p{70, vector(300, -200, 500)};
    const knownScalar rho{600, vector(4000, 7000, -3000)};
    const openVolume open(mesh);
    const tmp<volVectorField> got
    (
        pressureGradient
        (
            open,
            fieldOf<scalar>("p_rgh", mesh, dimPressure, p),
            fieldOf<scalar>("rho", mesh, dimDensity, rho),
            heightOf(mesh),
            g
        )
    );
    const auto expected = [&](const point& x)
    {
        return p.gradient + (g.value() & x)*rho.gradient + rho(x)*g.value();
    };
    compare("pressure gradient", got().primitiveField(), atCentres<vector>(mesh, expected), exact);
}


//- A stratified fluid at rest: with ρ = ρ0 + β g·x and p_rgh = -β (g·x)²/2 on every face nothing but ρ g is left
void testFluidAtRest(const fvMesh& mesh)
{
    const scalar beta = 400;
    const auto p = [&](const point& x) { return -0.5*beta*sqr(g.value() & x); };
    const auto rho = [&](const point& x) { return 700 + beta*(g.value() & x); };
    const openVolume open(mesh);
    const tmp<volVectorField> got
    (
        pressureGradient
        (
            open,
            fieldOf<scalar>("p_rgh", mesh, dimPressure, p),
            fieldOf<scalar>("rho", mesh, dimDensity, rho),
            heightOf(mesh),
            g
        )
    );
    const auto weight = [&](const point& x) { return rho(x)*g.value(); };
    const boolList inner(deep(mesh, 1));
    compare("pressure gradient at rest", only(inner, got().primitiveField()),
        only(inner, atCentres<vector>(mesh, weight)), exact);
}


void testDerivatives(const fvMesh& mesh, const knownVelocity& u, const boolList& where, const std::string& what)
{
    const volVectorField U(fieldOf<vector>("U", mesh, dimVelocity, u));
    const auto change = [](const point& x) { return vector(1 + x.x(), -3*x.z(), 2); };
    const volVectorField ddtU(fieldOf<vector>("ddtU", mesh, dimAcceleration, change));
    const auto total = [&](const point& x) { return u.convected(x) + change(x); };
    const auto curl = [&](const point& x) { return u.curl(x); };
    compare("material derivative, " + what, only(where, materialDerivative(U, ddtU)().primitiveField()),
        only(where, atCentres<vector>(mesh, total)), exact);
    compare("vorticity, " + what, only(where, vorticity(U)().primitiveField()),
        only(where, atCentres<vector>(mesh, curl)), exact);
}


//- ∇·τ = μ [∇²u + ∇(∇·u) - 2/3 ∇(∇·u)], μ = ρν of water at rest
void testViscousForce(const fvMesh& mesh)
{
    const knownVelocity u(quadraticVelocity());
    const scalar nu = 1.79e-6;
    volVectorField U(fieldOf<vector>("U", mesh, dimVelocity, u));
    const surfaceScalarField phi("phi", fvc::flux(U));
    immiscibleIncompressibleTwoPhaseMixture mixture(U, phi);
    autoPtr<incompressible::turbulenceModel> turbulence(incompressible::turbulenceModel::New(U, phi, mixture));

    const knownScalar rho{700, Zero};
    const volScalarField density(fieldOf<scalar>("rho", mesh, dimDensity, rho));
    const auto force = [&](const point&) { return rho.value*nu*(u.laplacian() + u.gradDiv()/3); };
    const boolList inner(deep(mesh, 2));
    compare("viscous force", only(inner, viscousForce(turbulence(), density, U)().primitiveField()),
        only(inner, atCentres<vector>(mesh, force)), exact);
}

} // End anonymous namespace


void testPressureGradient(const fvMesh& mesh)
{
    testLinearPressure(mesh);
    testFluidAtRest(mesh);
}


void testFlowAtParticles(const fvMesh& mesh)
{
    testDerivatives(mesh, linearVelocity(), deep(mesh, 0), "linear");
    testDerivatives(mesh, quadraticVelocity(), deep(mesh, 1), "quadratic");
    testViscousForce(mesh);
}


//- A body that moves by itself: 0 in the cells of which it has more than half at the start or the end of the step
void testAccelerationShare(Time& runTime, const fvMesh& mesh)
{
    const knownVelocity rest{Zero, Zero, Zero};
    const volVectorField U(fieldOf<vector>("U", mesh, dimVelocity, rest));
    const surfaceScalarField phi("phi", fvc::flux(U));
    immiscibleIncompressibleTwoPhaseMixture mixture(U, phi);
    const uniformDimensionedVectorField gravity
    (
        IOobject("g", mesh.time().constant(), mesh, IOobject::MUST_READ, IOobject::NO_WRITE)
    );
    autoPtr<fluidCoupling> coupling(fluidCoupling::New(mesh, mixture, gravity));
    const scalarField one(mesh.nCells(), 1);
    const vectorField none(mesh.nCells(), Zero);
    runTime.setDeltaT(coupling->beginStep(runTime.deltaTValue()), false);
    ++runTime;
    coupling->update(flowOnParticles{one, one, one, none, none, none, none, none, scalarField()});

    const volScalarField& gamma = coupling->bodies()->gamma();
    scalarField expected(mesh.nCells());
    label uncovered = 0;
    forAll(expected, celli)
    {
        expected[celli] = gamma[celli] < 0.5 && gamma.oldTime()[celli] < 0.5;
        uncovered += gamma[celli] < 0.5 && gamma.oldTime()[celli] >= 0.5;
    }
    require(returnReduce(uncovered, sumOp<label>()) > 0, "the body has just left cells");
    compare("share of the acceleration", accelerationShare(coupling()), expected, 0);
}

} // End namespace Foam
