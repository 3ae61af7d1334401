#include "bodyLoads.H"
#include "immersedBodies.H"
#include "surfaceInterpolate.H"
#include "surfaceFields.H"

namespace Foam
{

namespace
{

//- Σ p_f S_f over a cell's faces, outward [N], and Σ (x_f - c) x p_f S_f [N m]
void pressureOn
(
    const surfaceScalarField& pf,
    const label celli,
    const point& centre,
    vector& force,
    vector& torque
)
{
    const fvMesh& mesh = pf.mesh();
    for (const label facei : mesh.cells()[celli])
    {
        scalar p = 0;
        if (mesh.isInternalFace(facei))
        {
            p = pf[facei];
        }
        else
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            const fvsPatchScalarField& patchPf = pf.boundaryField()[patchi];
            p = patchPf.empty() ? 0 : patchPf[facei - mesh.boundaryMesh()[patchi].start()];
        }
        const scalar sign = mesh.faceOwner()[facei] == celli ? 1 : -1;
        const vector f(sign*p*mesh.faceAreas()[facei]);
        force += f;
        torque += (mesh.faceCentres()[facei] - centre) ^ f;
    }
}

} // End anonymous namespace


std::vector<frazil::BodyLoad> bodyLoads
(
    const immersedBodies& bodies,
    const volScalarField& p,
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

            if (cut.share[i] > 0)
            {
                vector cellForce(Zero);
                vector cellTorque(Zero);
                pressureOn(pf, celli, centre, cellForce, cellTorque);
                force -= cut.share[i]*cellForce;
                torque -= cut.share[i]*cellTorque;
            }
            if (bodies.bodyOf()[celli] == bodyi)
            {
                vector other(-V*blending[celli]);
                if (!bodies.slip(bodyi))
                {
                    other += cut.share[i]*V*viscous[celli];
                }
                force += other;
                torque += (mesh.C()[celli] - centre) ^ other;
            }
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
