#include "carriedImpulse.H"
#include "DynamicList.H"
#include "Pstream.H"
#include "Time.H"

Foam::carriedImpulse::carriedImpulse(const fvMesh& mesh)
:
    rows_
    (
        IOobject
        (
            "carriedImpulse",
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    )
{}


void Foam::carriedImpulse::restore(frazil::CouplingStep& step) const
{
    std::vector<frazil::CarriedImpulse> waiting;
    for (label row = 0; row + words <= rows_.size(); row += words)
    {
        const scalar* word = rows_.cdata() + row;
        waiting.push_back({std::int64_t(word[0]), {word[1], word[2], word[3]}});
    }
    step.setCarried(waiting);
}


void Foam::carriedImpulse::keep(const frazil::CouplingStep& step, const bool any)
{
    rows_.clear();
    if (!any)
    {
        return;
    }
    List<scalarList> ofRanks(Pstream::nProcs());
    DynamicList<scalar> mine;
    for (const frazil::CarriedImpulse& waiting : step.carried())
    {
        for (const scalar word : {scalar(waiting.cell), waiting.impulse.x, waiting.impulse.y, waiting.impulse.z})
        {
            mine.append(word);
        }
    }
    ofRanks[Pstream::myProcNo()] = mine;
    Pstream::gatherList(ofRanks);
    Pstream::scatterList(ofRanks);
    for (const scalarList& rows : ofRanks)
    {
        rows_.append(rows);
    }
}


// ************************************************************************* //
