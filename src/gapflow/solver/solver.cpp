#include "gapflow/solver/solver.hpp"

#include "gapflow/solver/conjugate_gradients.hpp"
#include "gapflow/solver/film_condensation.hpp"
#include "gapflow/solver/petsc_backend.hpp"

#include <cmath>
#include <optional>

namespace gapflow {

namespace {

constexpr double slow_eigenvalue = 5; // eigenvalue above which a motion of the bodies gets a column for the solves to come

} // namespace

template <int D>
struct CoupledSolver<D>::Data {
    Data(const CoupledSystem<D>& system, const SolverOptions& chosen)
        : options(chosen), whole(system), condensation(system), matrix(condensation.empty() ? system : condensation.reduced()),
          null_space(matrix.system()), vectors{zero_vector(matrix.system()), zero_vector(matrix.system()),
                                               zero_vector(matrix.system()), zero_vector(matrix.system())}
    {
        if (!condensation.empty())
            whole_null_space.emplace(system);
        if (options.backend == Backend::multigrid)
            preconditioner.emplace(matrix, options.bodies, options.ask_lightness);
        else
            petsc.emplace(matrix, null_space, options);
    }

    SolverOptions options;
    const CoupledSystem<D>& whole;
    FilmCondensation<D> condensation;
    CoupledOperator<D> matrix; ///< of the condensed system, if films are condensed
    NullSpace<D> null_space;   ///< of that
    std::optional<NullSpace<D>> whole_null_space;
    std::optional<BodyMotion> motion; ///< of the last solve, where films are condensed
    KrylovVectors<D> vectors;
    SlowMotions motions; ///< of the last solve
    std::optional<Preconditioner<D>> preconditioner;
    std::optional<PetscBackend<D>> petsc;
    double setup_seconds = 0;
};

template <int D>
CoupledSolver<D>::CoupledSolver(const CoupledSystem<D>& system, const SolverOptions& options)
{
    const double start = MPI_Wtime();
    data_ = std::make_unique<Data>(system, options);
    data_->setup_seconds = MPI_Wtime() - start;
}

template <int D>
CoupledSolver<D>::~CoupledSolver() = default;

template <int D>
SolveReport CoupledSolver<D>::solve(UnknownVector<D>& p, const UnknownVector<D>& rhs, double magnitude) const
{
    return solve(p, rhs, magnitude, data_->options.tolerance);
}

template <int D>
SolveReport CoupledSolver<D>::solve(UnknownVector<D>& p, const UnknownVector<D>& rhs, double magnitude, double tolerance) const
{
    const double start = MPI_Wtime();
    Data& d = *data_;
    SolveReport report =
        d.condensation.empty() ? solve_system(p, rhs, {magnitude}, tolerance) : solve_condensed(p, rhs, magnitude, tolerance);
    report.seconds = MPI_Wtime() - start;
    return report;
}

// The residual is the same, and so is what it is compared with: the norm of the whole right-hand side. That is made compatible as a whole, so that the
// pseudo-inverse is the whole system's.
template <int D>
SolveReport CoupledSolver<D>::solve_condensed(UnknownVector<D>& p, const UnknownVector<D>& rhs, double magnitude,
                                              double tolerance) const
{
    Data& d = *data_;
    UnknownVector<D> b = zero_vector(d.whole);
    compatible(d.whole, *d.whole_null_space, rhs, b);
    const double size = std::sqrt(dot(*d.whole.grid, b, b));
    const Eigen::VectorXd of_nodes = b.nodes;
    const auto reduced = d.condensation.reduce(of_nodes);
    b.nodes = reduced.nodes;
    if (d.matrix.dofs() > 0)
        d.matrix.add_flux(-d.matrix.inverse_mass(reduced.wrench), b);
    p.nodes = d.condensation.kept(p.nodes);
    const SolveReport report = solve_system(p, b, {magnitude, size}, tolerance);
    BodyMotion motion;
    if (d.matrix.dofs() > 0)
        motion.twist = d.matrix.inverse_mass(d.matrix.transpose_flux(p) + reduced.wrench, &motion.contact_impulse);
    p.nodes = d.condensation.expand(of_nodes, p.nodes, motion.twist);
    d.whole_null_space->project(p);
    if (d.matrix.system().nodes < d.whole.nodes)
        d.motion = std::move(motion);
    return report;
}

template <int D>
const std::optional<BodyMotion>& CoupledSolver<D>::motion() const
{
    return data_->motion;
}

template <int D>
SolveReport CoupledSolver<D>::solve_system(UnknownVector<D>& p, const UnknownVector<D>& rhs, const ResidualScale& scale,
                                           double tolerance) const
{
    Data& d = *data_;
    SolverOptions options = d.options;
    options.tolerance = tolerance;
    SolveReport report;
    if (d.preconditioner) {
        correct_slow_motions();
        report = conjugate_gradients(d.matrix, *d.preconditioner, d.null_space, d.vectors, p, rhs, options, scale, d.motions);
    }
    if (d.preconditioner && !report.converged && report.iterations < options.max_iterations && std::isfinite(report.residual)) {
        // Bodies that overlap far can make the films' part of the preconditioner indefinite: algebraic multigrid is not.
        const SolveReport first = report;
        if (!d.petsc)
            d.petsc.emplace(d.matrix, d.null_space, d.options);
        report = d.petsc->solve(p, rhs, scale, tolerance, d.vectors);
        report.iterations += first.iterations;
        if (!report.converged)
            report.message = first.message + "; then " + report.message;
    } else if (!d.preconditioner) {
        report = d.petsc->solve(p, rhs, scale, tolerance, d.vectors);
    }
    return report;
}

// A second solve for the same fluid, and the ones after it, need not find the bodies' slow motions again.
template <int D>
void CoupledSolver<D>::correct_slow_motions() const
{
    Data& d = *data_;
    Eigen::MatrixXd motions = d.motions.wrenches(slow_eigenvalue);
    for (long k = 0; k < motions.cols(); ++k)
        motions.col(k) = d.matrix.inverse_mass(motions.col(k));
    d.preconditioner->add_motions(motions);
}

template <int D>
void CoupledSolver<D>::update_bodies()
{
    data_->condensation.update_bodies();
    data_->matrix.update_bodies();
    if (data_->preconditioner) {
        data_->preconditioner->update_bodies();
        data_->petsc.reset(); // its columns for the bodies are out of date
    }
}

template <int D>
bool CoupledSolver<D>::corrects_bodies() const
{
    return data_->preconditioner && data_->preconditioner->corrects_bodies();
}

template <int D>
double CoupledSolver<D>::setup_seconds() const
{
    return data_->setup_seconds;
}

template <int D>
double CoupledSolver<D>::bytes_per_cell() const
{
    const Data& d = *data_;
    const Grid<D>& grid = *d.matrix.system().grid;
    const double vectors = 4.0 * 8.0 * d.vectors.r.cells.size();
    return (vectors + d.condensation.bytes() + d.matrix.bytes() + (d.preconditioner ? d.preconditioner->bytes() : 0)) /
           grid.owned_cells();
}

template class CoupledSolver<2>;
template class CoupledSolver<3>;

} // namespace gapflow
