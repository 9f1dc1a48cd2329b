#include "gapflow/viscosity/viscous_solver.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/viscosity/viscous_multigrid.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr int most_iterations = 500;
// Below this ratio of an edge to a cell's mass the diagonal alone preconditions well.
constexpr double stiff = 0.25;

// Velocities on the lattice and twists of the free bodies.
template <int D>
struct Unknowns {
    FaceField<D> u;
    Eigen::VectorXd V;

    explicit Unknowns(const ViscousSystem<D>& system)
        : u(*system.grid), V(Eigen::VectorXd::Zero(twist_size<D> * static_cast<long>(system.admissible.size())))
    {
    }
};

template <int D>
class ViscousSolver {
public:
    explicit ViscousSolver(const ViscousSystem<D>& system) : system_(system), grid_(*system.grid)
    {
        for (const ViscousTerm<D>& term : system.terms)
            for (int k = 0; k < 2 && term.at >= 0; ++k)
                if (const int b = term.solid[k] < 0 ? -1 : system.free_body[term.solid[k]]; b >= 0)
                    couplings_.push_back({term.axis, term.at, b,
                                          term.stiffness * term.weight * (system.admissible[b] * term.row[k])});
        for (std::size_t b = 0; b < system.admissible.size(); ++b) {
            const long at = twist_size<D> * static_cast<long>(b);
            const TwistMatrix<D> block = Eigen::MatrixXd(system.body_matrix.block(at, at, twist_size<D>, twist_size<D>));
            body_blocks_.emplace_back(block);
        }
        if (system.edge > stiff * system.cell_mass)
            for (int axis = 0; axis < D; ++axis)
                multigrid_.emplace_back(system, axis);
    }

    ViscousReport solve(Unknowns<D>& x, double tolerance)
    {
        Unknowns<D> r(system_), z(system_), p(system_), q(system_);
        apply(x, q);
        const double start = std::abs(dot(rhs(), x));
        for_each_value([&](int axis, long at) { r.u[axis].data()[at] = system_.rhs[axis].data()[at] - q.u[axis].data()[at]; });
        r.V = system_.body_rhs - q.V;
        precondition(r, z);
        double rho = dot(r, z);
        const double scale = std::sqrt(std::max(start, rho));
        ViscousReport report;
        for_each_value([&](int axis, long at) { p.u[axis].data()[at] = z.u[axis].data()[at]; });
        p.V = z.V;
        while (std::sqrt(std::max(rho, 0.0)) > tolerance * scale && report.iterations < most_iterations) {
            apply(p, q);
            const double alpha = rho / dot(p, q);
            for_each_value([&](int axis, long at) {
                x.u[axis].data()[at] += alpha * p.u[axis].data()[at];
                r.u[axis].data()[at] -= alpha * q.u[axis].data()[at];
            });
            x.V += alpha * p.V;
            r.V -= alpha * q.V;
            precondition(r, z);
            const double rho_next = dot(r, z), beta = rho_next / rho;
            rho = rho_next;
            for_each_value([&](int axis, long at) {
                p.u[axis].data()[at] = z.u[axis].data()[at] + beta * p.u[axis].data()[at];
            });
            p.V = z.V + beta * p.V;
            ++report.iterations;
        }
        report.residual = scale > 0 ? std::sqrt(std::max(rho, 0.0)) / scale : 0.0;
        report.converged = !(report.residual > tolerance);
        exchange(grid_, x.u, 1);
        return report;
    }

    double work_of_rhs(const Unknowns<D>& x) const { return dot(rhs(), x); }

private:
    struct BodyCoupling {
        int axis;
        long at;
        int body;
        Twist<D> row;
    };

    struct Rhs {
        const FaceField<D>& u;
        const Eigen::VectorXd& V;
    };
    Rhs rhs() const { return {system_.rhs, system_.body_rhs}; }

    template <class F>
    void for_each_value(F&& f) const
    {
        for (int axis = 0; axis < D; ++axis) {
            const Index<D> low = grid_.low(), end = owned_faces_end(grid_, axis);
            const Block<D>& block = system_.active[axis].block();
            for_each_plane(low[D - 1], end[D - 1], [&](int plane) {
                Index<D> from = low, to = end;
                from[D - 1] = plane;
                to[D - 1] = plane + 1;
                for_each_row<D>(from, to, [&](const Index<D>& row) {
                    const long first = block.offset(row), last = first + end[0] - low[0];
                    for (long at = first; at < last; ++at)
                        f(axis, at);
                });
            });
        }
    }

    template <class A>
    double dot(const A& a, const Unknowns<D>& b) const
    {
        double sum = 0;
        for (int axis = 0; axis < D; ++axis) {
            const Index<D> low = grid_.low(), end = owned_faces_end(grid_, axis);
            const Block<D>& block = system_.active[axis].block();
            sum += sum_over_planes(low[D - 1], end[D - 1], [&](int plane) {
                Index<D> from = low, to = end;
                from[D - 1] = plane;
                to[D - 1] = plane + 1;
                double of_plane = 0;
                for_each_row<D>(from, to, [&](const Index<D>& row) {
                    const double *x = a.u[axis].data() + block.offset(row), *y = b.u[axis].data() + block.offset(row);
                    double of_row = 0;
#pragma omp simd reduction(+ : of_row)
                    for (int i = 0; i < end[0] - low[0]; ++i)
                        of_row += x[i] * y[i];
                    of_plane += of_row;
                });
                return of_plane;
            });
        }
        return grid_.comm().sum(sum) + a.V.dot(b.V);
    }

