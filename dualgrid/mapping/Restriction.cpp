#include "Restriction.h"

namespace frazil
{

namespace
{

void add(CoarsePhase& sum, const FineFlow& flow, std::size_t f, double volume)
{
    const double accelerated = volume * flow.accelerated(f);
    sum.volume += volume;
    sum.velocity += volume * flow.velocity[f];
    sum.accelerated += accelerated;
    sum.acceleration += accelerated * flow.acceleration[f];
    sum.vorticity += volume * flow.vorticity[f];
}

void finish(CoarsePhase& phase, double cellVolume)
{
    if (!(phase.volume > roundOffShare * cellVolume)) {
        phase = CoarsePhase{};
        return;
    }
    const double scale = 1 / phase.volume;
    phase.velocity *= scale;
    phase.vorticity *= scale;
    if (phase.accelerated > roundOffShare * phase.volume)
        phase.acceleration *= 1 / phase.accelerated;
    else
        phase.acceleration = Vec3{};
    phase.accelerated *= scale;
}

} // namespace

void restrictSums(const FineParts& parts, const FineFlow& flow, const Vec3& gravity, const LocalCells& cells,
                  CoarseField<CoarseFluid>& sums)
{
    sums.reset(cells);
    for (int row = 0; row < parts.rows(); ++row) {
        CoarseFluid& sum = sums[parts.coarseCell(row)];
        const Vec3 centre = cells.grid().centre(cells.global(parts.coarseCell(row)));
        for (const FinePart* part = parts.begin(row); part != parts.end(row); ++part) {
            const int f = part->fineCell;
            const double w = flow.fluidShare[f] * part->volume, wet = flow.wet(f);
            const double open = flow.open(f) * part->volume, water = wet * open;
            const Vec3 place = part->centroid - centre;
            sum.openVolume += open;
            sum.openWater += water;
            sum.openMoment += open * place;
            sum.waterMoment += water * place;
            sum.fluidVolume += w;
            sum.fluidMass += flow.density[f] * w;
            sum.pressureGradient += w * (flow.pressureGradient[f] - flow.density[f] * gravity);
            sum.viscousForce += w * flow.viscousForce[f];
            if (wet > 0)
                add(sum.water, flow, f, wet * w);
            if (wet < 1)
                add(sum.air, flow, f, (1 - wet) * w);
        }
    }
}

void finishAverages(CoarseFluid& cell, double cellVolume)
{
    if (!(cell.fluidVolume > roundOffShare * cellVolume)) {
        cell = CoarseFluid{};
        return;
    }
    cell.pressureGradient *= 1 / cell.fluidVolume;
    cell.viscousForce *= 1 / cell.fluidVolume;
    finish(cell.water, cellVolume);
    finish(cell.air, cellVolume);
}

void restrictLoad(const FineParts& parts, const FineFlow& flow, const PassiveForces& forces, const double* solid,
                  const LocalCells& cells, CoarseField<SolidLoad>& sums)
{
    sums.reset(cells);
    for (int row = 0; row < parts.rows(); ++row) {
        SolidLoad& sum = sums[parts.coarseCell(row)];
        for (const FinePart* part = parts.begin(row); part != parts.end(row); ++part, ++solid) {
            const double volume = *solid;
            if (!(volume > 0))
                continue;
            const int f = part->fineCell;
            if (forces.pressureGradient) {
                sum.carried -= volume * (flow.pressureGradient[f] - flow.density[f] * forces.gravity);
                sum.displaced += volume * flow.density[f];
            }
            if (forces.viscous)
                sum.carried += volume * flow.viscousForce[f];
        }
    }
}

} // namespace frazil
