// Connected parts of the grid: cells joined by open faces alone, not by films.
#pragma once

#include "gapflow/coupling/system.hpp"

#include <vector>

namespace gapflow {

template <int D>
struct GridParts {
    CellField<D, int> part;     ///< number of each owned cell's part, -1: no unknown
    std::vector<long> size;     ///< cells of each part, over all ranks; the same on all ranks
    std::vector<char> grounded; ///< whether an open side touches it
};

/// Numbers the parts, largest first. Collective.
template <int D>
GridParts<D> find_grid_parts(const CoupledSystem<D>& system);

} // namespace gapflow
