#include "fluidCoupling.H"
#include "couplingSettings.H"
#include "pairExchange.H"
#include "prescribedMotion.H"
#include "IOdictionary.H"
#include "zeroGradientFvPatchFields.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Density and dynamic viscosity of phase number n of transportProperties
frazil::Phase phase(const Foam::dictionary& transport, const Foam::label n)
{
    using namespace Foam;

    const wordList names(transport.get<wordList>("phases"));
    const dictionary& dict = transport.subDict(names[n]);
    const scalar rho = dimensionedScalar("rho", dimDensity, dict).value();
    const scalar nu = dimensionedScalar("nu", dimViscosity, dict).value();
    return {rho, rho*nu};
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fluidCoupling> Foam::fluidCoupling::New
(
    const fvMesh& mesh,
    const dictionary& transportProperties,
    const dimensionedVector& g
)
{
    IOdictionary properties
    (
        IOobject
        (
            "couplingProperties",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );

    if (!properties.typeHeaderOk<IOdictionary>(true))
    {
        return nullptr;
    }

    return autoPtr<fluidCoupling>
    (
        new fluidCoupling(mesh, properties, transportProperties, g)
    );
}


Foam::fluidCoupling::fluidCoupling
(
    const fvMesh& mesh,
    const dictionary& couplingProperties,
    const dictionary& transportProperties,
    const dimensionedVector& g
)
:
    mesh_(mesh),
    fluidFraction_
    (
        IOobject("fluidFraction", mesh.time().timeName(), mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE),
        mesh,
        dimensionedScalar("one", dimless, 1.0),
        zeroGradientFvPatchScalarField::typeName
    ),
    reaction_(mesh),
    fluidFractionRead_(fluidFraction_.headerOk())
{
    const dictionary bodies(couplingProperties.subOrEmptyDict("bodies"));
    if (!bodies.empty())
    {
        makeBodies(bodies);
    }

    const frazil::Settings settings(couplingSettings(couplingProperties));
    settings.has("bodies");  // read above; known, for the message on others
    if (settings.flag("coupling", true))
    {
        makeExchange(settings, transportProperties, g.value());
    }
    else
    {
        pairExchange::learnKeys(settings);
        settings.finish();
        motion_.reset(new prescribedMotion(bodies, loadedStates()));
    }
}


Foam::fluidCoupling::~fluidCoupling()
{}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::fluidCoupling::makeBodies(const dictionary& bodies)
{
    bodies_.reset(new immersedBodies(mesh_, bodies));
    loads_.reset(new heldLoads(mesh_, bodies_->hellos()));
    if (!bodies_->continued())
    {
        bodies_->place(loadedStates());
    }
}


void Foam::fluidCoupling::makeExchange
(
    const frazil::Settings& settings,
    const dictionary& transportProperties,
    const vector& g
)
{
    exchange_.reset
    (
        new pairExchange
        (
            mesh_,
            settings,
            phase(transportProperties, 0),
            phase(transportProperties, 1),
            toVec3(g),
            bodies_.valid() ? bodies_->hellos() : std::vector<frazil::BodyHello>()
        )
    );
}


std::vector<frazil::BodyState> Foam::fluidCoupling::loadedStates() const
{
    if (bodies_.valid())
    {
        return bodies_->asLoaded();
    }
    return {};
}


void Foam::fluidCoupling::updateParticles(const flowOnParticles& flow)
{
    scalarField open;
    std::vector<frazil::BodyLoad> loads;
    if (bodies_.valid())
    {
        open = 1.0 - bodies_->gamma().primitiveField();
        loads = loads_->loads();
    }
    exchange_->advance(flow, open, toVec3(reaction_.ahead()), loads);
    const frazil::FineSource& source = exchange_->source();

    // Trigger the storage of the old value before the new one comes in
    fluidFraction_.storeOldTimes();

    scalarField& alphaf = fluidFraction_.primitiveFieldRef();
    forAll(alphaf, celli)
    {
        alphaf[celli] = 1 - source.solidFraction[celli];
    }

    fluidFraction_.correctBoundaryConditions();
    reaction_.take(source);

    // At the very start the particles have always been where they are
    if (firstStep_ && !fluidFractionRead_)
    {
        fluidFraction_.oldTime() == fluidFraction_;
    }
}


void Foam::fluidCoupling::updateBodies
(
    const std::vector<frazil::BodyState>& states
)
{
    // frazilDem may have moved its surfaces before the coupling began; a prescribed motion starts anew in each run
    if (firstStep_ && (motion_ || !bodies_->continued()))
    {
        bodies_->place(states);
    }
    bodies_->move(states, deltaT_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fluidCoupling::demDeltaT() const
{
    return exchange_ ? exchange_->demDeltaT() : 0;
}


Foam::scalar Foam::fluidCoupling::beginStep(const scalar deltaT)
{
    deltaT_ = exchange_ ? exchange_->agree(deltaT) : deltaT;
    return deltaT_;
}


void Foam::fluidCoupling::update(const flowOnParticles& flow)
{
    std::vector<frazil::BodyState> states;
    if (exchange_)
    {
        states = exchange_->receive();
    }
    else if (motion_)
    {
        states = motion_->states();
    }
    if (bodies_.valid())
    {
        updateBodies(states);
    }
    if (exchange_)
    {
        updateParticles(flow);
    }
    if (motion_)
    {
        motion_->advance(deltaT_);
    }
    firstStep_ = false;
}


void Foam::fluidCoupling::endStep(const std::vector<frazil::BodyLoad>& loads)
{
    if (bodies_.valid())
    {
        loads_->hold(loads);
    }
}


void Foam::fluidCoupling::finish()
{
    if (exchange_)
    {
        exchange_->finish();
    }
}


// ************************************************************************* //
