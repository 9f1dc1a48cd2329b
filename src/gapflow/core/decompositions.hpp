// Decompositions of matrices, compiled once: a matrix library's templates take longer to compile than what uses them.
#pragma once

#include <Eigen/Dense>

#include <optional>

namespace gapflow {

/// a = vectors diag(values) vectors^T with orthonormal vectors; values in increasing order.
template <int N = Eigen::Dynamic>
struct SymmetricEigen {
    Eigen::Matrix<double, N, 1> values;
    Eigen::Matrix<double, N, N> vectors;
};

/// Of a symmetric matrix, whose lower triangle is read. N is 3, 6 or Eigen::Dynamic.
template <int N>
SymmetricEigen<N> symmetric_eigen(const Eigen::Matrix<double, N, N>& a);
/// The values alone. N is 2 or 3.
template <int N>
Eigen::Matrix<double, N, 1> symmetric_eigenvalues(const Eigen::Matrix<double, N, N>& a);

/// Pseudo-inverse of a symmetric positive semidefinite matrix whose rows and columns may have different units. The matrix is scaled
/// to a unit diagonal first; eigenvalues of the scaled one up to `rank_tolerance` count as 0. Rows whose diagonal is not positive
/// give 0.
Eigen::MatrixXd positive_pseudo_inverse(const Eigen::MatrixXd& a, double rank_tolerance);

/// x with a x = b, for a symmetric positive definite a; empty if it is not positive definite.
std::optional<Eigen::MatrixXd> positive_definite_solution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// x with a x = b, for a symmetric positive semidefinite a and a b that it can make.
Eigen::VectorXd semidefinite_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// F with F F^T = a, for a symmetric positive semidefinite a: a column for each of its eigenvalues above `rank_tolerance`.
Eigen::MatrixXd semidefinite_factor(const Eigen::MatrixXd& a, double rank_tolerance);

/// Singular values in decreasing order and the vectors of one side as columns.
struct SingularVectors {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};

/// Left singular vectors, as many as there are singular values.
SingularVectors left_singular_vectors(const Eigen::MatrixXd& a);
/// All right singular vectors: those beyond the singular values span what a maps to 0 anyway.
SingularVectors right_singular_vectors(const Eigen::MatrixXd& a);

/// The least-squares solution of least norm.
class LeastNormSolver {
public:
    /// Pivots below `rank_tolerance` times the largest one count as 0.
    LeastNormSolver(const Eigen::MatrixXd& a, double rank_tolerance);
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

private:
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factor_;
};

} // namespace gapflow
