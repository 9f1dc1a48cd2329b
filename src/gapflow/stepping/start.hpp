// The start of a run (method, "The time step"): overlaps taken out, and the flow that the bodies' velocities drive in fluid that moves with the
// scene's initial velocity, by one projection that holds the bodies to their velocities.
#pragma once

#include "gapflow/core/timer.hpp"
#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

#include <vector>

namespace gapflow {

template <int D>
struct Start {
    Coupling<D> here;
    std::vector<Twist<D>> twists; ///< that the flow belongs to: start_twists()
};

/// Velocity, pressure and voids of the state; free bodies may be moved. `report`: of the projection, with what the user should know. Throws
/// InputError where no fluid is left or overlaps stay, ComputationError as project(). Collective.
template <int D>
Start<D> start(const Model<D>& model, State<D>& state, StepReport& report, StageTimers& timers);

/// Masses in the initial projection, beyond any added mass: they hold the bodies to their velocities. (As prescribed bodies they could choose
/// other masters for their films.)
template <int D>
std::vector<TwistMatrix<D>> held_masses(const Model<D>& model, const std::vector<RigidBody<D>>& bodies);

} // namespace gapflow
