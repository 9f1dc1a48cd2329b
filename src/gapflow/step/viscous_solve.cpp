#include "gapflow/step/viscous_solve.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/step/viscous_projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace gapflow {
namespace {

constexpr double penalty = 1e4;          // over what the row's own unknowns resist with
constexpr double solve_accuracy = 1e-13; // of the square root of the energy
constexpr double round_off = 1e-9;       // of the same, where corrections no longer become smaller
constexpr int most_corrections = 60;

[[noreturn]] void fail(int iterations)
{
    throw ComputationError("the viscous solve did not converge (" + std::to_string(iterations) + " iterations)");
}

} // namespace

/// Augmented Lagrangian: the rows' outflow has a penalty, so large that a few corrections of the multipliers are enough, each a solve with one factorisation; what
/// round-off the penalty makes goes with them.
template <int D>
struct ViscousSolve<D>::Direct {
    Vector penalty; ///< of each row's outflow
    SparseCholesky factor;
};

template <int D>
struct ViscousSolve<D>::Projected {
    ViscousProjection<D> projection;
};

template <int D>
ViscousSolve<D>::ViscousSolve(const Placed<D>& at, const ViscousColumns<D>& columns, const std::vector<TwistMatrix<D>>& mass,
                              double factor, ViscousMethod method)
    : columns_(columns), factor_(factor)
{
    find_mass(at, mass);
    find_free(at, mass);
    if (method == ViscousMethod::direct)
        set_up_direct();
    else
        set_up_projected(at);
}

template <int D>
ViscousSolve<D>::~ViscousSolve() = default;

template <int D>
void ViscousSolve<D>::set_up_direct()
{
    direct_ = std::make_unique<Direct>();
    const typename ViscousColumns<D>::Rows rows = columns_.squares() * free_, out = columns_.outflow() * free_;
    Matrix H = free_.transpose() * (mass_ + factor_ * Matrix(columns_.rotation())) * free_;
    H += factor_ * Matrix(Matrix(rows.transpose()) * Matrix(rows));
    H += hold_;
    const Vector diagonal = H.diagonal().cwiseAbs();
    direct_->penalty.resize(out.rows());
    for (int row = 0; row < out.rows(); ++row) {
        double response = 0;
        for (typename ViscousColumns<D>::Rows::InnerIterator entry(out, row); entry; ++entry)
            if (entry.value() != 0)
                response += entry.value() * entry.value() / diagonal[entry.col()];
        direct_->penalty[row] = response > 0 ? penalty / response : 0.0;
    }
    H += Matrix(Matrix(out.transpose()) * direct_->penalty.asDiagonal() * Matrix(out));
    if (!direct_->factor.compute(H))
        throw ComputationError("the viscous system is not positive definite");
}

template <int D>
Eigen::MatrixXd ViscousSolve<D>::body_block() const
{
    const int first = columns_.twist(0), n = static_cast<int>(free_.cols()) - first;
    const Matrix bodies = free_.rightCols(n);
    const typename ViscousColumns<D>::Rows rows = columns_.squares() * bodies;
    Matrix H = bodies.transpose() * (mass_ + factor_ * Matrix(columns_.rotation())) * bodies;
    H += factor_ * Matrix(Matrix(rows.transpose()) * Matrix(rows));
    H += Matrix(hold_.bottomRightCorner(n, n));
    return Eigen::MatrixXd(H);
}

template <int D>
void ViscousSolve<D>::set_up_projected(const Placed<D>& at)
{
    const int first = columns_.twist(0);
    Vector diagonal = Vector::Zero(first);
    diagonal.head(columns_.edges()).setOnes();
    const auto& rows = columns_.squares();
    for (int row = 0; row < rows.outerSize(); ++row)
        for (typename ViscousColumns<D>::Rows::InnerIterator entry(rows, row); entry; ++entry)
            if (entry.col() < first)
                diagonal[entry.col()] += factor_ * entry.value() * entry.value();
    projected_ = std::make_unique<Projected>(Projected{ViscousProjection<D>(at, columns_, diagonal, body_block())});
}

/// Own masses, D, what gaps add; edges have the energy 1/2 n^2.
template <int D>
void ViscousSolve<D>::find_mass(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass)
{
    constexpr int T = twist_size<D>;
    const Coupling<D>& coupling = at.coupling;
    std::vector<Eigen::Triplet<double>> entries;
    for (int edge = 0; edge < columns_.edges(); ++edge)
        entries.emplace_back(edge, edge, 1);
    for (int s = 0; s < static_cast<int>(coupling.solids.size()); ++s) {
        TwistMatrix<D> M = coupling.seen_mass[s];
        if (coupling.free_body[s] >= 0)
            M += mass[s];
        for (int i = 0; i < T; ++i)
            for (int j = 0; j < T; ++j)
                entries.emplace_back(columns_.twist(s, i), columns_.twist(s, j), M(i, j));
    }
    for (const NormalInertia<D>& gap : coupling.normal_inertia)
        for (const auto& [a, row_a] : {std::pair(gap.master, gap.row_master), std::pair(gap.other, gap.row_other)})
            for (const auto& [b, row_b] : {std::pair(gap.master, gap.row_master), std::pair(gap.other, gap.row_other)})
                for (int i = 0; i < T; ++i)
                    for (int j = 0; j < T; ++j)
                        entries.emplace_back(columns_.twist(a, i), columns_.twist(b, j), gap.mass * row_a[i] * row_b[j]);
    mass_.resize(columns_.columns(), columns_.columns());
    mass_.setFromTriplets(entries.begin(), entries.end());
}

