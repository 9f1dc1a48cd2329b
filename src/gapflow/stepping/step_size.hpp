// The step size (method, "The time step", stage 1).
#pragma once

#include "gapflow/complex/gap_arm.hpp"
#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

namespace gapflow {

/// The next step; it does not pass `next_output`. `here`, `histories`: coupled system and films at its start; `arms`, and the largest speed `in_gaps` beside voids: of a run on parts. `ways` receives the pairs whose gap
/// it changes by a large factor. Throws
/// ComputationError where prescribed bodies that have met continue to approach, and where the step becomes too small.
/// Collective.
template <int D>
Step choose_step(const Model<D>& model, const State<D>& state, const Coupling<D>& here, const FilmHistories<D>& histories,
                 double next_output, GapWays<D>& ways, std::span<const GapArm<D>> arms = {}, double in_gaps = 0);

} // namespace gapflow
