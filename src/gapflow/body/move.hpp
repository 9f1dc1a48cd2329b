// Moving bodies over a step (method, "The time step", stage 3).
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

/// The part of a body's acceleration over a step that goes on although others met in the step: an impact reaches all bodies in the fluid at
/// once, and what it does to them is over. The whole where it is no more than twice `before`, the step before's, or `least` (a
/// length over time squared), in the mean over the body's mass.
template <int D>
double lasting_part(const RigidBody<D>& body, const Twist<D>& acceleration, const Twist<D>& before, double least);

} // namespace gapflow
