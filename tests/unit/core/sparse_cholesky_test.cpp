// SparseCholesky (core/sparse_cholesky.hpp) in one piece, and cut into subtrees.
#include "gapflow/core/sparse_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <cmath>
#ifdef _OPENMP
#include <omp.h>
#endif

namespace gapflow {
namespace {

// Lower triangle of the five-point Laplacian on n x n places, plus `ground` on the diagonal, in an order that jumps.
Eigen::SparseMatrix<double> laplacian(int n, double ground)
{
    const auto row = [n](int i, int j) { return static_cast<int>((static_cast<long>(i * n + j) * 7919) % (n * n)); };
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            entries.emplace_back(row(i, j), row(i, j), 4 + ground);
            for (const auto& [k, l] : {std::pair(i + 1, j), std::pair(i, j + 1)})
                if (k < n && l < n)
                    entries.emplace_back(std::max(row(i, j), row(k, l)), std::min(row(i, j), row(k, l)), -1.0);
        }
    Eigen::SparseMatrix<double> a(n * n, n * n);
    a.setFromTriplets(entries.begin(), entries.end());
    return a;
}

// The same of the seven-point Laplacian on n x n x n places, nearly; in their own order.
Eigen::SparseMatrix<double> cells(int n)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < n * n * n; ++row) {
        entries.emplace_back(row, row, 6.1);
        for (const auto& [stride, place] : {std::pair(1, row % n), std::pair(n, row / n % n), std::pair(n * n, row / (n * n))})
            if (place + 1 < n)
                entries.emplace_back(row + stride, row, -1.0);
    }
    Eigen::SparseMatrix<double> a(n * n * n, n * n * n);
    a.setFromTriplets(entries.begin(), entries.end());
    return a;
}

Eigen::VectorXd waves(long n)
{
    return Eigen::VectorXd::NullaryExpr(n, [](long i) { return std::sin(1 + 0.37 * static_cast<double>(i * i % 1009)); });
}

TEST(SparseCholesky, IsUsedAgainForOtherEntries)
{
    for (int n : {1, 12, 170}) { // 170: large enough to be cut
        SparseCholesky factor;
        factor.analyse(laplacian(n, 0.1));
        const Eigen::VectorXd b = waves(n * n);
        for (double ground : {0.1, 1e-6, 3.0}) {
            const Eigen::SparseMatrix<double> a = laplacian(n, ground);
            ASSERT_TRUE(factor.factorise(a));
            const Eigen::VectorXd x = factor.solve(b);
            EXPECT_LT((a.selfadjointView<Eigen::Lower>() * x - b).norm(), 1e-12 * b.norm()) << n << " " << ground;
            EXPECT_LT((factor.solve_columns(b) - x).norm(), 1e-12 * x.norm()) << n << " " << ground;
        }
    }
}

TEST(SparseCholesky, PiecesFollowEachOther) // two Laplacians side by side: two trees, each with its own top
{
    const Eigen::SparseMatrix<double> one = laplacian(130, 0.1);
    const long n = one.rows();
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < n; ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(one, column); entry; ++entry)
            for (long shift : {0L, n})
                entries.emplace_back(static_cast<int>(entry.row() + shift), static_cast<int>(column + shift), entry.value());
    Eigen::SparseMatrix<double> two(2 * n, 2 * n);
    two.setFromTriplets(entries.begin(), entries.end());
    SparseCholesky factor;
    ASSERT_TRUE(factor.compute(two));
    const Eigen::VectorXd b = waves(2 * n);
    EXPECT_LT((two.selfadjointView<Eigen::Lower>() * factor.solve(b) - b).norm(), 1e-12 * b.norm());
}

// Dense blocks, as condensed films leave them: panels of many columns. Every third row stands alone.
TEST(SparseCholesky, DenseBlocks)
{
    constexpr int block = 9;
    for (int blocks : {1, 40, 2400}) { // 2400: large enough to be cut
        const int n = 3 * block * blocks / 2 + 1;
        std::vector<Eigen::Triplet<double>> entries;
        const auto row = [](int i) { return i / 2 * 3 + i % 2; };
        for (int i = 0; i < n; ++i)
            entries.emplace_back(i, i, 4.0 * block);
        for (int k = 0; k < blocks; ++k)
            for (int i = 0; i < block; ++i) {
                for (int j = 0; j < i; ++j)
                    entries.emplace_back(row(block * k + i), row(block * k + j), -1 - 0.5 * std::sin(i + 3 * j + k));
                if (k > 0 && i < 3) // to the block before, and to one far away
                    entries.emplace_back(row(block * k + i), row(block * (i == 2 ? k / 2 : k - 1) + i), -1.5);
            }
        Eigen::SparseMatrix<double> a(n, n);
        a.setFromTriplets(entries.begin(), entries.end());
        SparseCholesky factor;
        ASSERT_TRUE(factor.compute(a));
        const Eigen::VectorXd b = waves(n), x = factor.solve(b);
        EXPECT_LT((a.selfadjointView<Eigen::Lower>() * x - b).norm(), 1e-13 * b.norm()) << blocks;
        EXPECT_LT((factor.solve_columns(b) - x).norm(), 1e-13 * x.norm()) << blocks;
    }
}

