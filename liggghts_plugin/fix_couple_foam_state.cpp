/* fix couple/foam: what each particle carries, as it is sorted, migrates and goes through restart files. */

#include <cmath>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "coupling_history.h"
#include "fix_couple_foam.h"
#include "memory.h"
#include "update.h"

using namespace LAMMPS_NS;

double FixCoupleFoam::memory_usage()
{
    return double(atom->nmax) * (CARRIED + FORCES) * sizeof(double) +
           double(records_.capacity()) * (sizeof(frazil::ParticleRecord) + sizeof(frazil::ParticleReply) + sizeof(int));
}

void FixCoupleFoam::grow_arrays(int nmax)
{
    carried_.resize(nmax);
    memory->grow(array_atom, nmax, FORCES, "couple/foam:array_atom");
}

void FixCoupleFoam::copy_arrays(int i, int j, int)
{
    carried_[j] = carried_[i];
    memcpy(array_atom[j], array_atom[i], FORCES * sizeof(double));
}

/// A particle inserted during a fluid step feels the fluid from the next exchange on; those of the start are old
void FixCoupleFoam::set_arrays(int i)
{
    carried_[i] = frazil::CarriedParticle();
    if (exchangeStep_ < 0)
        carried_[i].age = HUGE_VAL;
    memset(array_atom[i], 0, FORCES * sizeof(double));
}

int FixCoupleFoam::pack_exchange(int i, double* buf)
{
    memcpy(buf, &carried_[i], sizeof(frazil::CarriedParticle));
    memcpy(buf + CARRIED, array_atom[i], FORCES * sizeof(double));
    return CARRIED + FORCES;
}

int FixCoupleFoam::unpack_exchange(int i, double* buf)
{
    memcpy(static_cast<void*>(&carried_[i]), buf, sizeof(frazil::CarriedParticle));
    memcpy(array_atom[i], buf + CARRIED, FORCES * sizeof(double));
    return CARRIED + FORCES;
}

/// Restart: the fluid time, the fluid step that has just ended, and per particle the same as in an exchange.
void FixCoupleFoam::write_restart(FILE* fp)
{
    const double state[2] = {fluidTimeNow(), lastDeltaT_};
    if (comm->me != 0)
        return;
    const int size = sizeof(state);
    fwrite(&size, sizeof(int), 1, fp);
    fwrite(state, sizeof(double), 2, fp);
}

void FixCoupleFoam::restart(char* buf)
{
    memcpy(&restartTime_, buf, sizeof(double));
    memcpy(&lastDeltaT_, buf + sizeof(double), sizeof(double));
    first_ = !(lastDeltaT_ > 0);
}

int FixCoupleFoam::pack_restart(int i, double* buf)
{
    buf[0] = size_restart(i);
    pack_exchange(i, buf + 1);
    return size_restart(i);
}

void FixCoupleFoam::unpack_restart(int nlocal, int nth)
{
    double* extra = atom->extra[nlocal];
    int m = 0;
    for (int i = 0; i < nth; i++)
        m += static_cast<int>(extra[m]);
    if (static_cast<int>(extra[m]) != size_restart(nlocal))
        stop("the restart file is of another version of Frazil. Continue it with that version, or start anew");
    unpack_exchange(nlocal, extra + m + 1);
    impulse_ += carried_[nlocal].impulse;
}

int FixCoupleFoam::size_restart(int)
{
    return 1 + CARRIED + FORCES;
}

int FixCoupleFoam::maxsize_restart()
{
    return size_restart(0);
}
