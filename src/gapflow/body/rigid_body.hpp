// State of a rigid body: its pose, mass and momentum, and the forces on it other than the fluid's.
//
// Twists, wrenches and momenta are in world axes about the centre of mass.
#pragma once

#include "gapflow/body/prescribed_motion.hpp"
#include "gapflow/geometry/solid.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace gapflow {

template <int D>
using SpinMatrix = Eigen::Matrix<double, spin_size<D>, spin_size<D>>;

/// A point of the world, in 3D an axis, that the body only turns about.
template <int D>
struct Hinge {
    Vec<D> point;
    Spin<D> axis; ///< unit vector in the world; 2D: 1
    Vec<D> arm;   ///< from the point to the centre of mass, in the shape's frame
};

/// Pulls the shape's origin towards a point of the world: force stiffness * (anchor - origin) - damping * (its velocity).
template <int D>
struct Spring {
    Vec<D> anchor;
    double stiffness = 0.0;
    double damping = 0.0;
};

/// A level of fluid at rest with air above.
template <int D>
struct WaterLevel {
    Plane<D> plane;               ///< in the world: fluid is where normal . x <= offset, and gravity is against the normal
    double specific_weight = 0.0; ///< of the fluid: density times |gravity|
};

/// A prescribed body's motion set by a controller: constant velocity from a given pose and time on.
template <int D>
struct SteeredMotion {
    double since = 0.0;
    Pose<D> start;
    Vec<D> velocity = Vec<D>::Zero(); ///< of the centre of mass
    Spin<D> angular_velocity = Spin<D>::Zero();
};

template <int D>
struct RigidBody {
    std::string name;
    std::shared_ptr<const Shape<D>> shape;
    Motion motion = Motion::free;

    Pose<D> pose;                             ///< of the shape's origin
    Vec<D> centre_of_mass = Vec<D>::Zero();   ///< in the shape's frame
    Vec<D> centre_of_volume = Vec<D>::Zero(); ///< in the shape's frame
    double volume = 0.0;                      ///< of fluid displaced; negative for a container (shape inside out)
    double mass = 1.0;
    SpinMatrix<D> inertia = SpinMatrix<D>::Identity(); ///< about the centre of mass, body axes
    std::array<bool, twist_size<D>> can_move;          ///< false: this component of the twist is held at 0
    std::optional<Hinge<D>> hinge;                     ///< needs can_move all true
    std::optional<Spring<D>> spring;
    std::optional<WaterLevel<D>> water; ///< that the body may float in; none: the fluid is all around it

    Twist<D> twist = Twist<D>::Zero();
    /// L: kept from step to step, so that free tumbling conserves it; inertia(R) omega = L in the components that move.
    Spin<D> angular_momentum = Spin<D>::Zero();
    Vec<D> acceleration = Vec<D>::Zero(); ///< over the last step, the part to extrapolate; 0 at the start and after an impact
    Spin<D> angular_momentum_rate = Spin<D>::Zero(); ///< likewise

    Vec<D> force = Vec<D>::Zero();                         ///< constant external force at the centre of mass
    Spin<D> torque = Spin<D>::Zero();                      ///< constant external torque about the centre of mass
    std::shared_ptr<const PrescribedMotion<D>> prescribed; ///< where motion is prescribed
    std::optional<SteeredMotion<D>> steered;               ///< the motion in `prescribed` if a controller has set it

    RigidBody() { can_move.fill(true); }
    /// World position of the centre of mass.
    Vec<D> centre() const { return pose.position + pose.matrix() * centre_of_mass; }
};

/// Takes volume and centre of volume from the shape, mass and inertia from them: the centre of mass is the centre of volume.
template <int D>
void set_density(RigidBody<D>& body, double density);
/// Takes volume and centre of volume from the shape; the centre of mass is put into the centre of volume.
template <int D>
void set_mass(RigidBody<D>& body, double mass, const SpinMatrix<D>& inertia);

/// Puts the body (its centre of mass) somewhere: pose such that centre() = centre.
template <int D>
void place(RigidBody<D>& body, const Vec<D>& centre, const Rotation<D>& rotation);

