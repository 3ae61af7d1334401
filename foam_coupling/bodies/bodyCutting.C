#include "bodyCutting.H"
#include "placedBody.H"
#include "fvMesh.H"
#include "processorPolyPatch.H"
#include "syncTools.H"
#include "volMesh.H"

#include <fmt/format.h>

#include "InputError.h"

// * * * * * * * * * * * * * * * Local Data  * * * * * * * * * * * * * * * * //

namespace
{

//- Near cells reach this many cell radii out of the surface
constexpr double nearRadii = 4;

//- The lattice's distance may grow a little faster than the way travelled
constexpr double surelyUncut = 1.1;

//- Shares closer than this to 0 or 1 are 0 or 1
constexpr double snap = 1e-4;

//- Largest |c| of the match γ += c γ (1 - γ)
constexpr double largestMatch = 0.9;

} // End anonymous namespace


void Foam::bodyCut::clear()
{
    cells.clear();
    share.clear();
    distance.clear();
    normal.clear();
    faces.clear();
    closed.clear();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::bodyCutting::coupled(const label facei) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    return patches[patches.whichPatch(facei)].coupled();
}


void Foam::bodyCutting::touch(const label facei, bodyCut& out)
{
    if (faceCut_[facei] != cut_)
    {
        faceCut_[facei] = cut_;
        out.faces.append(facei);
    }
}


frazil::CutFace Foam::bodyCutting::gather
(
    const placedBody& body,
    const label facei
)
{
    const face& f = mesh_.faces()[facei];
    corners_.resize(std::max(corners_.size(), std::size_t(f.size())));
    cornerDistances_.resize(corners_.size());

    forAll(f, i)
    {
        const label pointi = f[i];
        const point& p = mesh_.points()[pointi];
        if (pointCut_[pointi] != cut_)
        {
            pointCut_[pointi] = cut_;
            pointDistance_[pointi] = body.distance(p);
        }
        corners_[i] = toVec3(p);
        cornerDistances_[i] = pointDistance_[pointi];
    }

    const point& centre = mesh_.faceCentres()[facei];
    if (faceCut_[facei] != cut_)
    {
        faceDistance_[facei] = body.distance(centre);
    }
    return
    {
        int(f.size()), corners_.data(), cornerDistances_.data(),
        toVec3(centre), faceDistance_[facei]
    };
}


void Foam::bodyCutting::cutOne
(
    const placedBody& body,
    const label celli,
    const scalar distance,
    bodyCut& out
)
{
    frazil::CutCell cell(toVec3(mesh_.cellCentres()[celli]), distance);
    for (const label facei : mesh_.cells()[celli])
    {
        const frazil::CutFace face(gather(body, facei));
        cell.add(face);
        if (faceCut_[facei] != cut_)
        {
            touch(facei, out);
            const scalar closed = frazil::insideShare(face);
            closed_[facei] =
                closed < snap ? 0 : closed > 1 - snap ? 1 : closed;
        }
    }
    const scalar share = cell.insideShare();
    share_[celli] = share < snap ? 0 : share > 1 - snap ? 1 : share;
}


void Foam::bodyCutting::findNear(const placedBody& body, bodyCut& out)
{
    bins_.find(body.bounds(), candidates_);
    const scalarField& radius = bins_.radius();

    for (const label celli : candidates_)
    {
        const point& centre = mesh_.cellCentres()[celli];
        const scalar distance = body.distance(centre);
        if (distance < nearRadii*radius[celli])
        {
            out.cells.append(celli);
            out.distance.append(distance);
            out.normal.append(body.normal(centre));
        }
    }
}


void Foam::bodyCutting::cutNear(const placedBody& body, bodyCut& out)
{
    const scalarField& radius = bins_.radius();

    forAll(out.cells, i)
    {
        const label celli = out.cells[i];
        const scalar distance = out.distance[i];
        if (mag(distance) < surelyUncut*radius[celli])
        {
            cutOne(body, celli, distance, out);
        }
        else
        {
            share_[celli] = distance < 0 ? 1 : 0;
        }
    }
}


