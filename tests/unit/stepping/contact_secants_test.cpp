// What solves tell of the bodies' inertia (contact_secants), and what the laws of contact make of it.
#include "gapflow/core/decompositions.hpp"
#include "gapflow/stepping/contact_secants.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace gapflow {
namespace {

Eigen::MatrixXd dense(const Eigen::SparseMatrix<double>& A, const LowRankChange& change)
{
    return Eigen::MatrixXd(A) + change.vectors * change.weights * change.vectors.transpose();
}

// A matrix that couples all bodies, as the bulk does, and one that has the bodies alone.
struct Inertias {
    Eigen::MatrixXd exact;
    Eigen::SparseMatrix<double> near;
    explicit Inertias(int n)
    {
        std::srand(3);
        const Eigen::MatrixXd G = Eigen::MatrixXd::Random(n, n);
        exact = G * G.transpose() + Eigen::MatrixXd::Identity(n, n);
        near = Eigen::MatrixXd(exact.diagonal().asDiagonal()).sparseView();
    }
};

TEST(ContactSecants, TheChangedInertiaGivesThem)
{
    constexpr int n = 12;
    const Inertias inertias(n);
    const Eigen::MatrixXd S = Eigen::MatrixXd::Random(n, 4), Y = inertias.exact * S;
    const std::optional<LowRankChange> change = secant_change(inertias.near, S, Y);
    ASSERT_TRUE(change);
    const Eigen::MatrixXd changed = dense(inertias.near, *change);
    EXPECT_TRUE((changed * S).isApprox(Y, 1e-12));
    EXPECT_TRUE(changed.isApprox(changed.transpose(), 1e-14));
    EXPECT_GT(symmetric_eigen<Eigen::Dynamic>(changed).values[0], 0);
    EXPECT_TRUE((change->weights * change->inverse_weights).isApprox(Eigen::MatrixXd::Identity(8, 8), 1e-12));
    const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(n, n);
    EXPECT_TRUE(dense(inertias.near, *secant_change(inertias.near, all, inertias.exact)).isApprox(inertias.exact, 1e-12));
}

// A pair told twice, and one that is as small as the solves' errors, change nothing.
TEST(ContactSecants, RoundOffTellsNothing)
{
    constexpr int n = 8;
    const Inertias inertias(n);
    Eigen::MatrixXd S(n, 3), Y(n, 3);
    S.col(0) = Eigen::VectorXd::Random(n);
    Y.col(0) = inertias.exact * S.col(0);
    S.col(1) = 2 * S.col(0);
    Y.col(1) = 2 * Y.col(0);
    S.col(2) = 1e-7 * Eigen::VectorXd::Random(n);
    Y.col(2) = 100 * inertias.exact * S.col(2);
    const std::optional<LowRankChange> change = secant_change(inertias.near, S, Y);
    ASSERT_TRUE(change);
    EXPECT_EQ(change->vectors.cols(), 2);
    EXPECT_TRUE((dense(inertias.near, *change) * S.col(0)).isApprox(Y.col(0), 1e-5));
    EXPECT_FALSE(secant_change(inertias.near, S.leftCols(1), -Y.leftCols(1)));
    EXPECT_FALSE(secant_change(inertias.near, Eigen::MatrixXd(n, 0), Eigen::MatrixXd(n, 0)));
}

TEST(ContactSecants, PairsOfOneFluidAlone)
{
    SecantMemory memory;
    const Eigen::Vector3d twist(1, 2, 3), impulse(4, 5, 6), other(1, 1, 1);
    memory.add(twist, impulse);
    EXPECT_TRUE(memory.secants().empty());
    memory.add(twist + other, impulse + 2 * other);
    ASSERT_EQ(memory.secants().twists.cols(), 1);
    EXPECT_TRUE(memory.secants().twists.col(0).isApprox(other, 1e-14));
    EXPECT_TRUE(memory.secants().impulses.col(0).isApprox(2 * other, 1e-14));
    memory.add(twist, impulse + 3 * other); // a push that moves backwards
    EXPECT_EQ(memory.secants().twists.cols(), 1);
    memory.forget();
    memory.add(twist, impulse);
    EXPECT_TRUE(memory.secants().empty());
}

} // namespace
} // namespace gapflow
