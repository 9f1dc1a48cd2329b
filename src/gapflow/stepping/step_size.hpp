// How long a step may be (method, "The time step", stage 1).
#pragma once

#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

namespace gapflow {

/// The next step; it does not pass `next_output`. `here`, `memories`: coupled system and films at its start. Throws ComputationError where
/// prescribed bodies that have met go on, and where the step falls beyond all sense. Collective.
template <int D>
Step choose_step(const Model<D>& model, const State<D>& state, const Coupling<D>& here, const FilmMemories<D>& memories,
                 double next_output);

} // namespace gapflow
