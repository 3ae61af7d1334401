#include "momentumBudget.H"
#include "bodyLoads.H"
#include "immersedBodies.H"
#include "openVolume.H"

namespace Foam
{

namespace
{

//- Σ over the domain's boundary of weight times what a matrix takes out of the cells there
vector throughBoundary(const fvVectorMatrix& M, const volVectorField& U, const scalarField& weight)
{
    vector sum(Zero);
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        if (pU.coupled())
        {
            continue;
        }
        const labelUList& cells = pU.patch().faceCells();
        forAll(pU, i)
        {
            const vector& inside = U[cells[i]];
            sum += weight[cells[i]]
               *(cmptMultiply(M.internalCoeffs()[patchi][i], inside) - M.boundaryCoeffs()[patchi][i]);
        }
    }
    return returnReduce(sum, sumOp<vector>());
}


//- Σ p S over the domain's boundary [N]
vector pressureOnBoundary(const surfaceScalarField& pf)
{
    const fvMesh& mesh = pf.mesh();
    vector sum(Zero);
    forAll(pf.boundaryField(), patchi)
    {
        const fvsPatchScalarField& ppf = pf.boundaryField()[patchi];
        if (!ppf.coupled() && ppf.size())
        {
            sum += Foam::sum(ppf*mesh.Sf().boundaryField()[patchi]);
        }
    }
    return returnReduce(sum, sumOp<vector>());
}

vector total(const std::vector<frazil::BodyLoad>& loads)
{
    vector sum(Zero);
    for (const frazil::BodyLoad& load : loads)
    {
        sum += vector(load.force[0], load.force[1], load.force[2]);
    }
    return sum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

momentumBudget::momentumBudget(const openVolume& open)
:
    open_(open),
    outflow_(Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const tmp<fvVectorMatrix>& momentumBudget::keepStress(const tmp<fvVectorMatrix>& tviscous)
{
    if (open_.active())
    {
        viscous_.reset(new fvVectorMatrix(tviscous()));
    }
    return tviscous;
}


void momentumBudget::keep(const fvVectorMatrix& UEqn)
{
    if (open_.active())
    {
        diag_ = UEqn.diag();
        source_ = UEqn.source();
    }
}


void momentumBudget::evaluate(const fvVectorMatrix& UEqn, const volVectorField& U)
{
    const scalarField& V = U.mesh().V();

    stress_.reset((-(viscous_() & U)).ptr());
    inertia_.reset((UEqn & U).ptr());
    inertia_().primitiveFieldRef() -=
        ((UEqn.diag() - diag_)*U.primitiveField() - (UEqn.source() - source_))/V;
    outflow_ =
        throughBoundary(UEqn, U, scalarField(V.size(), 1))
      - throughBoundary(viscous_(), U, open_.fraction().primitiveField());
}


void momentumBudget::balance(const fluidForces& forces)
{
    byBodies_.reset
    (
        (inertia_() - open_.fraction()*(forces.weight() + forces.tension() - forces.gradP())).ptr()
    );
    byBodies_().primitiveFieldRef() -= forces.particles;
}


scalarField momentumBudget::outsideBodies(const immersedBodies* bodies) const
{
    scalarField outside(open_.fraction().size(), 1);
    if (bodies)
    {
        outside -= bodies->gamma().primitiveField();
    }
    return outside;
}


vector momentumBudget::splitting(const immersedBodies* bodies) const
{
    const scalarField& V = open_.fraction().mesh().V();
    vector sum(Zero);
    forAll(V, celli)
    {
        if (!bodies || bodies->bodyOf()[celli] < 0)
        {
            sum += V[celli]*byBodies_()[celli];
        }
    }
    return returnReduce(sum, sumOp<vector>());
}


vector momentumBudget::gradient
(
    const surfaceScalarField& pf,
    const volVectorField& gradP,
    const immersedBodies* bodies
) const
{
    const scalarField taken(outsideBodies(bodies)*pf.mesh().V());
    vector sum(Zero);
    forAll(taken, celli)
    {
        if (!bodies || !touchedByBody(*bodies, celli))
        {
            sum += pressureNotTaken(pf, taken[celli]*gradP[celli], celli);
        }
    }
    return returnReduce(sum, sumOp<vector>());
}


void momentumBudget::report
(
    const volVectorField& U,
    const volScalarField& p,
    const fluidForces& forces,
    const immersedBodies* bodies,
    const std::vector<frazil::BodyLoad>& loads
) const
{
    const scalarField& V = U.mesh().V();
    const scalarField& epsilon = open_.fraction().primitiveField();
    const vectorField& stress = stress_().primitiveField();
    const surfaceScalarField pf(fvc::interpolate(p));
    const scalarField byParticles(outsideBodies(bodies) - epsilon);

    const vector change = gSum(V*open_.momentumChange(U));
    const vector boundary = gSum(V*stress) - outflow_ - pressureOnBoundary(pf);
    const vector weight = gSum(V*epsilon*forces.weight().primitiveField());
    const vector tension = gSum(V*epsilon*forces.tension().primitiveField());
    const vector particles = gSum(V*forces.particles);
    const vector solid = gSum(V*byParticles*(forces.gradP().primitiveField() - stress));
    const vector byBodies = -total(loads);
    const vector split = splitting(bodies);
    const vector grad = -gradient(pf, forces.gradP(), bodies);
    const vector error = change - (boundary + weight + tension + particles + solid + byBodies + split + grad);

    Info<< "Momentum budget: change " << change << " boundary " << boundary << " weight " << weight
        << " tension " << tension << " particles " << particles << " solid " << solid << " bodies " << byBodies
        << " splitting " << split << " gradient " << grad << " error " << error << endl;
}

} // End namespace Foam
