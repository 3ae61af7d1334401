#include "Restriction.h"

namespace frazil
{

void restrictSums(const FineParts& parts, const FineFlow& flow, const LocalCells& cells, CoarseField<CoarseFluid>& sums)
{
    sums.reset(cells);
    for (int row = 0; row < parts.rows(); ++row) {
        CoarseFluid& sum = sums[parts.coarseCell(row)];
        const Vec3 centre = cells.grid().centre(cells.global(parts.coarseCell(row)));
        for (const FinePart* part = parts.begin(row); part != parts.end(row); ++part) {
            const int f = part->fineCell;
            const double w = flow.fluidFraction[f] * part->volume;
            const double open = flow.open(f) * part->volume, water = flow.wetFraction[f] * open;
            const Vec3 place = part->centroid - centre;
            sum.openVolume += open;
            sum.openWater += water;
            sum.openMoment += open * place;
            sum.waterMoment += water * place;
            sum.fluidVolume += w;
            sum.fluidMass += flow.density[f] * w;
            sum.wetFraction += flow.wetFraction[f] * w;
            sum.velocity += w * flow.velocity[f];
            sum.pressureGradient += w * flow.pressureGradient[f];
            sum.viscousForce += w * flow.viscousForce[f];
            sum.accelerated += w * flow.accelerated(f);
            sum.acceleration += w * flow.accelerated(f) * flow.acceleration[f];
            sum.vorticity += w * flow.vorticity[f];
        }
    }
}

void finishAverages(CoarseFluid& cell, double cellVolume)
{
    // Less than this share of the cell is round-off of the cutting, not fluid.
    if (!(cell.fluidVolume > 1e-12 * cellVolume)) {
        cell = CoarseFluid{};
        return;
    }
    const double scale = 1 / cell.fluidVolume;
    cell.wetFraction *= scale;
    for (Vec3* average : {&cell.velocity, &cell.pressureGradient, &cell.viscousForce, &cell.vorticity})
        *average *= scale;
    if (cell.accelerated > 0)
        cell.acceleration *= 1 / cell.accelerated;
    cell.accelerated *= scale;
}

} // namespace frazil
