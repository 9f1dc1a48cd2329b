// The motions of the bodies that slow conjugate gradients down.
#pragma once

#include <Eigen/Dense>

#include <vector>

namespace gapflow {

/// Follows the iterations of one solve, and finds the bodies' motions that belong to the largest eigenvalues of the preconditioned matrix: the
/// body's part of them, K M^-1 K^T, is not in the preconditioner, and is as large as the fluid that a light body moves in its films. (Ritz
/// vectors of the Lanczos process that conjugate gradients are.)
class SlowMotions {
public:
    /// An iteration: z . r with z the preconditioned residual, the step alpha along p = z + beta (the last p), and K^T p.
    void add(double zr, double alpha, double beta, const Eigen::VectorXd& wrench);
    void clear();
    /// K^T v of the eigenvectors v, |v| = 1 in the preconditioner's inverse, whose eigenvalues are larger than `least`: columns, the largest first.
    Eigen::MatrixXd wrenches(double least) const;

private:
    std::vector<double> zr_, alpha_, beta_;
    std::vector<Eigen::VectorXd> wrench_;
};

} // namespace gapflow
