/// Where each particle is on the coarse grid: its share in the water, in the air and in the mesh, and its windows.
///
/// The kernel's stencil of a sphere is weighted anew for each question: solid by the volume of the mesh, whichever fluid
/// is in it, and whether or not a body is (αs must not move because they do); flow by the open water or air, each fluid
/// by itself; its reaction by fluid mass.
/// Cost: per particle a stencil, four times weighted, and its cut by the surface (WaterSurface.h). Parallel: local.
#pragma once

#include <vector>

#include "FluidOnGrid.h"
#include "Kernel.h"
#include "Ledger.h"
#include "LocalFlow.h"
#include "ParticleView.h"
#include "WaterSurface.h"

namespace frazil
{

/// A particle on the coarse grid.
struct Place {
    Stencil solid;   ///< weighted by volume: where its own volume is
    Stencil wet;     ///< by open water: where its share in the water sees the flow
    Stencil dry;     ///< by open air
    Stencil mass;    ///< by fluid mass: where its reaction goes; at the surface the water, not the air above it
    double wetShare; ///< of the sphere [-]
    double presence; ///< share of its volume that is in the mesh [-]; 0: it finds no fluid

    /// Of the fluid in the sphere's place [kg/m3].
    double density(const Phase& water, const Phase& air) const
    {
        return wetShare * water.density + (1 - wetShare) * air.density;
    }
};

class ParticlePlaces
{
  public:
    explicit ParticlePlaces(const Kernel& kernel) : kernel_(kernel) {}

    /// All particles; their number and volume go into the ledger. InputError for one that is not ours.
    void find(const ParticleView& particles, const FluidOnGrid& grid, CoarseState& state, Ledger& ledger);

    const Place& operator[](std::size_t particle) const { return places_[particle]; }

  private:
    void makeStencils(const ParticleView& particles, const LocalCells& cells);
    void findSurfaces(const ParticleView& particles, const FluidOnGrid& grid, const CoarseState& state);
    void finish(Place& place, const SphereShare& share, const FluidOnGrid& grid) const;

    const Kernel kernel_;
    std::vector<Place> places_;
    CoarseField<WaterSurface> surface_;
    CoarseField<char> needed_; ///< cells whose surface a sphere asks for
};

} // namespace frazil
