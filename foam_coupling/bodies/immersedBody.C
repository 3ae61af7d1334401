#include "immersedBody.H"
#include "ListOps.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "ops.H"
#include "scalarList.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr double latticePerCell = 3;

//- Width over which edges are rounded, in cells: that of a mean over two cells
const double edgeWidth = 1/std::sqrt(3.0);

constexpr double marginInCells = 4;
constexpr double mostNodes = 8e6;

//- Sizes of cells that differ by less are the same: round-off of volumes
constexpr double sameSize = 1e-6;


//- A third of a cell, unless the lattice would have too many nodes
double defaultSpacing(const frazil::Box& bounds, double cellSize)
{
    const double margin = 2*marginInCells*cellSize;
    const frazil::Vec3 size = bounds.size() + frazil::Vec3{margin, margin, margin};
    return std::max
    (
        cellSize/latticePerCell,
        std::cbrt(size.x*size.y*size.z/mostNodes)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::immersedBody::computeLattice()
{
    const double spacing = givenSpacing_ > 0 ? givenSpacing_ : defaultSpacing(box_, cellSize_);
    lattice_.reset(new frazil::DistanceLattice(box_, spacing, marginInCells*cellSize_));
    lattice_->compute(frazil::joinCorners(triangles_), Pstream::myProcNo(), Pstream::nProcs());

    // Every rank has computed its planes and left zero elsewhere
    if (Pstream::parRun())
    {
        std::vector<double>& values = lattice_->values();
        scalarList all(label(values.size()));
        std::copy(values.begin(), values.end(), all.begin());
        Pstream::listCombineGather(all, plusEqOp<scalar>());
        Pstream::listCombineScatter(all);
        std::copy(all.begin(), all.end(), values.begin());
    }

    lattice_->roundEdges(edgeWidth*cellSize_, mass_.volume);

    const int* n = lattice_->nodes();
    Info<< "Body " << name_ << ": " << label(triangles_.size())
        << " triangles, volume " << mass_.volume << " m3, cells of " << cellSize_ << " m, distance lattice "
        << n[0] << " x " << n[1] << " x " << n[2] << ", spacing " << spacing
        << " m" << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::immersedBody::immersedBody
(
    const word& name,
    const frazil::Settings& settings,
    const std::string& casePath
)
:
    name_(name),
    file_(settings.text("surface")),
    slip_(settings.flag("slip", true)),
    givenCellSize_(settings.has("cellSize") ? settings.positive("cellSize") : 0),
    givenSpacing_(settings.has("lattice") ? settings.positive("lattice") : 0),
    reach_(0),
    cellSize_(0)
{
    settings.finish();
    const std::string path = file_[0] == '/' ? file_ : casePath + "/" + file_;
    triangles_ = frazil::readClosedStl(path, "bodies." + name);
    box_ = frazil::boundsOf(triangles_);
    mass_ = frazil::massProperties(triangles_, 1);
    for (const frazil::Triangle& t : triangles_)
    {
        for (const frazil::Vec3& p : t)
        {
            reach_ = max(reach_, norm(p - mass_.centre));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

frazil::BodyState Foam::immersedBody::asLoaded() const
{
    frazil::BodyState state;
    name_.copy(state.name, sizeof(state.name) - 1);
    state.centre = mass_.centre;
    return state;
}


void Foam::immersedBody::resolve(const scalar cellSize)
{
    const scalar size = cellSizeGiven() ? givenCellSize_ : cellSize;
    if (mag(size - cellSize_) > sameSize*size)
    {
        cellSize_ = size;
        computeLattice();
    }
}


// ************************************************************************* //
