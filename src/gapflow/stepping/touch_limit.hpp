// The step's limit by surfaces that meet on the way (method, "The time step", stage 1): no body passes another one or a wall in a step,
// however far it goes.
#pragma once

#include "gapflow/core/error.hpp"
#include "gapflow/stepping/state.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// Two prescribed bodies, or one and something fixed, that meet and go on.
ComputationError driven_into_each_other(const std::string& a, const std::string& b, double time);

/// The step size dt, or where surfaces would pass each other by more than contacts move apart in one pass, the time to their first touch. A step
/// from surfaces that overlap or touch lets them go so much deeper. `solids`: of the state. Throws ComputationError where
/// surfaces meet that cannot give way.
template <int D>
double until_touch(const Model<D>& model, const State<D>& state, const std::vector<Solid<D>>& solids, double dt);

} // namespace gapflow
