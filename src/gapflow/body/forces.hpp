// Forces on a body other than the fluid's motion exerts, over one time step: constant ones, gravity with buoyancy, springs.
//
// Velocities come from the coupled solve at t^{n+1}; poses have moved there before it, extrapolated (stage 3), and so lag by
// dt/2 (V^n - V^{n-1}) behind the trapezoidal rule's. With x the pose at t^{n+1}, a force that depends on the pose is taken at
//
//     x - (1/2 - delta) dt V^n + beta dt (V^{n+1} - V^n),       damping at (1 - gamma) V^n + gamma V^{n+1},
//
// which is Newmark's method with gamma = 1/2 + delta and beta = (1 + delta)^2 / 4 (N. M. Newmark, J. Eng. Mech. Div. 85,
// 1959): the extrapolation's lag cancels. Terms with V^{n+1} join the mass matrix. delta = s^2 / (16 + s^2), with
// s = (stiffness dt^2 + damping dt) / (effective mass at the spring's point), is the trapezoidal rule as long as the period is
// resolved and damps unresolved oscillations, for any stiffness. Gravity on a hinged body is taken with beta = 0 (the leapfrog rule). A float's
// buoyancy is like a spring with the stiffness of its section with the water's level; s then has dt^2 times the sum of its squared frequencies, too.
#pragma once

#include "gapflow/body/rigid_body.hpp"

namespace gapflow {

/// Wrench of the spring about the centre of mass, at the present pose and twist; 0 without a spring.
template <int D>
Twist<D> spring_wrench(const RigidBody<D>& body);
/// Energy stored in the spring, 1/2 stiffness |anchor - origin|^2.
template <int D>
double spring_energy(const RigidBody<D>& body);

/// Mass matrix that the implicit part of a spring and of a float's buoyancy add in a step of length dt; at the pose after the body has moved.
template <int D>
TwistMatrix<D> stiffness_inertia(const RigidBody<D>& body, double dt);

/// V* of the method for a body that has moved over a step: its twist after all forces but the fluid's, at its present pose,
/// (M + stiffness_inertia)^-1 applied to the admissible part of momentum and impulse.
template <int D>
Twist<D> forced_twist(const RigidBody<D>& body, const Vec<D>& gravity, double fluid_density, double dt);

/// Change of forced_twist() by an impulse.
template <int D>
Twist<D> impulse_response(const RigidBody<D>& body, const Twist<D>& impulse, double dt);

/// Highest angular frequency of the body on its spring, without the fluid's added mass (which lowers it); 0 without a spring.
template <int D>
double spring_frequency(const RigidBody<D>& body);
/// Bound of the angular frequency at which a hinged body swings under constant forces, gravity and its spring's pull, without
/// the fluid's added mass; 0 without a hinge.
template <int D>
double swing_frequency(const RigidBody<D>& body, const Vec<D>& gravity, double fluid_density);

} // namespace gapflow
