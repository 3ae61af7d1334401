#include "bodyLoads.H"
#include "immersedBodies.H"
#include "surfaceInterpolate.H"
#include "surfaceFields.H"

namespace Foam
{

namespace
{

//- Value of a face [-], or of the pressure there; zero on empty patches
scalar faceValue(const surfaceScalarField& sf, const label facei)
{
    const fvMesh& mesh = sf.mesh();
    if (mesh.isInternalFace(facei))
    {
        return sf[facei];
    }
    const label patchi = mesh.boundaryMesh().whichPatch(facei);
    const fvsPatchScalarField& patch = sf.boundaryField()[patchi];
    return patch.empty() ? 0 : patch[facei - mesh.boundaryMesh()[patchi].start()];
}


//- Does a body touch the cell or one of its faces over the step?
bool touched(const immersedBodies& bodies, const label celli)
{
    bool open = bodies.gamma()[celli] <= 0;
    for (const label facei : bodies.gamma().mesh().cells()[celli])
    {
        open = open && faceValue(bodies.theta(), facei) >= 1;
    }
    return !open;
}


//- What the pressure around a cell gives to the fluid and the fluid does not take, (1 - γ) V ∇p - Σ p_f S_f [N]
void pressureOn
(
    const surfaceScalarField& pf,
    const vector& fluidShare,
    const label celli,
    const point& centre,
    vector& force,
    vector& torque
)
{
    const fvMesh& mesh = pf.mesh();
    force += fluidShare;
    torque += (mesh.C()[celli] - centre) ^ fluidShare;

    for (const label facei : mesh.cells()[celli])
    {
        const scalar sign = mesh.faceOwner()[facei] == celli ? 1 : -1;
        const vector f(sign*faceValue(pf, facei)*mesh.faceAreas()[facei]);
        force -= f;
        torque -= (mesh.faceCentres()[facei] - centre) ^ f;
    }
}

} // End anonymous namespace


std::vector<frazil::BodyLoad> bodyLoads
(
    const immersedBodies& bodies,
    const volScalarField& p,
    const volVectorField& gradP,
    const volVectorField& blending,
    const volVectorField& viscous,
    const volScalarField& alpha1,
    const vector& up
)
{
    const fvMesh& mesh = p.mesh();
    const surfaceScalarField pf(fvc::interpolate(p));
    std::vector<frazil::BodyLoad> loads;

    for (label bodyi = 0; bodyi < bodies.size(); ++bodyi)
    {
        const bodyCut& cut = bodies.cutOf(bodyi);
        const point centre = bodies.centre(bodyi);
        vector force(Zero);
        vector torque(Zero);

        forAll(cut.cells, i)
        {
            const label celli = cut.cells[i];
            const scalar V = mesh.V()[celli];

            if (bodies.bodyOf()[celli] != bodyi || !touched(bodies, celli))
            {
                continue;
            }
            pressureOn(pf, (1 - bodies.gamma()[celli])*V*gradP[celli], celli, centre, force, torque);

            vector other(-V*blending[celli]);
            if (!bodies.slip(bodyi))
            {
                other += cut.share[i]*V*viscous[celli];
            }
            force += other;
            torque += (mesh.C()[celli] - centre) ^ other;
        }

        reduce(force, sumOp<vector>());
        reduce(torque, sumOp<vector>());
        const scalar wet = bodies.wetFraction(bodyi, alpha1, up);
        loads.push_back({{force.x(), force.y(), force.z()}, {torque.x(), torque.y(), torque.z()}, wet});

        Info<< "Body " << bodies.name(bodyi) << ": centre " << centre << " velocity "
            << bodies.pose(bodyi).velocity << " force " << force << " torque " << torque << " wet " << wet << endl;
    }
    return loads;
}

} // End namespace Foam
