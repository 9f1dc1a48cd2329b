// What the bodies drive the fluid with at the start (method, "The time step").
#pragma once

#include "gapflow/body/rigid_body.hpp"
#include "gapflow/coupling/coupling.hpp"

#include <functional>
#include <vector>

namespace gapflow {

/// Twists of all solids that the flow at the start belongs to: the given ones, but without the speed at which surfaces that lie
/// flat on each other near each other or part. A film without thickness cannot take that up; what becomes of it is the first
/// step's. Free bodies give way by their masses, prescribed ones where no free body can. `twists` if no surfaces do so.
template <int D>
std::vector<Twist<D>> start_twists(const Coupling<D>& coupling, const std::vector<RigidBody<D>>& bodies,
                                   const std::function<GapSettings(int, int)>& gaps, const std::vector<Twist<D>>& twists);

} // namespace gapflow
