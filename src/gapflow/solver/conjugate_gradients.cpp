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

/// x += a p, r -= a q; returns |r|^2. Hands r to the preconditioner, divided by `size`.
template <int D>
double advance(const Grid<D>& grid, Preconditioner<D>& preconditioner, UnknownVector<D>& x, UnknownVector<D>& r, double a,
               const UnknownVector<D>& p, const UnknownVector<D>& q, double size)
{
    const double square = sum_over_pieces<1>(grid, [&](const Index<D>& first, int n) {
        double* __restrict xs = &x.cells(first), * __restrict rs = &r.cells(first);
        const double *ps = &p.cells(first), *qs = &q.cells(first);
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int i = 0; i < n; ++i) {
            xs[i] += a * ps[i];
            rs[i] -= a * qs[i];
            sum += rs[i] * rs[i];
        }
        preconditioner.load(first, rs, n, 1 / size);
        return std::array<double, 1>{sum};
    })[0];
    x.nodes += a * p.nodes;
    r.nodes -= a * q.nodes;
    return grid.comm().sum(square) + r.nodes.squaredNorm();
}

struct Dots {
    double zr, zq; ///< z . r and z . q with z projected
    double shift;  ///< what is to be subtracted from z, the same in all unknowns
};

/// Of the preconditioner's last result z, in one reduction. With one component z is projected on the fly, else it must be
/// already.
template <int D>
Dots dots(const CoupledSystem<D>& system, const NullSpace<D>& null_space, const Preconditioner<D>& preconditioner,
          const UnknownVector<D>& z, const UnknownVector<D>& r, const UnknownVector<D>& q)
{
    enum { zr, zq, z1, r1, q1 };
    const Grid<D>& grid = *system.grid;
    std::array<double, 5> sums = sum_over_pieces<5>(grid, [&](const Index<D>& first, int n) {
        double buffer[piece];
        const double* zs = preconditioner.result(first, z, n, buffer);
        const double *rs = &r.cells(first), *qs = &q.cells(first);
        double a = 0, b = 0, c = 0, d = 0, e = 0;
#pragma omp simd reduction(+ : a, b, c, d, e)
        for (int i = 0; i < n; ++i) {
            a += zs[i] * rs[i];
            b += zs[i] * qs[i];
            c += zs[i];
            d += rs[i];
            e += qs[i];
        }
        return std::array<double, 5>{a, b, c, d, e};
    });
    for (int plane = grid.low()[D - 1]; plane < grid.high()[D - 1]; ++plane)
        preconditioner.result_rest(plane, [&](const Index<D>& cell, double value) {
            sums[zr] += value * r.cells(cell);
            sums[zq] += value * q.cells(cell);
            sums[z1] += value;
        });
    grid.comm().sum(sums);
    sums[zr] += z.nodes.dot(r.nodes);
    sums[zq] += z.nodes.dot(q.nodes);
    sums[z1] += z.nodes.sum();
    sums[r1] += r.nodes.sum();
    sums[q1] += q.nodes.sum();
    double shift = 0;
    if (!null_space.empty() && system.components.size() == 1) {
        shift = null_space.shifts(sums[z1])[1];
        sums[zr] -= shift * sums[r1];
        sums[zq] -= shift * sums[q1];
    }
    return {sums[zr], sums[zq], shift};
}

