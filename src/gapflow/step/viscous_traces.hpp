// The traces of the viscous form in the preconditioner of its solve. Beside the means of the faces around them, which they follow, each has a change of its own:
// found face by face.
#pragma once

#include "gapflow/step/viscous_columns.hpp"

namespace gapflow {

template <int D>
class ViscousTraces {
public:
    using Vector = Eigen::VectorXd;
    using Rows = typename ViscousColumns<D>::Rows;

    /// `free`: columns of the unknowns: edges, traces and free twists. `resistance`: diagonal of the system, of the traces.
    ViscousTraces(const ViscousColumns<D>& columns, const Eigen::SparseMatrix<double>& free, const Vector& resistance);

    /// Adds what a residual of the traces is for edges and twists.
    void pull(const Vector& residual, Vector& whole) const
    {
        whole.noalias() += pulled_ * residual.segment(first_, scale_.size());
    }
    /// The traces that follow the other unknowns, and what their own residual asks for.
    void follow(const Vector& residual, Vector& z) const;

private:
    void find_elements();

    const ViscousColumns<D>& columns_;
    int first_;
    Rows means_;   ///< traces x unknowns
    Rows pulled_;  ///< transposed
    Vector scale_; ///< 1 over the root of the resistance and of the number of faces
    Vector alone_; ///< of traces: whether no face has them
    /// Of faces with elements of their own: their traces, and the inverse of what the element resists with over the roots of the whole resistance.
    struct Element {
        std::vector<std::int32_t> traces;
        Eigen::MatrixXd inverse;
    };
    std::vector<Element> elements_;
};

} // namespace gapflow
