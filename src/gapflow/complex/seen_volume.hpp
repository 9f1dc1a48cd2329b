// Volume of a solid as the planes of the grid see it.
#pragma once

#include "gapflow/complex/placed.hpp"

namespace gapflow {

/// Sum of the solid's sections with the planes normal to d, in the grid of the core continued without end; of one that is inside out that of its cavity.
template <int D>
double seen_volume(const PlacedSolid<D>& solid, int d);

} // namespace gapflow
