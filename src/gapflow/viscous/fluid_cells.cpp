#include "gapflow/viscous/fluid_cells.hpp"

#include "gapflow/grid/field.hpp"
#include "gapflow/viscous/parameters.hpp"

#include <algorithm>
#include <numeric>

namespace gapflow {
namespace {

/// Layers of cells around those that are cut, solid, or beside a closed side.
template <int D>
std::vector<std::uint8_t> find_layers(const Grid<D>& grid, const Complex<D>& complex)
{
    const DenseIndex<D>& index = complex.index;
    std::vector<std::uint8_t> layer(index.count, viscous_parameters.layers);
    for_each_index<D>(index.low, index.high(), [&](const Index<D>& c) {
        bool near = complex.cell[index(c)] != Complex<D>::open;
        for (int axis = 0; axis < D; ++axis)
            near = near || (c[axis] == 0 && grid.side(axis, 0) == SideKind::wall) ||
                   (c[axis] == grid.cells()[axis] - 1 && grid.side(axis, 1) == SideKind::wall);
        if (near)
            layer[index(c)] = 0;
    });
    // A box around each cell, one axis after the other.
    for (int axis = 0; axis < D; ++axis) {
        const std::vector<std::uint8_t> before = layer;
        for_each_index<D>(index.low, index.high(), [&](const Index<D>& c) {
            std::uint8_t& here = layer[index(c)];
            for (int k = -viscous_parameters.layers; k <= viscous_parameters.layers; ++k) {
                const Index<D> other = index.wrapped(Index<D>(c + k * step<D>(axis)));
                if (index.holds(other))
                    here = std::min<std::uint8_t>(here, std::max<int>(before[index(other)], std::abs(k)));
            }
        });
    }
    return layer;
}

} // namespace

template <int D>
FluidCells<D> find_fluid_cells(const Grid<D>& grid, const Complex<D>& complex)
{
    FluidCells<D> cells;
    std::vector<std::int32_t> root(complex.parts());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](std::int32_t part) {
        while (root[part] != part)
            part = root[part] = root[root[part]];
        return part;
    };
    for (const CornerLink<D>& link : complex.links)
        root[std::max(find(link.a), find(link.b))] = std::min(find(link.a), find(link.b));
    cells.of_part.resize(complex.parts());
    for (int part = 0; part < complex.parts(); ++part) {
        if (const std::int32_t first = find(part); first < part) {
            cells.of_part[part] = cells.of_part[first];
            continue;
        }
        cells.of_part[part] = cells.count();
        cells.grid_cell.push_back(complex.cut_cell[complex.part_cell[part]]);
        cells.whole.push_back(false);
    }
    cells.of_whole.assign(complex.index.count, -1);
    for_each_index<D>(complex.index.low, complex.index.high(), [&](const Index<D>& c) {
        const int number = complex.index(c);
        if (complex.cell[number] != Complex<D>::open)
            return;
        cells.of_whole[number] = cells.count();
        cells.grid_cell.push_back(number);
        cells.whole.push_back(true);
    });
    cells.layer = find_layers(grid, complex);
    return cells;
}

template FluidCells<2> find_fluid_cells(const Grid<2>&, const Complex<2>&);
template FluidCells<3> find_fluid_cells(const Grid<3>&, const Complex<3>&);

} // namespace gapflow
