// Moving bodies over a step (method, "The time step", stage 3).
#pragma once

#include "gapflow/body/rigid_body.hpp"

namespace gapflow {

/// Moves a body from `time` to time + dt; only its pose changes. Free bodies move with their twist and the last step's
/// acceleration, prescribed ones to their given pose; fixed ones do not move.
/// Throws ComputationError if the rotation over the step is too large to be solved for (about 1 radian).
template <int D>
void move(RigidBody<D>& body, double time, double dt);

/// Twist of a body after dt with the last step's acceleration, at its present pose. Prescribed and fixed bodies:
/// the mean twist over time .. time + dt, which is their twist at the end of the step.
template <int D>
Twist<D> predicted_twist(const RigidBody<D>& body, double time, double dt);

/// The part of a body's acceleration over a step that is extrapolated although other bodies had an impact in the step. An impact changes the
/// velocities of all bodies in the fluid within the step, and that change must not be extrapolated. The whole acceleration where it is at most
/// twice `before`, the step before's, or `least` (a length over time squared), on average over the body's mass.
template <int D>
double lasting_part(const RigidBody<D>& body, const Twist<D>& acceleration, const Twist<D>& before, double least);

} // namespace gapflow
