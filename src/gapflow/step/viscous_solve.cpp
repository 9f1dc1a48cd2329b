#include "gapflow/step/viscous_solve.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/step/viscous_product.hpp"
#include "gapflow/step/viscous_projection.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace gapflow {
namespace {

constexpr double row_penalty = 1e4;      // over what the row's own unknowns resist with
constexpr double solve_accuracy = 1e-13; // of the square root of the energy
constexpr double round_off = 1e-4;       // of the same, where velocities found anew change as much again
constexpr int most_solves = 200;
constexpr double least_mass =
    1e-3; // of a mode of a body's own mass less what planes see of it, over the system's diagonal: D may take all of a light body's

/// The nearest matrix without modes of less than `least_mass`, in units in which the system's diagonal is 1.
template <int D>
TwistMatrix<D> positive(const TwistMatrix<D>& block, const Twist<D>& diagonal)
{
    const Twist<D> scale = diagonal.cwiseMax(1e-300).cwiseSqrt();
    const TwistMatrix<D> scaled = scale.cwiseInverse().asDiagonal() * block * scale.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<TwistMatrix<D>> modes(scaled);
    if (modes.eigenvalues()[0] >= least_mass)
        return block;
    const Twist<D> values = modes.eigenvalues().cwiseMax(least_mass);
    return scale.asDiagonal() * modes.eigenvectors() * values.asDiagonal() * modes.eigenvectors().transpose() *
           scale.asDiagonal();
}

/// Ones on the diagonal of the first columns, the entries in those behind.
Eigen::SparseMatrix<double> ones_and(int ones, const std::vector<Eigen::Triplet<double>>& entries, Eigen::Index rows,
                                     Eigen::Index columns)
{
    Eigen::SparseMatrix<double> rest(rows, columns);
    rest.setFromTriplets(entries.begin(), entries.end());
    std::vector<int> end(columns + 1), row(ones + rest.nonZeros());
    std::vector<double> value(row.size(), 1.0);
    std::iota(row.begin(), row.begin() + ones, 0);
    std::copy_n(rest.innerIndexPtr(), rest.nonZeros(), row.begin() + ones);
    std::copy_n(rest.valuePtr(), rest.nonZeros(), value.begin() + ones);
    for (Eigen::Index k = 0; k <= columns; ++k)
        end[k] = static_cast<int>(std::min<Eigen::Index>(k, ones)) + rest.outerIndexPtr()[k];
    return Eigen::Map<const Eigen::SparseMatrix<double>>(rows, columns, static_cast<Eigen::Index>(row.size()), end.data(),
                                                         row.data(), value.data());
}

[[noreturn]] void fail(int iterations)
{
    throw ComputationError("the viscous solve did not converge (" + std::to_string(iterations) + " iterations)");
}

} // namespace

/// Augmented Lagrangian: the rows' outflow has a penalty, so large that a few solves with one factorisation find the multipliers, by conjugate gradients with it as
/// the preconditioner: of a chamber with narrow outlets the pressure takes many corrections one after the other, and one of these directions.
template <int D>
struct ViscousSolve<D>::Direct {
    Matrix system; ///< without the penalty
    typename ViscousColumns<D>::Rows out;
    std::vector<int> given{};
    Vector penalty{}; ///< of each row's outflow
    SparseCholesky factor{};

    void set_up()
    {
        const Vector diagonal = system.diagonal().cwiseAbs();
        penalty.resize(out.rows());
        for (int row = 0; row < out.rows(); ++row) {
            double response = 0;
            for (typename ViscousColumns<D>::Rows::InnerIterator entry(out, row); entry; ++entry)
                if (entry.value() != 0)
                    response += entry.value() * entry.value() / diagonal[entry.col()];
            penalty[row] = response > 0 ? row_penalty / response : 0.0;
        }
        for (const int row : given)
            penalty[row] = 0;
        const Matrix H = system + Matrix(Matrix(out.transpose()) * penalty.asDiagonal() * Matrix(out));
        if (!factor.compute(H))
            throw ComputationError("the viscous system is not positive definite");
    }
};

template <int D>
struct ViscousSolve<D>::Projected {
    ViscousProjection<D> projection;
    ViscousProduct<D> product;
};

