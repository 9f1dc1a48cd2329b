// Preconditioned conjugate gradients for the coupled system.
#pragma once

#include "gapflow/solver/null_space.hpp"
#include "gapflow/solver/preconditioner.hpp"
#include "gapflow/solver/slow_motions.hpp"
#include "gapflow/solver/solver.hpp"

#include <algorithm>
#include <optional>

namespace gapflow {

/// Storage with the lifetime of the solver: nothing is allocated while iterating.
template <int D>
struct KrylovVectors {
    UnknownVector<D> r, z, p, q;
};

/// What a residual is relative to: the norm of the right-hand side, or `norm` in its place, but at least `least`.
struct ResidualScale {
    double least = 0;
    std::optional<double> norm = {};
    double reference(double of_rhs) const { return std::max(norm.value_or(of_rhs), least); }
};

/// On return A p = rhs as CoupledSolver::solve says, and `motions` has followed the iterations. Collective.
template <int D>
SolveReport conjugate_gradients(const CoupledOperator<D>& matrix, Preconditioner<D>& preconditioner,
                                const NullSpace<D>& null_space, KrylovVectors<D>& vectors, UnknownVector<D>& x,
                                const UnknownVector<D>& rhs, const SolverOptions& options, const ResidualScale& scale,
                                SlowMotions& motions);

/// v = rhs with 0 in cells without unknown and without its part along the null vectors.
template <int D>
void compatible(const CoupledSystem<D>& system, const NullSpace<D>& null_space, const UnknownVector<D>& rhs,
                UnknownVector<D>& v);

/// r = rhs - A x in all unknowns; returns the norm of its part orthogonal to the null vectors.
template <int D>
double true_residual(const CoupledOperator<D>& matrix, const NullSpace<D>& null_space, UnknownVector<D>& x,
                     const UnknownVector<D>& rhs, UnknownVector<D>& q, UnknownVector<D>& r);

} // namespace gapflow