void Foam::bodyCutting::closeSolidCells(bodyCut& out)
{
    for (const label celli : out.cells)
    {
        if (share_[celli] == 1)
        {
            for (const label facei : mesh_.cells()[celli])
            {
                touch(facei, out);
                closed_[facei] = 1;
            }
        }
    }
}


void Foam::bodyCutting::shareCoupledFaces(bodyCut& out)
{
    SubList<scalar> boundary
    (
        closed_,
        mesh_.nFaces() - mesh_.nInternalFaces(),
        mesh_.nInternalFaces()
    );
    syncTools::syncBoundaryFaceList(mesh_, boundary, maxEqOp<scalar>());

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!patch.coupled())
        {
            continue;
        }
        for (label facei = patch.start(); facei < patch.start() + patch.size(); ++facei)
        {
            if (closed_[facei] > 0)
            {
                touch(facei, out);
            }
        }
    }
}


bool Foam::bodyCutting::fillClosedCells(const bodyCut& out)
{
    bool filled = false;
    for (const label celli : out.cells)
    {
        if (share_[celli] == 1)
        {
            continue;
        }
        bool open = false;
        for (const label facei : mesh_.cells()[celli])
        {
            open = open || closed_[facei] < 1;
        }
        if (!open)
        {
            share_[celli] = 1;
            filled = true;
        }
    }
    return returnReduce(filled, orOp<bool>());
}


Foam::bodyCutting::cutSums Foam::bodyCutting::sumsOf(const bodyCut& out) const
{
    const scalarField& V = mesh_.V();
    vector sums(Zero);
    for (const label celli : out.cells)
    {
        const scalar share = share_[celli];
        sums[0] += share*V[celli];
        sums[1] += share*(1 - share)*V[celli];
    }
    for (const label facei : out.faces)
    {
        if (facei >= mesh_.nInternalFaces() && closed_[facei] > 0)
        {
            sums[2] += coupled(facei) ? 0 : 1;
        }
    }
    reduce(sums, sumOp<vector>());
    return {sums[0], sums[1], sums[2] > 0};
}


void Foam::bodyCutting::matchVolume(const placedBody& placed, bodyCut& out)
{
    const immersedBody& body = placed.body();
    const cutSums sums(sumsOf(out));
    out.volumeCut = out.volume = sums.volume;

    // Nothing crosses the boundary: all inside, unless the body has just left
    const bool inside = !sums.crossesBoundary && mesh_.bounds().contains(placed.pose().centre);
    if (!inside || sums.room <= SMALL*body.volume())
    {
        return;
    }
    const scalar match = (body.volume() - sums.volume)/sums.room;
    if (mag(match) > largestMatch)
    {
        throw frazil::InputError
        (
            "constant/couplingProperties",
            "bodies." + body.name(),
            body.file(),
            fmt::format("the mesh holds {:.3g} m3 of the body's {:.3g} m3", sums.volume, body.volume()),
            "Refine the mesh around the body: its thinnest part should be several cells wide."
        );
    }
    for (const label celli : out.cells)
    {
        share_[celli] += match*share_[celli]*(1 - share_[celli]);
    }
    out.volume = body.volume();
}


void Foam::bodyCutting::collect(bodyCut& out)
{
    for (const label celli : out.cells)
    {
        out.share.append(share_[celli]);
        share_[celli] = 0;
    }
    for (const label facei : out.faces)
    {
        out.closed.append(closed_[facei]);
        closed_[facei] = 0;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyCutting::bodyCutting(const fvMesh& mesh)
:
    mesh_(mesh),
    bins_(mesh),
    share_(mesh.nCells(), Zero),
    closed_(mesh.nFaces(), Zero),
    pointCut_(mesh.nPoints(), -1),
    faceCut_(mesh.nFaces(), -1),
    cut_(0),
    pointDistance_(mesh.nPoints(), Zero),
    faceDistance_(mesh.nFaces(), Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bodyCutting::cut(const placedBody& body, bodyCut& out)
{
    ++cut_;
    out.clear();
    findNear(body, out);
    cutNear(body, out);

    do
    {
        closeSolidCells(out);
        shareCoupledFaces(out);
    }
    while (fillClosedCells(out));

    matchVolume(body, out);
    collect(out);
}


// ************************************************************************* //
