// Volume of a solid as the planes of the grid see it.
#pragma once

#include "gapflow/complex/area_derivative.hpp"
#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/placed.hpp"

namespace gapflow {

/// Sum of the solid's sections with the planes normal to d, in the grid of the core continued without end; of one that is inside out that of its cavity.
template <int D>
double seen_volume(const PlacedSolid<D>& solid, int d);

/// From a solid's reference point to the middle of a cell; along a periodic axis the short way.
template <int D>
Vec<D> way_from(const Grid<D>& grid, const GridPlanes<D>& planes, const Vec<D>& reference, const Index<D>& cell);

/// Of each solid: what the planes see of it more than its volume, times the share of the solid that is in the fluid: inside the domain and not within another
/// solid. That share is the volume that the planes see through the walls of the complex, over that of the whole solid. `derivatives`: fills the
/// rates; null: not wanted.
template <int D>
std::vector<Vec<D>> seen_excess(const Grid<D>& grid, const GridPlanes<D>& planes, std::span<const Solid<D>> solids,
                                const std::vector<PlacedSolid<D>>& placed, const Complex<D>& complex,
                                FaceDerivatives<D>* derivatives);

} // namespace gapflow
