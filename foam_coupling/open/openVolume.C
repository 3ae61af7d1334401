#include "openVolume.H"
#include "immersedBodies.H"
#include "faceMax.H"
#include "potentialFlux.H"
#include "smallCells.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{

namespace
{

//- An unregistered field of the mesh, so that nothing but the solver sees it
template<class Type>
autoPtr<GeometricField<Type, fvPatchField, volMesh>> cellField
(
    const word& name,
    const fvMesh& mesh,
    const dimensioned<Type>& value
)
{
    return autoPtr<GeometricField<Type, fvPatchField, volMesh>>
    (
        new GeometricField<Type, fvPatchField, volMesh>
        (
            IOobject(name, mesh.time().timeName(), mesh),
            mesh,
            value,
            zeroGradientFvPatchField<Type>::typeName
        )
    );
}


//- Set value and old value of the current time index
void setWithOld(volScalarField& vf, const volScalarField& old, const volScalarField& now)
{
    vf.oldTime() == old;
    vf == now;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void openVolume::setFaces()
{
    faces_() == fvc::interpolate(*fluidFraction_);
    merged_() == dimensionedScalar(dimless, Zero);

    if (bodies_)
    {
        solid_() == neg(max(start_(), end_()) - divisible);
        faces_() *= bodies_->theta()*(1.0 - faceMax(solid_()));
        const volScalarField least(1.0 - max(bodies_->gamma(), bodies_->gamma().oldTime()));
        small_() == neg(least - smallCell);
        mergeSmallCells(merged_(), least, smallCell, solid_(), bodies_->normal());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

openVolume::openVolume(const fvMesh& mesh)
:
    mesh_(mesh),
    bodies_(nullptr),
    fluidFraction_(nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void openVolume::use
(
    const volScalarField& fluidFraction,
    const immersedBodies* bodies,
    const surfaceScalarField& phi,
    const volScalarField& rho
)
{
    fluidFraction_ = &fluidFraction;
    bodies_ = bodies;
    makeFields(phi, rho);

    update();
    start_() == end_();
    wholeStep();
    setFaces();
    rhoE_() == end_()*rho;
    rhoE_().oldTime();
    wholeFlux_().oldTime();
}


void openVolume::makeFields(const surfaceScalarField& phi, const volScalarField& rho)
{
    const dimensionedScalar one("one", dimless, 1.0);
    epsilon_ = cellField("epsilon", mesh_, one);
    start_ = cellField("epsilonStart", mesh_, one);
    end_ = cellField("epsilonEnd", mesh_, one);
    solid_ = cellField("solid", mesh_, dimensionedScalar(dimless, Zero));
    small_ = cellField("small", mesh_, dimensionedScalar(dimless, Zero));
    faces_.reset(new surfaceScalarField("openFaces", fvc::interpolate(one*end_())));
    merged_.reset(new surfaceScalarField("mergedFaces", 0*faces_()));
    cuttingFlux_.reset(new surfaceScalarField("cuttingFlux", 0*phi));
    wholeFlux_.reset
    (
        new surfaceScalarField
        (
            IOobject("phiWhole", mesh_.time().timeName(), mesh_, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE), phi
        )
    );

    // Named as rho, so that the schemes of rho apply to it, but known to nobody
    rhoE_.reset
    (
        new volScalarField
        (
            IOobject("rho", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE, false),
            1.0*rho
        )
    );
}


void openVolume::update()
{
    // The old values, not end_ of the step before: at the very start particles and bodies have always been there, and
    // their volume must not be pushed out of the first step
    start_() == fluidFraction_->oldTime();
    end_() == *fluidFraction_;
    if (bodies_)
    {
        start_() == start_()*(1.0 - bodies_->gamma().oldTime());
        end_() == end_()*(1.0 - bodies_->gamma());
    }
    wholeStep();
    setFaces();
}


void openVolume::correctFlux
(
    surfaceScalarField& phi,
    const volScalarField& p_rgh,
    pimpleControl& pimple
)
{
    // What passed through faces that are closed now stays behind
    phi *= pos(faces_() + merged_());
    const tmp<surfaceScalarField> conductance(faceCoefficient(unitConductance(mesh_)()));
    const volScalarField* solid = bodies_ ? &solid_() : nullptr;
    phi += potentialFlux(conductance(), &phi, sweptVolume(), p_rgh, solid, pimple);

    if (bodies_)
    {
        cuttingFlux_() = potentialFlux(conductance(), nullptr, cuttingDemand(), p_rgh, solid, pimple);
    }
}


scalarField openVolume::sweptVolume() const
{
    return mesh_.V()*(start_().primitiveField() - end_().primitiveField())/mesh_.time().deltaTValue();
}


scalarField openVolume::cuttingDemand() const
{
    const surfaceScalarField rigid((1.0 - bodies_->theta())*(fvc::interpolate(bodies_->Ub()) & mesh_.Sf()));
    const volScalarField& gamma = bodies_->gamma();
    const scalarField cut((gamma.primitiveField() - gamma.oldTime().primitiveField())/mesh_.time().deltaTValue());
    return
        (1.0 - solid_().primitiveField())*fluidFraction_->primitiveField()*mesh_.V()
       *(cut + fvc::div(rigid)().primitiveField());
}


void openVolume::partOfStep(const label i, const label n)
{
    if (active())
    {
        const scalar from = scalar(i)/n;
        const scalar to = scalar(i + 1)/n;
        setWithOld
        (
            epsilon_(),
            max((1 - from)*start_() + from*end_(), divisible),
            max((1 - to)*start_() + to*end_(), divisible)
        );
    }
}


void openVolume::wholeStep()
{
    partOfStep(0, 1);
}


const volScalarField& openVolume::density(const volScalarField& rho)
{
    if (!active())
    {
        return rho;
    }
    rhoE_().oldTime() == start_()*rho.oldTime();
    rhoE_() == end_()*rho;
    return rhoE_();
}


tmp<vectorField> openVolume::momentumChange(const volVectorField& U) const
{
    return
        (
            rhoE_().primitiveField()*U.primitiveField()
          - rhoE_().oldTime().primitiveField()*U.oldTime().primitiveField()
        )/mesh_.time().deltaTValue();
}


scalar openVolume::mean(const volScalarField& vf) const
{
    if (!active())
    {
        return vf.weightedAverage(mesh_.Vsc()).value();
    }
    const scalarField open(end_().primitiveField()*mesh_.V());
    return gSum(open*vf.primitiveField())/gSum(open);
}


void openVolume::reportWater(const volScalarField& alpha) const
{
    if (active())
    {
        Info<< "Water volume = " << gSum(end_().primitiveField()*alpha.primitiveField()*mesh_.V()) << endl;
    }
}


tmp<volScalarField> openVolume::inCells(const volScalarField& vf) const
{
    return active() ? max(end_(), divisiblePressure)*vf : tmp<volScalarField>(vf);
}


tmp<volScalarField> openVolume::inCells(const tmp<volScalarField>& tvf) const
{
    return active() ? max(end_(), divisiblePressure)*tvf : tvf;
}


tmp<volVectorField> openVolume::inCells(const tmp<volVectorField>& tvf) const
{
    return active() ? end_()*tvf : tvf;
}


tmp<fvVectorMatrix> openVolume::inCells(const tmp<fvVectorMatrix>& tM) const
{
    return active() ? end_()*tM : tM;
}


tmp<volVectorField> openVolume::reconstruct(const tmp<surfaceScalarField>& tssf) const
{
    if (!active() || !bodies_)
    {
        return fvc::reconstruct(tssf);
    }

    // A face counts as far as it is open. Where a cell is about to close, the pressure that drives its last volume out
    // through a sliver is of no concern to the neighbour's velocity: in the sum its weight goes to zero. The floor keeps
    // the matrix invertible in cells with closed faces.
    const surfaceScalarField& theta = bodies_->theta();
    const surfaceVectorField normal(mesh_.Sf()/mesh_.magSf());
    tmp<volVectorField> tresult
    (
        new volVectorField
        (
            "reconstructed",
            inv(fvc::surfaceSum(max(theta, scalar(0.01))*normal*mesh_.Sf())) & fvc::surfaceSum(theta*normal*tssf)
        )
    );
    return tresult;
}


tmp<surfaceScalarField> openVolume::throughFaces(const tmp<surfaceScalarField>& tssf) const
{
    return active() ? faces_()*tssf : tssf;
}


tmp<surfaceScalarField> openVolume::betweenLargeCells(const tmp<surfaceScalarField>& tssf) const
{
    return active() && bodies_ ? (1.0 - faceMax(small_()))*tssf : tssf;
}


const surfaceScalarField& openVolume::wholeFaceFlux(const surfaceScalarField& phi) const
{
    return active() ? wholeFlux_() : phi;
}


void openVolume::setWholeFaceFlux(const surfaceScalarField& phiWhole)
{
    wholeFlux_() == phiWhole;
}


void openVolume::closeFaces(surfaceScalarField& phiHbyA, const surfaceScalarField& phig) const
{
    if (active())
    {
        phiHbyA = faces_()*phiHbyA + merged_()*phig + cuttingFlux_();
    }
}


tmp<surfaceScalarField> openVolume::faceCoefficient(const surfaceScalarField& rAUf) const
{
    return active() ? (faces_() + merged_())*rAUf : tmp<surfaceScalarField>(rAUf);
}


scalar openVolume::courantNumber(const surfaceScalarField& phi) const
{
    const scalarField rate(fvc::surfaceSum(mag(phi))().primitiveField());
    return 0.5*gMax(rate/(mesh_.V()*fluidFraction_->primitiveField()))*mesh_.time().deltaTValue();
}


} // End namespace Foam
