/* frazilDem: stock LIGGGHTS plus the styles of this folder. Alone it is `liggghts`, digit for digit. */

#include <csignal>
#include <cstring>
#include <mpi.h>

#include "input.h"
#include "lammps.h"
#include "register_styles.h"
#include "signal_handling.h"

#include "World.h"

using namespace LAMMPS_NS;

namespace
{

void handle(int signal, void (*handler)(int))
{
    struct sigaction action;
    std::memset(&action, 0, sizeof(action));
    action.sa_handler = handler;
    sigaction(signal, &action, nullptr);
}

} // namespace

int main(int argc, char** argv)
{
    // as liggghts: end the run cleanly, with a restart file where asked for. mpirun turns SIGINT into SIGTERM.
    handle(SIGINT, SignalHandler::int_handler);
    handle(SIGTERM, SignalHandler::int_handler);
    handle(SIGUSR1, SignalHandler::usr1_handler);

    frazil::World::declare(frazil::Side::dem);
    MPI_Init(&argc, &argv);

    LAMMPS* lammps = new LAMMPS(argc, argv, frazil::World::instance().own());
    frazil::registerStyles(lammps);
    lammps->input->file();
    delete lammps;

    MPI_Finalize();
}
