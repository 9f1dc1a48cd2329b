// Newton and Euler for one body:  m V' = F,  L' = T,  L = I(q) omega,  I(q) = R I_body R^T.
//
// Reduced pressure p - rho g.x: the fluid gets no gravity, a body of volume V_b gets m g at its centre of mass and
// -rho V_b g at its centre of volume (method, "The time step"). Of a float V_b is the part below the water's level ("Surface sides").
#include "gapflow/body/rigid_body.hpp"

#include "gapflow/body/constraint.hpp"
#include "gapflow/geometry/part_below.hpp"

#include <cmath>

namespace gapflow {

namespace {

template <int D>
MassProperties<D> displaced(RigidBody<D>& body)
{
    const MassProperties<D> p = body.shape->mass_properties();
    body.volume = body.shape->inside_out() ? -p.volume : p.volume;
    body.centre_of_volume = body.centre_of_mass = p.centre;
    return p;
}

} // namespace

template <int D>
void set_density(RigidBody<D>& body, double density)
{
    const MassProperties<D> p = displaced(body);
    body.mass = density * p.volume;
    body.inertia = density * p.inertia;
}

template <int D>
void set_mass(RigidBody<D>& body, double mass, const SpinMatrix<D>& inertia)
{
    displaced(body);
    body.mass = mass;
    body.inertia = inertia;
}

template <int D>
void place(RigidBody<D>& body, const Vec<D>& centre, const Rotation<D>& rotation)
{
    body.pose.rotation = rotation;
    body.pose.position = centre - body.pose.matrix() * body.centre_of_mass;
}

template <int D>
void steer(RigidBody<D>& body, const SteeredMotion<D>& motion)
{
    body.steered = motion;
    const PrescribedMotion<D> course =
        constant_motion<D>(motion.start, body.centre_of_mass, motion.velocity, motion.angular_velocity);
    body.prescribed =
        std::make_shared<PrescribedMotion<D>>([course, since = motion.since](double time) { return course(time - since); });
}

template <int D>
void attach_hinge(RigidBody<D>& body, const Vec<D>& point, const Spin<D>& axis)
{
    body.hinge = Hinge<D>{point, axis, body.pose.matrix().transpose() * (body.centre() - point)};
}

template <int D>
void displace(RigidBody<D>& body, const Vec<D>& shift, const Spin<D>& angle)
{
    Rotation<D> rotation = rotation_of<D>(angle) * body.pose.rotation;
    if constexpr (D == 3)
        rotation.normalize();
    // From the hinge each time: steps leave no drift.
    place(body, body.hinge ? Vec<D>(body.hinge->point + rotation * body.hinge->arm) : Vec<D>(body.centre() + shift), rotation);
}

template <int D>
SpinMatrix<D> world_inertia(const RigidBody<D>& body, const Rotation<D>& rotation)
{
    if constexpr (D == 2) {
        return body.inertia;
    } else {
        const Mat<3> R = rotation.toRotationMatrix();
        return R * body.inertia * R.transpose();
    }
}

template <int D>
SpinMatrix<D> world_inertia(const RigidBody<D>& body)
{
    return world_inertia(body, body.pose.rotation);
}

template <int D>
TwistMatrix<D> mass_matrix(const RigidBody<D>& body)
{
    TwistMatrix<D> M = TwistMatrix<D>::Zero();
    M.template topLeftCorner<D, D>().diagonal().setConstant(body.mass);
    M.template bottomRightCorner<spin_size<D>, spin_size<D>>() = world_inertia(body);
    return M;
}

template <int D>
Spin<D> angular_velocity(const RigidBody<D>& body, const Rotation<D>& rotation, const Spin<D>& angular_momentum)
{
    if constexpr (D == 2) {
        return body.can_move[2] ? Spin<2>(angular_momentum / body.inertia(0, 0)) : Spin<2>(0.0);
    } else {
        Mat<3> I = world_inertia(body, rotation);
        Vec<3> L = angular_momentum;
        for (int k = 0; k < 3; ++k)
            if (!body.can_move[3 + k]) { // row and column of the identity: omega_k = 0
                I.row(k).setZero();
                I.col(k).setZero();
                I(k, k) = 1;
                L[k] = 0;
            }
        return I.inverse() * L;
    }
}

template <int D>
Twist<D> hinged_twist(const RigidBody<D>& body, double rate)
{
    const Spin<D> omega = rate * body.hinge->axis;
    Twist<D> twist;
    twist << spin_velocity<D>(omega, body.centre() - body.hinge->point), omega;
    return twist;
}

// The inertia about an axis does not change as the body turns about it.
template <int D>
double hinge_rate(const RigidBody<D>& body, const Spin<D>& angular_momentum)
{
    const Spin<D>& axis = body.hinge->axis;
    return axis.dot(angular_momentum) / axis.dot(world_inertia(body) * axis);
}

template <int D>
Twist<D> momentum(const RigidBody<D>& body)
{
    const Twist<D> twist = body.hinge ? hinged_twist(body, hinge_rate(body, body.angular_momentum)) : body.twist;
    Twist<D> p;
    p << body.mass * twist.template head<D>(), body.angular_momentum;
    return p;
}

template <int D>
Spin<D> angular_momentum_about(const RigidBody<D>& body, const Vec<D>& point)
{
    return body.angular_momentum + moment<D>(body.centre() - point, Vec<D>(momentum(body).template head<D>()));
}

template <int D>
double kinetic_energy(const RigidBody<D>& body)
{
    return 0.5 * body.twist.dot(mass_matrix(body) * body.twist);
}

namespace {

// With N the velocity along n, the way up, of a point of the section per twist: the integral of specific_weight N^T N over the section.
template <int D>
TwistMatrix<D> section_stiffness(const PartBelow<D>& part, const Vec<D>& n, double specific_weight)
{
    // By integrals over the section about the centre of mass. N = (n, r x n), with r moment<D>(r, n) is linear in r.
    Eigen::Matrix<double, twist_size<D>, D> slope = Eigen::Matrix<double, twist_size<D>, D>::Zero(); // N^T = (n, 0) + slope r
    for (int k = 0; k < D; ++k)
        slope.col(k).template tail<spin_size<D>>() = moment<D>(unit<D>(k), n);
    Twist<D> rise = Twist<D>::Zero();
    rise.template head<D>() = n;
    const Twist<D> tilt = slope * part.section_moment;
    return specific_weight * (part.section * rise * rise.transpose() + rise * tilt.transpose() + tilt * rise.transpose() +
                              slope * part.section_square * slope.transpose());
}

} // namespace

template <int D>
Displacement<D> displacement(const RigidBody<D>& body)
{
    const Mat<D> rotation = body.pose.matrix();
    const Displacement<D> whole{body.volume, rotation * (body.centre_of_volume - body.centre_of_mass)};
    if (!body.water || body.volume == 0)
        return whole;
    const Vec<D> n = body.water->plane.normal, up = rotation.transpose() * n;
    const Plane<D> level{up, body.water->plane.offset - n.dot(body.pose.position)}; // in the shape's frame
    const Bounds<D> bounds = body.shape->bounds();
    const double middle = up.dot(0.5 * (bounds.low + bounds.high)), reach = up.cwiseAbs().dot(0.5 * (bounds.high - bounds.low));
    if (middle + reach <= level.offset)
        return whole;
    if (middle - reach >= level.offset)
        return {0, Vec<D>::Zero()};
    PartBelow<D> part = part_below(*body.shape, level);
    Displacement<D> result{part.volume, Vec<D>::Zero()};
    if (part.volume != 0)
        result.arm = rotation * (part.moment / part.volume - body.centre_of_mass);
    if (body.shape->inside_out()) // its stiffness is negative
        return result;
    const Vec<D> c = body.centre_of_mass, m = part.section_moment;
    part.section_square += -m * c.transpose() - c * m.transpose() + part.section * c * c.transpose();
    part.section_square = rotation * part.section_square * rotation.transpose();
    part.section_moment = rotation * (m - part.section * c);
    result.stiffness = section_stiffness<D>(part, n, body.water->specific_weight);
    return result;
}

template <int D>
double gravity_energy(const RigidBody<D>& body, const Vec<D>& gravity, double fluid_density)
{
    const Displacement<D> displaced = displacement(body);
    const double level = body.water ? body.water->plane.offset * body.water->specific_weight : 0.0;
    return -body.mass * gravity.dot(body.centre()) + level * displaced.volume +
           fluid_density * displaced.volume * gravity.dot(body.centre() + displaced.arm);
}

template <int D>
Twist<D> explicit_wrench(const RigidBody<D>& body, const Vec<D>& gravity, double fluid_density)
{
    const Displacement<D> displaced = displacement(body);
    const Vec<D> buoyancy = -fluid_density * displaced.volume * gravity;
    Twist<D> w;
    w << body.force + (body.mass - fluid_density * displaced.volume) * gravity,
        body.torque + moment<D>(displaced.arm, buoyancy);
    return w;
}

template <int D>
Twist<D> twist_after(const RigidBody<D>& body, const Twist<D>& impulse)
{
    const Twist<D> p = momentum(body) + impulse;
    if (constrained(body))
        return admissible_response<D>(admissible_twists(body), mass_matrix(body), p);
    Twist<D> twist;
    twist << p.template head<D>() / body.mass, angular_velocity<D>(body, body.pose.rotation, p.template tail<spin_size<D>>());
    return twist;
}

template <int D>
void set_initial_twist(RigidBody<D>& body, const Twist<D>& twist)
{
    body.twist = twist;
    body.angular_momentum = world_inertia(body) * twist.template tail<spin_size<D>>();
    body.acceleration.setZero();
    body.angular_momentum_rate.setZero();
}

template <int D>
void finish_step(RigidBody<D>& body, const Twist<D>& twist_next, double dt, double lasting)
{
    const Vec<D> V = body.twist.template head<D>();
    const Spin<D> L = body.angular_momentum;
    set_initial_twist(body, twist_next);
    body.acceleration = lasting * (body.twist.template head<D>() - V) / dt;
    body.angular_momentum_rate = lasting * (body.angular_momentum - L) / dt;
}

template <int D>
Solid<D> solid_of(const RigidBody<D>& body)
{
    return {body.name, PlacedShape<D>(*body.shape, body.pose), body.centre(), body.motion, false, admissible_projector(body)};
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void set_density<D>(RigidBody<D>&, double);                                                                       \
    template void set_mass<D>(RigidBody<D>&, double, const SpinMatrix<D>&);                                                    \
    template void place<D>(RigidBody<D>&, const Vec<D>&, const Rotation<D>&);                                                  \
    template void steer<D>(RigidBody<D>&, const SteeredMotion<D>&);                                                            \
    template void attach_hinge<D>(RigidBody<D>&, const Vec<D>&, const Spin<D>&);                                               \
    template void displace<D>(RigidBody<D>&, const Vec<D>&, const Spin<D>&);                                                   \
    template Twist<D> hinged_twist<D>(const RigidBody<D>&, double);                                                            \
    template double hinge_rate<D>(const RigidBody<D>&, const Spin<D>&);                                                        \
    template SpinMatrix<D> world_inertia<D>(const RigidBody<D>&);                                                              \
    template SpinMatrix<D> world_inertia<D>(const RigidBody<D>&, const Rotation<D>&);                                          \
    template TwistMatrix<D> mass_matrix<D>(const RigidBody<D>&);                                                               \
    template Spin<D> angular_velocity<D>(const RigidBody<D>&, const Rotation<D>&, const Spin<D>&);                             \
    template Twist<D> momentum<D>(const RigidBody<D>&);                                                                        \
    template Spin<D> angular_momentum_about<D>(const RigidBody<D>&, const Vec<D>&);                                            \
    template double kinetic_energy<D>(const RigidBody<D>&);                                                                    \
    template Displacement<D> displacement<D>(const RigidBody<D>&);                                                             \
    template double gravity_energy<D>(const RigidBody<D>&, const Vec<D>&, double);                                             \
    template Twist<D> explicit_wrench<D>(const RigidBody<D>&, const Vec<D>&, double);                                          \
    template Twist<D> twist_after<D>(const RigidBody<D>&, const Twist<D>&);                                                    \
    template void set_initial_twist<D>(RigidBody<D>&, const Twist<D>&);                                                        \
    template void finish_step<D>(RigidBody<D>&, const Twist<D>&, double, double);                                              \
    template Solid<D> solid_of<D>(const RigidBody<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
