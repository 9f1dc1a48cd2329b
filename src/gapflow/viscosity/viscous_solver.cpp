#include "gapflow/viscosity/viscous_solver.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/viscosity/lattice_metric.hpp"
#include "gapflow/viscosity/viscous_multigrid.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

constexpr int most_iterations = 500;
constexpr int most_rounds = 20;           // of corrections in single precision
constexpr double single_tolerance = 1e-5; // reduction of the residual by one of them
// Below this ratio of an edge to a cell's mass the diagonal alone preconditions well.
constexpr double stiff = 0.25;

// Velocities on the lattice and twists of the free bodies.
template <int D, class T = double>
struct Unknowns {
    FaceField<D, T> u;
    Eigen::VectorXd V;

    explicit Unknowns(const ViscousSystem<D>& system)
        : u(*system.grid), V(Eigen::VectorXd::Zero(twist_size<D> * static_cast<long>(system.admissible.size())))
    {
    }
};

/// Sum of f(axis, place of the row's first value, number of values) over all rows of this rank's faces.
template <int D, class F>
double sum_over_face_rows(const Grid<D>& grid, const Block<D>& block, F&& f)
{
    double sum = 0;
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid.low(), end = owned_faces_end(grid, axis);
        sum += sum_over_planes(low[D - 1], end[D - 1], [&](int plane) {
            Index<D> from = low, to = end;
            from[D - 1] = plane;
            to[D - 1] = plane + 1;
            double of_plane = 0;
            for_each_row<D>(from, to, [&](const Index<D>& row) { of_plane += f(axis, block.offset(row), end[0] - low[0]); });
            return of_plane;
        });
    }
    return sum;
}

/// The matrix and its preconditioner on values of one precision.
template <int D, class T>
class ViscousMatrix {
public:
    using Values = Unknowns<D, T>;

    /// `diagonal`: of the system, in this precision.
    ViscousMatrix(const ViscousSystem<D>& system, const FaceField<D, T>& diagonal)
        : system_(system), grid_(*system.grid), diagonal_(diagonal)
    {
        for (const ViscousTerm<D>& term : system.terms)
            for (int k = 0; k < 2 && term.at >= 0; ++k)
                if (const int b = term.solid[k] < 0 ? -1 : system.free_body[term.solid[k]]; b >= 0)
                    couplings_.push_back(
                        {term.axis, term.at, b, term.stiffness * term.weight * (system.admissible[b] * term.row[k])});
        for (std::size_t b = 0; b < system.admissible.size(); ++b) {
            const long at = twist_size<D> * static_cast<long>(b);
            const TwistMatrix<D> block = Eigen::MatrixXd(system.body_matrix.block(at, at, twist_size<D>, twist_size<D>));
            body_blocks_.emplace_back(block);
        }
    }

    /// y = A x; returns x . y.
    double apply(Values& x, Values& y) const
    {
        exchange(grid_, x.u, 1);
        const T edge = static_cast<T>(system_.edge);
        double energy = over_rows([&](int axis, long at, int n) {
            if (grid_.graded())
                return apply_to_graded_row(axis, at, n, x, y);
            std::array<long, D> stride;
            for (int k = 0; k < D; ++k)
                stride[k] = block().stride[k];
            const T *v = x.u[axis].data() + at, *diagonal = diagonal_[axis].data() + at;
            const std::int8_t* active = system_.active[axis].data() + at;
            T* result = y.u[axis].data() + at;
            T of_row = 0;
#pragma omp simd reduction(+ : of_row)
            for (int i = 0; i < n; ++i) {
                T around = 0;
                for (int k = 0; k < D; ++k)
                    around += v[i - stride[k]] + v[i + stride[k]];
                result[i] = diagonal[i] * v[i] - edge * static_cast<T>(active[i]) * around;
                of_row += result[i] * v[i];
            }
            return of_row;
        });
        y.V.setZero();
        constexpr int n = twist_size<D>;
        for (const BodyCoupling& c : couplings_) {
            const double reaction = c.row.dot(x.V.template segment<n>(n * c.body)), moved = x.u[c.axis].data()[c.at];
            y.u[c.axis].data()[c.at] += static_cast<T>(reaction);
            y.V.template segment<n>(n * c.body) += moved * c.row;
            energy += moved * reaction;
        }
        if (x.V.size() > 0)
            grid_.comm().sum(std::span<double>(y.V.data(), y.V.size()));
        y.V += system_.body_matrix * x.V;
        return grid_.comm().sum(energy) + x.V.dot(y.V);
    }

