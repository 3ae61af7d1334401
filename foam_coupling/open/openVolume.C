#include "openVolume.H"
#include "immersedBodies.H"
#include "gaussConvectionScheme.H"
#include "pimpleControl.H"
#include "upwind.H"
#include "fixedValueFvPatchFields.H"
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


//- Least ε [-] that MULES divides by, in cells that are closed
const scalar divisible = 1e-9;

//- Least ε [-] in the pressure equation's cell coefficient; the faces of such a cell are closed
const scalar divisiblePressure = 1e-6;


//- Set value and old value of the current time index
void setWithOld(volScalarField& vf, const volScalarField& old, const volScalarField& now)
{
    vf.oldTime() == old;
    vf == now;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

tmp<surfaceScalarField> openVolume::faceMax(const volScalarField& vf) const
{
    tmp<surfaceScalarField> tmax(fvc::interpolate(vf));
    surfaceScalarField& fmax = tmax.ref();

    forAll(fmax, facei)
    {
        fmax[facei] = max(vf[mesh_.owner()[facei]], vf[mesh_.neighbour()[facei]]);
    }
    forAll(fmax.boundaryField(), patchi)
    {
        const fvPatchScalarField& pvf = vf.boundaryField()[patchi];
        fmax.boundaryFieldRef()[patchi] =
            pvf.coupled()
          ? max(pvf.patchInternalField(), pvf.patchNeighbourField())
          : pvf.patchInternalField();
    }
    return tmax;
}


void openVolume::setFaces()
{
    faces_() == fvc::interpolate(*fluidFraction_);
    merged_() == dimensionedScalar(dimless, Zero);

    if (bodies_)
    {
        solid_() == neg(max(start_(), end_()) - divisible);
        faces_() *= bodies_->theta()*(1.0 - faceMax(solid_()));
        small_() == neg(min(start_(), end_()) - smallCell*(*fluidFraction_));
        mergeSmallCells();
    }
}


void openVolume::mergeSmallCells()
{
    const volScalarField least(min(start_(), end_())/(*fluidFraction_));
    const volScalarField share((1.0 - solid_())*sqr(max(1.0 - least/smallCell, scalar(0))));
    const volVectorField& normal = bodies_->normal();
    const surfaceVectorField Sf(mesh_.Sf()/mesh_.magSf());
    surfaceScalarField& merged = merged_();

    // From the small cell to its neighbour on the fluid's side of the surface, weighted by the angle
    auto conductance = [](const scalar share, const scalar cosine)
    {
        return share*sqr(max(cosine, scalar(0)));
    };

    forAll(merged, facei)
    {
        const label own = mesh_.owner()[facei];
        const label nei = mesh_.neighbour()[facei];
        merged[facei] =
            conductance(share[own], normal[own] & Sf[facei])
          + conductance(share[nei], -(normal[nei] & Sf[facei]));
    }
    forAll(merged.boundaryField(), patchi)
    {
        if (!mesh_.boundary()[patchi].coupled())
        {
            continue;
        }
        const scalarField own(share.boundaryField()[patchi].patchInternalField());
        const scalarField nei(share.boundaryField()[patchi].patchNeighbourField());
        const vectorField ownNormal(normal.boundaryField()[patchi].patchInternalField());
        const vectorField neiNormal(normal.boundaryField()[patchi].patchNeighbourField());
        const vectorField& pSf = Sf.boundaryField()[patchi];
        forAll(own, i)
        {
            merged.boundaryFieldRef()[patchi][i] =
                conductance(own[i], ownNormal[i] & pSf[i]) + conductance(nei[i], -(neiNormal[i] & pSf[i]));
        }
    }
    merged *= 1.0 - faceMax(solid_());
}


tmp<volScalarField> openVolume::anchoring() const
{
    return max(1.0 - 10.0*end_(), scalar(0));
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

    update();
    start_() == end_();
    wholeStep();
    setFaces();
    rhoE_() == end_()*rho;
    rhoE_().oldTime();
    wholeFlux_().oldTime();
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


tmp<surfaceScalarField> openVolume::potentialFlux
(
    const surfaceScalarField* phi,
    const scalarField& demand,
    const volScalarField& p_rgh,
    pimpleControl& pimple
) const
{
    wordList types(p_rgh.boundaryField().size(), zeroGradientFvPatchScalarField::typeName);
    forAll(types, patchi)
    {
        if (p_rgh.boundaryField()[patchi].fixesValue())
        {
            types[patchi] = fixedValueFvPatchScalarField::typeName;
        }
    }
    volScalarField pcorr
    (
        IOobject("pcorr", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(p_rgh.dimensions(), Zero),
        types
    );
    mesh_.setFluxRequired(pcorr.name());

    const surfaceScalarField unit
    (
        IOobject("unit", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("unit", dimTime/dimDensity, 1.0)
    );
    const tmp<surfaceScalarField> conductance(faceCoefficient(unit));

    // In a tank without an outlet the level is free: held in one cell of all, as setRefCell does. Held on every rank,
    // volume would flow between the ranks' cells
    const label refCell = Pstream::master() ? 0 : -1;
    tmp<surfaceScalarField> tflux(new surfaceScalarField("potentialFlux", 0*wholeFlux_()));

    while (pimple.correctNonOrthogonal())
    {
        fvScalarMatrix pcorrEqn(fvm::laplacian(conductance(), pcorr));
        if (phi)
        {
            pcorrEqn -= fvc::div(*phi);
        }
        pcorrEqn.source() -= demand;
        anchorPressure(pcorrEqn, pcorr, unit);
        pcorrEqn.setReference(refCell, 0);
        pcorrEqn.solve(mesh_.solver(pcorr.select(pimple.finalNonOrthogonalIter())));

        if (pimple.finalNonOrthogonalIter())
        {
            tflux.ref() = -pcorrEqn.flux();
        }
    }
    return tflux;
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
    phi += potentialFlux(&phi, sweptVolume(), p_rgh, pimple);

    if (bodies_)
    {
        cuttingFlux_() = potentialFlux(nullptr, cuttingDemand(), p_rgh, pimple);
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


scalar openVolume::courantNumber(const surfaceScalarField& phi) const
{
    const scalarField rate(fvc::surfaceSum(mag(phi))().primitiveField());
    return 0.5*gMax(rate/(mesh_.V()*fluidFraction_->primitiveField()))*mesh_.time().deltaTValue();
}


void openVolume::anchor(fvVectorMatrix& UEqn, const volScalarField& rho, const volVectorField& U) const
{
    if (bodies_)
    {
        const volScalarField coefficient(anchoring()*rho/mesh_.time().deltaT());
        UEqn += fvm::Sp(coefficient, U) - coefficient*U;
    }
}


void openVolume::anchorPressure
(
    fvScalarMatrix& pEqn,
    const volScalarField& p_rgh,
    const surfaceScalarField& rAUf
) const
{
    if (bodies_)
    {
        const scalarField anchored
        (
            solid_().primitiveField()
           *fvc::surfaceSum(rAUf*mesh_.magSf()*mesh_.deltaCoeffs())().primitiveField()
        );
        pEqn.diag() -= anchored;
        pEqn.source() -= anchored*p_rgh.primitiveField();
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
    anchorPressure(pEqn, p_rgh, rAUf);
}


template<class Type>
void openVolume::extend(GeometricField<Type, fvPatchField, volMesh>& vf, const scalarField& closed) const
{
    const volVectorField& normal = bodies_->normal();

    for (label sweep = 0; sweep < nExtensionLayers; ++sweep)
    {
        vf.correctBoundaryConditions();
        Field<Type> sum(mesh_.nCells(), Zero);
        scalarField weights(mesh_.nCells(), Zero);

        auto take = [&](const label celli, const Type& value, const scalar outward)
        {
            if (closed[celli] > 0.5 && outward > 0)
            {
                sum[celli] += outward*value;
                weights[celli] += outward;
            }
        };

        for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
        {
            const label own = mesh_.owner()[facei];
            const label nei = mesh_.neighbour()[facei];
            const vector& S = mesh_.Sf()[facei];
            take(own, vf[nei], normal[own] & S);
            take(nei, vf[own], -(normal[nei] & S));
        }
        for (const fvPatchField<Type>& pvf : vf.boundaryField())
        {
            if (pvf.coupled())
            {
                const Field<Type> other(pvf.patchNeighbourField());
                forAll(other, i)
                {
                    const label celli = pvf.patch().faceCells()[i];
                    take(celli, other[i], normal[celli] & pvf.patch().Sf()[i]);
                }
            }
        }
        forAll(sum, celli)
        {
            if (weights[celli] > 0)
            {
                vf[celli] = sum[celli]/weights[celli];
            }
        }
    }
    vf.correctBoundaryConditions();
}


void openVolume::extendIntoBodies(volScalarField& vf) const
{
    if (active() && bodies_)
    {
        extend(vf, closedAtEnd());
    }
}


void openVolume::extendPressure(volScalarField& p_rgh) const
{
    if (active() && bodies_)
    {
        extend(p_rgh, solid_());
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
    extend(U, solid_());

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
