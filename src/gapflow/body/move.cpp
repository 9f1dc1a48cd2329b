// x^{n+1} = x^n + dt (V^n + dt/2 A),       A = (V^n - V^{n-1}) / dt^{n-1}, extrapolated over the step
// q^{n+1} = exp(dt omega_m) q^n,           omega_m = I(q_m)^-1 (L^n + dt/2 L'),  q_m = exp(dt/2 omega_m) q^n
//
// A hinged body turns about its axis by theta^{n+1} - theta^n = dt (rate^n + dt/2 rate'), its centre of mass follows.
//
// Implicit Lie midpoint: symmetric, second order, exact for |L| of a free body (L is not touched), energy without drift
// (Simo & Wong, Int. J. Numer. Meth. Eng. 31, 1991; Hairer, Lubich & Wanner, Geometric Numerical Integration, VII.5).
#include "gapflow/body/move.hpp"

#include "gapflow/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace gapflow {

namespace {

Mat<3> cross_matrix(const Vec<3>& a)
{
    return (Mat<3>() << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0).finished();
}

// Angular velocity at mid-step, by Newton for g(omega) = omega - J(q_m) L, J = I^-1 in the components that move.
// A turn d(theta) of q_m changes I by [d theta] I - I [d theta], so with w = J L
//     d(J L) = -J ([d theta] I - I [d theta]) w = J ([I w] - I [w]) d theta,   d theta = (dt/2) (1 + [phi]/2 + ...) d omega,
// phi = dt/2 omega. Truncation of the series only costs a few iterations.
Vec<3> midpoint_angular_velocity(const RigidBody<3>& body, const Vec<3>& L, double dt)
{
    constexpr double round_off = 4 * std::numeric_limits<double>::epsilon();
    Vec<3> omega = angular_velocity<3>(body, body.pose.rotation, L);
    double last_change = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < 30; ++iteration) {
        const Vec<3> phi = 0.5 * dt * omega;
        const Rotation<3> middle = rotation_of<3>(phi) * body.pose.rotation;
        const Mat<3> I = world_inertia(body, middle);
        const Vec<3> w = angular_velocity<3>(body, middle, L);
        const Mat<3> twist_to_torque = cross_matrix(I * w) - I * cross_matrix(w);
        Mat<3> jacobian = Mat<3>::Identity();
        const Mat<3> turn = 0.5 * dt * (Mat<3>::Identity() + 0.5 * cross_matrix(phi));
        for (int k = 0; k < 3; ++k)
            jacobian.col(k) -= angular_velocity<3>(body, middle, twist_to_torque * turn.col(k));
        const Vec<3> change = jacobian.inverse() * (w - omega);
        omega += change;
        const double size = change.norm();
        if (size <= round_off * omega.norm() || (size >= last_change && size <= 100 * round_off * omega.norm()))
            return omega;
        last_change = size;
    }
    throw ComputationError("body '" + body.name + "' turns by " + std::to_string(dt * omega.norm()) +
                           " radians in one step, too much for the time integration; use a smaller time.max_step or cfl");
}

} // namespace

template <int D>
void move(RigidBody<D>& body, double time, double dt)
{
    if (body.motion == Motion::fixed)
        return;
    if (body.motion == Motion::prescribed) {
        body.pose = (*body.prescribed)(time + dt);
        return;
    }
    const Vec<D> shift = dt * (body.twist.template head<D>() + 0.5 * dt * body.acceleration);
    const Spin<D> L = body.angular_momentum + 0.5 * dt * body.angular_momentum_rate;
    Spin<D> omega;
    if (body.hinge)
        omega = hinge_rate(body, L) * body.hinge->axis;
    else if constexpr (D == 2)
        omega = angular_velocity<2>(body, body.pose.rotation, L);
    else
        omega = midpoint_angular_velocity(body, L, dt);
    displace<D>(body, shift, dt * omega);
}

template <int D>
Twist<D> predicted_twist(const RigidBody<D>& body, double time, double dt)
{
    if (body.motion == Motion::fixed)
        return Twist<D>::Zero();
    if (body.motion == Motion::prescribed)
        return prescribed_twist<D>(*body.prescribed, body.centre_of_mass, time, time + dt);
    if (body.hinge)
        return hinged_twist(body, hinge_rate<D>(body, body.angular_momentum + dt * body.angular_momentum_rate));
    Twist<D> impulse;
    impulse << dt * body.mass * body.acceleration, dt * body.angular_momentum_rate;
    return twist_after(body, impulse);
}

template <int D>
double lasting_part(const RigidBody<D>& body, const Twist<D>& acceleration, const Twist<D>& before, double least)
{
    const TwistMatrix<D> mass = mass_matrix(body) / body.mass;
    const auto size = [&](const Twist<D>& a) { return std::sqrt(a.dot(mass * a)); };
    const double now = size(acceleration), most = std::max(2 * size(before), least);
    return now > most ? most / now : 1.0;
}

template void move<2>(RigidBody<2>&, double, double);
template void move<3>(RigidBody<3>&, double, double);
template double lasting_part<2>(const RigidBody<2>&, const Twist<2>&, const Twist<2>&, double);
template double lasting_part<3>(const RigidBody<3>&, const Twist<3>&, const Twist<3>&, double);
template Twist<2> predicted_twist<2>(const RigidBody<2>&, double, double);
template Twist<3> predicted_twist<3>(const RigidBody<3>&, double, double);

} // namespace gapflow
