// Conjugate gradients (Hestenes & Stiefel 1952) with the flexible factor beta = z_new . (r_new - r_old) / z_old . r_old
// (Golub & Ye, SIAM J. Sci. Comput. 21, 1999): a cycle in single precision is symmetric only to round-off. The residual is
// recursive while iterating and computed afresh at the end, always.

#include "gapflow/solver/conjugate_gradients.hpp"

#include <cmath>
#include <cstdio>

namespace gapflow {

namespace {

std::string describe(const char* format, double value)
{
    char text[200];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// Iterations still to come at the mean rate so far.
double expected_iterations(int done, double reached, double wanted)
{
    if (reached <= wanted)
        return 0;
    if (reached >= 1)
        return 1e9;
    return done * (std::log(wanted) / std::log(reached) - 1);
}

/// x += a p, r -= a q; returns |r|^2.
template <int D>
double advance(const Grid<D>& grid, UnknownVector<D>& x, UnknownVector<D>& r, double a, const UnknownVector<D>& p,
               const UnknownVector<D>& q)
{
    double square = 0;
    for_each_field_row(
        grid,
        [&](int n, double* x_row, double* r_row, const double* p_row, const double* q_row) {
            for (int i = 0; i < n; ++i) {
                x_row[i] += a * p_row[i];
                r_row[i] -= a * q_row[i];
            }
            square += Eigen::Map<const Eigen::VectorXd>(r_row, n).squaredNorm();
        },
        x.cells, r.cells, p.cells, q.cells);
    x.nodes += a * p.nodes;
    r.nodes -= a * q.nodes;
    return grid.comm().sum(square) + r.nodes.squaredNorm();
}

struct Dots {
    double zr, zq; ///< z . r and z . q with z projected
    double sum;    ///< of z
};

/// In one reduction. With one component z is projected on the fly, else it must be already.
template <int D>
Dots dots(const CoupledSystem<D>& system, const NullSpace<D>& null_space, const UnknownVector<D>& z, const UnknownVector<D>& r,
          const UnknownVector<D>& q)
{
    enum { zr, zq, z1, r1, q1 };
    std::array<double, 5> sums{};
    for_each_field_row(
        *system.grid,
        [&](int n, const double* z_row, const double* r_row, const double* q_row) {
            using Row = Eigen::Map<const Eigen::VectorXd>;
            const Row zs(z_row, n), rs(r_row, n), qs(q_row, n);
            sums[zr] += zs.dot(rs);
            sums[zq] += zs.dot(qs);
            sums[z1] += zs.sum();
            sums[r1] += rs.sum();
            sums[q1] += qs.sum();
        },
        z.cells, r.cells, q.cells);
    system.grid->comm().sum(sums);
    sums[zr] += z.nodes.dot(r.nodes);
    sums[zq] += z.nodes.dot(q.nodes);
    sums[z1] += z.nodes.sum();
    sums[r1] += r.nodes.sum();
    sums[q1] += q.nodes.sum();
    if (!null_space.empty() && system.components.size() == 1) {
        const double mean = null_space.shifts(sums[z1])[1];
        sums[zr] -= mean * sums[r1];
        sums[zq] -= mean * sums[q1];
    }
    return {sums[zr], sums[zq], sums[z1]};
}

/// p = (projected z) + b p; whatever p holds if b = 0.
template <int D>
void turn(const CoupledSystem<D>& system, const NullSpace<D>& null_space, UnknownVector<D>& p, double b,
          const UnknownVector<D>& z, double sum)
{
    if (b == 0) {
        p.cells.fill(0);
        p.nodes.setZero();
    }
    if (null_space.empty() || system.components.size() > 1) { // z is projected
        for_each_field_row(
            *system.grid,
            [&](int n, double* p_row, const double* z_row) {
                for (int i = 0; i < n; ++i)
                    p_row[i] = z_row[i] + b * p_row[i];
            },
            p.cells, z.cells);
        p.nodes = z.nodes + b * p.nodes;
        return;
    }
    const Eigen::VectorXd& shift = null_space.shifts(sum);
    for_each_field_row(
        *system.grid,
        [&, s = shift.data() + 1](int n, double* p_row, const double* z_row, const int* component) {
            for (int i = 0; i < n; ++i)
                p_row[i] = z_row[i] - s[component[i]] + b * p_row[i];
        },
        p.cells, z.cells, system.component);
    for (int i = 0; i < system.nodes; ++i)
        p.nodes[i] = z.nodes[i] - shift[system.node_component[i] + 1] + b * p.nodes[i];
}

} // namespace

template <int D>
void compatible(const CoupledSystem<D>& system, const NullSpace<D>& null_space, const UnknownVector<D>& rhs, UnknownVector<D>& v)
{
    for_each_field_row(
        *system.grid,
        [&](int n, double* row, const double* from, const int* component) {
            for (int i = 0; i < n; ++i)
                row[i] = component[i] >= 0 ? from[i] : 0.0;
        },
        v.cells, rhs.cells, system.component);
    v.nodes = rhs.nodes;
    null_space.project(v);
}

template <int D>
double true_residual(const CoupledOperator<D>& matrix, const NullSpace<D>& null_space, UnknownVector<D>& x,
                     const UnknownVector<D>& rhs, UnknownVector<D>& q, UnknownVector<D>& r)
{
    compatible(matrix.system(), null_space, rhs, r);
    matrix.apply(x, q);
    add(*matrix.system().grid, r, -1.0, q);
    null_space.project(r);
    return std::sqrt(dot(*matrix.system().grid, r, r));
}

template <int D>
SolveReport conjugate_gradients(const CoupledOperator<D>& matrix, Preconditioner<D>& preconditioner,
                                const NullSpace<D>& null_space, KrylovVectors<D>& vectors, UnknownVector<D>& x,
                                const UnknownVector<D>& rhs, const SolverOptions& options, double magnitude)
{
    const CoupledSystem<D>& system = matrix.system();
    const Grid<D>& grid = *system.grid;
    auto& [r, z, p, q] = vectors;
    SolveReport report;

    compatible(system, null_space, rhs, r);
    const double size = std::sqrt(dot(grid, r, r));
    const double reference = std::max(size, magnitude), target = options.tolerance * reference;
    bool reached = false; // by the recursive residual
    auto finish = [&](std::string reason) {
        const double residual = true_residual(matrix, null_space, x, rhs, q, r);
        report.residual = reference > 0 ? residual / reference : residual;
        report.converged = std::isfinite(residual) && (residual <= target || (reached && residual <= matrix.round_off(x)));
        report.message = report.converged ? std::string() : std::move(reason);
        return report;
    };
    if (!std::isfinite(size)) {
        report.residual = size;
        report.message = "the right-hand side is not finite";
        return report;
    }
    compatible(system, null_space, x, p); // the first guess without its part along the null vectors
    std::swap(x, p);
    if (!std::isfinite(dot(grid, x, x))) {
        x.cells.fill(0);
        x.nodes.setZero();
    }

    std::string reason;
    constexpr int most_restarts = 2; // by a residual that drifted from the true one, or by a breakdown
    for (int restarts = 0; restarts <= most_restarts;) {
        const double start = true_residual(matrix, null_space, x, rhs, q, r);
        if (start <= target || (reached && start <= matrix.round_off(x)))
            break;
        double residual = start, zr = 0, alpha = 0;
        bool broken = false, bodies_added = false;
        for (int k = 0; residual > 0.9 * target && report.iterations < options.max_iterations; ++k, ++report.iterations) {
            preconditioner.apply(r, z, residual);
            if (system.components.size() > 1)
                null_space.project(z);
            const auto [zr_new, zq, sum] = dots(system, null_space, z, r, q);
            if (!(zr_new > 0) || !std::isfinite(zr_new)) {
                reason = describe("the preconditioner is not positive: r.Br = %g", zr_new);
                broken = true;
                break;
            }
            turn(system, null_space, p, k == 0 ? 0.0 : -alpha * zq / zr, z, sum);
            zr = zr_new;
            const double energy = matrix.apply(p, q);
            if (!(energy > 0) || !std::isfinite(energy)) {
                reason = describe("the matrix is not positive definite: p.Ap = %g", energy);
                broken = true;
                break;
            }
            alpha = zr / energy;
            residual = std::sqrt(advance(grid, x, r, alpha, p, q));
            if (k >= 4 && preconditioner.wants_bodies(expected_iterations(k + 1, residual / start, target / start))) {
                preconditioner.add_bodies();
                bodies_added = true;
                ++report.iterations;
                break;
            }
        }
        if (report.iterations >= options.max_iterations) {
            reason = describe("not converged after %g iterations", report.iterations);
            break;
        }
        if (bodies_added)
            continue;
        ++restarts;
        reached = !broken;
        if (reached)
            reason = "the true residual stays above the recursive one: the system is too badly conditioned";
    }
    return finish(reason);
}

template void compatible<2>(const CoupledSystem<2>&, const NullSpace<2>&, const UnknownVector<2>&, UnknownVector<2>&);
template void compatible<3>(const CoupledSystem<3>&, const NullSpace<3>&, const UnknownVector<3>&, UnknownVector<3>&);
template double true_residual<2>(const CoupledOperator<2>&, const NullSpace<2>&, UnknownVector<2>&, const UnknownVector<2>&,
                                 UnknownVector<2>&, UnknownVector<2>&);
template double true_residual<3>(const CoupledOperator<3>&, const NullSpace<3>&, UnknownVector<3>&, const UnknownVector<3>&,
                                 UnknownVector<3>&, UnknownVector<3>&);
template SolveReport conjugate_gradients<2>(const CoupledOperator<2>&, Preconditioner<2>&, const NullSpace<2>&,
                                            KrylovVectors<2>&, UnknownVector<2>&, const UnknownVector<2>&, const SolverOptions&,
                                            double);
template SolveReport conjugate_gradients<3>(const CoupledOperator<3>&, Preconditioner<3>&, const NullSpace<3>&,
                                            KrylovVectors<3>&, UnknownVector<3>&, const UnknownVector<3>&, const SolverOptions&,
                                            double);

} // namespace gapflow
