// The faces on the sides of the domain.
#pragma once

#include "gapflow/grid/field.hpp"

namespace gapflow {

/// Calls f(face) for this rank's faces on the low (end = 0) or high side of the domain normal to `axis`.
template <int D, class F>
void for_each_face_of_side(const Grid<D>& grid, int axis, int end, F&& f)
{
    const int place = end * grid.cells()[axis];
    if ((end ? grid.high()[axis] : grid.low()[axis]) != place)
        return;
    Index<D> low = grid.low(), high = grid.high();
    low[axis] = place;
    high[axis] = place + 1;
    for_each_index<D>(low, high, f);
}

} // namespace gapflow
