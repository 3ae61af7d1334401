#include "immersedBody.H"
#include "ListOps.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "ops.H"
#include "scalarList.H"
#include "quaternion.H"

#include <cmath>

#include <fmt/format.h>

#include "InputError.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr double latticePerCell = 3;

//- Width over which edges are rounded, in cells: that of a mean over two cells
const double edgeWidth = 1/std::sqrt(3.0);

constexpr double marginInCells = 4;
constexpr double mostNodes = 8e6;

//- Volumes of the same STL read by two programs agree to round-off; ascii
//  files keep at least six digits
constexpr double volumeTolerance = 1e-6;


Foam::tensor rotationBy(const Foam::vector& angle)
{
    using namespace Foam;

    const scalar size = mag(angle);
    return
        size > VSMALL
      ? quaternion(angle/size, size).R()
      : tensor(tensor::I);
}


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


// * * * * * * * * * * * * * * * * Body's pose * * * * * * * * * * * * * * * //

Foam::bodyPose::bodyPose(const frazil::BodyState& state)
:
    centre(toVector(state.centre)),
    rotation
    (
        normalize
        (
            quaternion
            (
                state.orientation[0],
                vector
                (
                    state.orientation[1],
                    state.orientation[2],
                    state.orientation[3]
                )
            )
        ).R()
    ),
    velocity(toVector(state.velocity)),
    omega(toVector(state.angularVelocity))
{}


Foam::bodyPose::bodyPose(const scalar* row)
:
    centre(row[0], row[1], row[2]),
    rotation
    (
        row[3], row[4], row[5], row[6], row[7], row[8], row[9], row[10], row[11]
    ),
    velocity(row[12], row[13], row[14]),
    omega(row[15], row[16], row[17])
{}


void Foam::bodyPose::put(scalar* row) const
{
    for (const vector& v : {centre, rotation.x(), rotation.y(), rotation.z(), velocity, omega})
    {
        for (direction c = 0; c < 3; ++c)
        {
            *row++ = v[c];
        }
    }
}


Foam::bodyPose Foam::bodyPose::after(const scalar deltaT) const
{
    bodyPose later(*this);
    later.centre += deltaT*velocity;
    later.rotation = rotationBy(deltaT*omega) & rotation;
    return later;
}


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
    cellSize_(0),
    pose_(frazil::BodyState())
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
    place(asLoaded());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

frazil::BodyState Foam::immersedBody::asLoaded() const
{
    frazil::BodyState state;
    name_.copy(state.name, sizeof(state.name) - 1);
    state.centre = mass_.centre;
    state.volume = mass_.volume;
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


void Foam::immersedBody::check(const frazil::BodyState& state) const
{
    if (mag(state.volume - mass_.volume) > volumeTolerance*mass_.volume)
    {
        throw frazil::InputError
        (
            "constant/couplingProperties",
            "bodies." + name_ + ".surface",
            file_,
            fmt::format
            (
                "its volume is {:.9g} m3, but body '{}' of frazilDem has "
                "{:.9g} m3",
                mass_.volume, state.name, state.volume
            ),
            "Give both programs the same surface, in the same unit of length."
        );
    }
}


void Foam::immersedBody::place(const frazil::BodyState& state)
{
    centre_ = mass_.centre - state.centroidOffset;
    pose_ = bodyPose(state);
}


Foam::boundBox Foam::immersedBody::bounds() const
{
    const frazil::Box box = lattice_->box();
    boundBox world(boundBox::invertedBox);
    for (int corner = 0; corner < 8; ++corner)
    {
        const frazil::Vec3 p
        {
            corner & 1 ? box.max.x : box.min.x,
            corner & 2 ? box.max.y : box.min.y,
            corner & 4 ? box.max.z : box.min.z
        };
        world.add(pose_.centre + (pose_.rotation & toVector(p - centre_)));
    }
    return world;
}


// ************************************************************************* //
