// A time step of ideal fluid without circulation (theory of the step): bodies and fluid are one system with the energy 1/2 V N(x) V.
//
//     dP/dt = F + dT/dx,     P = M V + N_f V,     N_f V = dT/dV of the fluid
//
// The bodies move first; the fluid's flow at the new places follows from the impulses. Nothing of the fluid is carried.
#pragma once

#include "gapflow/core/timer.hpp"
#include "gapflow/step/instant.hpp"
#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

namespace gapflow {

/// From `old`, to which the state belongs, to the end of the step: the state becomes that of the instant that is returned. The grid goes with its body.
/// Throws ComputationError as project(). Collective.
template <int D>
Instant<D> advance(Model<D>& model, Instant<D>& old, const Step& step, State<D>& state, StepReport& report,
                   StageTimers& timers);

/// The instant of the state's bodies with its potential and with voids in gaps. Collective.
template <int D>
Instant<D> restored(const Model<D>& model, const State<D>& state, const PartVoids& voids = {});

} // namespace gapflow