/// Sets the motion of a prescribed body from now on.
template <int D>
void steer(RigidBody<D>& body, const SteeredMotion<D>& motion);

/// Lets the body, where it is now, only turn about a point; 3D: about an axis of unit length through it.
template <int D>
void attach_hinge(RigidBody<D>& body, const Vec<D>& point, const Spin<D>& axis);
/// Turns the body by an angle vector and shifts its centre of mass; a hinged body only turns, about its hinge, along its axis.
template <int D>
void displace(RigidBody<D>& body, const Vec<D>& shift, const Spin<D>& angle);

/// R I R^T: inertia about the centre of mass in world axes, at the body's rotation or another one.
template <int D>
SpinMatrix<D> world_inertia(const RigidBody<D>& body);
template <int D>
SpinMatrix<D> world_inertia(const RigidBody<D>& body, const Rotation<D>& rotation);
/// diag(m 1, R I R^T).
template <int D>
TwistMatrix<D> mass_matrix(const RigidBody<D>& body);
/// Angular velocity of the body at a rotation with angular momentum L, in the components that can move (0 in the others).
template <int D>
Spin<D> angular_velocity(const RigidBody<D>& body, const Rotation<D>& rotation, const Spin<D>& angular_momentum);

/// The twist that a hinged body has when it turns about its hinge at a rate, at its present pose.
template <int D>
Twist<D> hinged_twist(const RigidBody<D>& body, double rate);
/// Rate of a hinged body whose angular momentum about the centre of mass is L.
template <int D>
double hinge_rate(const RigidBody<D>& body, const Spin<D>& angular_momentum);

/// (m V, L). A hinged body's velocity turns with it: V is that of its present pose.
template <int D>
Twist<D> momentum(const RigidBody<D>& body);
/// Angular momentum about a point of the world: L + (centre - point) x m V.
template <int D>
Spin<D> angular_momentum_about(const RigidBody<D>& body, const Vec<D>& point);
template <int D>
double kinetic_energy(const RigidBody<D>& body);

/// What of the body is in the fluid: all of it, or what is below the water's level. World axes.
template <int D>
struct Displacement {
    double volume;
    Vec<D> arm; ///< from the centre of mass to the centre of that volume
    /// How the buoyancy's wrench falls as the body rises and tilts, by the section with the water's level alone: symmetric, not negative. The
    /// shift of the displaced volume's centre as the body tilts is not in it.
    TwistMatrix<D> stiffness = TwistMatrix<D>::Zero();
};
template <int D>
Displacement<D> displacement(const RigidBody<D>& body);
/// Gravity's energy of the body and of the fluid that it displaces, up to a constant: its derivative along the body's motion is that of gravity's and
/// buoyancy's wrench.
template <int D>
double gravity_energy(const RigidBody<D>& body, const Vec<D>& gravity, double fluid_density);

/// Force and torque about the centre of mass that depend neither on the flow nor on a spring: external ones, and gravity in
/// reduced-pressure form, (mass - fluid_density * volume displaced) g, the buoyant part acting at the centre of that volume.
template <int D>
Twist<D> explicit_wrench(const RigidBody<D>& body, const Vec<D>& gravity, double fluid_density);
/// Twist at the present pose once `impulse` has been added to the momentum: the admissible twist V with
/// B^T M V = B^T ((m V, L) + impulse), B the basis of the admissible ones.
template <int D>
Twist<D> twist_after(const RigidBody<D>& body, const Twist<D>& impulse);

/// Twist at the start: no acceleration.
template <int D>
void set_initial_twist(RigidBody<D>& body, const Twist<D>& twist);
/// Sets the twist at the end of a step of length dt, with L = I omega at the present pose, and stores the change over the
/// step as acceleration: the share `lasting` of it, which is extrapolated (after an impact none).
template <int D>
void finish_step(RigidBody<D>& body, const Twist<D>& twist_next, double dt, double lasting = 1);

/// The body as a solid for grid and films. Refers to the body's shape.
template <int D>
Solid<D> solid_of(const RigidBody<D>& body);

} // namespace gapflow
