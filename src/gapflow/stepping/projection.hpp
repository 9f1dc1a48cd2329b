// The coupled system of a projection (method, "The coupled system") with the current sets of contacts and voids, and its
// solves.
#pragma once

#include "gapflow/body/rigid_body.hpp"
#include "gapflow/core/timer.hpp"
#include "gapflow/coupling/coupling.hpp"
#include "gapflow/coupling/wet_system.hpp"
#include "gapflow/solver/solver.hpp"
#include "gapflow/stepping/contact_set.hpp"
#include "gapflow/stepping/rounds.hpp"
#include "gapflow/stepping/void_set.hpp"

#include <optional>
#include <vector>

namespace gapflow {

/// Input of a projection. All of it must outlive the projection.
template <int D>
struct ProjectionStart {
    Coupling<D>& coupling;
    const std::vector<RigidBody<D>>& bodies;
    const std::vector<TwistMatrix<D>>& masses; ///< of all solids
    const std::vector<Twist<D>>& forced;       ///< of all solids after all forces but the fluid's and the contacts'
    ContactSet<D>* contacts;                   ///< null: none
    VoidSet<D>* voids;                         ///< null: none
    const std::vector<double>& beyond_mouths;  ///< reduced pressure beyond every mouth that the system takes as 0
    const UnknownVector<D>& beside;            ///< outflow that u* has beside faces, films and mouths; empty: none
    double dt;                                 ///< 0: the initial projection
    long step;                                 ///< its number, for messages
};

template <int D>
class Projection {
public:
    /// `velocity`: u*; the flux of mouths that voids shut becomes 0. `impulse`: becomes that of the pressure.
    Projection(const ProjectionStart<D>& start, FluidVelocity<D>& velocity, UnknownVector<D>& impulse,
               const SolverOptions& options, StageTimers& stages);

    /// Assembles the system with the current sets: held contacts, sliding friction, voids; V* and the right-hand side. Throws
    /// ComputationError where incompressible
    /// fluid has no way out. Collective.
    void assemble(bool voids_changed, bool links_changed = false);
    /// Pressure and twists of the end of the step. Collective.
    SolveReport solve(double tolerance);
    /// Updates the contacts after the solve. `inertia`: for their forecast.
    ContactChange update_contacts(const NearInertia<D>& inertia, double tolerance, const Rounds& rounds);
    /// Updates void nodes and their mouths after the solve; true if some changed. In late rounds one at a time, once the
    /// contacts do not change.
    bool update_voids(double tolerance, const Rounds& rounds, bool contacts_changed);
    /// Adds the voids' pressure to the impulse and restores the coupling.
    void finish_voids();

    /// Twists of the end of the step, of all solids.
    const std::vector<Twist<D>>& twists() const { return twists_; }
    /// The same before the pressure acts.
    const std::vector<Twist<D>>& without_pressure() const { return without_pressure_; }
    /// L p + K V + D u* of the film nodes after the last update_voids(); else empty.
    const Eigen::VectorXd& node_outflow() const { return node_outflow_; }
    /// Whether any contact holds or any node is a void.
    bool holds() const { return start_.voids || start_.coupling.system.contact.rows() > 0; }
    bool corrects_bodies() const { return solver_->corrects_bodies(); }
    double solver_seconds() const { return solver_seconds_; }

private:
    void hold_voids();

    ProjectionStart<D> start_;
    FluidVelocity<D>& velocity_;
    UnknownVector<D>& impulse_;
    SolverOptions options_;
    StageTimers& stages_;
    std::vector<double> open_flux_; ///< of the mouths as long as none is shut
    std::optional<WetSystem<D>> wet_;
    std::optional<CoupledSolver<D>> solver_;
    std::vector<Twist<D>> twists_, without_pressure_;
    Eigen::VectorXd contact_impulse_, held_impulse_; ///< of the held contacts, with and without pressure
    UnknownVector<D> rhs_;
    Eigen::VectorXd node_outflow_;
    double squares_ = 0, held_squares_ = 0, solver_seconds_ = 0;
};

} // namespace gapflow