template <int D>
void ViscousSolve<D>::find_free(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass)
{
    constexpr int T = twist_size<D>;
    const Coupling<D>& coupling = at.coupling;
    const int fluid = columns_.twist(0);
    std::vector<Eigen::Triplet<double>> entries, hold;
    for (int k = 0; k < fluid; ++k)
        entries.emplace_back(k, k, 1);
    int bodies = 0;
    for (int s = 0; s < static_cast<int>(coupling.solids.size()); ++s) {
        if (coupling.free_body[s] < 0)
            continue;
        const TwistMatrix<D>& P = coupling.solids[s].admissible;
        const TwistMatrix<D> rest = mass[s].diagonal().maxCoeff() * (TwistMatrix<D>::Identity() - P);
        const int first = fluid + T * bodies++;
        for (int i = 0; i < T; ++i)
            for (int j = 0; j < T; ++j) {
                entries.emplace_back(columns_.twist(s, i), first + j, P(i, j));
                hold.emplace_back(first + i, first + j, rest(i, j));
            }
    }
    free_.resize(columns_.columns(), fluid + T * bodies);
    free_.setFromTriplets(entries.begin(), entries.end());
    hold_.resize(free_.cols(), free_.cols());
    hold_.setFromTriplets(hold.begin(), hold.end());
}

template <int D>
Eigen::VectorXd ViscousSolve<D>::friction(const Vector& y) const
{
    return factor_ * (columns_.squares().transpose() * Vector(columns_.squares() * y) + columns_.rotation() * y);
}

template <int D>
double ViscousSolve<D>::size(const Vector& change) const
{
    const Vector s = columns_.squares() * change;
    return std::sqrt(
        std::abs(change.dot(mass_ * change) + factor_ * (s.squaredNorm() + change.dot(Vector(columns_.rotation() * change)))));
}

template <int D>
typename ViscousSolve<D>::Stage ViscousSolve<D>::solve(const Vector& y_star, const Vector& load, const Vector& traces) const
{
    Vector base = y_star;
    base.segment(columns_.edges(), columns_.twist(0) - columns_.edges()).setZero();
    return direct_ ? solve_direct(base, load) : solve_projected(base, load, traces);
}

template <int D>
typename ViscousSolve<D>::Stage ViscousSolve<D>::solve_direct(const Vector& base, const Vector& load) const
{
    const Vector& penalty_of = direct_->penalty;
    Vector d = Vector::Zero(base.size()), outflow = Vector::Zero(penalty_of.size());
    Stage stage{base, outflow};
    double last = std::numeric_limits<double>::infinity();
    for (stage.iterations = 1;; ++stage.iterations) {
        const Vector multiplier = stage.pressure + penalty_of.cwiseProduct(outflow),
                     rest = load - mass_ * d - friction(stage.y) - columns_.outflow().transpose() * multiplier,
                     change = free_ * direct_->factor.solve(free_.transpose() * rest);
        d += change;
        stage.y = base + d;
        outflow = columns_.outflow() * d;
        stage.pressure += penalty_of.cwiseProduct(outflow);
        const double moved = size(change), whole = size(d);
        if (moved <= solve_accuracy * whole ||
            (moved >= 0.5 * last && (moved <= round_off * whole || moved <= solve_accuracy * size(stage.y))))
            return stage; // of a steady flow all changes are round-off
        if (stage.iterations == most_corrections)
            fail(stage.iterations);
        last = moved;
    }
}

/// Conjugate gradients (N. I. M. Gould, M. E. Hribar, J. Nocedal, SIAM J. Sci. Comput. 23 (2001) 1376-1395): each residual is projected, and its part that is a pressure's
/// is taken out of it, so that what the projection's tolerance leaves does not grow.
template <int D>
typename ViscousSolve<D>::Stage ViscousSolve<D>::solve_projected(const Vector& base, const Vector& load,
                                                                 const Vector& traces) const
{
    constexpr int most_iterations = 3000;
    const ViscousProjection<D>& projection = projected_->projection;
    Vector x = Vector::Zero(free_.cols()); // change in the unknowns
    if (traces.size() > 0)
        x.segment(columns_.edges(), traces.size()) = traces;
    const auto product = [&](const Vector& v) {
        const Vector y = free_ * v;
        return Vector(free_.transpose() * (mass_ * y + friction(y)) + hold_ * v);
    };
    Stage stage{base, Vector::Zero(columns_.unknowns())};
    Vector r = free_.transpose() * (load - friction(base)) - product(x);
    Vector z, p;
    double rz = 0, first = 0;
    for (stage.iterations = 0;; ++stage.iterations) {
        stage.pressure += projection.project(r, z); // r without what a pressure holds
        const double next = r.dot(z);
        first = std::max(first, next);
        if (!(next > solve_accuracy * solve_accuracy * 1e2 * first))
            break;
        if (stage.iterations == most_iterations)
            fail(stage.iterations);
        p = stage.iterations == 0 ? z : Vector(z + next / rz * p);
        rz = next;
        const Vector q = product(p);
        const double step = rz / p.dot(q);
        x += step * p;
        r -= step * q;
    }
    stage.y = base + free_ * x;
    return stage;
}

template class ViscousSolve<2>;
template class ViscousSolve<3>;

} // namespace gapflow
