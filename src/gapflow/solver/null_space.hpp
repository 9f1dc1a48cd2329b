// Projection onto the complement of the null space of the coupled system (method, "The coupled system").
#pragma once

#include "gapflow/core/sparse_cholesky.hpp"
#include "gapflow/solver/coupled_operator.hpp"

namespace gapflow {

/// Projection onto the orthogonal complement of the null vectors z_j = sum_k null_space(k, j) 1_k.
template <int D>
class NullSpace {
public:
    explicit NullSpace(const CoupledSystem<D>& system);
    bool empty() const { return system_.null_space.cols() == 0; }
    /// On return v is orthogonal to all z_j and 0 in cells without unknown. Collective.
    void project(UnknownVector<D>& v) const;
    /// What project() would subtract in each component [component + 1]; entry 0 is 0. Collective unless empty.
    const Eigen::VectorXd& shifts(const UnknownVector<D>& v) const;
    /// The same for the only component, from the sum over all its unknowns.
    const Eigen::VectorXd& shifts(double sum) const;

private:
    const CoupledSystem<D>& system_;
    Eigen::SparseMatrix<double> vectors_; ///< components x null vectors
    SparseCholesky gram_;                 ///< of the z_j
    double size_ = 1;                     ///< unknowns in all components
    mutable Eigen::VectorXd sums_;
};

} // namespace gapflow
