#include "FluidOnGrid.h"

#include "FilledBox.h"
#include "ParticleTerms.h"
#include "Sum.h"

namespace frazil
{

namespace
{

/// Volume and centroid of the mesh in each coarse cell, this rank's share.
CoarseField<MeshShare> sharesOf(const FineParts& parts, const LocalCells& cells)
{
    CoarseField<MeshShare> shares(cells);
    for (int row = 0; row < parts.rows(); ++row) {
        const int cell = parts.coarseCell(row);
        const Vec3 centre = cells.grid().centre(cells.global(cell));
        for (const FinePart* part = parts.begin(row); part != parts.end(row); ++part) {
            shares[cell].volume += part->volume;
            shares[cell].moment += part->volume * (part->centroid - centre);
        }
    }
    return shares;
}

} // namespace

FluidOnGrid::FluidOnGrid(const LocalCells& cells, MPI_Comm ranks)
    : comm(ranks), plan(cells, ranks), filled(cells), meshVolume(cells)
{
}

void FluidOnGrid::setParts(const std::vector<FinePiece>& pieces, CoarseState& state)
{
    LocalCells& cells = state.cells;
    cells = LocalCells(cells.grid(), rankIn(comm), touchedCells(pieces));
    plan = ExchangePlan(cells, comm);
    parts = FineParts(pieces, cells);
    CoarseField<MeshShare> shares = sharesOf(parts, cells);
    complete(shares);
    filled.reset(cells);
    meshVolume.reset(cells);
    for (int c = 0; c < cells.count(); ++c) {
        filled[c] = filledBox(cells.grid().cellBox(cells.grid().index(cells.global(c))), shares[c]);
        meshVolume[c] = shares[c].volume;
    }
}

void FluidOnGrid::restrictFluid(const FineFlow& flow, const Vec3& gravity, CoarseState& state)
{
    const PhaseTimer::Scope scope(state.timer, PhaseTimer::restriction);
    const LocalCells& cells = state.cells;
    restrictSums(parts, flow, gravity, cells, state.fluid);
    plan.accumulate(state.fluid.data());
    for (int c = 0; c < cells.ownedCount(); ++c)
        finishAverages(state.fluid[c], cells.grid().cellVolume());
    plan.update(state.fluid.data());
    for (CoarseField<double>* field : {&openVolume, &solidWindow, &openWater, &openAir, &fluidMass})
        field->reset(cells);
    const double least = roundOffShare * cells.grid().cellVolume();
    for (int c = 0; c < cells.count(); ++c) {
        const CoarseFluid& here = state.fluid[c];
        fluidMass[c] = here.fluidMass;
        if (!here.hasFluid())
            continue;
        // The open volume, not the fluid's: spheres displace the fluid around them, and what is free of them elsewhere
        // would draw more than its share
        openVolume[c] = here.openVolume;
        solidWindow[c] = here.openVolume > least ? meshVolume[c] : 0;
        openWater[c] = here.openWater > least ? here.openWater : 0;
        openAir[c] = here.openAir() > least ? here.openAir() : 0;
    }
}

} // namespace frazil
