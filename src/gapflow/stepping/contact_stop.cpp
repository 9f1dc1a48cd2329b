#include "gapflow/stepping/contact_stop.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/stepping/contact_law.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr double accuracy = 1e-6; // of the largest speed

} // namespace

template <int D>
std::vector<Twist<D>> stopped_by_contacts(const ContactSet<D>& contacts, const std::vector<RigidBody<D>>& bodies,
                                          const std::vector<Twist<D>>& twists, double dt)
{
    std::vector<Contact<D>> laws = contacts.contacts();
    double fastest = 0;
    for (Contact<D>& c : laws) {
        c.least = c.target = -std::max(c.point.distance - c.hold, 0.0) / dt;
        c.friction = 0;
        for (int solid : {c.point.a, c.point.b})
            fastest = std::max(fastest, twists[solid].template head<D>().norm());
    }
    NearInertia<D> inertia;
    inertia.mobility.assign(twists.size(), TwistMatrix<D>::Zero());
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].motion == Motion::free)
            for (int k = 0; k < twist_size<D>; ++k)
                inertia.mobility[b].col(k) = impulse_response(bodies[b], Twist<D>(Twist<D>::Unit(k)), dt);
    const std::vector<ContactImpulse<D>> none(laws.size());
    return forecast_contacts<D>(laws, none, twists, inertia, accuracy * fastest).twists;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<Twist<D>> stopped_by_contacts<D>(const ContactSet<D>&, const std::vector<RigidBody<D>>&,              \
                                                          const std::vector<Twist<D>>&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
