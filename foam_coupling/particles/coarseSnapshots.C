#include "coarseSnapshots.H"

#include <vector>

#include "World.h"

Foam::coarseSnapshots::coarseSnapshots(const frazil::CoarseGrid& grid, const bool continued)
:
    grid_(grid),
    file_
    (
        "coarse.h5",
        frazil::World::instance().own(),
        continued ? frazil::SnapshotFile::Mode::append : frazil::SnapshotFile::Mode::create
    )
{}


void Foam::coarseSnapshots::write(const frazil::CouplingStep& step, const label index, const scalar time)
{
    const label owned = step.cells().ownedCount();
    std::vector<double> solidFraction(owned), water(owned);
    std::vector<frazil::Vec3> velocity(owned);
    for (label cell = 0; cell < owned; ++cell)
    {
        const frazil::CoarseFluid& fluid = step.fluid()[cell];
        solidFraction[cell] = step.solidVolume()[cell]/grid_.cellVolume();
        water[cell] = fluid.wetFraction();
        velocity[cell] = fluid.velocity();
    }

    file_.begin(index, time);
    file_.coarse
    (
        "coarse",
        grid_,
        {
            {"solid fraction", 1, solidFraction.data()},
            {"water fraction", 1, water.data()},
            {"velocity", 3, reinterpret_cast<const double*>(velocity.data())}
        }
    );
    file_.end();
}


// ************************************************************************* //
