#include "gapflow/core/decompositions.hpp"

#include <cmath>

namespace gapflow {

template <int N>
SymmetricEigen<N> symmetric_eigen(const Eigen::Matrix<double, N, N>& a)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> eigen(a);
    return {eigen.eigenvalues(), eigen.eigenvectors()};
}

template <int N>
Eigen::Matrix<double, N, 1> symmetric_eigenvalues(const Eigen::Matrix<double, N, N>& a)
{
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::MatrixXd positive_pseudo_inverse(const Eigen::MatrixXd& a, double rank_tolerance)
{
    const Eigen::VectorXd scaling = a.diagonal().unaryExpr([](double v) { return v > 0 ? 1 / std::sqrt(v) : 0.0; });
    const SymmetricEigen<> eigen = symmetric_eigen<Eigen::Dynamic>(scaling.asDiagonal() * a * scaling.asDiagonal());
    const Eigen::VectorXd inverse = eigen.values.unaryExpr([&](double v) { return v > rank_tolerance ? 1 / v : 0.0; });
    const Eigen::MatrixXd vectors = scaling.asDiagonal() * eigen.vectors;
    return vectors * inverse.asDiagonal() * vectors.transpose();
}

std::optional<Eigen::MatrixXd> positive_definite_solution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    const Eigen::LLT<Eigen::MatrixXd> factor(a);
    if (factor.info() != Eigen::Success)
        return std::nullopt;
    return factor.solve(b);
}

Eigen::VectorXd semidefinite_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b)
{
    return a.ldlt().solve(b);
}

Eigen::MatrixXd semidefinite_factor(const Eigen::MatrixXd& a, double rank_tolerance)
{
    const SymmetricEigen<> eigen = symmetric_eigen<Eigen::Dynamic>(a);
    const long rank = (eigen.values.array() > rank_tolerance).count();
    return eigen.vectors.rightCols(rank) * eigen.values.tail(rank).cwiseSqrt().asDiagonal();
}

SingularVectors left_singular_vectors(const Eigen::MatrixXd& a)
{
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeThinU);
    return {svd.singularValues(), svd.matrixU()};
}

SingularVectors right_singular_vectors(const Eigen::MatrixXd& a)
{
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeFullV);
    return {svd.singularValues(), svd.matrixV()};
}

LeastNormSolver::LeastNormSolver(const Eigen::MatrixXd& a, double rank_tolerance)
{
    factor_.setThreshold(rank_tolerance);
    if (a.size() > 0)
        factor_.compute(a);
}

Eigen::VectorXd LeastNormSolver::solve(const Eigen::VectorXd& b) const
{
    return b.size() > 0 ? Eigen::VectorXd(factor_.solve(b)) : b;
}

template Eigen::Vector2d symmetric_eigenvalues<2>(const Eigen::Matrix2d&);
template Eigen::Vector3d symmetric_eigenvalues<3>(const Eigen::Matrix3d&);
template SymmetricEigen<3> symmetric_eigen<3>(const Eigen::Matrix3d&);
template SymmetricEigen<6> symmetric_eigen<6>(const Eigen::Matrix<double, 6, 6>&);
template SymmetricEigen<> symmetric_eigen<Eigen::Dynamic>(const Eigen::MatrixXd&);

} // namespace gapflow
