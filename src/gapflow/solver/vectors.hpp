// Sums over unknown vectors. Cells are summed over the ranks, film nodes (replicated) counted once.
#pragma once

#include "gapflow/coupling/system.hpp"
#include "gapflow/solver/halo.hpp"

namespace gapflow {

template <int D>
UnknownVector<D> zero_vector(const CoupledSystem<D>& system)
{
    return {CellField<D>(*system.grid), Eigen::VectorXd::Zero(system.nodes)};
}

/// Calls f(pointer to the row in each field ..., number of cells) for the rows of owned cells.
template <int D, class F, class... Fields>
void for_each_field_row(const Grid<D>& grid, F&& f, Fields&... fields)
{
    const int n = grid.high()[0] - grid.low()[0];
    for_each_row<D>(grid.low(), grid.high(), [&](const Index<D>& row) { f(n, &fields(row)...); });
}

/// Sum over this rank's cells of a b.
template <int D>
double cell_dot(const Grid<D>& grid, const CellField<D>& a, const CellField<D>& b)
{
    double total = 0;
    for_each_field_row(
        grid,
        [&](int n, const double* a_row, const double* b_row) {
            total += Eigen::Map<const Eigen::VectorXd>(a_row, n).dot(Eigen::Map<const Eigen::VectorXd>(b_row, n));
        },
        a, b);
    return total;
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
    for_each_field_row(
        grid,
        [&](int n, double* y_row, const double* x_row) {
            for (int i = 0; i < n; ++i)
                y_row[i] += s * x_row[i];
        },
        y.cells, x.cells);
    y.nodes += s * x.nodes;
}

} // namespace gapflow
