/// What the two programs tell each other once, before the first step, and the comparison that both make of it.
///
/// Both sides compare the same two hellos with the same function, so both print the same refusal.
/// Cost: one message each way. Parallel: the first ranks talk, then each tells its own.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "Box.h"
#include "Vec3.h"

namespace frazil
{

/// Version of the messages; raised when a record or its meaning changes.
constexpr std::int64_t messageVersion = 5;

struct BodyHello {
    std::string name;
    double volume = 0; ///< of the closed surface [m3]
};

/// Are these the volumes [m3] of one surface, read by two programs or in two runs? Ascii STL files keep six digits.
inline bool sameVolume(double a, double b)
{
    return std::fabs(a - b) <= 1e-6 * std::fabs(b);
}

struct DemHello {
    std::int64_t version = messageVersion;
    std::string units = "si";   ///< LIGGGHTS's unit style
    Vec3 gravity;               ///< of fix gravity; zero without one [m/s2]
    double startTime = 0;       ///< DEM time at the handshake, its own clock [s]
    double endTime = 0;         ///< at the end of the run (`run ... stop`) [s]
    double deltaT = 0;          ///< DEM time step [s]
    double fluidTime = -1;      ///< fluid time that a restart file belongs to [s]; negative: not restarted
    Box reach;                  ///< bounding box of the coupled particles' centres [m]
    double largestRadius = 0;   ///< of the coupled particles [m]
    std::int64_t particles = 0; ///< in the group of fix couple/foam
    std::vector<BodyHello> bodies;
};

struct FoamHello {
    std::int64_t version = messageVersion;
    Vec3 gravity;           ///< constant/g [m/s2]
    double startTime = 0;   ///< [s]
    double endTime = 0;     ///< controlDict endTime [s]
    Box mesh;               ///< bounding box of the fluid mesh [m]
    Box coarse;             ///< coarseGrid min max, in whole cells [m]
    double cellSize = 0;    ///< coarseGrid cellSize [m]
    std::int64_t ranks = 1; ///< owners of the coarse grid; filled in by FoamLink
    double watchdog = 600;  ///< couplingProperties watchdog [s]
    std::vector<BodyHello> bodies;
};

/// What does not fit, each with both values and the cure, one per line; empty if the two may work together.
std::string mismatch(const DemHello& dem, const FoamHello& foam);

std::vector<char> pack(const DemHello& hello);
std::vector<char> pack(const FoamHello& hello);
DemHello unpackDemHello(const std::vector<char>& bytes);
FoamHello unpackFoamHello(const std::vector<char>& bytes);

} // namespace frazil
