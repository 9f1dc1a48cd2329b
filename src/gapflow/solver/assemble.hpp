// Assembled forms of the coupled system: dense for tests, PETSc for the library backend.
#pragma once

#include "gapflow/coupling/system.hpp"
#include "gapflow/solver/petsc_handle.hpp"

#include <Eigen/Dense>

namespace gapflow {

/// Numbering of the unknowns in the whole system: film nodes 0 .. nodes-1 (on rank 0), then cells, rank by rank.
template <int D>
struct Numbering {
    CellField<D, int> cell; ///< of each owned cell and the ghosts beside it, -1: no unknown
    int owned = 0;          ///< unknowns of this rank
    int first = 0;          ///< the first of them
    int first_cell = 0;     ///< the first that is a cell
    int total = 0;
};

/// Collective.
template <int D>
Numbering<D> number_unknowns(const CoupledSystem<D>& system);

/// L + K M^-1 K^T as a dense matrix in the numbering of number_unknowns; one rank only.
template <int D>
Eigen::MatrixXd assemble_dense(const CoupledSystem<D>& system);

/// L alone as a distributed sparse matrix, every diagonal entry present. Collective.
template <int D>
PetscMatrix assemble_fluid(const CoupledSystem<D>& system, const Numbering<D>& numbering);

} // namespace gapflow
