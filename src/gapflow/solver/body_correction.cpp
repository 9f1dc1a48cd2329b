// Woodbury with the bodies' compliance M^-1 = F F^T, contacts held:
//
//     (B^-1 + K F F^T K^T)^-1 = B - W F (1 + F^T K^T W F)^-1 F^T W^T,   W = B K.
//
// The full small matrix, never one body at a time: block diagonals are not safely definite. Its eigenvalues are at least 1. Films of
// very viscous fluid have an added mass of 1e10 bodies: against it contacts that are springs in M + K^T W are too weak, or so stiff that
// the bodies' own inertia is lost to round-off. With W stored (single precision, in the cells of mouths double: stiff links amplify the rounding of the
// difference between a film node and its cell) a correction costs two passes over W; for more bodies W is not stored and B is
// applied a second time to K F (1 + F^T K^T W F)^-1 F^T K^T z.

#include "gapflow/solver/body_correction.hpp"

#include "gapflow/core/decompositions.hpp"

#include <algorithm>

#include <cmath>

namespace gapflow {

namespace {

constexpr double held = 1e-12; // a motion's compliance relative to the free body's, round-off: contacts hold it

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
void BodyCorrection<D>::find_exact_cells(std::vector<Index<D>> banded)
{
    const CoupledSystem<D>& system = matrix_.system();
    const Grid<D>& grid = *system.grid;
    exact_cells_ = std::move(
        banded); // a pocket with films as its only outlets has a pressure of 1e8 there, and its rounding error matters
    for (const Link& link : system.links)
        for (const auto& entry : link.cells)
            if (const Index<D> c = grid.cell_of_key(entry.first); grid.owns(c))
                exact_cells_.push_back(c);
    std::sort(exact_cells_.begin(), exact_cells_.end(),
              [&](const Index<D>& a, const Index<D>& b) { return grid.key(a) < grid.key(b); });
    exact_cells_.erase(std::unique(exact_cells_.begin(), exact_cells_.end()), exact_cells_.end());
}

template <int D>
void BodyCorrection<D>::keep_column(const UnknownVector<D>& z)
{
    const Grid<D>& grid = *matrix_.system().grid;
    Column& column = columns_.emplace_back();
    column.nodes = z.nodes;
    column.cells.reserve(grid.owned_cells());
    for_each_field_row(
        grid, [&](int n, const double* row) { column.cells.insert(column.cells.end(), row, row + n); }, z.cells);
    const Block<D> block(grid.low(), grid.high());
    for (const Index<D>& c : exact_cells_)
        column.remainder.push_back(z.cells(c) - column.cells[block.offset(c)]);
}

template <int D>
bool BodyCorrection<D>::set_up(const Inverse& inverse, double bytes_per_cell, std::vector<Index<D>> banded)
{
    const CoupledSystem<D>& system = matrix_.system();
    const int dofs = matrix_.dofs();
    columns_.clear();
    motions_.resize(dofs, 0);
    kept_ = 4.0 * dofs <= bytes_per_cell;
    if (kept_)
        find_exact_cells(std::move(banded));

    added_ = Eigen::MatrixXd::Zero(dofs, dofs);
    UnknownVector<D> r = zero_vector(system), z = zero_vector(system);
    columns_.reserve(kept_ ? dofs : 0);
    for (int d = 0; d < dofs; ++d) {
        r.cells.fill(0);
        r.nodes.setZero();
        matrix_.add_flux(Eigen::VectorXd::Unit(dofs, d), r);
        inverse(r, z);
        added_.col(d) = matrix_.transpose_flux(z);
        if (kept_)
            keep_column(z);
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
    const Eigen::SparseMatrix<double>& mass = matrix_.system().mass;
    const long dofs = matrix_.dofs();
    const Eigen::VectorXd scale = mass.diagonal().cwiseSqrt();
    const Eigen::MatrixXd momentum = in_part() ? Eigen::MatrixXd(mass * motions_) : Eigen::MatrixXd(scale.asDiagonal());
    Eigen::MatrixXd response(dofs, momentum.cols());
    for (long k = 0; k < momentum.cols(); ++k)
        response.col(k) = matrix_.inverse_mass(momentum.col(k));
    const Eigen::MatrixXd compliance = momentum.transpose() * response;
    half_ = semidefinite_factor(0.5 * (compliance + compliance.transpose()), held);
    if (!in_part())
        half_ = scale.asDiagonal().inverse() * half_;
    const Eigen::MatrixXd added = half_.transpose() * added_ * half_;
    capacitance_.compute(Eigen::MatrixXd::Identity(added.rows(), added.cols()) + 0.5 * (added + added.transpose()));
    ready_ = capacitance_.info() == Eigen::Success;
}

template <int D>
void BodyCorrection<D>::add_motions(const Inverse& inverse, double bytes_per_cell, const Eigen::MatrixXd& motions,
                                    std::vector<Index<D>> banded)
{
    constexpr double independent = 0.1; // of a motion's norm: what must be left of it without the others
    const CoupledSystem<D>& system = matrix_.system();
    const int dofs = matrix_.dofs();
    if (!in_part()) {
        find_exact_cells(std::move(banded));
        motions_.resize(dofs, 0);
        kept_ = true;
    }
    std::vector<Eigen::VectorXd> wrenches; // K^T W U of the new ones
    UnknownVector<D> r = zero_vector(system), z = zero_vector(system);
    for (long k = 0; k < motions.cols() && 4.0 * static_cast<double>(motions_.cols() + 1) <= bytes_per_cell; ++k) {
        Eigen::VectorXd u = motions.col(k);
        const double size = std::sqrt(u.dot(system.mass * u));
        for (int pass = 0; pass < 2; ++pass)
            u -= motions_ * (motions_.transpose() * (system.mass * u));
        const double left = std::sqrt(u.dot(system.mass * u));
        if (!(left > independent * size))
            continue;
        u /= left;
        r.cells.fill(0);
        r.nodes.setZero();
        matrix_.add_flux(u, r);
        inverse(r, z);
        keep_column(z);
        motions_.conservativeResize(dofs, motions_.cols() + 1);
        motions_.rightCols(1) = u;
        wrenches.push_back(matrix_.transpose_flux(z));
    }
    if (wrenches.empty())
        return;
    const long old = added_.cols(), count = motions_.cols();
    added_.conservativeResize(count, count);
    for (long k = old; k < count; ++k)
        added_.col(k) = motions_.transpose() * wrenches[k - old];
    added_.bottomLeftCorner(count - old, old) = added_.topRightCorner(old, count - old).transpose();
    added_.bottomRightCorner(count - old, count - old) =
        0.5 * (added_.bottomRightCorner(count - old, count - old) +
               added_.bottomRightCorner(count - old, count - old).transpose().eval());
    ready_ = true;
    update();
}

template <int D>
void BodyCorrection<D>::correct(const Inverse& inverse, const UnknownVector<D>& r, UnknownVector<D>& z) const
{
    if (!ready_)
        return;
    const CoupledSystem<D>& system = matrix_.system();
    const Grid<D>& grid = *system.grid;
    const Eigen::VectorXd wrench = matrix_.transpose_flux(z); // K^T B r = W^T r
    const Eigen::VectorXd force = in_part() ? Eigen::VectorXd(motions_.transpose() * wrench) : wrench;
    const Eigen::VectorXd twist = half_ * capacitance_.solve(half_.transpose() * force);
    const int columns = static_cast<int>(twist.size());
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
            for (; d + 3 <= columns; d += 3) { // twists come in threes
                const float* w0 = columns_[d].cells.data() + offset;
                const float* w1 = columns_[d + 1].cells.data() + offset;
                const float* w2 = columns_[d + 2].cells.data() + offset;
                const double t0 = twist[d], t1 = twist[d + 1], t2 = twist[d + 2];
                for (int i = 0; i < n; ++i)
                    row[i] -= t0 * w0[i] + t1 * w1[i] + t2 * w2[i];
            }
            for (; d < columns; ++d) {
                const float* w = columns_[d].cells.data() + offset;
                for (int i = 0; i < n; ++i)
                    row[i] -= twist[d] * w[i];
            }
            offset += n;
        },
        z.cells);
    for (int d = 0; d < columns; ++d) {
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
