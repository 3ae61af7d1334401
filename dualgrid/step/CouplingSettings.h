/// What the user says of the coupling step: constants of a run.
#pragma once

#include "ForceModel.h"
#include "Kernel.h"
#include "Prolongation.h"
#include "Settings.h"

namespace frazil
{

struct CouplingSettings {
    bool dualGrid = true; ///< off: each particle couples with the fine cell that holds its centre
    Kernel kernel;
    ProlongationSettings prolongation;
    double smallestFluidFraction = 0.25; ///< αf never falls below [-]
    bool momentumExchange = true;        ///< off: the fluid does not feel drag and added mass

    /// Reads the keys that CouplingStep.h lists, but for `forces`.
    static CouplingSettings read(const Settings& settings);
};

/// All that the phases of a step need to know and that never changes.
struct CouplingModel {
    CouplingSettings settings;
    ForceModel forces;
    Phase water, air;
    Vec3 gravity; ///< [m/s2]
};

} // namespace frazil