template <int D>
ViscousSolve<D>::ViscousSolve(const Placed<D>& at, const ViscousColumns<D>& columns, const std::vector<TwistMatrix<D>>& mass,
                              double factor, double tolerance, ViscousMethod method, const std::vector<int>& given)
    : columns_(columns), factor_(factor), tolerance_(tolerance)
{
    find_mass(at, mass);
    find_free(at, mass);
    if (method == ViscousMethod::direct)
        set_up_direct(given);
    else
        set_up_projected(at, mass, given);
}

template <int D>
ViscousSolve<D>::~ViscousSolve() = default;

template <int D>
void ViscousSolve<D>::set_up_direct(const std::vector<int>& given)
{
    direct_ = std::make_unique<Direct>();
    const typename ViscousColumns<D>::Rows rows = columns_.squares() * free_, out = columns_.outflow() * free_;
    Matrix H = free_.transpose() * (mass_ + factor_ * Matrix(columns_.rotation())) * free_;
    H += factor_ * Matrix(Matrix(rows.transpose()) * Matrix(rows));
    H += hold_;
    *direct_ = Direct{std::move(H), out, given};
    direct_->set_up();
}

template <int D>
auto ViscousSolve<D>::body_block(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass,
                                 std::vector<Eigen::Triplet<double>> entries) const -> Matrix
{
    constexpr int T = twist_size<D>;
    const Coupling<D>& coupling = at.coupling;
    const auto admitted = [&](int s) -> const TwistMatrix<D>& { return coupling.solids[s].admissible; };
    Vector diagonal = Vector::Zero(free_.cols() - columns_.twist(0));
    for (const auto& entry : entries)
        if (entry.row() == entry.col())
            diagonal[entry.row()] += entry.value();
    for (const NormalInertia<D>& gap : coupling.normal_inertia)
        for (const auto& [a, row_a] : {std::pair(gap.master, gap.row_master), std::pair(gap.other, gap.row_other)})
            for (const auto& [b, row_b] : {std::pair(gap.master, gap.row_master), std::pair(gap.other, gap.row_other)})
                if (const int i = coupling.free_body[a], j = coupling.free_body[b]; i >= 0 && j >= 0) {
                    const TwistMatrix<D> pair =
                        gap.mass * Twist<D>(admitted(a) * row_a) * Twist<D>(admitted(b) * row_b).transpose();
                    for (int k = 0; k < T * T; ++k)
                        entries.emplace_back(T * i + k / T, T * j + k % T, pair(k / T, k % T));
                }
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        if (const int b = coupling.free_body[s]; b >= 0) {
            const TwistMatrix<D> own = admitted(s) * (coupling.seen_mass[s] + mass[s]) * admitted(s) +
                                       TwistMatrix<D>(hold_.block(columns_.twist(0) + T * b, columns_.twist(0) + T * b, T, T)),
                                 block = positive<D>(own, own.diagonal().cwiseAbs() + diagonal.template segment<T>(T * b));
            for (int k = 0; k < T * T; ++k)
                entries.emplace_back(T * b + k / T, T * b + k % T, block(k / T, k % T));
        }
    Matrix H(diagonal.size(), diagonal.size());
    H.setFromTriplets(entries.begin(), entries.end());
    return H;
}

/// The form's columns of the unknowns.
template <int D>
auto ViscousSolve<D>::form_of_unknowns() const -> typename ViscousColumns<D>::Rows
{
    using Rows = typename ViscousColumns<D>::Rows;
    const int fluid = columns_.twist(0), n = columns_.columns() - fluid;
    const Rows &form = columns_.form(), of_twists = free_.bottomRows(n);
    std::vector<int> end{0}, column;
    std::vector<double> factor;
    Row row;
    for (int k = 0; k < form.rows(); ++k) {
        row = {};
        for (typename Rows::InnerIterator entry(form, k); entry; ++entry)
            if (entry.col() < fluid) {
                column.push_back(static_cast<int>(entry.col()));
                factor.push_back(entry.value());
            } else
                for (typename Rows::InnerIterator of(of_twists, entry.col() - fluid); of; ++of)
                    row.add(static_cast<int>(of.col()), entry.value() * of.value());
        row.merge();
        for (const Term& term : row.terms()) {
            column.push_back(term.column);
            factor.push_back(term.factor);
        }
        end.push_back(static_cast<int>(column.size()));
    }
    return Eigen::Map<const Rows>(form.rows(), free_.cols(), static_cast<Eigen::Index>(column.size()), end.data(),
                                  column.data(), factor.data());
}

