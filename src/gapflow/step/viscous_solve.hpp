// One implicit stage of viscosity on parts: of the velocities y that keep every row's outflow,
//
//     the least of  1/2 |y - y*|^2_T + factor E(y) - load . y,
//
// T the kinetic energy of fluid and bodies, E the viscous form, the latter also of its traces. One symmetric positive definite problem for fluid and bodies.
#pragma once

#include "gapflow/core/sparse_cholesky.hpp"
#include "gapflow/solver/solver.hpp"
#include "gapflow/step/viscous_columns.hpp"

#include <memory>

namespace gapflow {

/// How the system is solved.
enum class ViscousMethod {
    direct,   ///< one factorisation, for a stage or two in the plane
    projected ///< conjugate gradients among the velocities without outflow
};
template <int D>
inline constexpr ViscousMethod viscous_method = D == 2 ? ViscousMethod::direct : ViscousMethod::projected;

/// Of rows whose pressure is given instead of their outflow, those of voids.
struct GivenRows {
    Eigen::VectorXd pressure; ///< of all rows: multipliers of the given ones, else 0
    Eigen::VectorXd outflow;  ///< by which that of the others is to change
};

template <int D>
class ViscousSolve {
public:
    using Vector = Eigen::VectorXd;
    using Matrix = Eigen::SparseMatrix<double>;

    /// `mass`: of all solids, their own. `factor`: viscosity times time, by the length of a cell to the power D - 2. `given`: rows whose pressure is.
    /// `tolerance`: of conjugate gradients, of the square root of the energy.
    ViscousSolve(const Placed<D>& at, const ViscousColumns<D>& columns, const std::vector<TwistMatrix<D>>& mass, double factor,
                 double tolerance, ViscousMethod method = viscous_method<D>, const std::vector<int>& given = {});
    ~ViscousSolve();

    struct Stage {
        Vector y;        ///< of all columns
        Vector pressure; ///< multipliers of the rows
        int iterations = 0;
        Vector change{}; ///< of the unknowns; empty: not kept
    };
    /// `like`: one whose change is a guess of this one's; null: none. `rows`: null: zeros. Throws ComputationError where it does not converge.
    Stage solve(const Vector& y_star, const Vector& load, const Stage* like = nullptr, const GivenRows* rows = nullptr) const;

    /// T y: of edges and twists, 0 for traces.
    Vector inertia(const Vector& y) const { return mass_ * y; }
    /// Derivatives of `factor` E.
    Vector friction(const Vector& y) const;

private:
    struct Direct;
    struct Projected;

    void find_mass(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass);
    void find_free(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass);
    typename ViscousColumns<D>::Rows form_of_unknowns() const;
    void set_up_direct(const std::vector<int>& given);
    void set_up_projected(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass, const std::vector<int>& given);
    Stage solve_direct(const Vector& base, const Vector& load, const GivenRows* rows) const;
    Stage solve_projected(const Vector& base, const Vector& load, const Stage* like, const GivenRows* rows) const;
    /// The square root of twice the energy that a change has, with its dissipation.
    double size(const Vector& change) const;
    /// The system's block of the free bodies, in the unknowns `free_` maps; where bodies lose more of their mass than they have to the volume that planes see of
    /// them, with the least positive mass: only for preconditioners.
    /// `friction`: that of the form in it.
    Matrix body_block(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass,
                      std::vector<Eigen::Triplet<double>> friction) const;

    const ViscousColumns<D>& columns_;
    double factor_, tolerance_;
    Matrix mass_;
    Matrix free_; ///< columns x unknowns: edges, traces, and the free bodies' twists that their constraints admit
    Matrix hold_; ///< of unknowns that no motion has
    std::unique_ptr<Direct> direct_;
    std::unique_ptr<Projected> projected_;
};

} // namespace gapflow
