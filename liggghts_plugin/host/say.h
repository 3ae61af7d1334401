/* A line on the screen and in the log file, once, whatever the number of ranks. */

#ifndef FRAZIL_SAY_H
#define FRAZIL_SAY_H

#include "World.h"
#include "lammps.h"

#include <cstdio>
#include <string>

namespace frazil
{

/// `line` ends with a line feed. Also at the end of LIGGGHTS, which by then has deleted its communicator.
inline void say(const LAMMPS_NS::LAMMPS& lammps, const std::string& line)
{
    if (World::instance().ownRank() != 0)
        return;
    for (FILE* file : {lammps.screen, lammps.logfile})
        if (file)
            std::fputs(line.c_str(), file), std::fflush(file);
}

} // namespace frazil

#endif
