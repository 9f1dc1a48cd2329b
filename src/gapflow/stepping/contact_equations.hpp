// Direct solution of the laws of contact (contact_law): an active set of equations in the impulses of all contacts with a
// positive impulse.
#pragma once

#include "gapflow/stepping/contact_law.hpp"

#include <optional>

namespace gapflow {

/// As forecast_contacts, from the states (pressing, sliding) of `guess` on; impulses that redundant contacts may share in many ways
/// are those nearest to its. Nothing where no set of states is found that obeys the laws. The cost grows with
/// the cube of the number of contacts.
template <int D>
std::optional<ContactForecast<D>> solve_contacts(const std::vector<Contact<D>>& contacts,
                                                 const std::vector<ContactImpulse<D>>& given,
                                                 const std::vector<Twist<D>>& twists, const NearInertia<D>& inertia,
                                                 const std::vector<ContactImpulse<D>>& guess, double accuracy);

} // namespace gapflow