    /// x += alpha p, r -= alpha q; returns r . B r with the diagonal for B.
    double advance(double alpha, const Values& p, const Values& q, Values& x, Values& r) const
    {
        x.V += alpha * p.V;
        r.V -= alpha * q.V;
        const T a = static_cast<T>(alpha);
        const double sum = over_rows([&](int axis, long at, int n) {
            const T *dp = p.u[axis].data() + at, *dq = q.u[axis].data() + at, *diagonal = diagonal_[axis].data() + at;
            T *to = x.u[axis].data() + at, *left = r.u[axis].data() + at;
            T of_row = 0;
#pragma omp simd reduction(+ : of_row)
            for (int i = 0; i < n; ++i) {
                to[i] += a * dp[i];
                left[i] -= a * dq[i];
                of_row += left[i] * left[i] * inverse(diagonal[i]);
            }
            return of_row;
        });
        return grid_.comm().sum(sum) + solve_bodies(r.V).dot(r.V);
    }

    /// r . B r with the diagonal for B.
    double energy(const Values& r) const
    {
        const double sum = over_rows([&](int axis, long at, int n) {
            const T *from = r.u[axis].data() + at, *diagonal = diagonal_[axis].data() + at;
            T of_row = 0;
#pragma omp simd reduction(+ : of_row)
            for (int i = 0; i < n; ++i)
                of_row += from[i] * from[i] * inverse(diagonal[i]);
            return of_row;
        });
        return grid_.comm().sum(sum) + solve_bodies(r.V).dot(r.V);
    }

    /// p = B r + beta p with the diagonal for B.
    void turn(Values& p, const Values& r, double beta) const
    {
        const T b = static_cast<T>(beta);
        over_rows([&](int axis, long at, int n) {
            T* to = p.u[axis].data() + at;
            const T *from = r.u[axis].data() + at, *diagonal = diagonal_[axis].data() + at;
#pragma omp simd
            for (int i = 0; i < n; ++i)
                to[i] = from[i] * inverse(diagonal[i]) + b * to[i];
            return T(0);
        });
        p.V = solve_bodies(r.V) + beta * p.V;
    }

    /// The bodies' own blocks, solved.
    Eigen::VectorXd solve_bodies(const Eigen::VectorXd& r) const
    {
        constexpr int n = twist_size<D>;
        Eigen::VectorXd z(r.size());
        for (std::size_t b = 0; b < body_blocks_.size(); ++b)
            z.template segment<n>(n * static_cast<long>(b)) =
                body_blocks_[b].solve(Twist<D>(r.template segment<n>(n * static_cast<long>(b))));
        return z;
    }

    template <class F>
    double over_rows(F&& f) const
    {
        return sum_over_face_rows(grid_, block(), f);
    }

private:
    struct BodyCoupling {
        int axis;
        long at;
        int body;
        Twist<D> row;
    };
    const Block<D>& block() const
    {
        return system_.active[0].block();
    }
    // apply() where cells differ in width.
    T apply_to_graded_row(int axis, long at, int n, const Values& x, Values& y) const
    {
        Index<D> row;
        long left = at;
        for (int k = D - 1; k >= 0; --k) {
            row[k] = block().low[k] + static_cast<int>(left / block().stride[k]);
            left %= block().stride[k];
        }
        const EdgeRow<D> edges(grid_, axis, row);
        const T *v = x.u[axis].data() + at, *diagonal = diagonal_[axis].data() + at;
        const std::int8_t* active = system_.active[axis].data() + at;
        T* result = y.u[axis].data() + at;
        T of_row = 0;
        for (int i = 0; i < n; ++i) {
            double around = 0;
            for (int k = 0; k < D; ++k)
                around += edges.before(k, i) * v[i - block().stride[k]] + edges.after(k, i) * v[i + block().stride[k]];
            result[i] = diagonal[i] * v[i] - static_cast<T>(system_.edge * active[i] * around);
            of_row += result[i] * v[i];
        }
        return of_row;
    }
    static T inverse(T diagonal)
    {
        return 1 / (diagonal > 0 ? diagonal : std::numeric_limits<T>::infinity());
    }

