// What solves with different contacts tell of the bodies' inertia in the fluid (method, "Contact"): twists that differ by s where the contacts' impulses
// differ by y have y = A s, with all that the forecast's A misses of the bulk.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <optional>

namespace gapflow {

/// S and Y: a column for each pair of solves, rows for the twists of all solids.
struct ContactSecants {
    Eigen::MatrixXd twists, impulses;

    bool empty() const { return twists.cols() == 0; }
};

/// The pairs of a step's solves.
class SecantMemory {
public:
    /// Another solve of the same fluid: twists of all solids, and the impulses of the contacts on them. (Solids that do not yield move alike in all
    /// solves.)
    void add(const Eigen::VectorXd& twists, const Eigen::VectorXd& impulses);
    void forget() { *this = {}; }
    const ContactSecants& secants() const { return secants_; }

private:
    ContactSecants secants_;
    Eigen::VectorXd last_twists_, last_impulses_; ///< empty: none
};

/// U W U^T, W symmetric.
struct LowRankChange {
    Eigen::MatrixXd vectors, weights, inverse_weights;
};

/// The change of A that makes (A + U W U^T) S = Y: BFGS for several pairs at once (R. B. Schnabel, "Quasi-Newton methods using multiple secant equations", 1983),
///
///     -A S (S^T A S)^-1 S^T A + Y (S^T Y)^-1 Y^T.
///
/// Positive definite as A is. What the pairs tell twice, or by round-off, counts once. Nothing where they tell of no positive inertia.
std::optional<LowRankChange> secant_change(const Eigen::SparseMatrix<double>& A, const Eigen::MatrixXd& S,
                                           const Eigen::MatrixXd& Y);

} // namespace gapflow
