// Decompositions (core/decompositions.hpp): what each promises, on matrices with a kernel and with rows of other units.
#include "gapflow/core/decompositions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace gapflow {
namespace {

Eigen::MatrixXd random_matrix(int rows, int columns)
{
    std::srand(7);
    return Eigen::MatrixXd::Random(rows, columns);
}

TEST(Decompositions, EigenvectorsMakeTheMatrix)
{
    const Eigen::MatrixXd a = random_matrix(6, 6);
    const Eigen::Matrix<double, 6, 6> symmetric = a + a.transpose();
    const SymmetricEigen<6> eigen = symmetric_eigen<6>(symmetric);
    EXPECT_TRUE((eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose()).isApprox(symmetric, 1e-13));
    EXPECT_TRUE(std::is_sorted(eigen.values.begin(), eigen.values.end()));
    const Eigen::Matrix3d small = symmetric.topLeftCorner<3, 3>();
    EXPECT_TRUE(symmetric_eigenvalues<3>(small).isApprox(symmetric_eigen<3>(small).values, 1e-13));
}

TEST(Decompositions, PseudoInverseDoesNotDependOnUnits)
{
    // Two springs in a row between three masses: the common shift is the kernel.
    Eigen::MatrixXd a(4, 4);
    a << 1, -1, 0, 0, -1, 3, -2, 0, 0, -2, 2, 0, 0, 0, 0, 0;
    const Eigen::MatrixXd inverse = positive_pseudo_inverse(a, 1e-10);
    EXPECT_TRUE((a * inverse * a).isApprox(a, 1e-13));
    EXPECT_TRUE(inverse.row(3).isZero(0));
    const Eigen::VectorXd unit = Eigen::Vector4d(1, 1e6, 1e-6, 1);
    const Eigen::MatrixXd other = unit.asDiagonal() * a * unit.asDiagonal();
    EXPECT_TRUE((unit.asDiagonal() * positive_pseudo_inverse(other, 1e-10) * unit.asDiagonal()).isApprox(inverse, 1e-10));
}

TEST(Decompositions, AnIndefiniteMatrixHasNoPositiveDefiniteSolution)
{
    Eigen::MatrixXd a = Eigen::Vector3d(1, 2, 3).asDiagonal();
    const Eigen::MatrixXd b = random_matrix(3, 2);
    ASSERT_TRUE(positive_definite_solution(a, b));
    EXPECT_TRUE((a * *positive_definite_solution(a, b)).isApprox(b, 1e-14));
    a(1, 1) = -2;
    EXPECT_FALSE(positive_definite_solution(a, b));
}

// What the matrix maps to 0 the factor maps to 0 by round-off, not by its root.
TEST(Decompositions, AFactorOfASemidefiniteMatrixKeepsTheKernel)
{
    const Eigen::MatrixXd basis = random_matrix(6, 4);
    const Eigen::VectorXd sizes = Eigen::Vector4d(1, 1, 1e-4, 1e-8);
    const Eigen::MatrixXd a = basis * sizes.asDiagonal() * basis.transpose();
    const Eigen::MatrixXd factor = semidefinite_factor(a, 1e-12),
                          kernel = right_singular_vectors(basis.transpose()).vectors.rightCols(2);
    ASSERT_EQ(factor.cols(), 4);
    EXPECT_TRUE((factor * factor.transpose()).isApprox(a, 1e-14));
    EXPECT_LT((factor.transpose() * kernel).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_EQ(semidefinite_factor(Eigen::MatrixXd::Zero(3, 3), 1e-12).cols(), 0);
}

TEST(Decompositions, RightSingularVectorsSpanTheKernel)
{
    const Eigen::MatrixXd a = random_matrix(2, 5);
    const SingularVectors right = right_singular_vectors(a);
    ASSERT_EQ(right.values.size(), 2);
    ASSERT_EQ(right.vectors.cols(), 5);
    EXPECT_LT((a * right.vectors.rightCols(3)).norm(), 1e-14);
    const SingularVectors left = left_singular_vectors(a.transpose());
    ASSERT_EQ(left.vectors.cols(), 2);
    EXPECT_TRUE((left.vectors * left.vectors.transpose() * a.transpose()).isApprox(a.transpose(), 1e-13));
}

TEST(Decompositions, LeastNormSharesBetweenEqualUnknowns)
{
    Eigen::MatrixXd a(2, 2);
    a << 1, 1, 1, 1;
    EXPECT_TRUE(LeastNormSolver(a, 1e-10).solve(Eigen::Vector2d(2, 2)).isApprox(Eigen::Vector2d(1, 1), 1e-14));
    EXPECT_EQ(LeastNormSolver(Eigen::MatrixXd(0, 0), 1e-10).solve(Eigen::VectorXd(0)).size(), 0);
}

} // namespace
} // namespace gapflow
