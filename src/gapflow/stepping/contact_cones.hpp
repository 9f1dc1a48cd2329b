// Solution of the laws of contact (contact_law) for many contacts together, where sweeps over single contacts converge slowly and
// contact_equations, exact, are too many.
#pragma once

#include "gapflow/stepping/contact_law.hpp"

#include <optional>

namespace gapflow {

/// As forecast_contacts, from `guess` on; impulses that redundant contacts may share in many ways stay near its. Nothing where the
/// inertia is not positive definite or the secants tell nothing.
template <int D>
std::optional<ContactForecast<D>> solve_cones(const std::vector<Contact<D>>& contacts,
                                              const std::vector<ContactImpulse<D>>& given, const std::vector<Twist<D>>& twists,
                                              const NearInertia<D>& inertia, const std::vector<ContactImpulse<D>>& guess,
                                              double accuracy, const ContactSecants& secants = {});

} // namespace gapflow
