#include "gapflow/grid/side_distance.hpp"

#include "gapflow/grid/far_field.hpp"

namespace gapflow {

template <int D>
double side_distance(const Grid<D>& grid, int axis, int end, const Index<D>& f)
{
    return grid.side(axis, end) == SideKind::far ? 0.5 * far_distance(grid, far_field(grid), axis, f) : 0.5;
}

template double side_distance(const Grid<2>&, int, int, const Index<2>&);
template double side_distance(const Grid<3>&, int, int, const Index<3>&);

} // namespace gapflow
