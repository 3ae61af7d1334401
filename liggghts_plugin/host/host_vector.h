/* The hosts' rows of three numbers as vectors. */

#ifndef FRAZIL_HOST_VECTOR_H
#define FRAZIL_HOST_VECTOR_H

#include "Vec3.h"

namespace frazil
{

inline Vec3 vec(const double* row)
{
    return {row[0], row[1], row[2]};
}

} // namespace frazil

#endif