template <int D>
void ViscousSolve<D>::set_up_projected(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass,
                                       const std::vector<int>& given)
{
    Vector diagonal = factor_ * columns_.diagonal().head(columns_.twist(0));
    diagonal.head(columns_.edges()).array() += 1;
    using Rows = typename ViscousColumns<D>::Rows;
    const Eigen::Index n = free_.cols() - columns_.twist(0);
    const Matrix motions = free_.rightCols(n);
    const Rows form_of = form_of_unknowns();
    ViscousProduct<D> product(columns_.of_form(), form_of, factor_, columns_.edges(),
                              Matrix(Matrix(motions.transpose()) * mass_ * motions) + Matrix(hold_.bottomRightCorner(n, n)));
    ViscousProjection<D> projection(at, columns_, form_of, diagonal, body_block(at, mass, product.friction_of_bodies()),
                                    tolerance_, given);
    projected_ = std::make_unique<Projected>(Projected{std::move(projection), std::move(product)});
}

/// Own masses, D, what gaps add; edges have the energy 1/2 n^2.
template <int D>
void ViscousSolve<D>::find_mass(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass)
{
    constexpr int T = twist_size<D>;
    const Coupling<D>& coupling = at.coupling;
    std::vector<Eigen::Triplet<double>> entries;
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
    mass_ = ones_and(columns_.edges(), entries, columns_.columns(), columns_.columns());
}

template <int D>
void ViscousSolve<D>::find_free(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass)
{
    constexpr int T = twist_size<D>;
    const Coupling<D>& coupling = at.coupling;
    const int fluid = columns_.twist(0);
    std::vector<Eigen::Triplet<double>> entries, hold;
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
    free_ = ones_and(fluid, entries, columns_.columns(), fluid + T * bodies);
    hold_.resize(free_.cols(), free_.cols());
    hold_.setFromTriplets(hold.begin(), hold.end());
}

template <int D>
Eigen::VectorXd ViscousSolve<D>::friction(const Vector& y) const
{
    return factor_ * columns_.friction(y);
}

template <int D>
double ViscousSolve<D>::size(const Vector& change) const
{
    return std::sqrt(std::abs(change.dot(mass_ * change + friction(change))));
}

template <int D>
typename ViscousSolve<D>::Stage ViscousSolve<D>::solve(const Vector& y_star, const Vector& load, const Stage* like,
                                                       const GivenRows* rows) const
{
    Vector base = y_star;
    base.segment(columns_.edges(), columns_.twist(0) - columns_.edges()).setZero();
    return direct_ ? solve_direct(base, load, rows) : solve_projected(base, load, like, rows);
}

