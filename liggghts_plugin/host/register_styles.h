/* Makes Frazil's styles known to LIGGGHTS, which has no plugin loader. */

#ifndef FRAZIL_REGISTER_STYLES_H
#define FRAZIL_REGISTER_STYLES_H

#include "lammps.h"

namespace frazil
{

/* Add the styles to this instance, now and again after every `clear` of the input script
   (which replaces the tables of styles). */
void registerStyles(LAMMPS_NS::LAMMPS*);

} // namespace frazil

#endif
