// Small groups of cells that faces tie to each other much more than to the rest: pores of one or a few cells behind narrow openings.
//
// Relaxation corrects the common level of a group by 2 out / (sum of diagonals) a cycle, out being what leads out of it, and no coarser grid has that
// level: a cell of the coarser one lies on both sides of the walls. That number is an eigenvalue of the preconditioned fluid.
#pragma once

#include "gapflow/grid/grid.hpp"

#include <array>
#include <span>
#include <vector>

namespace gapflow {

/// A cell with an unknown: conductances of its faces (lower and upper of each axis), and of all else that enters its diagonal.
template <int D>
struct CellTies {
    long key; ///< Grid::key
    std::array<double, 2 * D> faces;
    double others;
};

/// Which of the cells belong to a group of at most `most` of them whose level relaxation corrects by less than `least` a cycle. `cells`: sorted by key.
template <int D>
std::vector<char> loose_cells(const Grid<D>& grid, std::span<const CellTies<D>> cells, double least, std::size_t most);

} // namespace gapflow
