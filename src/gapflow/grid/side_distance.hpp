// How far the pressure beyond an open side is.
#pragma once

#include "gapflow/grid/grid.hpp"

namespace gapflow {

/// From the centre of the cell beside face `f` of an open or far side to the pressure 0 beyond it, over the cell's width across the side. Not inline: folders that compile without
/// contracted multiplications must not leave their own copies of what others use (src/gapflow/CMakeLists.txt).
template <int D>
double side_distance(const Grid<D>& grid, int axis, int end, const Index<D>& f);

} // namespace gapflow
