// Twists that determine the flow at the start (method, "Contact").
#pragma once

#include "gapflow/body/rigid_body.hpp"
#include "gapflow/coupling/coupling.hpp"

#include <functional>
#include <vector>

namespace gapflow {

/// Twists of all solids for the flow at the start: the given ones without the rate of approach or separation of surfaces that
/// lie flat on each other. A film of zero thickness cannot carry the corresponding flux; the first step treats that rate as an
/// impact. Free bodies give way by their masses, prescribed ones where no free body can. `twists` if no surfaces do so.
template <int D>
std::vector<Twist<D>> start_twists(const Coupling<D>& coupling, const std::vector<RigidBody<D>>& bodies,
                                   const std::function<GapSettings(int, int)>& gaps, const std::vector<Twist<D>>& twists);

} // namespace gapflow
