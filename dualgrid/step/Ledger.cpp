#include "Ledger.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "Columns.h"
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

const char* const whole = "{}";
const char* const exact = "{:.17g}";
const char* const rounded = "{:.6g}";
const char* const error = "{:.3g}";

Columns<Ledger> allColumns()
{
    return Columns<Ledger>()
        .add("particles", whole, &Ledger::particles)
        .add("dryParticles", whole, &Ledger::dryParticles)
        .add("volumeParticles", exact, &Ledger::particleVolume)
        .add("volumeAbsent", exact, &Ledger::absentVolume)
        .add("volumeCoarse", exact, &Ledger::coarseVolume)
        .add("volumeFine", exact, &Ledger::fineVolume)
        .add("volumeClipped", rounded, &Ledger::clippedVolume)
        .add("cellsClipped", whole, &Ledger::clippedCells)
        .add("volumeErrorCoarse", error, &Ledger::volumeErrorCoarse)
        .add("volumeErrorFine", error, &Ledger::volumeErrorFine)
        .addVector("impulseReceived", exact, &Ledger::received)
        .addVector("impulseCarried", exact, &Ledger::carriedIn)
        .addVector("impulseCoarse", exact, &Ledger::coarseImpulse)
        .addVector("impulseFine", exact, &Ledger::given)
        .addVector("impulseUnplaced", exact, &Ledger::unplaced)
        .addVector("impulseHeld", exact, &Ledger::held)
        .add("impulseErrorCoarse", error, &Ledger::impulseErrorCoarse)
        .add("impulseErrorFine", error, &Ledger::impulseErrorFine)
        .addVector("passiveReceived", exact, &Ledger::passiveReceived)
        .addVector("passiveCarried", exact, &Ledger::passiveCarried)
        .addVector("passiveReturned", exact, &Ledger::passiveReturned)
        .addVector("response", exact, &Ledger::response)
        .add("passiveError", error, &Ledger::passiveError);
}

const Columns<Ledger>& columns()
{
    static const Columns<Ledger> list = allColumns();
    return list;
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

    std::vector<double> sums;
    for (const double* number : numbers)
        sums.push_back(*number);
    for (const Vec3* vector : vectors)
        sums.insert(sums.end(), {vector->x, vector->y, vector->z});
    for (const std::int64_t* count : counts)
        sums.push_back(double(*count)); // exact below 2^53
    sumOverRanks(sums.data(), int(sums.size()), comm);
    int n = 0;
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
    return "time," + columns().header();
}

std::string Ledger::csvLine(double time) const
{
    return fmt::format("{:.9g},", time) + columns().line(*this);
}

} // namespace frazil
