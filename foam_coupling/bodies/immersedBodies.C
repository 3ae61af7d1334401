#include "immersedBodies.H"
#include "bodyCellSize.H"
#include "bodyChecks.H"
#include "bodyWetting.H"
#include "couplingSettings.H"
#include "fvMesh.H"
#include "Time.H"

#include <algorithm>

#include "InputError.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Bodies with their settings. `motion` belongs to prescribedMotion.
frazil::Settings settingsOf(const dictionary& bodiesDict)
{
    dictionary bodies(bodiesDict);
    for (const word& name : bodies.toc())
    {
        if (bodies.isDict(name))
        {
            bodies.subDict(name).remove("motion");
        }
    }
    return couplingSettings(bodies, "bodies");
}


PtrList<immersedBody> bodiesOf(const fvMesh& mesh, const dictionary& bodiesDict)
{
    const frazil::Settings settings(settingsOf(bodiesDict));
    const std::string casePath(mesh.time().rootPath()/mesh.time().globalCaseName());
    PtrList<immersedBody> bodies;
    for (const std::string& name : settings.subKeys())
    {
        bodies.append(new immersedBody(word(name), settings.sub(name), casePath));
    }
    settings.finish();
    return bodies;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::bodyPose Foam::immersedBodies::poseOf
(
    const immersedBody& body,
    const std::vector<frazil::BodyState>& states
) const
{
    const auto found = std::find_if
    (
        states.begin(), states.end(),
        [&](const frazil::BodyState& s) { return body.name() == s.name; }
    );
    if (found == states.end())
    {
        throw frazil::InputError
        (
            "constant/couplingProperties", "bodies", body.name(),
            "frazilDem has no body of this name",
            "Give the fix body/rigid in the DEM script this name as its ID."
        );
    }
    return bodyPose(*found, body.centroid());
}


void Foam::immersedBodies::cutAt(stepEnd pose, closedFaces& closed)
{
    fields_.clear(cuts_);
    closed.clear();
    forAll(bodies_, i)
    {
        const placedBody placed(bodies_[i], (poses_.*pose)(i));
        cutting_->cut(placed, cuts_[i]);
        fields_.add(i, cuts_[i], placed.pose());
        closed.add(cuts_[i]);
    }
    fields_.finish(cuts_);
}


//- Two cuts: those of a step that another run, or another mesh, has begun
void Foam::immersedBodies::cutBothEnds()
{
    cutAt(&bodyPoses::start, closedStart_);
    fields_.gamma.oldTime() == fields_.gamma;
    cutEnd();
}


void Foam::immersedBodies::startStep()
{
    if (timeIndex_ != mesh_.time().timeIndex())
    {
        timeIndex_ = mesh_.time().timeIndex();
        fields_.gamma.storeOldTimes();
        poses_.startStep();
        std::swap(closedStart_, closedEnd_);
    }
}


void Foam::immersedBodies::cutEnd()
{
    cutAt(&bodyPoses::end, closedEnd_);
    setOpenShares(theta_, closedStart_, closedEnd_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::immersedBodies::immersedBodies
(
    const fvMesh& mesh,
    const dictionary& bodiesDict
)
:
    mesh_(mesh),
    bodies_(bodiesOf(mesh, bodiesDict)),
    poses_(mesh, bodies_.size()),
    cuts_(bodies_.size()),
    cutting_(new bodyCutting(mesh)),
    timeIndex_(mesh.time().timeIndex()),
    found_(false),
    warned_(bodies_.size(), false),
    fields_(mesh),
    theta_
    (
        IOobject("theta", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("open", dimless, 1)
    )
{
    closedStart_.reset(mesh.nFaces());
    closedEnd_.reset(mesh.nFaces());
    forAll(cuts_, i)
    {
        cuts_.set(i, new bodyCut());
    }
    if (poses_.read())
    {
        forAll(bodies_, i)
        {
            bodies_[i].resolve(poses_.cellSize(i));
        }
        cutBothEnds();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::immersedBodies::place(const std::vector<frazil::BodyState>& states)
{
    forAll(bodies_, i)
    {
        immersedBody& body = bodies_[i];
        poses_.place(i, poseOf(body, states));
        body.resolve(cellSizeAt(mesh_, placedBody(body, poses_.end(i))));
        poses_.setCellSize(i, body.cellSize());
    }
    cutAt(&bodyPoses::end, closedEnd_);
    fields_.gamma.oldTime() == fields_.gamma;
    closedStart_ = closedEnd_;
    timeIndex_ = mesh_.time().timeIndex();
    setOpenShares(theta_, closedStart_, closedEnd_);
}


void Foam::immersedBodies::move
(
    const std::vector<frazil::BodyState>& states,
    const scalar deltaT
)
{
    startStep();
    forAll(bodies_, i)
    {
        poses_.setEnd(i, poseOf(bodies_[i], states).after(deltaT));
    }
    cutEnd();

    forAll(bodies_, i)
    {
        // Once: a body may leave the mesh later, and may be loaded outside it
        if (!found_)
        {
            checkInMesh(mesh_, placedBody(bodies_[i], poses_.end(i)), cuts_[i]);
        }
        warned_[i] = warned_[i] || warnOfFinerCells(mesh_, bodies_[i], cuts_[i]);
    }
    found_ = true;
}


void Foam::immersedBodies::updateMesh()
{
    startStep();
    cutting_.reset(new bodyCutting(mesh_));
    for (bodyCut& cut : cuts_)
    {
        cut.clear();
    }
    fields_.reset();
    closedStart_.reset(mesh_.nFaces());
    closedEnd_.reset(mesh_.nFaces());
    cutBothEnds();
}


std::vector<frazil::BodyHello> Foam::immersedBodies::hellos() const
{
    std::vector<frazil::BodyHello> hellos;
    for (const immersedBody& body : bodies_)
    {
        hellos.push_back({body.name(), body.volume()});
    }
    return hellos;
}


std::vector<frazil::BodyState> Foam::immersedBodies::asLoaded() const
{
    std::vector<frazil::BodyState> states;
    for (const immersedBody& body : bodies_)
    {
        states.push_back(body.asLoaded());
    }
    return states;
}


Foam::scalar Foam::immersedBodies::submergedShare
(
    const label i,
    const volScalarField& alpha1,
    const vector& up
) const
{
    return Foam::submergedShare
    (
        alpha1,
        cuts_[i],
        closedEnd_.share,
        centre(i),
        bodies_[i].reach(),
        up
    );
}


Foam::tmp<Foam::volVectorField> Foam::immersedBodies::constrained
(
    const tmp<volVectorField>& U
) const
{
    tmp<volVectorField> result
    (
        new volVectorField("constrained", U()*dimensionedScalar(dimless, Zero))
    );
    vectorField& part = result.ref().primitiveFieldRef();

    for (const bodyCut& cut : cuts_)
    {
        for (const label celli : cut.cells)
        {
            const vector& n = fields_.normal[celli];
            const vector& u = U()[celli];
            const scalar sticking = bodies_[fields_.bodyOf[celli]].slip() ? fields_.edge[celli] : 1;
            part[celli] = sticking*u + (1 - sticking)*n*(n & u);
        }
    }
    U.clear();
    result.ref().correctBoundaryConditions();
    return result;
}


// ************************************************************************* //
