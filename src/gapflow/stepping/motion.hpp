// Bodies over a step (method, "The time step", stages 3 and 5): where they go, what pushes them but the fluid, and what becomes of their twists.
#pragma once

#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

#include <vector>

namespace gapflow {

/// Stage 3: the bodies at the step's end, moved with V^n + 1/2 dt (V^n - V^{n-1}) / dt^{n-1}.
template <int D>
std::vector<RigidBody<D>> moved(std::vector<RigidBody<D>> bodies, const Step& step);

/// Contacts of the new configuration, in state.contacts. Overlaps that the motion left are taken out first, by moving bodies.
template <int D>
void find_contacts(const Model<D>& model, State<D>& state, const Step& step);

/// Twists of all solids at the step's end if the accelerations of the last one go on. `bodies`: moved.
template <int D>
std::vector<Twist<D>> predicted_twists(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Step& step);

/// Stage 5: twists of free bodies after all forces but the fluid's, and what the last pressure does on their way; of others as given.
/// `change`: what it does to the bulk's velocity; `old`, `there`: fractions before and after the motion. (A hinged body's pressure turns it about
/// its hinge: left out.) Collective.
template <int D>
std::vector<Twist<D>> forced_twists(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const FaceField<D>& change,
                                    const FaceFractions<D>& old, const FaceFractions<D>& there, const Step& step);

/// The bodies take the twists V of the step's end, and what goes on of their change. True if something met in the step.
template <int D>
bool finish_bodies(const Model<D>& model, const std::vector<Twist<D>>& V, const Step& step, State<D>& state);

} // namespace gapflow