/// p = z - shift + b p and q = A p in one pass over memory; returns p . q. Cells without unknown get -shift: q is 0 there.
template <int D>
double turn(const CoupledOperator<D>& matrix, const Preconditioner<D>& preconditioner, const UnknownVector<D>& z, double shift,
            double b, UnknownVector<D>& p, UnknownVector<D>& q)
{
    const Grid<D>& grid = *matrix.system().grid;
    const int low = grid.low()[D - 1], planes = grid.high()[D - 1] - low;
    auto turn_plane = [&](int plane) {
        for_each_piece_of_plane<D>(grid, plane, [&](const Index<D>& first, int n) {
            double buffer[piece];
            const double* zs = preconditioner.result(first, z, n, buffer);
            double* __restrict ps = &p.cells(first);
            if (b == 0) // whatever p holds
                for (int i = 0; i < n; ++i)
                    ps[i] = zs[i] - shift;
            else
                for (int i = 0; i < n; ++i)
                    ps[i] = zs[i] - shift + b * ps[i];
        });
        preconditioner.result_rest(plane, [&](const Index<D>& cell, double value) { p.cells(cell) += value; });
    };
    if (b == 0)
        p.nodes.setZero();
    p.nodes = z.nodes + b * p.nodes;
    p.nodes.array() -= shift;
    if (b == 0) // nothing else writes there
        matrix.begin_product(p);
    // Slabs of planes for threads: the products of planes whose neighbours lie in the slab follow on the heels of p.
    const int slabs = std::max(1, std::min(thread_count(), planes / 4));
    const bool fused = matrix.halo_only_last_axis();
    std::vector<double> energy(planes, 0.0);
    auto multiply = [&](int plane) { energy[plane - low] = matrix.product_plane(p.cells, q.cells, plane); };
    auto slab_begin = [&](int t) { return low + static_cast<int>(static_cast<long>(planes) * t / slabs); };
    for_each_part_of(slabs, slabs, [&](long t, long end) {
        for (; t < end; ++t)
            for (int k = slab_begin(static_cast<int>(t)); k < slab_begin(static_cast<int>(t) + 1); ++k) {
                turn_plane(k);
                if (fused && k >= slab_begin(static_cast<int>(t)) + 2)
                    multiply(k - 1);
            }
    });
    matrix.exchange(p);
    for_each_part_of(slabs, slabs, [&](long t, long end) {
        for (; t < end; ++t) {
            const int from = slab_begin(static_cast<int>(t)), to = slab_begin(static_cast<int>(t) + 1);
            for (int k = from; k < to; ++k)
                if (!fused || k == from || k == to - 1)
                    multiply(k);
        }
    });
    double sum = 0;
    for (double part : energy)
        sum += part;
    return matrix.finish_product(p, q, sum);
}

} // namespace

template <int D>
void compatible(const CoupledSystem<D>& system, const NullSpace<D>& null_space, const UnknownVector<D>& rhs,
                UnknownVector<D>& v)
{
    for_each_piece(*system.grid, [&](const Index<D>& first, int n) {
        double* row = &v.cells(first);
        const double* from = &rhs.cells(first);
        const int* component = &system.component(first);
        for (int i = 0; i < n; ++i)
            row[i] = component[i] >= 0 ? from[i] : 0.0;
    });
    v.nodes = rhs.nodes;
    null_space.project(v);
}

template <int D>
double true_residual(const CoupledOperator<D>& matrix, const NullSpace<D>& null_space, UnknownVector<D>& x,
                     const UnknownVector<D>& rhs, UnknownVector<D>& q, UnknownVector<D>& r)
{
    const CoupledSystem<D>& system = matrix.system();
    const Grid<D>& grid = *system.grid;
    matrix.apply(x, q);
    // r = rhs - A x where there is an unknown.
    std::array<double, 2> sums = sum_over_pieces<2>(grid, [&](const Index<D>& first, int n) {
        double* row = &r.cells(first);
        const double *from = &rhs.cells(first), *product = &q.cells(first);
        const int* component = &system.component(first);
        double square = 0, sum = 0;
#pragma omp simd reduction(+ : square, sum)
        for (int i = 0; i < n; ++i) {
            row[i] = component[i] >= 0 ? from[i] - product[i] : 0.0;
            square += row[i] * row[i];
            sum += row[i];
        }
        return std::array<double, 2>{square, sum};
    });
    r.nodes = rhs.nodes - q.nodes;
    grid.comm().sum(sums);
    const double square = sums[0] + r.nodes.squaredNorm(), sum = sums[1] + r.nodes.sum();
    if (null_space.empty())
        return std::sqrt(square);
    if (system.components.size() == 1) {
        const double constant = null_space.shifts(sum)[1] * sum; // its part of |r|^2
        if (constant < 1e-3 * square)
            return std::sqrt(square - constant);
    }
    null_space.project(r);
    return std::sqrt(dot(grid, r, r));
}

