// Cells of the viscous form: whole cells of the grid and parts of cut ones.
//
// Parts that a corner's link joins are one of them: the line by which a corner divides a cell carries no friction.
#pragma once

#include "gapflow/complex/complex.hpp"

#include <cstdint>
#include <vector>

namespace gapflow {

template <int D>
struct FluidCells {
    std::vector<std::int32_t> of_part;   ///< of each part
    std::vector<std::int32_t> of_whole;  ///< of each whole cell, by its number in Complex::index; -1: none
    std::vector<std::int32_t> grid_cell; ///< number in Complex::index
    std::vector<char> whole;
    std::vector<std::uint8_t>
        layer; ///< of each cell in Complex::index: how many cells away the next cut or closed one is, at most ViscousParameters::layers

    int count() const { return static_cast<int>(grid_cell.size()); }
    std::int32_t of(const PartOrCell& side) const
    {
        return !side.exists() ? -1 : side.is_part() ? of_part[side.number()] : of_whole[side.number()];
    }
};

/// Cells of a column that ends at a closed side whose values the rows there have.
inline constexpr int column_at_side = 4;
/// Whether the compact lattice reaches the closed sides of an axis, with rows of its own beside them; else they have layers as solids have.
template <int D>
bool has_wall_rows(const Grid<D>& grid, int axis);

template <int D>
FluidCells<D> find_fluid_cells(const Grid<D>& grid, const Complex<D>& complex);

} // namespace gapflow
