// Solution of the laws of contact (contact_law) for all contacts together, where sweeps over single contacts converge slowly.
#pragma once

#include "gapflow/stepping/contact_law.hpp"

#include <optional>

namespace gapflow {

/// As forecast_contacts, from `guess` on; impulses that redundant contacts may share in many ways stay near its. Nothing where there are no contacts, or
/// the inertia is not positive definite.
template <int D>
std::optional<ContactForecast<D>> solve_contacts(const std::vector<Contact<D>>& contacts,
                                                 const std::vector<ContactImpulse<D>>& given,
                                                 const std::vector<Twist<D>>& twists, const NearInertia<D>& inertia,
                                                 const std::vector<ContactImpulse<D>>& guess, double accuracy);

} // namespace gapflow
