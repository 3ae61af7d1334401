#include "couplingSettings.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The words of an entry as plain text, strings without their quotes
std::string text(const Foam::entry& e)
{
    std::string words;

    for (const Foam::token& t : e.stream())
    {
        Foam::OStringStream os;
        if (t.isString())
        {
            os.writeQuoted(t.stringToken(), false);
        }
        else
        {
            os << t;
        }
        words += (words.empty() ? "" : " ") + os.str();
    }

    return words;
}


void copy(const Foam::dictionary& from, frazil::Settings& to)
{
    for (const Foam::entry& e : from)
    {
        if (e.isDict())
        {
            copy(e.dict(), to.addSub(e.keyword()));
        }
        else
        {
            to.set(e.keyword(), text(e));
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

frazil::Settings Foam::couplingSettings
(
    const dictionary& dict,
    const std::string& path
)
{
    // The bodies' entries are read, and checked, by immersedBodies
    dictionary own(dict);
    own.remove("bodies");

    frazil::Settings settings("constant/couplingProperties", path);
    copy(own, settings);
    return settings;
}


// ************************************************************************* //
