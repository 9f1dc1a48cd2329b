// Woodbury: (B^-1 + K M^-1 K^T)^-1 = B - B K (M + K^T B K)^-1 K^T B. The full small matrix, never one body at a time: block
// diagonals are not safely definite. With W = B K stored (single precision, in the cells of mouths double: stiff links
// amplify the rounding of the difference between a film node and its cell) a correction costs two passes over W; for
// more bodies W is not stored and B is applied a second time to K (M + K^T W)^-1 K^T z.

#include "gapflow/solver/body_correction.hpp"

#include <algorithm>

#include <cmath>

namespace gapflow {

namespace {

constexpr double held_stiffness =
    1e6; // of contacts relative to the bodies' own with their added mass: rigid for a preconditioner

} // namespace

template <int D>
double BodyCorrection<D>::lightness(const Inverse& inverse) const
{
    const CoupledSystem<D>& system = matrix_.system();
    const Eigen::VectorXd mass = system.mass.diagonal();
    Eigen::VectorXd direction(matrix_.dofs());
    for (int d = 0; d < matrix_.dofs(); ++d) { // a different value for each body: squeezing a film needs relative motion
        const double golden = 0.6180339887498949 * (d + 1);
        direction[d] = (2 * (golden - std::floor(golden)) - 1) / std::sqrt(mass[d]);
    }
    UnknownVector<D> r = zero_vector(system), z = zero_vector(system);
    matrix_.add_flux(direction, r);
    r.nodes.setZero(); // the bulk's part alone: films add a few isolated eigenvalues, one iteration each
    inverse(r, z);
    z.nodes.setZero();
    const Eigen::VectorXd response = matrix_.transpose_flux(z);
    double largest = 0;
    for (int body = 0; body < system.bodies; ++body) {
        const Twist<D> own = direction.segment<twist_size<D>>(twist_size<D> * body);
        const double energy = own.cwiseAbs2().dot(mass.segment<twist_size<D>>(twist_size<D> * body));
        largest = std::max(largest, own.dot(response.segment<twist_size<D>>(twist_size<D> * body)) / energy);
    }
    return largest;
}

template <int D>
bool BodyCorrection<D>::set_up(const Inverse& inverse, double bytes_per_cell, std::vector<Index<D>> banded)
{
    const CoupledSystem<D>& system = matrix_.system();
    const Grid<D>& grid = *system.grid;
    const int dofs = matrix_.dofs();
    kept_ = 4.0 * dofs <= bytes_per_cell;
    if (kept_)
        exact_cells_ = std::move(
            banded); // a pocket with films as its only outlets has a pressure of 1e8 there, and its rounding error matters
    if (kept_)
        for (const Link& link : system.links)
            for (const auto& entry : link.cells)
                if (const Index<D> c = grid.cell_of_key(entry.first); grid.owns(c))
                    exact_cells_.push_back(c);
    std::sort(exact_cells_.begin(), exact_cells_.end(),
              [&](const Index<D>& a, const Index<D>& b) { return grid.key(a) < grid.key(b); });
    exact_cells_.erase(std::unique(exact_cells_.begin(), exact_cells_.end()), exact_cells_.end());

    added_ = Eigen::MatrixXd::Zero(dofs, dofs);
    UnknownVector<D> r = zero_vector(system), z = zero_vector(system);
    columns_.reserve(kept_ ? dofs : 0);
    for (int d = 0; d < dofs; ++d) {
        r.cells.fill(0);
        r.nodes.setZero();
        matrix_.add_flux(Eigen::VectorXd::Unit(dofs, d), r);
        inverse(r, z);
        added_.col(d) = matrix_.transpose_flux(z);
        if (!kept_)
            continue;
        Column& column = columns_.emplace_back();
        column.nodes = z.nodes;
        column.cells.reserve(grid.owned_cells());
        for_each_field_row(
            grid, [&](int n, const double* row) { column.cells.insert(column.cells.end(), row, row + n); }, z.cells);
        const Block<D> block(grid.low(), grid.high());
        for (const Index<D>& c : exact_cells_)
            column.remainder.push_back(z.cells(c) - column.cells[block.offset(c)]);
    }
    added_ = 0.5 * (added_ + added_.transpose().eval());
    ready_ = true;
    update();
    if (!ready_)
        columns_.clear();
    return ready_;
}

template <int D>
void BodyCorrection<D>::update()
{
    if (!ready_)
        return;
    const CoupledSystem<D>& system = matrix_.system();
    Eigen::MatrixXd capacitance = added_ + Eigen::MatrixXd(system.mass);
    if (system.contact.rows() > 0) {
        const Eigen::VectorXd mobility = system.contact.cwiseAbs2() * capacitance.diagonal().cwiseInverse();
        Eigen::VectorXd stiffness = held_stiffness * mobility.cwiseInverse();
        stiffness = (mobility.array() > 0).select(stiffness, 0.0); // 0: constraints prevent the contact from moving its bodies
        stiffness = stiffness.cwiseMin(system.contact_resistance);
        capacitance += system.contact.transpose() * stiffness.asDiagonal() * system.contact;
    }
    capacitance_.compute(capacitance);
    ready_ = capacitance_.info() == Eigen::Success;
}

template <int D>
void BodyCorrection<D>::correct(const Inverse& inverse, const UnknownVector<D>& r, UnknownVector<D>& z) const
{
    if (!ready_)
        return;
    const CoupledSystem<D>& system = matrix_.system();
    const Grid<D>& grid = *system.grid;
    const int dofs = matrix_.dofs();
    const Eigen::VectorXd twist = capacitance_.solve(matrix_.transpose_flux(z)); // K^T B r = W^T r
    if (!kept_) {
        UnknownVector<D> modified = r;
        matrix_.add_flux(-twist, modified);
        inverse(modified, z);
        return;
    }
    long offset = 0;
    for_each_field_row(
        grid,
        [&](int n, double* row) {
            int d = 0;
            for (; d + 3 <= dofs; d += 3) { // twists come in threes
                const float* w0 = columns_[d].cells.data() + offset;
                const float* w1 = columns_[d + 1].cells.data() + offset;
                const float* w2 = columns_[d + 2].cells.data() + offset;
                const double t0 = twist[d], t1 = twist[d + 1], t2 = twist[d + 2];
                for (int i = 0; i < n; ++i)
                    row[i] -= t0 * w0[i] + t1 * w1[i] + t2 * w2[i];
            }
            offset += n;
        },
        z.cells);
    for (int d = 0; d < dofs; ++d) {
        z.nodes -= twist[d] * columns_[d].nodes;
        for (std::size_t i = 0; i < exact_cells_.size(); ++i)
            z.cells(exact_cells_[i]) -= twist[d] * columns_[d].remainder[i];
    }
}

template <int D>
long BodyCorrection<D>::bytes() const
{
    long sum = 0;
    for (const Column& column : columns_)
        sum += 4 * static_cast<long>(column.cells.size()) + 8 * column.nodes.size();
    return sum;
}

template class BodyCorrection<2>;
template class BodyCorrection<3>;

} // namespace gapflow
