#include "gapflow/viscous/fluid_cells.hpp"

#include "gapflow/grid/field.hpp"
#include "gapflow/viscous/parameters.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace gapflow {
namespace {

template <int D>
bool is_closed(const Grid<D>& grid, int axis, int end)
{
    return grid.side(axis, end) == SideKind::wall;
}

/// The compact lattice reaches a closed side by columns of cells of which all are its own.
template <int D>
void open_columns_at_sides(const Grid<D>& grid, const DenseIndex<D>& index, std::vector<std::uint8_t>& layer)
{
    constexpr int L = viscous_parameters.layers;
    for (bool changed = true; changed;) {
        changed = false;
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end) {
                if (!is_closed(grid, axis, end) || !has_wall_rows(grid, axis))
                    continue;
                Index<D> low = index.low, high = index.high();
                (end ? low : high)[axis] = end ? high[axis] - 1 : low[axis] + 1;
                const int step = (end ? -1 : 1) * index.stride[axis];
                for_each_index<D>(low, high, [&](const Index<D>& c) {
                    const int first = index(c);
                    int own = 0;
                    for (int k = 0; k < column_at_side; ++k)
                        own += layer[first + k * step] >= L;
                    if (own == 0 || own == column_at_side)
                        return;
                    changed = true;
                    for (int k = 0; k < column_at_side; ++k)
                        layer[first + k * step] = std::min<std::uint8_t>(layer[first + k * step], L - 1);
                });
            }
    }
}

/// Layers of cells around those that are cut or solid, or beside a closed side that the compact lattice does not reach.
template <int D>
std::vector<std::uint8_t> find_layers(const Grid<D>& grid, const Complex<D>& complex)
{
    constexpr int layers = viscous_parameters.layers;
    const DenseIndex<D>& index = complex.index;
    const int n = index.size[0] - 1;
    std::vector<std::uint8_t> layer(index.count, layers);
    const auto is_side = [&](int axis, int c) {
        return !has_wall_rows(grid, axis) &&
               ((c == 0 && is_closed(grid, axis, 0)) || (c == grid.cells()[axis] - 1 && is_closed(grid, axis, 1)));
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
    open_columns_at_sides(grid, index, layer);
    return layer;
}

} // namespace

template <int D>
bool has_wall_rows(const Grid<D>& grid, int axis)
{
    return grid.cells()[axis] >= 4 * column_at_side; // shear in narrower channels is exact
}

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

template bool has_wall_rows(const Grid<2>&, int);
template bool has_wall_rows(const Grid<3>&, int);
template FluidCells<2> find_fluid_cells(const Grid<2>&, const Complex<2>&);
template FluidCells<3> find_fluid_cells(const Grid<3>&, const Complex<3>&);

} // namespace gapflow
