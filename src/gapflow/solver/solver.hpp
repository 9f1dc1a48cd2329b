// Solves the coupled system: conjugate gradients in double precision, preconditioned by multigrid on the grid block, a
// direct solve of the films' band, and a capacitance (Woodbury) correction for the bodies.
#pragma once

#include "gapflow/coupling/system.hpp"

#include <memory>
#include <optional>
#include <string>

namespace gapflow {

struct ResidualScale;

enum class Backend { multigrid, petsc };

/// When the preconditioner corrects for the bodies: decided by their lightness and by the iterations' progress, or as set.
enum class BodyMode { automatic, always, never };

struct SolverOptions {
    double tolerance = 1e-8; ///< on the 2-norm of the residual, relative to the right-hand side's
    int max_iterations = 500;
    Backend backend = Backend::multigrid;
    BodyMode bodies = BodyMode::automatic;
    bool ask_lightness = true; ///< automatic: from the start; else the iterations' progress alone decides
};

struct SolveReport {
    int iterations = 0;
    double residual = 0;    ///< true final relative residual
    bool converged = false; ///< to the tolerance, or to the round-off of the residual itself where films are very stiff
    double seconds = 0;
    std::string message; ///< reason if not converged; else empty
};

/// What the pressure of a solve does to the free bodies.
struct BodyMotion {
    Eigen::VectorXd twist;           ///< M^-1 K^T p
    Eigen::VectorXd contact_impulse; ///< of the contacts that hold them
};

/// Set up once for a system, then solve for any number of right-hand sides. Keeps a reference to the system. Collective.
template <int D>
class CoupledSolver {
public:
    CoupledSolver(const CoupledSystem<D>& system, const SolverOptions& options);
    ~CoupledSolver();

    /// On return (L + K M^-1 K^T) p = rhs to tolerance * max(|rhs|, magnitude), p orthogonal to the null space. `p` holds the
    /// first guess. `rhs` is made compatible by projection. `magnitude`: residuals below tolerance * magnitude are round-off.
    SolveReport solve(UnknownVector<D>& p, const UnknownVector<D>& rhs, double magnitude = 0.0) const;
    /// The same to another tolerance than the options'.
    SolveReport solve(UnknownVector<D>& p, const UnknownVector<D>& rhs, double magnitude, double tolerance) const;

    /// Of the last solve, where films are condensed for it. Where contacts' rows nearly depend on each other M^-1 K^T p is not determined to round-off, and the
    /// pressure belongs to this one.
    const std::optional<BodyMotion>& motion() const;

    /// Reads the system's masses and contacts again after they changed; all else must be unchanged.
    void update_bodies();

    /// Whether the preconditioner corrects for the bodies, by now.
    bool corrects_bodies() const;
    double setup_seconds() const;
    /// Bytes held by the solver per cell of the rank's block.
    double bytes_per_cell() const;

private:
    SolveReport solve_condensed(UnknownVector<D>& p, const UnknownVector<D>& rhs, double magnitude, double tolerance) const;
    SolveReport solve_system(UnknownVector<D>& p, const UnknownVector<D>& rhs, const ResidualScale& scale,
                             double tolerance) const;
    void correct_slow_motions() const;

    struct Data;
    std::unique_ptr<Data> data_;
};

/// y = (L + K M^-1 K^T) p, matrix-free, the same product that the solver uses. Ghosts of p are filled.
template <int D>
void apply(const CoupledSystem<D>& system, UnknownVector<D>& p, UnknownVector<D>& y);

/// K^T p: wrench of every free body, one column of twist_size<D> a body. Collective.
template <int D>
Eigen::VectorXd wrenches(const CoupledSystem<D>& system, const UnknownVector<D>& p);

} // namespace gapflow
