// Motion given by the user: the pose of a body's shape as a function of time.
#pragma once

#include "gapflow/geometry/pose.hpp"
#include "gapflow/scene/scene.hpp"

#include <functional>

namespace gapflow {

/// Pose of the shape's origin at a time.
template <int D>
using PrescribedMotion = std::function<Pose<D>(double time)>;

/// exp(angle vector) as a rotation, and back. The quaternion's angle vector is at most pi long.
template <int D>
Rotation<D> rotation_of(const Spin<D>& angle);
/// Angle vector, world axes, of the rotation that leads from one orientation to another (2D: of any number of turns).
template <int D>
Spin<D> angle_between(const Rotation<D>& from, const Rotation<D>& to);

/// Centre of mass moving at a constant velocity while the body turns about it at a constant angular velocity (world axes),
/// from `start` at time 0. Exact rotation.
template <int D>
PrescribedMotion<D> constant_motion(const Pose<D>& start, const Vec<D>& centre_of_mass, const Vec<D>& velocity,
                                    const Spin<D>& angular_velocity);
/// Rows x,y,angle (2D) or x,y,z,qw,qx,qy,qz (3D; normalised here), held constant beyond the ends. Between rows as the table says: linear, slerp
/// for quaternions; or cubic, with the velocities at the rows behind these values (2D: vx,vy,omega, of the origin; NaN: not given) or those of
/// a smooth curve through the rows (row_slopes()). The table has at least one row.
template <int D>
PrescribedMotion<D> table_motion(const TimeTable& table);

/// Mean twist over t0..t1 about the centre of mass, world axes: displacement of the centre and angle vector between the two
/// poses, over t1 - t0. A flux of this twist over the step matches the change of geometry.
template <int D>
Twist<D> prescribed_twist(const PrescribedMotion<D>& motion, const Vec<D>& centre_of_mass, double t0, double t1);

} // namespace gapflow
