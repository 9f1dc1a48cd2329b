// Faces of the grid between two cells of the domain, where circulation has its momentum.
#pragma once

#include "gapflow/grid/field.hpp"

namespace gapflow {

/// Between the centres of the cells beside a face.
template <int D>
double face_length(const Grid<D>& grid, int axis, const Index<D>& f)
{
    return grid.dx() * grid.spread(axis, f[axis]);
}

/// Whether a face lies between two cells of the domain.
template <int D>
bool is_inner(const Grid<D>& grid, int axis, const Index<D>& f)
{
    return grid.in_domain(grid.wrapped(f)) && grid.in_domain(grid.wrapped(Index<D>(f - step<D>(axis))));
}

} // namespace gapflow