namespace {

enum class Stop { reached, broken, bodies_added };

// Iterations from the residual r of norm `start` until it falls to nine tenths of the target, the preconditioner or the matrix is found not
// to be positive (with the reason), or the preconditioner has added the bodies' correction.
template <int D>
Stop iterate(const CoupledOperator<D>& matrix, Preconditioner<D>& preconditioner, const NullSpace<D>& null_space,
             KrylovVectors<D>& vectors, UnknownVector<D>& x, double start, double target, int max_iterations, int& iterations,
             SlowMotions& motions, std::string& reason)
{
    const CoupledSystem<D>& system = matrix.system();
    const Grid<D>& grid = *system.grid;
    auto& [r, z, p, q] = vectors;
    const bool in_z = !null_space.empty() && system.components.size() > 1;
    double residual = start, zr = 0, alpha = 0, loaded_size = start;
    for (int k = 0; residual > 0.9 * target && iterations < max_iterations; ++k, ++iterations) {
        preconditioner.apply_in_place(r, z, loaded_size, k > 0, in_z);
        if (in_z)
            null_space.project(z);
        const auto [zr_new, zq, shift] = dots(system, null_space, preconditioner, z, r, q);
        if (!(zr_new > 0) || !std::isfinite(zr_new)) {
            reason = describe("the preconditioner is not positive: r.Br = %g", zr_new);
            return Stop::broken;
        }
        const double beta = k == 0 ? 0.0 : -alpha * zq / zr;
        zr = zr_new;
        const double energy = turn(matrix, preconditioner, z, shift, beta, p, q);
        if (!(energy > 0) || !std::isfinite(energy)) {
            reason = describe("the matrix is not positive definite: p.Ap = %g", energy);
            return Stop::broken;
        }
        alpha = zr / energy;
        motions.add(zr, alpha, beta, matrix.last_wrench());
        loaded_size = residual;
        residual = std::sqrt(advance(grid, preconditioner, x, r, alpha, p, q, loaded_size));
        if (k >= 4 && preconditioner.wants_bodies(k + 1, expected_iterations(k + 1, residual / start, target / start))) {
            preconditioner.add_bodies();
            ++iterations;
            return Stop::bodies_added;
        }
    }
    return Stop::reached;
}

} // namespace

template <int D>
SolveReport conjugate_gradients(const CoupledOperator<D>& matrix, Preconditioner<D>& preconditioner,
                                const NullSpace<D>& null_space, KrylovVectors<D>& vectors, UnknownVector<D>& x,
                                const UnknownVector<D>& rhs, const SolverOptions& options, const ResidualScale& scale,
                                SlowMotions& motions)
{
    const CoupledSystem<D>& system = matrix.system();
    const Grid<D>& grid = *system.grid;
    auto& [r, z, p, q] = vectors;
    SolveReport report;

    motions.clear();
    compatible(system, null_space, rhs, r);
    const double size = std::sqrt(dot(grid, r, r));
    const double reference = scale.reference(size), target = options.tolerance * reference;
    bool reached = false; // by the recursive residual
    auto finish = [&](std::string reason) {
        compatible(system, null_space, x, p); // without what CG left in cells without unknown
        std::swap(x, p);
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
    const double guess = dot(grid, x, x);
    if (!std::isfinite(guess)) {
        x.cells.fill(0);
        x.nodes.setZero();
    } else if (guess > 0) {
        compatible(system, null_space, x, p); // without its part along the null vectors
        std::swap(x, p);
    }
    bool fresh = !(guess > 0); // r is the residual already

    std::string reason;
    constexpr int most_restarts = 2; // by a residual that drifted from the true one, or by a breakdown
    for (int restarts = 0; restarts <= most_restarts;) {
        double start = size;
        if (!fresh) {
            start = true_residual(matrix, null_space, x, rhs, q, r);
            null_space.project(r);
        }
        if (!fresh && report.iterations == 0 && restarts == 0 && start > size) { // a guess worse than none
            x.cells.fill(0);
            x.nodes.setZero();
            compatible(system, null_space, rhs, r);
            start = size;
        }
        fresh = false;
        if (start <= target || (reached && start <= matrix.round_off(x)))
            break;
        const Stop stop = iterate(matrix, preconditioner, null_space, vectors, x, start, target, options.max_iterations,
                                  report.iterations, motions, reason);
        if (report.iterations >= options.max_iterations) {
            reason = describe("not converged after %g iterations", report.iterations);
            break;
        }
        if (stop == Stop::bodies_added)
            continue;
        ++restarts;
        reached = stop == Stop::reached;
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
                                            const ResidualScale&, SlowMotions&);
template SolveReport conjugate_gradients<3>(const CoupledOperator<3>&, Preconditioner<3>&, const NullSpace<3>&,
                                            KrylovVectors<3>&, UnknownVector<3>&, const UnknownVector<3>&, const SolverOptions&,
                                            const ResidualScale&, SlowMotions&);

} // namespace gapflow
