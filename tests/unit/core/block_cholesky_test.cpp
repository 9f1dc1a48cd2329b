// The factor by blocks against dense solutions.
#include "gapflow/core/block_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <random>

namespace gapflow::test {
namespace {

// Bodies in a ring, each joined to the next and some to one across; positive definite.
Eigen::SparseMatrix<double> joined(int bodies, int block, double least)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const int n = bodies * block;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    const auto join = [&](int a, int b) {
        Eigen::MatrixXd row = Eigen::MatrixXd::Zero(2, n);
        for (int i = 0; i < block; ++i)
            for (int k = 0; k < 2; ++k) {
                row(k, a * block + i) = uniform(random);
                row(k, b * block + i) = uniform(random);
            }
        matrix += row.transpose() * row;
    };
    for (int body = 0; body < bodies; ++body) {
        join(body, (body + 1) % bodies);
        if (body % 3 == 0)
            join(body, (7 * body + 5) % bodies);
    }
    matrix += least * Eigen::MatrixXd::Identity(n, n);
    return matrix.sparseView();
}

TEST(BlockCholesky, SolvesWhatTheDenseFactorSolves)
{
    for (int block : {1, 3, 6})
        for (int bodies : {1, 2, 40}) {
            const Eigen::SparseMatrix<double> matrix = joined(bodies, block, 0.1);
            const auto factor = BlockCholesky::of(matrix, block);
            ASSERT_TRUE(factor);
            const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(matrix.rows(), -1, 2);
            const Eigen::VectorXd expected = Eigen::MatrixXd(matrix).llt().solve(b), found = factor->solve(b);
            EXPECT_LT((found - expected).norm(), 1e-12 * expected.norm()) << block << ' ' << bodies;
            for (int columns : {3, 8, 19}) {
                const Eigen::VectorXd scale = Eigen::VectorXd::LinSpaced(columns, 1, 3);
                const Eigen::MatrixXd difference = factor->solve_columns(b * scale.transpose()) - expected * scale.transpose();
                EXPECT_LT(difference.norm(), 1e-12 * expected.norm() * scale.norm())
                    << block << ' ' << bodies << ' ' << columns;
            }
        }
}

TEST(BlockCholesky, TellsWhatIsNotPositive)
{
    for (int block : {1, 3, 6}) {
        EXPECT_FALSE(BlockCholesky::of(joined(40, block, -0.5), block));
        Eigen::SparseMatrix<double> none(2 * block, 2 * block); // zeros
        EXPECT_FALSE(BlockCholesky::of(none, block));
    }
    EXPECT_THROW(BlockCholesky::of(joined(5, 1, 1), 3), std::logic_error);
}

} // namespace
} // namespace gapflow::test
