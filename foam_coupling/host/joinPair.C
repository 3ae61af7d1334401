#include "joinPair.H"
#include "UPstream.H"

#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <string>

#include "World.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Not a catch in main: by then OpenFOAM's destructors would have ended MPI, and the partner would never learn the reason
void failed()
{
    std::string reason = "an unknown exception";
    try
    {
        throw;
    }
    catch (const std::exception& error)
    {
        reason = error.what();
    }
    catch (...)
    {}

    if (frazil::World::started())
    {
        frazil::World::instance().fail(reason);
    }
    std::cerr << "\nfrazilFoam: " << reason << std::endl;
    std::_Exit(1);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::joinPair(int& argc, char**& argv)
{
    std::set_terminate(failed);
    frazil::World::declare(frazil::Side::foam);
    bool parallel = false;
    for (int i = 1; i < argc; ++i)
    {
        parallel = parallel || std::strcmp(argv[i], "-parallel") == 0;
    }
    if (!parallel && frazil::World::startedByMpirun())
    {
        UPstream::initNull();
    }
}


// ************************************************************************* //
