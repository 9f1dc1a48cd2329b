// KSP CG on the shell matrix L + K M^-1 K^T; preconditioner BoomerAMG (Henson & Yang, Appl. Numer. Math. 41, 2002) of the
// assembled L, corrected for the bodies by Woodbury. Parts of the fluid that no open side touches make L singular: algebraic
// multigrid gets L + 1e-6 diag(L) there. The null vectors are projected out of every preconditioned residual.

#include "gapflow/solver/petsc_backend.hpp"

#include "gapflow/core/error.hpp"

#include <cmath>

namespace gapflow {

namespace {

constexpr double shift = 1e-6;

template <int D>
void to_petsc(const CoupledSystem<D>& system, const UnknownVector<D>& from, ::Vec to)
{
    const Grid<D>& grid = *system.grid;
    PetscScalar* values = nullptr;
    VecGetArrayWrite(to, &values);
    PetscScalar* next = values;
    if (grid.comm().root())
        next = std::copy_n(from.nodes.data(), system.nodes, next);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (system.component(c) >= 0)
            *next++ = from.cells(c);
    });
    VecRestoreArrayWrite(to, &values);
}

template <int D>
void from_petsc(const CoupledSystem<D>& system, ::Vec from, UnknownVector<D>& to)
{
    const Grid<D>& grid = *system.grid;
    const PetscScalar* values = nullptr;
    VecGetArrayRead(from, &values);
    const PetscScalar* next = values;
    if (grid.comm().root()) {
        std::copy_n(next, system.nodes, to.nodes.data());
        next += system.nodes;
    }
    for_each_index<D>(grid.low(), grid.high(),
                      [&](const Index<D>& c) { to.cells(c) = system.component(c) >= 0 ? *next++ : 0.0; });
    VecRestoreArrayRead(from, &values);
    grid.comm().broadcast(std::span<double>(to.nodes.data(), to.nodes.size()));
}

} // namespace

template <int D>
struct PetscBackend<D>::Data {
    const CoupledOperator<D>& matrix;
    const NullSpace<D>& null_space;
    SolverOptions options;
    UnknownVector<D> in, out;
    BodyCorrection<D> bodies;
    PetscMatrix fluid, shell;
    PetscPreconditioner multigrid;
    PetscSolver solver;
    PetscVector x, b, work_in, work_out;

    void apply_fluid_inverse(const UnknownVector<D>& r, UnknownVector<D>& z)
    {
        to_petsc(matrix.system(), r, work_in.get());
        check_petsc(PCApply(multigrid.get(), work_in.get(), work_out.get()), "PCApply");
        from_petsc(matrix.system(), work_out.get(), z);
    }

    static PetscErrorCode multiply(::Mat shell, ::Vec in, ::Vec out)
    {
        Data* self = nullptr;
        MatShellGetContext(shell, &self);
        from_petsc(self->matrix.system(), in, self->in);
        self->matrix.apply(self->in, self->out);
        to_petsc(self->matrix.system(), self->out, out);
        return 0;
    }

    static PetscErrorCode precondition(PC shell, ::Vec in, ::Vec out)
    {
        Data* self = nullptr;
        PCShellGetContext(shell, &self);
        from_petsc(self->matrix.system(), in, self->in);
        auto inverse = [self](const UnknownVector<D>& r, UnknownVector<D>& z) { self->apply_fluid_inverse(r, z); };
        inverse(self->in, self->out);
        self->bodies.correct(inverse, self->in, self->out);
        self->null_space.project(self->out);
        to_petsc(self->matrix.system(), self->out, out);
        return 0;
    }
};

