// With q_k = z_k / sqrt(z_k . r_k), orthonormal in B^-1, B A has the tridiagonal matrix
//
//     T_kk = 1 / alpha_k + beta_k / alpha_(k-1),     T_k,k+1 = -sqrt(beta_(k+1)) / alpha_k
//
// (Saad, Iterative Methods for Sparse Linear Systems, 2003, 6.7.3). Its eigenvectors y give v = sum_k y_k q_k.
#include "gapflow/solver/slow_motions.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

void SlowMotions::add(double zr, double alpha, double beta, const Eigen::VectorXd& wrench)
{
    if (beta == 0) // a new start
        clear();
    zr_.push_back(zr);
    alpha_.push_back(alpha);
    beta_.push_back(beta);
    wrench_.push_back(wrench);
}

void SlowMotions::clear()
{
    zr_.clear();
    alpha_.clear();
    beta_.clear();
    wrench_.clear();
}

Eigen::MatrixXd SlowMotions::wrenches(double least) const
{
    const int n = static_cast<int>(zr_.size());
    if (n == 0 || wrench_[0].size() == 0)
        return {};
    Eigen::VectorXd diagonal(n), beside(std::max(n - 1, 0));
    for (int k = 0; k < n; ++k) {
        diagonal[k] = 1 / alpha_[k] + (k > 0 ? beta_[k] / alpha_[k - 1] : 0.0);
        if (k + 1 < n)
            beside[k] = -std::sqrt(std::max(beta_[k + 1], 0.0)) / alpha_[k];
    }
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
    eigen.computeFromTridiagonal(diagonal, beside);
    Eigen::MatrixXd basis(wrench_[0].size(), n); // K^T q_k
    for (int k = 0; k < n; ++k) {
        basis.col(k) = wrench_[k];
        if (k > 0)
            basis.col(k) -= beta_[k] * wrench_[k - 1];
        basis.col(k) /= std::sqrt(zr_[k]);
    }
    const long count = (eigen.eigenvalues().array() > least).count();
    return basis * eigen.eigenvectors().rightCols(count).rowwise().reverse();
}

} // namespace gapflow
