#include "immersedBodies.H"
#include "bodyCellSize.H"
#include "bodyEdges.H"
#include "bodyWetting.H"
#include "couplingSettings.H"
#include "fvMesh.H"
#include "Time.H"
#include "zeroGradientFvPatchFields.H"

#include <fmt/format.h>

#include "InputError.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const char* const settingsFile = "constant/couplingProperties";


IOobject bodyField(const fvMesh& mesh, const word& name, IOobject::writeOption w)
{
    return IOobject(name, mesh.time().timeName(), mesh, IOobject::NO_READ, w);
}


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


//- Cells finer than this share of the size that a body's distances are made for are worth a warning
constexpr scalar muchFiner = 0.8;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<const frazil::BodyState*> Foam::immersedBodies::inOurOrder
(
    const std::vector<frazil::BodyState>& states
) const
{
    std::vector<const frazil::BodyState*> ordered;
    for (const immersedBody& body : bodies_)
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
                settingsFile, "bodies", body.name(),
                "frazilDem has no body of this name",
                "Give the fix body/rigid in the DEM script this name as its ID."
            );
        }
        ordered.push_back(&*found);
    }
    return ordered;
}


void Foam::immersedBodies::checkInMesh() const
{
    forAll(bodies_, i)
    {
        if (cuts_[i].volumeCut > 0)
        {
            continue;
        }
        const boundBox mesh(mesh_.bounds());
        const point& c = bodies_[i].pose().centre;
        throw frazil::InputError
        (
            settingsFile, "bodies." + bodies_[i].name(), bodies_[i].file(),
            fmt::format
            (
                "no part of the body is inside the mesh: its centre is at "
                "({:.6g} {:.6g} {:.6g}), the mesh reaches from "
                "({:.6g} {:.6g} {:.6g}) to ({:.6g} {:.6g} {:.6g}) m",
                c.x(), c.y(), c.z(),
                mesh.min().x(), mesh.min().y(), mesh.min().z(),
                mesh.max().x(), mesh.max().y(), mesh.max().z()
            ),
            "Move the body or the mesh; STL files in millimetres must be "
            "scaled to metres; a body thinner than a cell needs a finer mesh."
        );
    }
}


void Foam::immersedBodies::warnOfFinerCells()
{
    forAll(bodies_, i)
    {
        const immersedBody& body = bodies_[i];
        const scalar finest = warned_[i] || body.cellSizeGiven() ? GREAT : finestCut(mesh_, cuts_[i]);
        if (finest < muchFiner*body.cellSize())
        {
            warned_[i] = true;
            Warning
                << "Body " << body.name() << " cuts cells of " << finest << " m, but its edges are rounded for the "
                << body.cellSize() << " m of the cells where it started." << nl
                << "    Give the size in constant/couplingProperties: bodies { " << body.name() << " { cellSize "
                << finest << "; } }" << nl << endl;
        }
    }
}


void Foam::immersedBodies::clearFields()
{
    scalarField& gamma = gamma_.primitiveFieldRef();
    vectorField& Ub = Ub_.primitiveFieldRef();
    vectorField& normal = normal_.primitiveFieldRef();
    scalarField& distance = distance_.primitiveFieldRef();

    for (const bodyCut& cut : cuts_)
    {
        for (const label celli : cut.cells)
        {
            gamma[celli] = 0;
            Ub[celli] = Zero;
            normal[celli] = Zero;
            distance[celli] = GREAT;
            bodyOf_[celli] = -1;
        }
    }
}


