#include "gapflow/viscous/fluid_cells.hpp"

#include "gapflow/grid/field.hpp"
#include "gapflow/viscous/parameters.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace gapflow {
namespace {

/// Layers of cells around those that are cut, solid, or beside a closed side.
template <int D>
std::vector<std::uint8_t> find_layers(const Grid<D>& grid, const Complex<D>& complex)
{
    constexpr int layers = viscous_parameters.layers;
    const DenseIndex<D>& index = complex.index;
    const int n = index.size[0] - 1;
    std::vector<std::uint8_t> layer(index.count, layers);
    const auto is_side = [&](int axis, int c) {
        return (c == 0 && grid.side(axis, 0) == SideKind::wall) ||
               (c == grid.cells()[axis] - 1 && grid.side(axis, 1) == SideKind::wall);
    };
    for_each_row<D>(index.low, index.high(), [&](const Index<D>& row) {
        const int id = index(row);
        bool side = false;
        for (int axis = 1; axis < D; ++axis)
            side = side || is_side(axis, row[axis]);
        for (int i = 0; i < n; ++i)
            if (side || complex.cell[id + i] != Complex<D>::open)
                layer[id + i] = 0;
        for (const int i : {0, n - 1})
            if (is_side(0, row[0] + i))
                layer[id + i] = 0;
    });
    // A box around each cell, one axis after the other.
    std::vector<std::uint8_t> padded(n + 2 * layers);
    for (int axis = 0; axis < D; ++axis) {
        const std::vector<std::uint8_t> before = layer;
        for_each_row<D>(index.low, index.high(), [&](const Index<D>& row) {
            std::uint8_t* here = &layer[index(row)];
            const auto spread = [&](const std::uint8_t* from, int distance) {
                for (int i = 0; i < n; ++i)
                    here[i] =
                        std::min<std::uint8_t>(here[i], std::max<std::uint8_t>(from[i], static_cast<std::uint8_t>(distance)));
            };
            if (axis == 0)
                for (int i = -layers; i < n + layers; ++i) {
                    const Index<D> other = index.wrapped(Index<D>(row + i * step<D>(0)));
                    padded[i + layers] = i >= 0 && i < n ? here[i] : index.holds(other) ? before[index(other)] : layers;
                }
            for (int k = -layers; k <= layers; ++k) {
                const Index<D> other = index.wrapped(Index<D>(row + k * step<D>(axis)));
                if (axis == 0)
                    spread(&padded[layers + k], std::abs(k));
                else if (index.holds(other))
                    spread(&before[index(other)], std::abs(k));
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
    const auto open = static_cast<std::size_t>(std::ranges::count(complex.cell, Complex<D>::open));
    cells.grid_cell.reserve(cells.grid_cell.size() + open);
    cells.whole.reserve(cells.whole.size() + open);
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
