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

/// Less than this share of a coarse cell is round-off of the cutting, or what diffusion has left: nothing is there.
const double nothing = 1e-12;

void finish(CoarsePhase& phase, double cellVolume)
{
    if (!(phase.volume > nothing * cellVolume)) {
        phase = CoarsePhase{};
        return;
    }
    const double scale = 1 / phase.volume;
    phase.velocity *= scale;
    phase.vorticity *= scale;
    if (phase.accelerated > nothing * phase.volume)
        phase.acceleration *= 1 / phase.accelerated;
    else
        phase.acceleration = Vec3{};
    phase.accelerated *= scale;
}

void add(CoarsePush& sum, double volume, const Vec3& pressureGradient, const Vec3& viscousForce)
{
    sum.volume += volume;
    sum.pressureGradient += volume * pressureGradient;
    sum.viscousForce += volume * viscousForce;
}

void finish(CoarsePush& push, double cellVolume)
{
    if (!(push.volume > nothing * nothing * cellVolume))
        return;
    push.pressureGradient *= 1 / push.volume;
    push.viscousForce *= 1 / push.volume;
}

} // namespace

void restrictSums(const FineParts& parts, const FineFlow& flow, const LocalCells& cells, CoarseField<CoarseFluid>& sums)
{
    sums.reset(cells);
    for (int row = 0; row < parts.rows(); ++row) {
        CoarseFluid& sum = sums[parts.coarseCell(row)];
        const Vec3 centre = cells.grid().centre(cells.global(parts.coarseCell(row)));
        for (const FinePart* part = parts.begin(row); part != parts.end(row); ++part) {
            const int f = part->fineCell;
            const double w = flow.fluidFraction[f] * part->volume, wet = flow.wet(f);
            const double open = flow.open(f) * part->volume, water = wet * open;
            const Vec3 place = part->centroid - centre;
            sum.openVolume += open;
            sum.openWater += water;
            sum.openMoment += open * place;
            sum.waterMoment += water * place;
            sum.fluidVolume += w;
            sum.fluidMass += flow.density[f] * w;
            if (wet > 0)
                add(sum.water, flow, f, wet * w);
            if (wet < 1)
                add(sum.air, flow, f, (1 - wet) * w);
        }
    }
}

void finishAverages(CoarseFluid& cell, double cellVolume)
{
    if (!(cell.fluidVolume > nothing * cellVolume)) {
        cell = CoarseFluid{};
        return;
    }
    finish(cell.water, cellVolume);
    finish(cell.air, cellVolume);
}

void restrictLoad(const FineParts& parts, const FineFlow& flow, const PassiveForces& forces, const double* wetSolid,
                  const double* drySolid, const LocalCells& cells, CoarseField<SolidLoad>& sums)
{
    sums.reset(cells);
    std::size_t p = 0;
    for (int row = 0; row < parts.rows(); ++row) {
        SolidLoad& sum = sums[parts.coarseCell(row)];
        for (const FinePart* part = parts.begin(row); part != parts.end(row); ++part, ++p) {
            const double wet = wetSolid[p], dry = drySolid[p];
            if (!(wet > 0 || dry > 0))
                continue;
            const int f = part->fineCell;
            const Vec3 gradient = forces.pressureGradient ? flow.pressureGradient[f] : Vec3{};
            const Vec3 viscous = forces.viscous ? flow.viscousForce[f] : Vec3{};
            const Vec3 weight = forces.pressureGradient ? flow.density[f] * forces.gravity : Vec3{};
            add(sum.wet, wet, gradient - weight, viscous);
            add(sum.dry, dry, gradient - weight, viscous);
            sum.carried += (wet + dry) * (viscous - gradient);
        }
    }
}

void finishAverages(SolidLoad& cell, double cellVolume)
{
    finish(cell.wet, cellVolume);
    finish(cell.dry, cellVolume);
}

} // namespace frazil
