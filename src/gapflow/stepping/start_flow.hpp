// Twists that determine the flow at the start (method, "Contact").
#pragma once

#include "gapflow/body/rigid_body.hpp"
#include "gapflow/coupling/coupling.hpp"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace gapflow {

/// What lies flat on another solid at the start.
namespace flat {
inline constexpr double flush = 1e-8; ///< in cells, and of the floor (roughness) 1e-3: surfaces that touch
inline constexpr double patch = 0.1;  ///< in cells: the size of what lies flat
inline constexpr double same = 1e-6;  ///< of the largest speed
} // namespace flat

/// Twists of all solids for the flow at the start: the given ones without the rate of approach or separation of surfaces that
/// lie flat on each other. A film of zero thickness cannot carry the corresponding flux; the first step treats that rate as an
/// impact. Free bodies give way by their masses, prescribed ones where no free body can. `twists` if no surfaces do so.
/// `rebound`: pairs that rebound; of their round surfaces, which touch at a point or along a line, the rate is kept.
template <int D>
std::vector<Twist<D>> start_twists(const Coupling<D>& coupling, const std::vector<RigidBody<D>>& bodies,
                                   const std::function<GapSettings(int, int)>& gaps, const std::vector<Twist<D>>& twists,
                                   const std::function<bool(int, int)>& rebound = {});

/// Two solids that rebound, lie flat on each other and approach, if no others that lie so part. Without what start_twists() takes from them, the bodies would
/// have it back in the first step, and with it the energy of a film that does not move at the start.
template <int D>
std::optional<std::array<int, 2>> falls_flat(const Coupling<D>& coupling, const std::function<GapSettings(int, int)>& gaps,
                                             const std::vector<Twist<D>>& twists, const std::function<bool(int, int)>& rebound);

} // namespace gapflow
