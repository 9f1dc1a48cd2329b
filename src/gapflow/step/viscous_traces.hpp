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

    /// `form_of`: the form's columns of the unknowns: edges, traces and free twists. `resistance`: diagonal of the system, of the traces.
    ViscousTraces(const ViscousColumns<D>& columns, const Rows& form_of, const Vector& resistance);

    /// Adds to edges and twists what the residual of the traces is for them, and takes it out again.
    Vector pull(Vector& residual) const;
    void release(const Vector& pulled, Vector& residual) const;
    /// The traces that follow the other unknowns, and what their own residual asks for.
    void follow(const Vector& residual, Vector& z) const;

private:
    void find_means(const Rows& form_of);
    void find_elements();

    const ViscousColumns<D>& columns_;
    int first_;
    RowList means_;           ///< of each trace, in unknowns
    std::vector<int> pulled_; ///< unknowns that it has
    RowList pull_;            ///< of each of these: transposed
    Vector scale_;            ///< 1 over the root of the resistance and of the number of faces
    Vector alone_;            ///< of traces: whether no face has them
    /// Of faces with elements of their own, one after the other: their traces, and the inverse of what the element resists with over the roots of the whole
    /// resistance.
    std::vector<std::int64_t> end_{0}, entry_{0};
    std::vector<std::int32_t> trace_;
    std::vector<double> inverse_;
};

} // namespace gapflow
