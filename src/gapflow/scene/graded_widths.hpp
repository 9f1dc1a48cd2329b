// Cells outside the core of a graded grid (method, "Graded spacing").
#pragma once

#include "gapflow/scene/scene.hpp"

#include <vector>

namespace gapflow {

/// Widths of the cells that fill a length outside the core, outwards, in multiples of the core's: as few as reach it with each at most
/// `growth` times as wide as the one before and none wider than `largest`; the growth is then reduced so that they fit. `growth` >= 1,
/// `largest` >= 1; a length of 0 needs none. Source: bisection for the growth's power series.
std::vector<double> graded_widths(double length, double growth, double largest);

/// Cells along an axis, of a graded grid those of its core.
int core_cells(const Scene& scene, int axis);

} // namespace gapflow
