#include "coarsePieces.H"
#include "conversions.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

frazil::Box boundsOf(const Foam::fvMesh& mesh, const Foam::label celli)
{
    Foam::boundBox bb(mesh.points(), mesh.cellPoints(celli), false);
    return Foam::toBox(bb);
}


bool overlaps(const frazil::Box& a, const frazil::Box& b)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        if (a.max[axis] <= b.min[axis] || b.max[axis] <= a.min[axis])
        {
            return false;
        }
    }
    return true;
}


//- Does the cell fill its bounding box, and so equal it?
bool isBox(const frazil::Box& bounds, const Foam::scalar volume)
{
    const frazil::Vec3 d = bounds.size();
    return Foam::mag(d.x*d.y*d.z - volume) < 1e-9*volume;
}


void clipPolyhedron
(
    const Foam::fvMesh& mesh,
    const Foam::label celli,
    const frazil::CoarseGrid& grid,
    const frazil::PieceSink& sink
)
{
    const frazil::Vec3 cellCentre = Foam::toVec3(mesh.cellCentres()[celli]);

    for (const Foam::label facei : mesh.cells()[celli])
    {
        const Foam::face& f = mesh.faces()[facei];
        const frazil::Vec3 faceCentre = Foam::toVec3(mesh.faceCentres()[facei]);

        forAll(f, fp)
        {
            const frazil::Vec3 tetrahedron[4] =
            {
                cellCentre,
                faceCentre,
                Foam::toVec3(mesh.points()[f[fp]]),
                Foam::toVec3(mesh.points()[f.nextLabel(fp)])
            };
            frazil::clipTetrahedron(tetrahedron, grid, sink);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::vector<frazil::FinePiece> Foam::coarsePieces
(
    const fvMesh& mesh,
    const frazil::CoarseGrid& grid
)
{
    std::vector<frazil::FinePiece> pieces;

    forAll(mesh.V(), celli)
    {
        const frazil::Box bounds = boundsOf(mesh, celli);
        if (!overlaps(bounds, grid.box()))
        {
            continue;
        }

        const auto sink =
            [&](std::int64_t coarse, double volume, const frazil::Vec3& centroid)
            {
                pieces.push_back({int(celli), coarse, volume, centroid});
            };

        if (isBox(bounds, mesh.V()[celli]))
        {
            frazil::clipBox(bounds, grid, sink);
        }
        else
        {
            clipPolyhedron(mesh, celli, grid, sink);
        }
    }

    return pieces;
}


// ************************************************************************* //