    // y = A x.
    void apply(Unknowns<D>& x, Unknowns<D>& y) const
    {
        exchange(grid_, x.u, 1);
        for (int axis = 0; axis < D; ++axis) {
            const Index<D> low = grid_.low(), end = owned_faces_end(grid_, axis);
            const Block<D>& block = system_.active[axis].block();
            std::array<long, D> stride;
            for (int k = 0; k < D; ++k)
                stride[k] = block.stride[k];
            for_each_plane(low[D - 1], end[D - 1], [&](int plane) {
                Index<D> from = low, to = end;
                from[D - 1] = plane;
                to[D - 1] = plane + 1;
                for_each_row<D>(from, to, [&](const Index<D>& row) {
                    const long at = block.offset(row);
                    const double *v = x.u[axis].data() + at, *diagonal = system_.diagonal[axis].data() + at;
                    const std::int8_t* active = system_.active[axis].data() + at;
                    double* result = y.u[axis].data() + at;
#pragma omp simd
                    for (int i = 0; i < end[0] - low[0]; ++i) {
                        double around = 0;
                        for (int k = 0; k < D; ++k)
                            around += v[i - stride[k]] + v[i + stride[k]];
                        result[i] = diagonal[i] * v[i] - system_.edge * active[i] * around;
                    }
                });
            });
        }
        if (x.V.size() == 0)
            return;
        y.V.setZero();
        constexpr int n = twist_size<D>;
        for (const BodyCoupling& c : couplings_) {
            y.u[c.axis].data()[c.at] += c.row.dot(x.V.template segment<n>(n * c.body));
            y.V.template segment<n>(n * c.body) += x.u[c.axis].data()[c.at] * c.row;
        }
        grid_.comm().sum(std::span<double>(y.V.data(), y.V.size()));
        y.V += system_.body_matrix * x.V;
    }

    void precondition(const Unknowns<D>& r, Unknowns<D>& z)
    {
        if (multigrid_.empty())
            for_each_value([&](int axis, long at) {
                const double d = system_.diagonal[axis].data()[at];
                z.u[axis].data()[at] = d > 0 ? r.u[axis].data()[at] / d : 0.0;
            });
        for (std::size_t axis = 0; axis < multigrid_.size(); ++axis)
            multigrid_[axis].cycle(r.u[static_cast<int>(axis)], z.u[static_cast<int>(axis)]);
        constexpr int n = twist_size<D>;
        for (std::size_t b = 0; b < body_blocks_.size(); ++b)
            z.V.template segment<n>(n * static_cast<long>(b)) =
                body_blocks_[b].solve(Twist<D>(r.V.template segment<n>(n * static_cast<long>(b))));
    }

    const ViscousSystem<D>& system_;
    const Grid<D>& grid_;
    std::vector<BodyCoupling> couplings_;
    std::vector<Eigen::LDLT<TwistMatrix<D>>> body_blocks_;
    std::vector<ViscousMultigrid<D>> multigrid_;
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
ViscousStep<D> solve_viscous_system(const ViscousSystem<D>& system, FaceField<D>& u, const ViscousBodies<D>& bodies, double tolerance)
{
    constexpr int n = twist_size<D>;
    const Grid<D>& grid = *system.grid;
    ViscousStep<D> step;
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
    for (const CutFace<D>& face : system.cut) {
        double& w = x.u[face.axis].data()[face.at];
        w = (w - (face.solid >= 0 ? face.row.dot(bodies.twists[face.solid]) : 0.0)) / face.share;
    }
    for (std::size_t s = 0; s < bodies.twists.size(); ++s)
        if (const int b = system.free_body[s]; b >= 0)
            x.V.template segment<n>(n * b) = bodies.twists[s];

    ViscousSolver<D> solver(system);
    step.report = solver.solve(x, tolerance);
    step.energy = grid.comm().sum(system.constant) - solver.work_of_rhs(x);
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
    for (const CutFace<D>& face : system.cut)
        u[face.axis].data()[face.at] = face.share * x.u[face.axis].data()[face.at] +
                                       (face.solid >= 0 ? face.row.dot(step.twists[face.solid]) : 0.0);
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
                Eigen::Map<Twist<D>>(&sums[n * static_cast<std::size_t>(term.solid[k])]) -= term.stiffness * excess * term.row[k];
    }
    grid.comm().sum(sums);
    for (std::size_t s = 0; s < bodies.twists.size(); ++s) {
        Twist<D> impulse = Eigen::Map<Twist<D>>(&sums[n * s]);
        impulse.template tail<spin_size<D>>() -=
            system.turning[s] * step.twists[s].template tail<spin_size<D>>();
        step.impulses.push_back(impulse);
    }
    return step;
}

template ViscousStep<2> solve_viscous_system<2>(const ViscousSystem<2>&, FaceField<2>&, const ViscousBodies<2>&, double);
template ViscousStep<3> solve_viscous_system<3>(const ViscousSystem<3>&, FaceField<3>&, const ViscousBodies<3>&, double);

} // namespace gapflow
