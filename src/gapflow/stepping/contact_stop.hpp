// Velocities that contacts leave of given ones, without the fluid's answer (method, "The bulk", viscous step).
#pragma once

#include "gapflow/stepping/contact_set.hpp"

#include <vector>

namespace gapflow {

/// Twists of all solids, changed as little as possible, in the metric of the bodies' masses, such that in a step of length `dt` no contact closes by more
/// than its distance. Without rebound and friction. `bodies` are the first solids.
template <int D>
std::vector<Twist<D>> stopped_by_contacts(const ContactSet<D>& contacts, const std::vector<RigidBody<D>>& bodies,
                                          const std::vector<Twist<D>>& twists, double dt);

} // namespace gapflow