template <int D>
typename ViscousSolve<D>::Stage ViscousSolve<D>::solve_direct(const Vector& base, const Vector& load,
                                                              const GivenRows* rows) const
{
    const Vector& penalty_of = direct_->penalty;
    const typename ViscousColumns<D>::Rows& out = columns_.outflow();
    const auto solve = [&](const Vector& push) { return Vector(free_ * direct_->factor.solve(free_.transpose() * push)); };
    Vector d = Vector::Zero(base.size()), outflow = Vector::Zero(penalty_of.size());
    Stage stage{base, outflow};
    if (rows) {
        stage.pressure = rows->pressure;
        outflow = -rows->outflow;
    }
    double last = std::numeric_limits<double>::infinity();
    double largest = 0; // of a load that the rows hold, as under a closed gap, all that is left is round-off
    for (stage.iterations = 1;; ++stage.iterations) {
        // The velocities of these multipliers; then what round-off has left of them.
        const Vector multiplier = stage.pressure + penalty_of.cwiseProduct(outflow),
                     change = solve(load - mass_ * d - friction(stage.y) - out.transpose() * multiplier);
        d += change;
        stage.y = base + d;
        outflow = out * d;
        if (rows)
            outflow -= rows->outflow;
        const double moved = size(change);
        largest = std::max(largest, size(d));
        if (moved <= solve_accuracy * largest ||
            (moved >= 0.5 * last && (moved <= round_off * size(d) || moved <= solve_accuracy * size(stage.y)))) {
            stage.pressure += penalty_of.cwiseProduct(outflow);
            return stage; // of a steady flow all changes are round-off
        }
        last = moved;
        // Conjugate gradients of the multipliers.
        Vector z = penalty_of.cwiseProduct(outflow), p = z;
        for (double rz = outflow.dot(z), step_size = std::numeric_limits<double>::infinity();
             step_size > solve_accuracy * largest;) {
            const Vector w = solve(out.transpose() * p), s = out * w;
            const double resistance = p.dot(s);
            if (!(rz > 0) || !(resistance > 0))
                break;
            if (++stage.iterations >= most_solves)
                fail(stage.iterations);
            const double step = rz / resistance;
            stage.pressure += step * p;
            d -= step * w;
            outflow -= step * s;
            step_size = step * size(w);
            z = penalty_of.cwiseProduct(outflow);
            const double next = outflow.dot(z);
            p = z + next / rz * p;
            rz = next;
        }
        stage.y = base + d;
    }
}

/// Conjugate gradients (N. I. M. Gould, M. E. Hribar, J. Nocedal, SIAM J. Sci. Comput. 23 (2001) 1376-1395): each residual is projected, and its part that is a pressure's
/// is taken out of it, so that what the projection's tolerance leaves does not grow.
template <int D>
typename ViscousSolve<D>::Stage ViscousSolve<D>::solve_projected(const Vector& base, const Vector& load, const Stage* like,
                                                                 const GivenRows* rows) const
{
    constexpr int most_iterations = 3000, slow_iterations = 32; // after which what is dissipated is asked for
    const ViscousProjection<D>& projection = projected_->projection;
    Vector x = Vector::Zero(free_.cols()); // change in the unknowns
    if (like && like->change.size() > 0)
        x = like->change;
    const Eigen::Index n = x.size();
    Vector p = Vector::Zero(projected_->product.size()), q; // with room behind the unknowns
    Stage stage{base, Vector::Zero(columns_.unknowns())};
    Vector force = load - friction(base);
    if (rows) {
        x = projection.with_outflow(rows->outflow);
        force -= columns_.outflow().transpose() * rows->pressure;
        stage.pressure = rows->pressure;
    }
    p.head(n) = x;
    projected_->product.apply(p, q);
    Vector r = free_.transpose() * force - q.head(n), z;
    // Relative to the kinetic energy, or to what the stage dissipates if that is more, or where there is none to what is gained: slip along walls that nothing resists yet has residuals of any size.
    double rz = 0, largest_outflow = projection.size_of(base), scale = base.dot(mass_ * base);
    const bool from_rest = !(scale > 0);
    for (stage.iterations = 0;; ++stage.iterations) {
        stage.pressure += projection.project(r, z, largest_outflow); // r without what a pressure holds
        const double next = r.dot(z);
        if (stage.iterations > 0 && stage.iterations % slow_iterations == 0) {
            const Vector y = base + free_ * x;
            scale = std::max(scale, y.dot(friction(y)));
        }
        if (next >= 0 && next <= tolerance_ * tolerance_ * scale)
            break;
        if (stage.iterations == most_iterations || !(next > 0))
            fail(stage.iterations);
        if (stage.iterations == 0)
            p.head(n) = z;
        else
            p.head(n) = z + next / rz * p.head(n);
        rz = next;
        projected_->product.apply(p, q);
        const double step = rz / p.head(n).dot(q.head(n));
        x += step * p.head(n);
        if (from_rest)
            scale += step * rz;
        r -= step * q.head(n);
    }
    stage.y = base + free_ * x;
    stage.change = x;
    return stage;
}

template class ViscousSolve<2>;
template class ViscousSolve<3>;

} // namespace gapflow
