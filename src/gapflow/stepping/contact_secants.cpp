#include "gapflow/stepping/contact_secants.hpp"

#include "gapflow/core/decompositions.hpp"

#include <algorithm>

namespace gapflow {

namespace {

// Least energy s.y of what the pairs tell, over the largest: solves are right to 1e-9 of the speeds, and contacts that settle change them by 1e-3 and less.
constexpr double told_by_round_off = 1e-10;

} // namespace

void SecantMemory::add(const Eigen::VectorXd& twists, const Eigen::VectorXd& impulses)
{
    if (last_twists_.size() > 0) {
        const Eigen::VectorXd moved = twists - last_twists_, pushed = impulses - last_impulses_;
        if (moved.dot(pushed) > 0) {
            const long k = secants_.twists.cols();
            secants_.twists.conservativeResize(twists.size(), k + 1);
            secants_.impulses.conservativeResize(twists.size(), k + 1);
            secants_.twists.col(k) = moved;
            secants_.impulses.col(k) = pushed;
        }
    }
    last_twists_ = twists;
    last_impulses_ = impulses;
}

std::optional<LowRankChange> secant_change(const Eigen::SparseMatrix<double>& A, const Eigen::MatrixXd& S,
                                           const Eigen::MatrixXd& Y)
{
    if (S.cols() == 0)
        return {};
    const Eigen::MatrixXd products = S.transpose() * Y;
    const SymmetricEigen<> eigen = symmetric_eigen<Eigen::Dynamic>(0.5 * (products + products.transpose()));
    const double largest = eigen.values[eigen.values.size() - 1];
    const long kept = (eigen.values.array() > told_by_round_off * std::max(largest, 0.0)).count();
    if (kept == 0)
        return {};
    // Combinations of the pairs with S^T Y = 1.
    const Eigen::MatrixXd turn =
        eigen.vectors.rightCols(kept) * eigen.values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
    const Eigen::MatrixXd turned = S * turn, AS = A * turned, own = turned.transpose() * AS;
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(kept, kept);
    const std::optional<Eigen::MatrixXd> inverse = positive_definite_solution(0.5 * (own + own.transpose()), one);
    if (!inverse)
        return {};
    LowRankChange change{Eigen::MatrixXd(A.rows(), 2 * kept), Eigen::MatrixXd::Zero(2 * kept, 2 * kept),
                         Eigen::MatrixXd::Zero(2 * kept, 2 * kept)};
    change.vectors << AS, Y * turn;
    change.weights.topLeftCorner(kept, kept) = -0.5 * (*inverse + inverse->transpose());
    change.inverse_weights.topLeftCorner(kept, kept) = -0.5 * (own + own.transpose());
    change.weights.bottomRightCorner(kept, kept) = one;
    change.inverse_weights.bottomRightCorner(kept, kept) = one;
    return change;
}

} // namespace gapflow
