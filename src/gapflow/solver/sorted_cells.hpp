// Lists of cells in the order of their keys (Grid::key): the neighbours of such a list on one side are in that order too, so that they are found by
// walking along it.
#pragma once

#include "gapflow/grid/grid.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace gapflow {

/// Finds neighbours of listed cells in the list.
template <int D>
class NeighbourWalk {
public:
    /// `keys`: ascending; to outlive the walk.
    NeighbourWalk(const Grid<D>& grid, std::span<const long> keys) : grid_(grid), keys_(keys) {}

    /// Place of the cell beside a listed cell (sides: lower and upper of each axis), or -1. To be asked with ascending cells for each side.
    long operator()(const Index<D>& cell, int side)
    {
        const int axis = side / 2;
        Index<D> beside = cell;
        beside[axis] += side % 2 ? 1 : -1;
        const bool inside = beside[axis] >= 0 && beside[axis] < grid_.cells()[axis];
        if (!inside && !grid_.periodic(axis))
            return -1;
        const long wanted = grid_.key(inside ? beside : grid_.wrapped(beside));
        if (!inside)
            return place(static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), wanted) - keys_.begin()),
                         wanted);
        std::size_t& at = at_[side];
        while (at < keys_.size() && keys_[at] < wanted)
            ++at;
        return place(at, wanted);
    }

private:
    long place(std::size_t at, long wanted) const
    {
        return at < keys_.size() && keys_[at] == wanted ? static_cast<long>(at) : -1;
    }

    const Grid<D>& grid_;
    std::span<const long> keys_;
    std::array<std::size_t, 2 * D> at_{}; ///< for each side: the first cell not below the last one wanted
};

/// The cells and all beside them in the domain.
template <int D>
std::vector<long> with_neighbours(const Grid<D>& grid, const std::vector<long>& cells)
{
    std::vector<Index<D>> places;
    for (long key : cells)
        places.push_back(grid.cell_of_key(key));
    std::vector<long> all = cells, beside, beyond, joined;
    const auto join = [&](std::vector<long>& more) {
        joined.resize(all.size() + more.size());
        joined.erase(std::set_union(all.begin(), all.end(), more.begin(), more.end(), joined.begin()), joined.end());
        all.swap(joined);
        more.clear();
    };
    for (int side = 0; side < 2 * D; ++side) {
        const int axis = side / 2;
        for (Index<D> c : places) {
            c[axis] += side % 2 ? 1 : -1;
            if (c[axis] >= 0 && c[axis] < grid.cells()[axis])
                beside.push_back(grid.key(c));
            else if (grid.periodic(axis))
                beyond.push_back(grid.key(grid.wrapped(c)));
        }
        join(beside);
    }
    std::sort(beyond.begin(), beyond.end());
    beyond.erase(std::unique(beyond.begin(), beyond.end()), beyond.end());
    join(beyond);
    return all;
}

} // namespace gapflow
