// The library cross-check: PETSc's conjugate gradients with hypre's BoomerAMG on the assembled fluid matrix.
#pragma once

#include "gapflow/solver/assemble.hpp"
#include "gapflow/solver/body_correction.hpp"
#include "gapflow/solver/conjugate_gradients.hpp"

#include <memory>

namespace gapflow {

template <int D>
class PetscBackend {
public:
    /// Keeps references to both. Collective.
    PetscBackend(const CoupledOperator<D>& matrix, const NullSpace<D>& null_space, const SolverOptions& options);
    ~PetscBackend();

    /// As CoupledSolver::solve.
    SolveReport solve(UnknownVector<D>& x, const UnknownVector<D>& rhs, const ResidualScale& scale, double tolerance,
                      KrylovVectors<D>& vectors);

private:
    struct Data; ///< stays in place: PETSc's shells point to it
    std::unique_ptr<Data> data_;
};

} // namespace gapflow