    const ViscousSystem<D>& system_;
    const Grid<D>& grid_;
    const FaceField<D, T>& diagonal_; ///< 0 where the lattice has no value
    std::vector<BodyCoupling> couplings_;
    std::vector<Eigen::LDLT<TwistMatrix<D>>> body_blocks_;
};

/// x . rhs.
template <int D>
double work_of_rhs(const ViscousSystem<D>& system, const Unknowns<D>& x)
{
    return system.grid->comm().sum(sum_over_face_rows(*system.grid, system.active[0].block(), [&](int axis, long at, int n) {
        const double *a = system.rhs[axis].data() + at, *b = x.u[axis].data() + at;
        double of_row = 0;
#pragma omp simd reduction(+ : of_row)
        for (int i = 0; i < n; ++i)
            of_row += a[i] * b[i];
        return of_row;
    })) + system.body_rhs.dot(x.V);
}

/// Conjugate gradients from x on, until the error's energy norm, estimated by the preconditioner, is `tolerance` of the solution's.
template <int D>
class ViscousSolver {
public:
    ViscousSolver(const ViscousSystem<D>& system, double tolerance)
        : system_(system), tolerance_(tolerance), matrix_(system, system.diagonal)
    {
    }

    ViscousReport solve(Unknowns<D>& x)
    {
        Unknowns<D> r(system_);
        matrix_.apply(x, r);
        const double start = std::abs(work_of_rhs(system_, x));
        subtract_from_rhs(r);
        ViscousReport report;
        if (system_.edge > stiff * system_.cell_mass)
            solve_with_multigrid(x, r, start, report);
        else
            solve_with_diagonal(x, r, start, report);
        report.converged = !(report.residual > tolerance_);
        exchange(*system_.grid, x.u, 1);
        return report;
    }

private:
    /// r = rhs - r.
    void subtract_from_rhs(Unknowns<D>& r) const
    {
        matrix_.over_rows([&](int axis, long at, int n) {
            const double* b = system_.rhs[axis].data() + at;
            double* to = r.u[axis].data() + at;
            for (int i = 0; i < n; ++i)
                to[i] = b[i] - to[i];
            return 0.0;
        });
        r.V = system_.body_rhs - r.V;
    }

    // In single precision, with half the memory traffic, for a correction of x; the next correction removes the rounding error.
    void solve_with_diagonal(Unknowns<D>& x, Unknowns<D>& r, double start, ViscousReport& report)
    {
        using Single = Unknowns<D, float>;
        FaceField<D, float> diagonal(*system_.grid);
        convert(system_.diagonal, 1, diagonal);
        const ViscousMatrix<D, float> matrix(system_, diagonal);
        Single left(system_), e(system_), p(system_), q(system_);
        double scale = 0;
        for (int round = 0; round < most_rounds; ++round) {
            const double size = std::sqrt(matrix_.energy(r));
            if (round == 0)
                scale = std::max(std::sqrt(start), size);
            report.residual = scale > 0 ? size / scale : 0.0;
            if (!(report.residual > tolerance_) || report.iterations >= most_iterations)
                return;
            convert(r.u, 1 / size, left.u); // single precision has a range of 1e38
            left.V = r.V / size;
            if (round > 0)
                for (int axis = 0; axis < D; ++axis)
                    e.u[axis].fill(0);
            e.V.setZero();
            matrix.turn(p, left, 0);
            const double enough = std::max(single_tolerance, 0.5 * tolerance_ / report.residual);
            for (double rho = 1; std::sqrt(std::max(rho, 0.0)) > enough && report.iterations < most_iterations;
                 ++report.iterations) {
                const double alpha = rho / matrix.apply(p, q), rho_next = matrix.advance(alpha, p, q, e, left);
                matrix.turn(p, left, rho_next / rho);
                rho = rho_next;
            }
            matrix_.over_rows([&](int axis, long at, int n) {
                const float* from = e.u[axis].data() + at;
                double* to = x.u[axis].data() + at;
                for (int i = 0; i < n; ++i)
                    to[i] += size * from[i];
                return 0.0;
            });
            x.V += size * e.V;
            matrix_.apply(x, r);
            subtract_from_rhs(r);
        }
    }

