/// The fine mesh and its fluid on the coarse grid: which part of each coarse cell is mesh, open, water, air, and the means
/// of both fluids there (Restriction.h).
///
/// Cost: a pass over the parts of the fine cells. Parallel: collective, two halo exchanges.
#pragma once

#include <vector>

#include <mpi.h>

#include "Box.h"
#include "CoarseState.h"
#include "ExchangePlan.h"
#include "FineParts.h"
#include "Overlap.h"

namespace frazil
{

class FluidOnGrid
{
  public:
    FluidOnGrid(const LocalCells& cells, MPI_Comm comm);

    /// Takes over the pieces of this rank's fine cells; state.cells grows by those that they touch.
    void setParts(const std::vector<FinePiece>& pieces, CoarseState& state);

    /// fine -> coarse: averages of water and air into state.fluid, and the windows below.
    void restrictFluid(const FineFlow& flow, const Vec3& gravity, CoarseState& state);

    /// Every rank's contributions to the owner, the owner's sum to every copy.
    template <class T> void complete(CoarseField<T>& field)
    {
        plan.accumulate(field.data());
        plan.update(field.data());
    }

    MPI_Comm comm;
    ExchangePlan plan;
    FineParts parts;
    CoarseField<Box> filled;                            ///< part of each cell that is in the mesh
    CoarseField<double> meshVolume;                     ///< of it [m3]
    CoarseField<double> solidWindow;                    ///< meshVolume of the cells that hold fluid [m3]
    CoarseField<double> openVolume, openWater, openAir; ///< of the cells that hold fluid [m3]
    CoarseField<double> fluidMass;                      ///< [kg]
};

} // namespace frazil
