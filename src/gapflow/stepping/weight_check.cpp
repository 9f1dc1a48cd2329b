#include "gapflow/stepping/weight_check.hpp"

#include "gapflow/body/constraint.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/stepping/short_text.hpp"

#include <algorithm>
#include <limits>

namespace gapflow {

namespace {

// L + K M^-1 K^T: the preconditioner takes its part with the bodies back, and what is left of that is round-off if it is so many times the fluid's. Of a disk
// and a box in a stream, a box on a hinge, crowds in touch, 1e-8 is solved for, 3e-9 is not.
constexpr double lightest = 1e-8;

// Inertia over that of the fluid in the body's place, in its admissible motions: of translations alone if there are any (with a mass a moment of inertia may be 0).
template <int D>
double share_of_fluid(const RigidBody<D>& body, double density)
{
    RigidBody<D> fluid = body;
    set_density(fluid, density);
    const TwistBasis<D> basis = admissible_twists(body);
    const bool turns_only = body.hinge || basis.template topRows<D>().isZero(0);
    const TwistMatrix<D> mass = mass_matrix(body), of_fluid = mass_matrix(fluid);
    double share = std::numeric_limits<double>::infinity();
    for (long k = 0; k < basis.cols(); ++k)
        if (const Twist<D> motion = basis.col(k); turns_only || !motion.template head<D>().isZero(0))
            share = std::min(share, motion.dot(mass * motion) / motion.dot(of_fluid * motion));
    return share;
}

} // namespace

template <int D>
void require_weight(const Scene& scene, const std::vector<RigidBody<D>>& bodies)
{
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].motion != Motion::free)
            continue;
        const double share = share_of_fluid(bodies[b], scene.density);
        if (share * (1 + 1e-9) >= lightest) // but for round-off
            continue;
        const BodyScene& from = scene.bodies[b];
        const std::string given =
            from.mass ? "mass = " + short_text(*from.mass) + " with its inertia" : "density = " + short_text(*from.density);
        throw InputError(
            scene.file + ": body." + given + ": body '" + bodies[b].name + "' has " + short_text(share) +
            " of the inertia of the fluid in its place, and less than " + short_text(lightest) +
            " of it is lost to round-off; use " + short_text(lightest / share) +
            " times as much, or more: a body of a thousandth of the fluid's density moves nearly as one without mass");
    }
}

template void require_weight<2>(const Scene&, const std::vector<RigidBody<2>>&);
template void require_weight<3>(const Scene&, const std::vector<RigidBody<3>>&);

} // namespace gapflow
