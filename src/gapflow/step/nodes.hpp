// Nodes of parts by their places, to find those of another instant.
#pragma once

#include "gapflow/step/placed.hpp"

#include <map>
#include <utility>

namespace gapflow {

template <int D>
class NodeNumbers {
public:
    explicit NodeNumbers(const Placed<D>& at)
    {
        for (int p = 0; p < at.complex.parts(); ++p)
            if (at.node[p] >= 0)
                numbers_.emplace(place(*at.coupling.grid, at.complex, p), at.node[p]);
    }
    /// That of a part of another complex: in the same cell, and of the same rank by its size there. -1: none.
    int find(const Grid<D>& grid, const Complex<D>& complex, int part) const
    {
        const auto found = numbers_.find(place(grid, complex, part));
        return found == numbers_.end() ? -1 : found->second;
    }

private:
    static std::pair<long, int> place(const Grid<D>& grid, const Complex<D>& complex, int part)
    {
        return {grid.key(grid.wrapped(complex.cell_of_part(part))), part - complex.first_part[complex.part_cell[part]]};
    }

    std::map<std::pair<long, int>, int> numbers_;
};

} // namespace gapflow
