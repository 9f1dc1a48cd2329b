// Sums over unknown vectors. Cells are summed over the ranks, film nodes (replicated) counted once.
#pragma once

#include "gapflow/core/threads.hpp"
#include "gapflow/coupling/system.hpp"
#include "gapflow/solver/halo.hpp"

#include <array>
#include <vector>

namespace gapflow {

template <int D>
UnknownVector<D> zero_vector(const CoupledSystem<D>& system)
{
    return {CellField<D>(*system.grid), Eigen::VectorXd::Zero(system.nodes)};
}

constexpr int piece = 512; ///< cells

/// Calls f(first cell, number of cells) for pieces of rows, of no more than `piece` owned cells, that make up a plane normal
/// to the last axis.
template <int D, class F>
void for_each_piece_of_plane(const Grid<D>& grid, int plane, F&& f)
{
    Index<D> low = grid.low(), high = grid.high();
    low[D - 1] = plane;
    high[D - 1] = plane + 1;
    for_each_row<D>(low, high, [&](Index<D> first) {
        for (; first[0] < high[0]; first[0] += piece)
            f(static_cast<const Index<D>&>(first), std::min(piece, high[0] - first[0]));
    });
}

/// The same for all planes, shared out over threads.
template <int D, class F>
void for_each_piece(const Grid<D>& grid, F&& f)
{
    const int low = grid.low()[D - 1];
    for_each_part(grid.high()[D - 1] - low, [&](long begin, long end) {
        for (long k = begin; k < end; ++k)
            for_each_piece_of_plane<D>(grid, low + static_cast<int>(k), f);
    });
}

/// Calls f(number of cells, pointer to the row in each field ...) for the rows of owned cells, in order.
template <int D, class F, class... Fields>
void for_each_field_row(const Grid<D>& grid, F&& f, Fields&... fields)
{
    const int n = grid.high()[0] - grid.low()[0];
    for_each_row<D>(grid.low(), grid.high(), [&](const Index<D>& row) { f(n, &fields(row)...); });
}

/// Sum of the N numbers f(first cell, number of cells) over the pieces of all planes, plane by plane: in the same order on
/// any number of threads.
template <int N, int D, class F>
std::array<double, N> sum_over_pieces(const Grid<D>& grid, F&& f)
{
    const int low = grid.low()[D - 1], planes = grid.high()[D - 1] - low;
    std::vector<std::array<double, N>> parts(planes);
    for_each_part(planes, [&](long begin, long end) {
        for (long k = begin; k < end; ++k) {
            std::array<double, N>& part = parts[k];
            part.fill(0);
            for_each_piece_of_plane<D>(grid, low + static_cast<int>(k), [&](const Index<D>& first, int n) {
                const std::array<double, N> row = f(first, n);
                for (int i = 0; i < N; ++i)
                    part[i] += row[i];
            });
        }
    });
    std::array<double, N> sum{};
    for (const auto& part : parts)
        for (int i = 0; i < N; ++i)
            sum[i] += part[i];
    return sum;
}

/// Sum over this rank's cells of a b.
template <int D>
double cell_dot(const Grid<D>& grid, const CellField<D>& a, const CellField<D>& b)
{
    return sum_over_pieces<1>(grid, [&](const Index<D>& first, int n) {
        using Row = Eigen::Map<const Eigen::VectorXd>;
        return std::array<double, 1>{Row(&a(first), n).dot(Row(&b(first), n))};
    })[0];
}

/// a . b over all unknowns. Collective.
template <int D>
double dot(const Grid<D>& grid, const UnknownVector<D>& a, const UnknownVector<D>& b)
{
    return grid.comm().sum(cell_dot(grid, a.cells, b.cells)) + a.nodes.dot(b.nodes);
}

/// y += s x.
template <int D>
void add(const Grid<D>& grid, UnknownVector<D>& y, double s, const UnknownVector<D>& x)
{
    for_each_piece(grid, [&](const Index<D>& first, int n) {
        double* __restrict to = &y.cells(first);
        const double* from = &x.cells(first);
        for (int i = 0; i < n; ++i)
            to[i] += s * from[i];
    });
    y.nodes += s * x.nodes;
}

} // namespace gapflow
