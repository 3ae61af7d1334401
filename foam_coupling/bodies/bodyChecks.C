#include "bodyChecks.H"
#include "bodyCellSize.H"
#include "fvMesh.H"

#include <fmt/format.h>

#include "InputError.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Cells finer than this share of the size that a body's distances are made for are worth a warning
constexpr Foam::scalar muchFiner = 0.8;


std::string words(const Foam::point& p)
{
    return fmt::format("({:.6g} {:.6g} {:.6g})", p.x(), p.y(), p.z());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::checkInMesh(const fvMesh& mesh, const placedBody& placed, const bodyCut& cut)
{
    if (cut.volumeCut > 0)
    {
        return;
    }
    const boundBox box(mesh.bounds());
    throw frazil::InputError
    (
        "constant/couplingProperties", "bodies." + placed.body().name(), placed.body().file(),
        fmt::format
        (
            "no part of the body is inside the mesh: its centre is at {}, the mesh reaches from {} to {} m",
            words(placed.pose().centre), words(box.min()), words(box.max())
        ),
        "Move the body or the mesh; STL files in millimetres must be "
        "scaled to metres; a body thinner than a cell needs a finer mesh."
    );
}


bool Foam::warnOfFinerCells(const fvMesh& mesh, const immersedBody& body, const bodyCut& cut)
{
    const scalar finest = body.cellSizeGiven() ? GREAT : finestCut(mesh, cut);
    if (finest >= muchFiner*body.cellSize())
    {
        return false;
    }
    Warning
        << "Body " << body.name() << " cuts cells of " << finest << " m, but its edges are rounded for the "
        << body.cellSize() << " m of the cells where it started." << nl
        << "    Give the size in constant/couplingProperties: bodies { " << body.name() << " { cellSize "
        << finest << "; } }" << nl << endl;
    return true;
}


// ************************************************************************* //
