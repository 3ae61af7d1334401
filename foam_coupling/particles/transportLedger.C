#include "transportLedger.H"

#include <cmath>
#include <cstddef>

#include "Columns.h"
#include "Sum.h"
#include "World.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- What arrived, summed over the fluid ranks
struct Arrived
{
    double particles = 0;
    double volume = 0;                 // [m3]
    frazil::Vec3 impulse;              // [N s]
    double impulseScale = 0;           // sum of the magnitudes [N s]
};


Arrived arrived(const frazil::ParticleView& particles)
{
    Arrived here;
    here.particles = double(particles.count);
    for (std::size_t p = 0; p < particles.count; ++p)
    {
        here.volume += 4.0/3.0*M_PI*std::pow(particles.radius[p], 3);
        here.impulse += particles.impulse[p];
        here.impulseScale += norm(particles.impulse[p]);
    }

    const frazil::Vec3& j = here.impulse;
    double sums[] = {here.particles, here.volume, j.x, j.y, j.z, here.impulseScale};
    frazil::sumOverRanks(sums, 6, frazil::World::instance().own());
    return {sums[0], sums[1], {sums[2], sums[3], sums[4]}, sums[5]};
}


double relative(const double difference, const double scale)
{
    return scale > 0 ? difference/scale : difference;
}


//- One exchange
struct Transport
{
    frazil::StepReport report;
    Arrived here;
    double before;  // particles that arrived with the exchange before

    double lost() const { return before - here.particles; }
    double volumeError() const
    {
        return relative(std::abs(here.volume - report.solidVolume), report.solidVolume);
    }
    double impulseError() const
    {
        return relative(norm(here.impulse - report.impulse), here.impulseScale);
    }
};


frazil::Columns<Transport> allColumns()
{
    const char* const exact = "{:.17g}";
    const char* const error = "{:.3g}";
    return frazil::Columns<Transport>()
        .add("demParticles", "{}", [](const Transport& t) { return t.report.particles; })
        .add("particlesLost", "{}", &Transport::lost)
        .add("demVolume", exact, [](const Transport& t) { return t.report.solidVolume; })
        .addVector("demImpulse", exact, [](const Transport& t) { return t.report.impulse; })
        .addVector("demMomentum", exact, [](const Transport& t) { return t.report.momentum; })
        .add("volumeErrorTransport", error, &Transport::volumeError)
        .add("impulseErrorTransport", error, &Transport::impulseError);
}


const frazil::Columns<Transport>& columns()
{
    static const frazil::Columns<Transport> list = allColumns();
    return list;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::string Foam::transportLedger::header()
{
    return "," + columns().header();
}


std::string Foam::transportLedger::line
(
    const frazil::StepReport& report,
    const frazil::ParticleView& particles
)
{
    const Arrived here = arrived(particles);
    const double before = arrivedBefore_ < 0 ? report.particles : arrivedBefore_;
    arrivedBefore_ = here.particles;
    return "," + columns().line({report, here, before});
}


// ************************************************************************* //