void Foam::immersedBodies::addToFields(const label bodyi)
{
    const bodyCut& cut = cuts_[bodyi];
    const bodyPose& pose = bodies_[bodyi].pose();
    scalarField& gamma = gamma_.primitiveFieldRef();
    vectorField& Ub = Ub_.primitiveFieldRef();
    vectorField& normal = normal_.primitiveFieldRef();
    scalarField& distance = distance_.primitiveFieldRef();

    forAll(cut.cells, i)
    {
        const label celli = cut.cells[i];
        gamma[celli] += cut.share[i];
        if (cut.distance[i] < distance[celli])
        {
            distance[celli] = cut.distance[i];
            normal[celli] = cut.normal[i];
            Ub[celli] = pose.velocityAt(mesh_.cellCentres()[celli]);
            bodyOf_[celli] = bodyi;
        }
    }
}


void Foam::immersedBodies::boundShares()
{
    scalarField& gamma = gamma_.primitiveFieldRef();
    for (const bodyCut& cut : cuts_)
    {
        for (const label celli : cut.cells)
        {
            gamma[celli] = min(gamma[celli], scalar(1));
        }
    }
}


void Foam::immersedBodies::cutAt
(
    const std::vector<bodyPose>& poses,
    closedFaces& closed
)
{
    clearFields();
    closed.clear();
    forAll(bodies_, i)
    {
        bodies_[i].place(poses[i]);
        cutting_->cut(bodies_[i], cuts_[i]);
        addToFields(i);
        closed.add(cuts_[i]);
    }
    boundShares();

    gamma_.correctBoundaryConditions();
    Ub_.correctBoundaryConditions();
    normal_.correctBoundaryConditions();
    distance_.correctBoundaryConditions();
    for (const bodyCut& cut : cuts_)
    {
        findEdges(distance_, cut.cells, edge_);
    }
}


void Foam::immersedBodies::startStep()
{
    if (timeIndex_ != mesh_.time().timeIndex())
    {
        timeIndex_ = mesh_.time().timeIndex();
        gamma_.storeOldTimes();
        start_ = end_;
        std::swap(closedStart_, closedEnd_);
    }
}


void Foam::immersedBodies::placeAtEnd()
{
    cutAt(end_, closedEnd_);
    setOpenShares(theta_, closedStart_, closedEnd_);
    keepPoses();
}


void Foam::immersedBodies::keepPoses()
{
    poses_.setSize(poseWords*bodies_.size());
    scalar* row = poses_.data();
    forAll(bodies_, i)
    {
        start_[i].put(row);
        end_[i].put(row + bodyPose::words);
        const frazil::Vec3& centre = bodies_[i].massCentre();
        for (int c = 0; c < 3; ++c)
        {
            row[2*bodyPose::words + c] = centre[c];
        }
        row[poseWords - 1] = bodies_[i].cellSize();
        row += poseWords;
    }
}


