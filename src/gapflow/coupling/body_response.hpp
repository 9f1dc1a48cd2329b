// Response of the bodies' twists to impulses: V = M^-1 (w + C^T lambda), with C V = s where contacts hold the bodies rigidly and
// lambda = k (s - C V) where they resist with k (method, "Contact"), else V = M^-1 w.
#pragma once

#include "gapflow/core/sparse_cholesky.hpp"

#include <Eigen/Sparse>

#include <memory>

namespace gapflow {

class BodyResponse {
public:
    BodyResponse() = default;
    /// `mass`: symmetric positive definite; `contact`: C, one row for each held contact, possibly none, possibly redundant; `resistance`: k
    /// of each row, infinite for rigid ones. Throws ComputationError where the mass is not positive definite.
    BodyResponse(const Eigen::SparseMatrix<double>& mass, const Eigen::SparseMatrix<double>& contact,
                 const Eigen::VectorXd& resistance);

    /// Whether there is one.
    bool ready() const { return factor_ != nullptr; }
    /// The same contacts, with what they share of impulses that others could take as well, on bodies of another mass.
    BodyResponse of_mass(const Eigen::SparseMatrix<double>& mass) const;

    /// Twists under impulse w with the contacts at rest. Symmetric in w. `lambda`, if given, receives the contacts' impulses.
    Eigen::VectorXd operator()(const Eigen::VectorXd& w, Eigen::VectorXd* lambda = nullptr) const;
    /// The same for every column.
    Eigen::MatrixXd of_columns(const Eigen::MatrixXd& w) const;
    /// The same with the contacts at the given speeds.
    Eigen::VectorXd operator()(const Eigen::VectorXd& w, const Eigen::VectorXd& speed, Eigen::VectorXd* lambda) const;

private:
    void factorise(const Eigen::SparseMatrix<double>& mass);

    std::shared_ptr<const SparseCholesky> factor_;       ///< of M + C^T diag(stiffness) C
    Eigen::SparseMatrix<double> contact_, contact_size_; ///< C, |C|
    Eigen::VectorXd stiffness_;
    Eigen::VectorXd rigid_; ///< 1 for rigid rows, else 0
};

} // namespace gapflow
