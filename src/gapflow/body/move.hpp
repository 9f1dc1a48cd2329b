// Moving bodies over a step (method, section 5, stage 3).
#pragma once

#include "gapflow/body/rigid_body.hpp"

namespace gapflow {

/// Moves a body from `time` to time + dt; only its pose changes. Free bodies go with their twist and the last step's
/// acceleration, prescribed ones to their given pose, fixed ones nowhere.
/// Throws ComputationError if the rotation over the step is too large to be solved for (about 1 radian).
template <int D>
void move(RigidBody<D>& body, double time, double dt);

/// Twist of a body moving on for dt with the last step's acceleration, at its present pose. Prescribed and fixed bodies:
/// the mean twist over time .. time + dt, the one their step ends with.
template <int D>
Twist<D> predicted_twist(const RigidBody<D>& body, double time, double dt);

} // namespace gapflow
