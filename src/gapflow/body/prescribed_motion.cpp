// Poses given in time. Between two orientations the body turns at constant angular velocity (slerp; Shoemake, SIGGRAPH 1985),
// so the mean angular velocity of a step inside one row is the exact one.
#include "gapflow/body/prescribed_motion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace gapflow {

template <int D>
Rotation<D> rotation_of(const Spin<D>& angle)
{
    if constexpr (D == 2) {
        return Rotation<2>(angle[0]);
    } else {
        // sin(t/2)/t by its series near 0, where the quotient is undefined.
        const double t = angle.norm();
        const double s = t < 1e-4 ? 0.5 - t * t / 48 : std::sin(0.5 * t) / t;
        return Rotation<3>(std::cos(0.5 * t), s * angle[0], s * angle[1], s * angle[2]);
    }
}

template <int D>
Spin<D> angle_between(const Rotation<D>& from, const Rotation<D>& to)
{
    if constexpr (D == 2) {
        return Spin<2>(to.angle() - from.angle());
    } else {
        Rotation<3> q = to * from.conjugate();
        if (q.w() < 0)
            q.coeffs() = -q.coeffs();
        const double s = q.vec().norm();
        const double factor = s < 1e-8 ? 2.0 : 2 * std::atan2(s, q.w()) / s;
        return factor * q.vec();
    }
}

template <int D>
PrescribedMotion<D> constant_motion(const Pose<D>& start, const Vec<D>& centre_of_mass, const Vec<D>& velocity,
                                    const Spin<D>& angular_velocity)
{
    const Vec<D> arm = start.matrix() * centre_of_mass, origin = start.position;
    return [=](double time) {
        Pose<D> pose;
        const Rotation<D> turn = rotation_of<D>(time * angular_velocity);
        pose.rotation = turn * start.rotation;
        pose.position = origin + time * velocity + (arm - turn * arm);
        return pose;
    };
}

namespace {

template <int D>
Pose<D> pose_of_row(const std::vector<double>& row)
{
    Pose<D> pose;
    pose.position = Eigen::Map<const Vec<D>>(row.data());
    if constexpr (D == 2)
        pose.rotation = Rotation<2>(row[2]);
    else
        pose.rotation = Rotation<3>(row[3], row[4], row[5], row[6]).normalized();
    return pose;
}

} // namespace

template <int D>
PrescribedMotion<D> table_motion(const TimeTable& table)
{
    assert(!table.time.empty() && table.rows.size() == table.time.size());
    std::vector<Pose<D>> poses;
    for (const std::vector<double>& row : table.rows) {
        assert(row.size() == (D == 2 ? 3 : 7));
        poses.push_back(pose_of_row<D>(row));
    }
    return [time = table.time, poses](double t) {
        const auto after = std::upper_bound(time.begin(), time.end(), t);
        if (after == time.begin())
            return poses.front();
        if (after == time.end())
            return poses.back();
        const auto k = after - time.begin();
        const double s = (t - time[k - 1]) / (time[k] - time[k - 1]);
        const Pose<D>&from = poses[k - 1], &to = poses[k];
        Pose<D> pose;
        pose.position = from.position + s * (to.position - from.position);
        if constexpr (D == 2)
            pose.rotation.angle() = from.rotation.angle() + s * (to.rotation.angle() - from.rotation.angle());
        else
            pose.rotation = from.rotation.slerp(s, to.rotation);
        return pose;
    };
}

template <int D>
Twist<D> prescribed_twist(const PrescribedMotion<D>& motion, const Vec<D>& centre_of_mass, double t0, double t1)
{
    const Pose<D> from = motion(t0), to = motion(t1);
    Twist<D> twist;
    twist << (to.position - from.position) + (to.rotation * centre_of_mass - from.rotation * centre_of_mass),
        angle_between<D>(from.rotation, to.rotation);
    return twist / (t1 - t0);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Rotation<D> rotation_of<D>(const Spin<D>&);                                                                       \
    template Spin<D> angle_between<D>(const Rotation<D>&, const Rotation<D>&);                                                 \
    template PrescribedMotion<D> constant_motion<D>(const Pose<D>&, const Vec<D>&, const Vec<D>&, const Spin<D>&);             \
    template PrescribedMotion<D> table_motion<D>(const TimeTable&);                                                            \
    template Twist<D> prescribed_twist<D>(const PrescribedMotion<D>&, const Vec<D>&, double, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
