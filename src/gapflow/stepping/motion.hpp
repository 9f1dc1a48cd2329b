// Bodies over a step (method, "The time step", stages 3 and 5): motion, forces other than the fluid's, and update of twists.
#pragma once

#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

#include <vector>

namespace gapflow {

/// Stage 3: the bodies at the step's end, moved with V^n + 1/2 dt (V^n - V^{n-1}) / dt^{n-1}.
template <int D>
std::vector<RigidBody<D>> moved(std::vector<RigidBody<D>> bodies, const Step& step);

/// Contacts of the new configuration, in state.contacts. Overlaps left by the motion are removed first, by moving bodies.
template <int D>
void find_contacts(const Model<D>& model, State<D>& state, const Step& step);

/// Twists of all solids at the step's end, extrapolated with the accelerations of the last one. `bodies`: moved.
template <int D>
std::vector<Twist<D>> predicted_twists(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Step& step);

/// Stage 5: twists of free bodies after all forces (the drive's too) but the fluid's; of others as given.
template <int D>
std::vector<Twist<D>> forced_twists(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Drive<D>& drive,
                                    const Step& step);

/// Gives the bodies the twists V of the step's end and the part of their change that is extrapolated. True if there was an
/// impact in the step.
template <int D>
bool finish_bodies(const Model<D>& model, const std::vector<Twist<D>>& V, const Step& step, State<D>& state);

} // namespace gapflow
