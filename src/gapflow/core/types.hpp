// Small vectors and rigid motion in D = 2 or 3 dimensions.
//
// A twist is (V, omega): velocity of the reference point and angular velocity (1 number in 2D, 3 in 3D).
// A wrench is (F, torque) about the same point; wrench . twist is a power (or, for area vectors, a volume flux).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace gapflow {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>;
template <int D>
using Mat = Eigen::Matrix<double, D, D>;
/// Integer index of a cell, face or node of the grid; the first axis runs fastest in memory.
template <int D>
using Index = Eigen::Matrix<int, D, 1>;

/// Number of components of an angular velocity.
template <int D>
inline constexpr int spin_size = D == 2 ? 1 : 3;
/// Number of degrees of freedom of a rigid body.
template <int D>
inline constexpr int twist_size = D + spin_size<D>;

template <int D>
using Spin = Eigen::Matrix<double, spin_size<D>, 1>;
template <int D>
using Twist = Eigen::Matrix<double, twist_size<D>, 1>;
template <int D>
using TwistMatrix = Eigen::Matrix<double, twist_size<D>, twist_size<D>>;

/// a x b: the moment of force b with lever a (a number in 2D).
template <int D>
Spin<D> moment(const Vec<D>& a, const Vec<D>& b)
{
    if constexpr (D == 2)
        return Spin<2>(a[0] * b[1] - a[1] * b[0]);
    else
        return a.cross(b);
}

/// omega x r: the velocity of a point at r from the axis.
template <int D>
Vec<D> spin_velocity(const Spin<D>& omega, const Vec<D>& r)
{
    if constexpr (D == 2)
        return Vec<2>(-omega[0] * r[1], omega[0] * r[0]);
    else
        return omega.cross(r);
}

/// (f, arm x f): the wrench about a point of a force (or area vector) f that acts at `arm` from it.
template <int D>
Twist<D> wrench(const Vec<D>& f, const Vec<D>& arm)
{
    Twist<D> w;
    w << f, moment<D>(arm, f);
    return w;
}

/// Rigid velocity field V + omega x arm of a twist.
template <int D>
Vec<D> velocity_at(const Twist<D>& twist, const Vec<D>& arm)
{
    return twist.template head<D>() + spin_velocity<D>(twist.template tail<spin_size<D>>(), arm);
}

/// Unit vector along an axis.
template <int D>
Vec<D> unit(int axis)
{
    return Vec<D>::Unit(axis);
}

/// Unit step of an index along an axis.
template <int D>
Index<D> step(int axis)
{
    return Index<D>::Unit(axis);
}

} // namespace gapflow
