// Solids that lie flat on each other and approach at the start.
#pragma once

#include "gapflow/stepping/model.hpp"
#include "gapflow/stepping/state.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// Takes from the free bodies' twists the rates at which solids close that lie flat on each other, by impulses between them: an impact of
/// the bodies alone, without rebound. The fluid of such a gap is as thin as the roughness, and has moved with no body: with these rates the
/// flow would have an energy that grows without bound as the roughness falls, and no velocity has brought it. Round surfaces keep theirs, of
/// finite energy, which contacts return. Notes on pairs that would rebound.
template <int D>
std::vector<std::string> stop_flat_closing(const Model<D>& model, State<D>& state);

} // namespace gapflow
