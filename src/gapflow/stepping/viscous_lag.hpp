// A note for the user where viscosity goes so far in a step that the forces on bodies lag behind their motion (method, "What to keep in mind").
#pragma once

#include "gapflow/stepping/state.hpp"

#include <optional>
#include <string>

namespace gapflow {

/// After a step: the note, if its length was too large for bodies that changed their velocities as they did. The same text for all steps of a scene.
template <int D>
std::optional<std::string> viscous_lag_note(const Model<D>& model, const State<D>& state);

} // namespace gapflow
