#include "gapflow/body/forces.hpp"

#include "gapflow/body/constraint.hpp"
#include "gapflow/core/decompositions.hpp"

#include <cmath>

namespace gapflow {

namespace {

template <int D>
using PointJacobian = Eigen::Matrix<double, D, twist_size<D>>;

// Velocity of the shape's origin per twist.
template <int D>
PointJacobian<D> origin_jacobian(const RigidBody<D>& body)
{
    const Vec<D> arm = body.pose.position - body.centre();
    PointJacobian<D> J;
    for (int k = 0; k < twist_size<D>; ++k)
        J.col(k) = velocity_at<D>(Twist<D>::Unit(k), arm);
    return J;
}

template <int D>
Twist<D> elastic_wrench(const RigidBody<D>& body)
{
    const Vec<D> origin = body.pose.position;
    return wrench<D>(body.spring->stiffness * (body.spring->anchor - origin), origin - body.centre());
}

// Inverse of the effective mass at the spring's point, in the direction where it is least.
template <int D>
double mobility(const RigidBody<D>& body)
{
    const PointJacobian<D> J = origin_jacobian(body);
    const TwistBasis<D> basis = admissible_twists(body);
    const TwistMatrix<D> mass = mass_matrix(body);
    Mat<D> response;
    for (int k = 0; k < D; ++k)
        response.col(k) = J * admissible_response<D>(basis, mass, J.row(k).transpose());
    return symmetric_eigenvalues<D>(response).maxCoeff();
}

struct Newmark {
    double delta = 0, gamma = 0.5, beta = 0.25;
};

// Sum of the squared frequencies of a float that its section with the water's level holds.
template <int D>
double squared_frequencies(const RigidBody<D>& body, const TwistMatrix<D>& section)
{
    const TwistBasis<D> basis = admissible_twists(body);
    const TwistMatrix<D> mass = mass_matrix(body);
    double sum = 0;
    for (int k = 0; k < twist_size<D>; ++k)
        sum += admissible_response<D>(basis, mass, section.col(k))[k];
    return sum;
}

// `section`: the stiffness of the section with the water's level, if there is one.
template <int D>
Newmark weights(const RigidBody<D>& body, const std::optional<TwistMatrix<D>>& section, double dt)
{
    if (!body.spring && !section)
        return {};
    double s = 0;
    if (body.spring)
        s = (body.spring->stiffness * dt + body.spring->damping) * dt * mobility(body);
    if (section)
        s += dt * dt * squared_frequencies<D>(body, *section);
    const double delta = s * s / (16 + s * s);
    return {delta, 0.5 + delta, 0.25 * (1 + delta) * (1 + delta)};
}

template <int D>
std::optional<TwistMatrix<D>> section_stiffness(const RigidBody<D>& body)
{
    if (!body.water)
        return {};
    const TwistMatrix<D> stiffness = displacement(body).stiffness;
    return stiffness.isZero(0) ? std::nullopt : std::optional(stiffness);
}

// The same impulse for the present pose: of a wrench on a hinged body only the moment about the axis at the pose it acted at
// counts.
template <int D>
Twist<D> carried(const Twist<D>& wrench_then, const RigidBody<D>& then)
{
    if (!then.hinge)
        return wrench_then;
    Twist<D> carried = Twist<D>::Zero();
    carried.template tail<spin_size<D>>() = hinged_twist(then, 1.0).dot(wrench_then) * then.hinge->axis;
    return carried;
}

} // namespace

template <int D>
Twist<D> spring_wrench(const RigidBody<D>& body)
{
    if (!body.spring)
        return Twist<D>::Zero();
    const PointJacobian<D> J = origin_jacobian(body);
    return elastic_wrench(body) - body.spring->damping * (J.transpose() * (J * body.twist));
}

template <int D>
double spring_energy(const RigidBody<D>& body)
{
    return body.spring ? 0.5 * body.spring->stiffness * (body.spring->anchor - body.pose.position).squaredNorm() : 0.0;
}

template <int D>
TwistMatrix<D> stiffness_inertia(const RigidBody<D>& body, double dt)
{
    const std::optional<TwistMatrix<D>> section = section_stiffness(body);
    TwistMatrix<D> inertia = TwistMatrix<D>::Zero();
    if (!body.spring && !section)
        return inertia;
    const Newmark w = weights(body, section, dt);
    const PointJacobian<D> J = origin_jacobian(body);
    if (body.spring)
        inertia = dt * (w.beta * dt * body.spring->stiffness + w.gamma * body.spring->damping) * (J.transpose() * J);
    if (section)
        inertia += w.beta * dt * dt * *section;
    return inertia;
}

template <int D>
Twist<D> forced_twist(const RigidBody<D>& body, const Vec<D>& gravity, double fluid_density, double dt)
{
    const std::optional<TwistMatrix<D>> section = section_stiffness(body);
    const Newmark w = weights(body, section, dt);
    const Twist<D> V = body.hinge ? hinged_twist(body, hinge_rate(body, body.angular_momentum)) : body.twist;
    RigidBody<D> middle = body;
    const double back = -(0.5 - w.delta) * dt;
    displace<D>(middle, back * V.template head<D>(), back * V.template tail<spin_size<D>>());
    Twist<D> at_middle = explicit_wrench<D>(middle, gravity, fluid_density);
    if (!body.spring && !section)
        return twist_after<D>(body, dt * carried(at_middle, middle));

    if (body.spring)
        at_middle += elastic_wrench(middle);
    Twist<D> p = momentum(body) + dt * carried(at_middle, middle);
    if (body.spring) {
        const double stiffness = w.beta * dt * dt * body.spring->stiffness, damping = dt * body.spring->damping;
        const PointJacobian<D> J = origin_jacobian(body);
        p += (stiffness - (1 - w.gamma) * damping) * (J.transpose() * (J * V));
    }
    if (section)
        p += w.beta * dt * dt * (*section * V);
    return impulse_response(body, p, dt);
}

template <int D>
Twist<D> impulse_response(const RigidBody<D>& body, const Twist<D>& impulse, double dt)
{
    return admissible_response<D>(admissible_twists(body), mass_matrix(body) + stiffness_inertia(body, dt), impulse);
}

template <int D>
double spring_frequency(const RigidBody<D>& body)
{
    return body.spring ? std::sqrt(body.spring->stiffness * mobility(body)) : 0.0;
}

template <int D>
double swing_frequency(const RigidBody<D>& body, const Vec<D>& gravity, double fluid_density)
{
    if (!body.hinge)
        return 0;
    const Twist<D> turn = hinged_twist(body, 1.0), w = explicit_wrench(body, gravity, fluid_density);
    double moment = w.template head<D>().norm() * turn.template head<D>().norm();
    if (body.spring)
        moment +=
            body.spring->stiffness * (body.spring->anchor - body.pose.position).norm() * (origin_jacobian(body) * turn).norm();
    return std::sqrt(moment / turn.dot(mass_matrix(body) * turn));
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Twist<D> spring_wrench<D>(const RigidBody<D>&);                                                                   \
    template double spring_energy<D>(const RigidBody<D>&);                                                                     \
    template TwistMatrix<D> stiffness_inertia<D>(const RigidBody<D>&, double);                                                 \
    template Twist<D> forced_twist<D>(const RigidBody<D>&, const Vec<D>&, double, double);                                     \
    template Twist<D> impulse_response<D>(const RigidBody<D>&, const Twist<D>&, double);                                       \
    template double spring_frequency<D>(const RigidBody<D>&);                                                                  \
    template double swing_frequency<D>(const RigidBody<D>&, const Vec<D>&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