// Twists of bodies that films and contacts join: blocks of six in a ring, and some to one across. Both triangles, of which the lower one is read.
TEST(SparseCholesky, ManyRightSidesOfBodies)
{
    constexpr int block = 6;
    for (int bodies : {1, 2, 40}) {
        const int n = block * bodies;
        Eigen::MatrixXd dense = 0.1 * Eigen::MatrixXd::Identity(n, n);
        const auto join = [&](int a, int b) {
            Eigen::MatrixXd row = Eigen::MatrixXd::Zero(n, 2);
            row.middleRows(block * a, block) = waves(2 * block).reshaped(block, 2) * (1 + a % 3);
            row.middleRows(block * b, block) += waves(2 * block + 5).tail(2 * block).reshaped(block, 2);
            dense += row * row.transpose();
        };
        for (int body = 0; body < bodies; ++body) {
            join(body, (body + 1) % bodies);
            if (body % 3 == 0)
                join(body, (7 * body + 5) % bodies);
        }
        SparseCholesky factor;
        ASSERT_TRUE(factor.compute(dense.sparseView()));
        for (int columns : {1, 3, 8, 19}) {
            const Eigen::MatrixXd b = waves(n) * Eigen::RowVectorXd::LinSpaced(columns, 1, 3), x = dense.llt().solve(b);
            EXPECT_LT((factor.solve_columns(b) - x).norm(), 1e-11 * x.norm()) << bodies << ' ' << columns;
            EXPECT_LT((factor.solve(b.col(0)) - x.col(0)).norm(), 1e-11 * x.norm()) << bodies;
        }
    }
}

TEST(SparseCholesky, IndefiniteMatrixIsRefused)
{
    SparseCholesky factor;
    for (int n : {12, 170}) {
        factor.analyse(laplacian(n, 0.0));
        EXPECT_FALSE(factor.factorise(laplacian(n, -1.0)));
    }
    EXPECT_FALSE(factor.compute(Eigen::SparseMatrix<double>(12, 12))); // zeros
}

TEST(SparseCholesky, ThreadsGiveTheSameBits)
{
#ifdef _OPENMP
    const int threads = omp_get_max_threads();
    const Eigen::SparseMatrix<double> block = cells(28),
                                      plane = laplacian(170, 0.1); // a top of one wide panel, and of narrow ones
    for (const Eigen::SparseMatrix<double>* a : {&block, &plane}) {
        const Eigen::VectorXd b = waves(a->cols());
        SparseCholesky factor;
        omp_set_num_threads(1);
        ASSERT_TRUE(factor.compute(*a));
        const Eigen::VectorXd x = factor.solve(b);
        for (int count : {2, 3}) {
            omp_set_num_threads(count);
            ASSERT_TRUE(factor.factorise(*a));
            EXPECT_EQ(factor.solve(b), x) << count;
        }
    }
    omp_set_num_threads(threads);
#else
    GTEST_SKIP() << "without OpenMP";
#endif
}

TEST(SparseCholesky, EntriesAreThoseBelowTheDiagonal)
{
    SparseCholesky factor;
    ASSERT_TRUE(factor.compute(laplacian(2, 0.1)));
    EXPECT_EQ(factor.entries(), 5); // a ring of four places fills in one entry
}

TEST(SparseCholesky, ABlockOfCellsIsDissected) // where minimum degree makes half as many entries more
{
    const Eigen::SparseMatrix<double> a = cells(28);
    SparseCholesky factor;
    ASSERT_TRUE(factor.compute(a));
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> minimum_degree(a);
    const auto by_minimum_degree = static_cast<double>(minimum_degree.matrixL().nestedExpression().nonZeros());
    EXPECT_LT(static_cast<double>(factor.entries()), 0.8 * by_minimum_degree);
    const Eigen::VectorXd b = waves(a.cols()), x = factor.solve(b);
    EXPECT_LT((a.selfadjointView<Eigen::Lower>() * x - b).norm(), 1e-12 * b.norm());
}

} // namespace
} // namespace gapflow
