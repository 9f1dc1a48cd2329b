// Roughness as a distance between surfaces (gap-energy, "Roughness").
#pragma once

#include "gapflow/complex/gap_arm.hpp"
#include "gapflow/scene/scene.hpp"

#include <vector>

namespace gapflow {

/// Solids as the complex takes them, and what pairs that are nearer than their roughness lack of it where they are nearest.
template <int D>
struct RoughSolids {
    std::vector<Solid<D>> solids; ///< those that touch are a little apart
    Standoffs<D> standoffs;       ///< gaps have the shape that they had if the surfaces were moved apart by it
};

/// The same on all ranks. Fixed solids that no [[pair]] names are one where they touch: they have no standoff.
template <int D>
RoughSolids<D> rough_solids(const Scene& scene, const Grid<D>& grid, std::vector<Solid<D>> solids);

} // namespace gapflow
