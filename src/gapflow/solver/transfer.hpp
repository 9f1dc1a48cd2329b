// Transfer between two levels: piecewise constant, zero where a cell has no unknown.
#pragma once

#include "gapflow/solver/level.hpp"

namespace gapflow {

/// Adds the residual b - A x of one plane of `fine` (normal to the last axis) to coarse.b, a sum over each coarse cell's fine
/// cells; the first plane of a coarse cell overwrites. Only coarse cells around this rank's fine cells are written.
template <int D>
void restrict_plane(const Level<D>& fine, Level<D>& coarse, int plane);

/// fine.x += coarse.x of the cell around, in one plane of `fine`.
template <int D>
void prolong_plane(const Level<D>& coarse, Level<D>& fine, int plane);

} // namespace gapflow
