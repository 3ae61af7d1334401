#include "bodyLoads.H"
#include "conversions.H"
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


//- p_f S_f of a cell's face, S_f out of the cell [N]
vector outwardPressure(const surfaceScalarField& pf, const label facei, const label celli)
{
    const fvMesh& mesh = pf.mesh();
    const scalar sign = mesh.faceOwner()[facei] == celli ? 1 : -1;
    return sign*faceValue(pf, facei)*mesh.faceAreas()[facei];
}


//- Σ of a force and of its moment
struct resultant
{
    vector force = Zero;
    vector torque = Zero;

    void add(const vector& f, const vector& arm)
    {
        force += f;
        torque += arm ^ f;
    }
};


//- -Σ p_f S_f of a cell, at its faces
void addPressure(const surfaceScalarField& pf, const label celli, const point& centre, resultant& load)
{
    for (const label facei : pf.mesh().cells()[celli])
    {
        load.add(-outwardPressure(pf, facei, celli), pf.mesh().faceCentres()[facei] - centre);
    }
}

} // End anonymous namespace


bool touchedByBody(const immersedBodies& bodies, const label celli)
{
    bool open = bodies.gamma()[celli] <= 0;
    for (const label facei : bodies.gamma().mesh().cells()[celli])
    {
        open = open && faceValue(bodies.theta(), facei) >= 1;
    }
    return !open && bodies.bodyOf()[celli] >= 0;
}


vector pressureNotTaken(const surfaceScalarField& pf, const vector& taken, const label celli)
{
    vector sum(taken);
    for (const label facei : pf.mesh().cells()[celli])
    {
        sum -= outwardPressure(pf, facei, celli);
    }
    return sum;
}


namespace
{

//- Force and torque on a body by this rank's cells
resultant resultantOn
(
    const immersedBodies& bodies,
    const label bodyi,
    const surfaceScalarField& pf,
    const volVectorField& gradP,
    const volVectorField& stress,
    const volVectorField& byBodies
)
{
    const fvMesh& mesh = pf.mesh();
    const scalarField& gamma = bodies.gamma();
    const point centre = bodies.centre(bodyi);
    resultant load;
    for (const label celli : bodies.cutOf(bodyi).cells)
    {
        if (bodies.bodyOf()[celli] != bodyi)
        {
            continue;
        }
        vector inCell(-byBodies[celli]);
        if (touchedByBody(bodies, celli))
        {
            inCell += (1 - gamma[celli])*gradP[celli] + gamma[celli]*stress[celli];
            addPressure(pf, celli, centre, load);
        }
        load.add(mesh.V()[celli]*inCell, mesh.C()[celli] - centre);
    }
    return load;
}

} // End anonymous namespace


std::vector<frazil::BodyLoad> bodyLoads
(
    const immersedBodies& bodies,
    const volScalarField& p,
    const volVectorField& gradP,
    const volVectorField& stress,
    const volVectorField& byBodies,
    const volScalarField& alpha1,
    const vector& up
)
{
    const surfaceScalarField pf(fvc::interpolate(p));
    std::vector<frazil::BodyLoad> loads;

    for (label bodyi = 0; bodyi < bodies.size(); ++bodyi)
    {
        const resultant load(resultantOn(bodies, bodyi, pf, gradP, stress, byBodies));
        const vector force = returnReduce(load.force, sumOp<vector>());
        const vector torque = returnReduce(load.torque, sumOp<vector>());
        const scalar submerged = bodies.submergedShare(bodyi, alpha1, up);
        loads.push_back({toVec3(force), toVec3(torque), submerged});

        Info<< "Body " << bodies.name(bodyi) << ": centre " << bodies.centre(bodyi) << " velocity "
            << bodies.pose(bodyi).velocity << " force " << force << " torque " << torque << " wet " << submerged << endl;
    }
    return loads;
}

} // End namespace Foam
