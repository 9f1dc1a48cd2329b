// Faces of the grid as edges of the complex: what circulation has its momentum along.
#pragma once

#include "gapflow/grid/field.hpp"
#include "gapflow/grid/side_distance.hpp"

namespace gapflow {

/// Between the centres of the cells beside a face; at an open side to where the potential is that beyond.
template <int D>
double face_length(const Grid<D>& grid, int axis, const Index<D>& f)
{
    const double length = grid.dx() * grid.spread(axis, f[axis]);
    const int end = f[axis] > 0;
    if ((end && f[axis] < grid.cells()[axis]) || !is_open(grid.side(axis, end)))
        return length;
    return length * side_distance(grid, axis, end, f);
}

/// Whether a face lies between two cells of the domain.
template <int D>
bool is_inner(const Grid<D>& grid, int axis, const Index<D>& f)
{
    return grid.in_domain(grid.wrapped(f)) && grid.in_domain(grid.wrapped(Index<D>(f - step<D>(axis))));
}

} // namespace gapflow
