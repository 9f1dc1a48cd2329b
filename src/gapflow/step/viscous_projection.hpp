// Velocities without outflow, for the viscous solve: of a residual r the least of 1/2 z . G z - r . z among z with D q + K V = 0. G is the diagonal of the
// system for edges, and the bodies' own block; traces follow. The multipliers are pressures of a coupled system with the conductances that this leaves.
#pragma once

#include "gapflow/core/sparse_cholesky.hpp"
#include "gapflow/solver/solver.hpp"
#include "gapflow/step/viscous_traces.hpp"

#include <memory>

namespace gapflow {

template <int D>
class ViscousProjection {
public:
    using Vector = Eigen::VectorXd;

    /// `given`: rows whose pressure is, and not their outflow. `diagonal`: of edges and traces; `bodies`: the block of the free bodies' admissible twists; `form_of`: the form's columns of the unknowns.
    /// `tolerance`: of the outflow that projections leave, over the largest that a residual has had.
    ViscousProjection(const Placed<D>& at, const ViscousColumns<D>& columns, const typename ViscousColumns<D>::Rows& form_of,
                      const Vector& diagonal, const Eigen::SparseMatrix<double>& bodies, double tolerance,
                      const std::vector<int>& given = {});

    /// The largest outflow that projections of changes of a flow are to leave, over the tolerance: a share of its fluxes' size.
    double size_of(const Vector& flow) const;
    /// z, and takes the pressure's part out of the residual of edges, traces and free twists. Returns the pressure. `largest`: outflow of the residuals so far or
    /// the size of the flow, of which the projection's is a part.
    Vector project(Vector& residual, Vector& z, double& largest) const;

    /// The least z, as G has it, with an outflow.
    Vector with_outflow(const Vector& outflow) const;

private:
    Vector pressure_of(const Vector& outflow, double tolerance) const;
    void find_weighted(const Vector& residual, Vector& z) const; ///< G^-1 r of edges and twists, no traces

    /// Edges, one after the other along the first axis, as cells are: between these. The root of their conductance.
    struct Run {
        std::int32_t edge, length, low, high;
        double root;
    };

    void find_conductances(const Placed<D>& at);
    void find_outflow(const std::vector<int>& given);
    Vector outflow_of(const Vector& z) const;
    /// r -= held pressure.
    void take_pressure(const Vector& pressure, Vector& residual) const;

    const ViscousColumns<D>& columns_;
    Vector weight_; ///< 1 over the diagonal, of edges
    double tolerance_;
    ViscousTraces<D> traces_;
    SparseCholesky bodies_;
    std::vector<Run> runs_;
    std::vector<int> held_by_;                        ///< unknowns of `outflow_`
    typename ViscousColumns<D>::Rows outflow_, held_; ///< of what is in no run: rows x these, and transposed
    Eigen::Index unknowns_ = 0;
    std::unique_ptr<Coupling<D>> coupling_;
    std::unique_ptr<CoupledSolver<D>> solver_;
};

} // namespace gapflow
