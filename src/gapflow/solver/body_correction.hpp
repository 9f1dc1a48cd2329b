// The bodies' part of the preconditioner: a capacitance (Woodbury) correction.
#pragma once

#include "gapflow/solver/coupled_operator.hpp"

#include <Eigen/Dense>

#include <functional>
#include <vector>

namespace gapflow {

/// Turns B ~ L^-1 into (B^-1 + K C K^T)^-1, C = M_c^-1: the bodies' response with the contacts held; with some motions U alone,
/// U^T M U = 1, into (B^-1 + K U C U^T K^T)^-1, C = U^T M M_c^-1 M U.
template <int D>
class BodyCorrection {
public:
    /// z = B r. Collective.
    using Inverse = std::function<void(const UnknownVector<D>& r, UnknownVector<D>& z)>;

    explicit BodyCorrection(const CoupledOperator<D>& matrix) : matrix_(matrix) {}

    /// Estimates the bodies' influence: the largest ratio of the bulk's added mass to own mass among them in one (mixed)
    /// direction.
    /// One application of B. Collective.
    double lightness(const Inverse& inverse) const;
    /// Computes the columns, dofs applications of B. They are kept if they need no more than `bytes_per_cell`. False, and
    /// nothing changed, if round-off outweighs the mass of very light bodies. Collective.
    /// `banded`: this rank's cells in which the films' band acts.
    bool set_up(const Inverse& inverse, double bytes_per_cell, std::vector<Index<D>> banded = {});
    bool ready() const { return ready_; }
    /// Corrects for motions of the bodies (columns) in place of all, besides those of earlier calls, one application of B each, as long as
    /// there are no more columns than `bytes_per_cell` allow: the first ones. Collective.
    void add_motions(const Inverse& inverse, double bytes_per_cell, const Eigen::MatrixXd& motions,
                     std::vector<Index<D>> banded);
    /// Whether it corrects for some motions alone.
    bool in_part() const { return motions_.cols() > 0; }
    /// Takes the system's masses and contacts anew.
    void update();

    /// z, on entry B r, becomes the corrected result. Collective.
    void correct(const Inverse& inverse, const UnknownVector<D>& r, UnknownVector<D>& z) const;
    long bytes() const;

private:
    struct Column {
        std::vector<float> cells;
        /// Where single precision would break the balance between film and cells: the rounding error of B K in double.
        std::vector<double> remainder;
        Eigen::VectorXd nodes;
    };
    void find_exact_cells(std::vector<Index<D>> banded);
    void keep_column(const UnknownVector<D>& z);

    const CoupledOperator<D>& matrix_;
    bool ready_ = false, kept_ = false;
    Eigen::MatrixXd motions_; ///< U; none: all
    std::vector<Column> columns_;
    std::vector<Index<D>>
        exact_cells_;       ///< of links and the films' band, on this rank: their entries of the columns are doubles
    Eigen::MatrixXd added_; ///< K^T B K, or U^T K^T B K U
    Eigen::MatrixXd half_;  ///< F with C = F F^T
    Eigen::LLT<Eigen::MatrixXd> capacitance_; ///< 1 + F^T added F
};

} // namespace gapflow