    void solve_with_multigrid(Unknowns<D>& x, Unknowns<D>& r, double start, ViscousReport& report)
    {
        std::vector<ViscousMultigrid<D>> multigrid;
        for (int axis = 0; axis < D; ++axis)
            multigrid.emplace_back(system_, axis);
        Unknowns<D> z(system_), p(system_), q(system_);
        auto precondition = [&] { // z = B r; returns z . r
            for (int axis = 0; axis < D; ++axis)
                multigrid[axis].cycle(r.u[axis], z.u[axis]);
            z.V = matrix_.solve_bodies(r.V);
            return system_.grid->comm().sum(matrix_.over_rows([&](int axis, long at, int n) {
                const double *a = r.u[axis].data() + at, *b = z.u[axis].data() + at;
                double of_row = 0;
#pragma omp simd reduction(+ : of_row)
                for (int i = 0; i < n; ++i)
                    of_row += a[i] * b[i];
                return of_row;
            })) + r.V.dot(z.V);
        };
        auto turn = [&](double beta) { // p = z + beta p
            matrix_.over_rows([&](int axis, long at, int n) {
                const double* from = z.u[axis].data() + at;
                double* to = p.u[axis].data() + at;
                for (int i = 0; i < n; ++i)
                    to[i] = from[i] + beta * to[i];
                return 0.0;
            });
            p.V = z.V + beta * p.V;
        };
        double rho = precondition();
        const double scale = std::sqrt(std::max(start, rho));
        turn(0);
        for (; std::sqrt(std::max(rho, 0.0)) > tolerance_ * scale && report.iterations < most_iterations; ++report.iterations) {
            const double alpha = rho / matrix_.apply(p, q);
            matrix_.advance(alpha, p, q, x, r);
            const double rho_next = precondition();
            turn(rho_next / rho);
            rho = rho_next;
        }
        report.residual = scale > 0 ? std::sqrt(std::max(rho, 0.0)) / scale : 0.0;
    }

    void convert(const FaceField<D>& from, double factor, FaceField<D, float>& to) const
    {
        matrix_.over_rows([&](int axis, long at, int n) {
            const double* x = from[axis].data() + at;
            float* y = to[axis].data() + at;
            for (int i = 0; i < n; ++i)
                y[i] = static_cast<float>(factor * x[i]);
            return 0.0;
        });
    }

    const ViscousSystem<D>& system_;
    double tolerance_;
    ViscousMatrix<D, double> matrix_;
};

template <int D>
double known_part(const std::array<int, 2>& solid, const std::array<Twist<D>, 2>& row, const std::vector<Twist<D>>& twists)
{
    double sum = 0;
    for (int k = 0; k < 2; ++k)
        if (solid[k] >= 0)
            sum += row[k].dot(twists[solid[k]]);
    return sum;
}

} // namespace

