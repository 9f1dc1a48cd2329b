// The laws of contact among rigid bodies alone (method, "Contact"):
//
//     0 <= lambda  |  c V - least >= 0,        |lambda_t| <= mu lambda, against the slip,
//     V = V_0 + A^-1 C^T (lambda - lambda_0)
//
// around twists V_0 that impulses lambda_0 gave. A: the bodies' inertia and that of the films between them (NearInertia). The
// rest of the fluid responds to a change of impulses too, so this is a forecast; where it changes nothing, V_0 and lambda_0
// obey the laws.
#pragma once

#include "gapflow/coupling/film_inertia.hpp"
#include "gapflow/stepping/contact_set.hpp"

#include <vector>

namespace gapflow {

/// The solution of the laws.
template <int D>
struct ContactForecast {
    std::vector<ContactImpulse<D>> impulses;
    std::vector<Twist<D>> twists; ///< V
};

/// `given`: lambda_0, one a contact. Speeds are found to `accuracy`, absolute. A is changed such that it gives the
/// secants, if there are any.
template <int D>
ContactForecast<D> forecast_contacts(const std::vector<Contact<D>>& contacts, const std::vector<ContactImpulse<D>>& given,
                                     const std::vector<Twist<D>>& twists, const NearInertia<D>& inertia, double accuracy,
                                     const ContactSecants& secants = {});

} // namespace gapflow
