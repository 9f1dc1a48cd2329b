// On graded grids, bodies that move and films stay in the core (method, "Graded spacing").
#pragma once

#include "gapflow/stepping/state.hpp"

#include <optional>
#include <string>

namespace gapflow {

/// What lies outside the core but must not, and where, as the beginning of a sentence: a body that moves, or a film; empty if there is
/// nothing, as on every uniform grid. Fixed bodies may reach out.
template <int D>
std::optional<std::string> outside_core(const Model<D>& model, const Coupling<D>& here,
                                        const std::vector<RigidBody<D>>& bodies);

} // namespace gapflow