template <int D>
ViscousSolution<D> solve_viscous_system(const ViscousSystem<D>& system, FaceField<D>& u, const ViscousBodies<D>& bodies,
                                        double tolerance)
{
    constexpr int n = twist_size<D>;
    const Grid<D>& grid = *system.grid;
    ViscousSolution<D> step;
    step.twists = bodies.twists;

    Unknowns<D> x(system);
    for (int axis = 0; axis < D; ++axis)
        for_each_row<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& row) {
            const std::int8_t* active = &system.active(axis, row);
            const double* from = &u(axis, row);
            double* to = &x.u(axis, row);
            for (int i = 0; i < owned_faces_end(grid, axis)[0] - row[0]; ++i)
                to[i] = active[i] ? from[i] : 0.0;
        });
    for (const ViscousCutFace<D>& face : system.cut) {
        double& w = x.u[face.axis].data()[face.at];
        w = (w - (face.solid >= 0 ? face.row.dot(bodies.twists[face.solid]) : 0.0)) / face.share;
    }
    for (std::size_t s = 0; s < bodies.twists.size(); ++s)
        if (const int b = system.free_body[s]; b >= 0)
            x.V.template segment<n>(n * b) = bodies.twists[s];

    step.report = ViscousSolver<D>(system, tolerance).solve(x);
    step.energy = grid.comm().sum(system.constant) - work_of_rhs(system, x);
    for (std::size_t s = 0; s < bodies.twists.size(); ++s) {
        const auto spin = bodies.twists[s].template tail<spin_size<D>>();
        step.energy += system.free_body[s] >= 0 ? bodies.twists[s].dot(bodies.mass[s] * bodies.twists[s])
                                                : spin.dot(system.turning[s] * spin);
    }

    for (std::size_t s = 0; s < bodies.twists.size(); ++s)
        if (const int b = system.free_body[s]; b >= 0)
            step.twists[s] = x.V.template segment<n>(n * b);
    for (int axis = 0; axis < D; ++axis)
        for_each_row<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& row) {
            const std::int8_t* active = &system.active(axis, row);
            const double* from = &x.u(axis, row);
            double* to = &u(axis, row);
            for (int i = 0; i < owned_faces_end(grid, axis)[0] - row[0]; ++i)
                to[i] = active[i] ? from[i] : to[i];
        });
    for (const ViscousCutFace<D>& face : system.cut)
        u[face.axis].data()[face.at] =
            face.share * x.u[face.axis].data()[face.at] + (face.solid >= 0 ? face.row.dot(step.twists[face.solid]) : 0.0);
    for (const FollowingFace<D>& face : system.following) {
        double& value = u[face.axis].data()[face.at];
        const double led = (face.leader >= 0 ? face.share * x.u[face.axis].data()[face.leader] : 0.0) +
                           known_part<D>(face.solid, face.row, step.twists);
        value = (face.mass * value + face.stiffness * led) / (face.mass + face.stiffness);
    }

    std::vector<double> sums(n * bodies.twists.size(), 0.0);
    for (const ViscousTerm<D>& term : system.terms) {
        const double excess = (term.at >= 0 ? term.weight * x.u[term.axis].data()[term.at] : 0.0) +
                              known_part<D>(term.solid, term.row, step.twists) - term.target;
        for (int k = 0; k < 2; ++k)
            if (term.solid[k] >= 0)
                Eigen::Map<Twist<D>>(&sums[n * static_cast<std::size_t>(term.solid[k])]) -=
                    term.stiffness * excess * term.row[k];
    }
    grid.comm().sum(sums);
    for (std::size_t s = 0; s < bodies.twists.size(); ++s) {
        Twist<D> impulse = Eigen::Map<Twist<D>>(&sums[n * s]);
        impulse.template tail<spin_size<D>>() -= system.turning[s] * step.twists[s].template tail<spin_size<D>>();
        step.impulses.push_back(impulse);
    }
    return step;
}

template ViscousSolution<2> solve_viscous_system<2>(const ViscousSystem<2>&, FaceField<2>&, const ViscousBodies<2>&, double);
template ViscousSolution<3> solve_viscous_system<3>(const ViscousSystem<3>&, FaceField<3>&, const ViscousBodies<3>&, double);

} // namespace gapflow