//- Both poses of the last step before the run was interrupted, with all that follows from them
void Foam::immersedBodies::goOn()
{
    const scalar* row = poses_.cdata();
    forAll(bodies_, i)
    {
        start_[i] = bodyPose(row);
        end_[i] = bodyPose(row + bodyPose::words);
        const scalar* centre = row + 2*bodyPose::words;
        bodies_[i].setMassCentre({centre[0], centre[1], centre[2]});
        bodies_[i].resolve(row[poseWords - 1]);
        row += poseWords;
    }
    cutAt(start_, closedStart_);
    gamma_.oldTime() == gamma_;
    cutAt(end_, closedEnd_);
    timeIndex_ = mesh_.time().timeIndex();
    setOpenShares(theta_, closedStart_, closedEnd_);
    continued_ = true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::immersedBodies::immersedBodies
(
    const fvMesh& mesh,
    const dictionary& bodiesDict
)
:
    mesh_(mesh),
    cutting_(new bodyCutting(mesh)),
    timeIndex_(-1),
    poses_
    (
        IOobject
        (
            "bodyPoses",
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    continued_(false),
    found_(false),
    gamma_
    (
        bodyField(mesh, "gamma", IOobject::AUTO_WRITE),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    theta_
    (
        bodyField(mesh, "theta", IOobject::NO_WRITE),
        mesh,
        dimensionedScalar("open", dimless, 1)
    ),
    Ub_
    (
        bodyField(mesh, "bodyVelocity", IOobject::NO_WRITE),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    normal_
    (
        bodyField(mesh, "bodyNormal", IOobject::NO_WRITE),
        mesh,
        dimensionedVector(dimless, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    distance_
    (
        bodyField(mesh, "bodyDistance", IOobject::NO_WRITE),
        mesh,
        dimensionedScalar("far", dimLength, GREAT),
        zeroGradientFvPatchScalarField::typeName
    ),
    bodyOf_(mesh.nCells(), -1),
    edge_(mesh.nCells(), Zero)
{
    const frazil::Settings bodies(settingsOf(bodiesDict));
    const std::string casePath
    (
        mesh.time().rootPath()/mesh.time().globalCaseName()
    );

    for (const std::string& name : bodies.subKeys())
    {
        bodies_.append
        (
            new immersedBody(word(name), bodies.sub(name), casePath)
        );
        cuts_.append(new bodyCut());
        end_.push_back(bodies_.last().pose());
    }
    bodies.finish();
    start_ = end_;
    warned_.setSize(bodies_.size(), false);
    closedStart_.reset(mesh.nFaces());
    closedEnd_.reset(mesh.nFaces());
    if (poses_.size() == poseWords*bodies_.size() && bodies_.size())
    {
        goOn();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::immersedBodies::place(const std::vector<frazil::BodyState>& states)
{
    const auto ordered = inOurOrder(states);
    forAll(bodies_, i)
    {
        bodies_[i].check(*ordered[i]);
        bodies_[i].place(*ordered[i]);
        bodies_[i].resolve(cellSizeAt(mesh_, bodies_[i]));
        end_[i] = bodies_[i].pose();
    }
    start_ = end_;

    cutAt(end_, closedEnd_);
    gamma_.oldTime() == gamma_;
    closedStart_ = closedEnd_;
    timeIndex_ = mesh_.time().timeIndex();
    setOpenShares(theta_, closedStart_, closedEnd_);
    keepPoses();
}


void Foam::immersedBodies::move
(
    const std::vector<frazil::BodyState>& states,
    const scalar deltaT
)
{
    startStep();
    const auto ordered = inOurOrder(states);
    forAll(bodies_, i)
    {
        end_[i] = bodyPose(*ordered[i]).after(deltaT);
    }
    placeAtEnd();

    // Once: a body may leave the mesh later, and may be loaded outside it
    if (!found_)
    {
        checkInMesh();
        found_ = true;
    }
    warnOfFinerCells();
}


void Foam::immersedBodies::updateMesh()
{
    startStep();
    cutting_.reset(new bodyCutting(mesh_));
    for (bodyCut& cut : cuts_)
    {
        cut.clear();
    }
    gamma_ == dimensionedScalar(dimless, Zero);
    Ub_ == dimensionedVector(dimVelocity, Zero);
    normal_ == dimensionedVector(dimless, Zero);
    distance_ == dimensionedScalar("far", dimLength, GREAT);
    bodyOf_.setSize(mesh_.nCells());
    bodyOf_ = -1;
    closedStart_.reset(mesh_.nFaces());
    closedEnd_.reset(mesh_.nFaces());

    cutAt(start_, closedStart_);
    gamma_.oldTime() == gamma_;
    placeAtEnd();
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


Foam::scalar Foam::immersedBodies::wetFraction
(
    const label i,
    const volScalarField& alpha1,
    const vector& up
) const
{
    return Foam::wetFraction
    (
        alpha1,
        cuts_[i],
        closedEnd_.share,
        end_[i].centre,
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
            const vector& n = normal_[celli];
            const vector& u = U()[celli];
            const scalar sticking = bodies_[bodyOf_[celli]].slip() ? edge_[celli] : 1;
            part[celli] = sticking*u + (1 - sticking)*n*(n & u);
        }
    }
    U.clear();
    result.ref().correctBoundaryConditions();
    return result;
}


// ************************************************************************* //
