// Cholesky factorisation of a symmetric positive definite matrix of small dense blocks.
#pragma once

#include <Eigen/Sparse>

#include <memory>

namespace gapflow {

/// A = P^T L L^T P with L in blocks, such as the twists of bodies that films and contacts join.
class BlockCholesky {
public:
    /// `matrix`: symmetric, both triangles, its rows a multiple of `block`: 1, 3 or 6. None where it is not positive definite.
    static std::unique_ptr<const BlockCholesky> of(const Eigen::SparseMatrix<double>& matrix, int block);

    virtual ~BlockCholesky() = default;
    /// A^-1 b.
    virtual Eigen::VectorXd solve(const Eigen::VectorXd& b) const = 0;
    /// The same of every column, several at a time: L is read once for them.
    virtual Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& b) const = 0;
};

} // namespace gapflow
