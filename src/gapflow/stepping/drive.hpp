// Mean pressure gradient that drives fluid and bodies along periodic axes (method, "Driven periodic boxes").
#pragma once

#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"
#include "gapflow/stepping/transport.hpp"

#include <vector>

namespace gapflow {

/// Mean velocity of fluid and solids over the domain's volume. `V`: twists of all solids that the flow belongs to. Collective.
template <int D>
Vec<D> mean_velocity(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V);

/// The gradient in a step, and the mean velocity before it; `state`: before the step. Zero where nothing drives. Collective.
template <int D>
Drive<D> next_drive(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const Step& step);

/// Adds the impulse of the gradient in the step to u* of bulk, films and mouths. Collective.
template <int D>
void drive_fluid(const Model<D>& model, const Coupling<D>& there, const Drive<D>& drive, const Step& step,
                 Intermediate<D>& star);

/// Force and torque of the gradient on a body about its centre of mass: as of gravity on the fluid that it displaces.
template <int D>
Twist<D> driving_wrench(const RigidBody<D>& body, const Drive<D>& drive);

} // namespace gapflow