template <int D>
PetscBackend<D>::PetscBackend(const CoupledOperator<D>& matrix, const NullSpace<D>& null_space, const SolverOptions& options)
    : data_(new Data{matrix,
                     null_space,
                     options,
                     zero_vector(matrix.system()),
                     zero_vector(matrix.system()),
                     BodyCorrection<D>(matrix),
                     {},
                     {},
                     {},
                     {},
                     {},
                     {},
                     {},
                     {}})
{
    Data& d = *data_;
    const CoupledSystem<D>& system = matrix.system();
    const Grid<D>& grid = *system.grid;
    const MPI_Comm comm = grid.comm().mpi();
    const Numbering<D> numbering = number_unknowns(system);
    d.fluid = assemble_fluid(system, numbering);
    check_petsc(MatCreateVecs(d.fluid.get(), d.x.out(), d.b.out()), "MatCreateVecs");
    check_petsc(VecDuplicate(d.x.get(), d.work_in.out()), "VecDuplicate");
    check_petsc(VecDuplicate(d.x.get(), d.work_out.out()), "VecDuplicate");

    PetscVector diagonal;
    check_petsc(VecDuplicate(d.x.get(), diagonal.out()), "VecDuplicate");
    check_petsc(MatGetDiagonal(d.fluid.get(), diagonal.get()), "MatGetDiagonal");
    PetscReal largest = 0;
    VecMax(diagonal.get(), nullptr, &largest);
    PetscScalar* values = nullptr;
    VecGetArray(diagonal.get(), &values);
    int i = 0;
    auto shifted = [&](int component) {
        double& value = values[i++];
        if (value <= 0)
            value = largest > 0 ? largest : 1; // a row of zeros: only bodies act on it
        else if (!system.components[component].grounded)
            value *= 1 + shift;
    };
    if (grid.comm().root())
        for (int component : system.node_component)
            shifted(component);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (system.component(c) >= 0)
            shifted(system.component(c));
    });
    VecRestoreArray(diagonal.get(), &values);
    check_petsc(MatDiagonalSet(d.fluid.get(), diagonal.get(), INSERT_VALUES), "MatDiagonalSet");

    check_petsc(PCCreate(comm, d.multigrid.out()), "PCCreate");
    check_petsc(PCSetType(d.multigrid.get(), PCHYPRE), "PCSetType");
    check_petsc(PCHYPRESetType(d.multigrid.get(), "boomeramg"), "PCHYPRESetType");
    check_petsc(PCSetOperators(d.multigrid.get(), d.fluid.get(), d.fluid.get()), "PCSetOperators");
    check_petsc(PCSetUp(d.multigrid.get()), "PCSetUp");
    if (matrix.dofs() > 0 && options.bodies != BodyMode::never)
        d.bodies.set_up([&d](const UnknownVector<D>& r, UnknownVector<D>& z) { d.apply_fluid_inverse(r, z); }, 1e9);

    check_petsc(MatCreateShell(comm, numbering.owned, numbering.owned, numbering.total, numbering.total, &d, d.shell.out()),
                "MatCreateShell");
    check_petsc(MatShellSetOperation(d.shell.get(), MATOP_MULT, reinterpret_cast<void (*)()>(Data::multiply)),
                "MatShellSetOperation");
    check_petsc(KSPCreate(comm, d.solver.out()), "KSPCreate");
    check_petsc(KSPSetOperators(d.solver.get(), d.shell.get(), d.shell.get()), "KSPSetOperators");
    check_petsc(KSPSetType(d.solver.get(), KSPCG), "KSPSetType");
    check_petsc(KSPSetNormType(d.solver.get(), KSP_NORM_UNPRECONDITIONED), "KSPSetNormType");
    check_petsc(KSPSetInitialGuessNonzero(d.solver.get(), PETSC_TRUE), "KSPSetInitialGuessNonzero");
    PC shell = nullptr;
    check_petsc(KSPGetPC(d.solver.get(), &shell), "KSPGetPC");
    check_petsc(PCSetType(shell, PCSHELL), "PCSetType");
    check_petsc(PCShellSetContext(shell, &d), "PCShellSetContext");
    check_petsc(PCShellSetApply(shell, Data::precondition), "PCShellSetApply");
}

template <int D>
PetscBackend<D>::~PetscBackend() = default;

template <int D>
SolveReport PetscBackend<D>::solve(UnknownVector<D>& x, const UnknownVector<D>& rhs, const ResidualScale& scale,
                                   double tolerance, KrylovVectors<D>& vectors)
{
    Data& d = *data_;
    const CoupledSystem<D>& system = d.matrix.system();
    const Grid<D>& grid = *system.grid;
    SolveReport report;
    compatible(system, d.null_space, rhs, vectors.r);
    const double reference = scale.reference(std::sqrt(dot(grid, vectors.r, vectors.r)));
    const double target = tolerance * reference;
    if (!std::isfinite(reference)) {
        report.residual = reference;
        report.message = "the right-hand side is not finite";
        return report;
    }
    to_petsc(system, vectors.r, d.b.get());
    double residual = 0;
    bool reached = false; // by the recursive residual
    for (int attempt = 0; attempt < 2; ++attempt) {
        compatible(system, d.null_space, x, vectors.p);
        std::swap(x, vectors.p);
        residual = true_residual(d.matrix, d.null_space, x, rhs, vectors.q, vectors.r);
        if (residual <= target || report.iterations >= d.options.max_iterations)
            break;
        to_petsc(system, x, d.x.get());
        check_petsc(KSPSetTolerances(d.solver.get(), 1e-50, 0.9 * target, 1e10, d.options.max_iterations - report.iterations),
                    "KSPSetTolerances");
        check_petsc(KSPSolve(d.solver.get(), d.b.get(), d.x.get()), "KSPSolve");
        PetscInt iterations = 0;
        KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
        KSPGetIterationNumber(d.solver.get(), &iterations);
        KSPGetConvergedReason(d.solver.get(), &reason);
        report.iterations += static_cast<int>(iterations);
        report.message = std::string("PETSc: ") + KSPConvergedReasons[reason];
        reached = reason > 0;
        from_petsc(system, d.x.get(), x);
    }
    residual = true_residual(d.matrix, d.null_space, x, rhs, vectors.q, vectors.r);
    report.residual = reference > 0 ? residual / reference : residual;
    report.converged = residual <= target || (reached && residual <= d.matrix.round_off(x));
    if (report.converged)
        report.message.clear();
    return report;
}

template class PetscBackend<2>;
template class PetscBackend<3>;

} // namespace gapflow
