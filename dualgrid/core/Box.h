/// Axis-aligned box [m].
#pragma once

#include "Vec3.h"

namespace frazil
{

struct Box {
    Vec3 min, max;

    Vec3 size() const { return max - min; }
    bool contains(const Vec3& p) const
    {
        return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z && p.z <= max.z;
    }
};

} // namespace frazil
