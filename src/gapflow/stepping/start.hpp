// The start of a run (method, "Contact"): removes overlaps, and computes the flow that the bodies' velocities drive in fluid
// with the scene's initial velocity, by one projection with the bodies' velocities held fixed.
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

/// Velocity, pressure and voids of the state; free bodies may be moved. `report`: of the projection, with notes for the user.
/// Throws
/// InputError where no fluid is left or overlaps stay, ComputationError as project(). Collective.
template <int D>
Start<D> start(const Model<D>& model, State<D>& state, StepReport& report, StageTimers& timers);

/// Throws InputError where bodies leave neither cells of fluid nor films between surfaces that are apart. Collective.
template <int D>
void require_fluid(const Model<D>& model, const Coupling<D>& coupling);

/// Masses in the initial projection, much larger than any added mass: they hold the bodies' velocities fixed. (As prescribed
/// bodies they could have other masters for their films.)
template <int D>
std::vector<TwistMatrix<D>> held_masses(const Model<D>& model, const std::vector<RigidBody<D>>& bodies);

} // namespace gapflow
