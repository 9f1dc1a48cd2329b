// The start of a run on parts: overlaps are removed, and the fluid at rest is set moving by the bodies' velocities.
#pragma once

#include "gapflow/core/timer.hpp"
#include "gapflow/step/instant.hpp"
#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

namespace gapflow {

/// Flow of the state; free bodies may be moved. `initial`: velocity on the faces of the grid to which the bodies' motion adds potential flow; none: rest. `report`: gets notes for the user. Throws InputError where no fluid is left or overlaps stay.
/// Collective.
template <int D>
Instant<D> start_on_parts(const Model<D>& model, State<D>& state, StepReport& report, StageTimers& timers,
                          const FaceField<D>* initial = nullptr);

} // namespace gapflow
