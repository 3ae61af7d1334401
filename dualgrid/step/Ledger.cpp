#include "Ledger.h"

#include <algorithm>

#include <fmt/format.h>

#include "Restriction.h"
#include "Sum.h"

namespace frazil
{

namespace
{

double relative(double difference, double scale)
{
    return scale > 0 ? difference / scale : difference;
}

} // namespace

void Ledger::addFine(const FineFlow& flow, const std::vector<double>& solidFraction, const std::vector<Vec3>& force,
                     double step)
{
    deltaT = step;
    for (std::size_t f = 0; f < flow.count; ++f) {
        fineVolume += solidFraction[f] * flow.open(f) * flow.volume[f];
        given -= deltaT * force[f];
    }
    given -= deltaT * passiveReturned;
}

void Ledger::sumOver(MPI_Comm comm)
{
    double* const numbers[] = {&particleVolume, &absentVolume, &coarseVolume, &fineVolume,
                               &clippedVolume,  &impulseScale, &passiveScale};
    Vec3* const vectors[] = {&received,        &carriedIn,      &coarseImpulse,   &given,   &unplaced,
                             &passiveReceived, &passiveCarried, &passiveReturned, &response};
    std::int64_t* const counts[] = {&particles, &dryParticles, &clippedCells};

    double sums[37];
    int n = 0;
    for (const double* number : numbers)
        sums[n++] = *number;
    for (const Vec3* vector : vectors) {
        for (int a = 0; a < 3; ++a)
            sums[n++] = (*vector)[a];
    }
    for (const std::int64_t* count : counts)
        sums[n++] = double(*count); // exact below 2^53
    sumOverRanks(sums, n, comm);
    n = 0;
    for (double* number : numbers)
        *number = sums[n++];
    for (Vec3* vector : vectors) {
        for (int a = 0; a < 3; ++a)
            (*vector)[a] = sums[n++];
    }
    for (std::int64_t* count : counts)
        *count = std::int64_t(sums[n++]);
}

double Ledger::volumeErrorCoarse() const
{
    return relative(std::abs(coarseVolume + absentVolume - particleVolume), particleVolume);
}

double Ledger::volumeErrorFine() const
{
    return relative(std::abs(fineVolume + clippedVolume - coarseVolume), particleVolume);
}

double Ledger::impulseErrorCoarse() const
{
    return relative(norm(coarseImpulse - received - carriedIn), impulseScale);
}

double Ledger::impulseErrorFine() const
{
    return relative(norm(given + unplaced - coarseImpulse), impulseScale + deltaT * passiveScale);
}

double Ledger::passiveError() const
{
    return relative(norm(passiveCarried + passiveReturned - passiveReceived), passiveScale);
}

std::string Ledger::csvHeader()
{
    return "time,particles,dryParticles,volumeParticles,volumeAbsent,volumeCoarse,volumeFine,volumeClipped,"
           "cellsClipped,"
           "volumeErrorCoarse,volumeErrorFine,"
           "impulseReceivedX,impulseReceivedY,impulseReceivedZ,impulseCarriedX,impulseCarriedY,impulseCarriedZ,"
           "impulseCoarseX,impulseCoarseY,impulseCoarseZ,impulseFineX,impulseFineY,impulseFineZ,"
           "impulseUnplacedX,impulseUnplacedY,impulseUnplacedZ,impulseHeldX,impulseHeldY,impulseHeldZ,"
           "impulseErrorCoarse,impulseErrorFine,"
           "passiveReceivedX,passiveReceivedY,passiveReceivedZ,passiveCarriedX,passiveCarriedY,passiveCarriedZ,"
           "passiveReturnedX,passiveReturnedY,passiveReturnedZ,responseX,responseY,responseZ,passiveError";
}

std::string Ledger::csvLine(double time) const
{
    std::string line = fmt::format("{:.9g},{},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.6g},{},{:.3g},{:.3g}", time,
                                   particles, dryParticles, particleVolume, absentVolume, coarseVolume, fineVolume,
                                   clippedVolume, clippedCells, volumeErrorCoarse(), volumeErrorFine());
    for (const Vec3* v : {&received, &carriedIn, &coarseImpulse, &given, &unplaced, &held}) {
        line += fmt::format(",{:.17g},{:.17g},{:.17g}", v->x, v->y, v->z);
    }
    line += fmt::format(",{:.3g},{:.3g}", impulseErrorCoarse(), impulseErrorFine());
    for (const Vec3* v : {&passiveReceived, &passiveCarried, &passiveReturned, &response}) {
        line += fmt::format(",{:.17g},{:.17g},{:.17g}", v->x, v->y, v->z);
    }
    return line + fmt::format(",{:.3g}", passiveError());
}

} // namespace frazil
