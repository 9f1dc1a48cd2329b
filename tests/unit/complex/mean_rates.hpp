// Disks whose rates are not those of their place.
#pragma once

#include "gapflow/geometry/solid.hpp"
#include "gapflow/grid/grid.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow::testing {

/// Whether a disk has just passed a plane of the grid: its rates there are means over a way (plane_of_rates()).
template <int D>
bool has_mean_rates(const Grid<D>& grid, const Solid<D>& solid)
{
    const auto radius = solid.shape.shape().sphere_radius();
    double least = 1;
    for (int axis = 0; axis < D && radius; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const double end = (side * (solid.shape.to_world(Vec<D>::Zero()) - grid.anchor())[axis] + *radius) / grid.dx();
            least = std::min(least, end - std::floor(end));
        }
    return D == 2 && least < 0.031;
}

} // namespace gapflow::testing
