// Poses given in time. Between two rows of a table, h apart,
//
//     x(s) = x_0 + (3 s^2 - 2 s^3) (x_1 - x_0) + h s (1 - s)^2 v_0 - h s^2 (1 - s) v_1,     s = (t - t_0) / h
//
// with the velocities v at the rows, so that the velocity does not jump there. Of orientations x is the angle vector from the row before, in
// world axes; its rate is the angular velocity w at angle 0, and J(x)^-1 w elsewhere,
//
//     J(x)^-1 = 1 - [x]/2 + (1/a^2 - 1 / (2 a tan(a/2))) [x]^2,     a = |x|,  [x] y = x cross y
//
// (A. Mueller, Mech. Mach. Theory 142 (2019), sec. 2). Linear tables: constant velocity, and constant angular velocity (slerp; Shoemake,
// SIGGRAPH 1985), so that the mean twist of a step inside one row is the exact one.
#include "gapflow/body/prescribed_motion.hpp"

#include "gapflow/body/row_slopes.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
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

template <int D>
Pose<D> linear_between(const Pose<D>& from, const Pose<D>& to, double s)
{
    Pose<D> pose;
    pose.position = from.position + s * (to.position - from.position);
    if constexpr (D == 2)
        pose.rotation.angle() = from.rotation.angle() + s * (to.rotation.angle() - from.rotation.angle());
    else
        pose.rotation = from.rotation.slerp(s, to.rotation);
    return pose;
}

/// The cubic from `from` to `to`; slopes times the way between the rows.
template <class Value>
Value cubic(const Value& from, const Value& to, const Value& slope_from, const Value& slope_to, double s)
{
    const double r = 1 - s;
    return from + s * s * (3 - 2 * s) * (to - from) + s * r * r * slope_from - s * s * r * slope_to;
}

/// Rate of the angle vector x of a rotation that turns with angular velocity w.
Vec<3> angle_rate(const Vec<3>& x, const Vec<3>& w)
{
    const double a = x.norm();
    const double factor = a < 1e-2 ? 1.0 / 12 + a * a / 720 : 1 / (a * a) - 1 / (2 * a * std::tan(0.5 * a));
    return w - 0.5 * x.cross(w) + factor * x.cross(x.cross(w));
}

/// The angle vector of the same rotation that is nearest to `near`: whole turns are added about its own axis.
Vec<3> unwrapped(const Vec<3>& angle, const Vec<3>& near)
{
    const Vec<3> axis = angle.norm() > 1e-8 ? angle.normalized() : near.normalized();
    return angle + 2 * std::numbers::pi * std::round((near - angle).dot(axis) / (2 * std::numbers::pi)) * axis;
}

/// Velocities at the rows of a table, of the shape's origin and of the turn.
template <int D>
struct RowVelocities {
    std::vector<Vec<D>> linear;
    std::vector<Spin<D>> angular;
};

/// Angular velocities at rows. Row by row, five of them as angle vectors from that one.
std::vector<Vec<3>> angular_velocities(const std::vector<double>& time, const std::vector<Pose<3>>& poses)
{
    std::vector<Vec<3>> turns; // from a row to the next one
    for (std::size_t k = 0; k + 1 < poses.size(); ++k)
        turns.push_back(angle_between<3>(poses[k].rotation, poses[k + 1].rotation));
    std::array<std::vector<double>, 3> slopes, secants;
    for (std::size_t k = 0; k < poses.size(); ++k) {
        const auto [first, count] = rows_about(k, poses.size());
        std::vector<Vec<3>> angles(count, Vec<3>::Zero());
        const auto angle_at = [&](std::size_t row, const Vec<3>& near) {
            angles[row - first] = unwrapped(angle_between<3>(poses[k].rotation, poses[row].rotation), near);
        };
        for (std::size_t row = k + 1; row < first + count; ++row)
            angle_at(row, angles[row - 1 - first] + turns[row - 1]);
        for (std::size_t row = k; row-- > first;)
            angle_at(row, angles[row + 1 - first] - turns[row]);
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double> of_axis;
            for (const Vec<3>& angle : angles)
                of_axis.push_back(angle[axis]);
            slopes[axis].push_back(polynomial_slope(std::span(time).subspan(first, count), of_axis, k - first));
            if (k < turns.size())
                secants[axis].push_back(turns[k][axis] / (time[k + 1] - time[k]));
        }
    }
    std::vector<Vec<3>> velocities(poses.size());
    for (int axis = 0; axis < 3; ++axis) {
        limit_slopes(time, secants[axis], slopes[axis]);
        for (std::size_t k = 0; k < poses.size(); ++k)
            velocities[k][axis] = slopes[axis][k];
    }
    return velocities;
}

template <int D>
RowVelocities<D> row_velocities(const TimeTable& table, const std::vector<Pose<D>>& poses)
{
    const std::size_t n = poses.size(), pose_columns = D == 2 ? 3 : 7;
    RowVelocities<D> v{std::vector<Vec<D>>(n), std::vector<Spin<D>>(n)};
    const auto slopes_of = [&](int column) {
        std::vector<double> values_of;
        for (const std::vector<double>& row : table.rows)
            values_of.push_back(row[column]);
        return row_slopes(table.time, values_of);
    };
    for (int axis = 0; axis < D; ++axis)
        for (std::size_t k = 0; const double slope : slopes_of(axis))
            v.linear[k++][axis] = slope;
    if constexpr (D == 2)
        for (std::size_t k = 0; const double slope : slopes_of(2))
            v.angular[k++][0] = slope;
    else
        v.angular = angular_velocities(table.time, poses);
    for (std::size_t k = 0; k < n && table.rows[k].size() > pose_columns; ++k) // given ones, NaN where there is none
        for (int i = 0; i < twist_size<D>; ++i)
            if (const double given = table.rows[k][pose_columns + i]; !std::isnan(given))
                (i < D ? v.linear[k][i] : v.angular[k][i - D]) = given;
    return v;
}

// Held constant beyond the ends of a table; in it between(k, s), s the part of the time from row k - 1 to row k.
template <int D, class F>
PrescribedMotion<D> motion_of_rows(const std::vector<double>& time, const std::vector<Pose<D>>& poses, F between)
{
    return [time, first = poses.front(), last = poses.back(), between = std::move(between)](double t) {
        const auto after = std::upper_bound(time.begin(), time.end(), t);
        if (after == time.begin())
            return first;
        if (after == time.end())
            return last;
        const auto k = after - time.begin();
        return between(k, (t - time[k - 1]) / (time[k] - time[k - 1]));
    };
}

template <int D>
PrescribedMotion<D> smooth_motion(const TimeTable& table, const std::vector<Pose<D>>& poses)
{
    const RowVelocities<D> v = row_velocities<D>(table, poses);
    return motion_of_rows<D>(table.time, poses, [time = table.time, poses, v](long k, double s) {
        const double h = time[k] - time[k - 1];
        const Pose<D>&from = poses[k - 1], &to = poses[k];
        Pose<D> pose;
        pose.position = cubic<Vec<D>>(from.position, to.position, h * v.linear[k - 1], h * v.linear[k], s);
        if constexpr (D == 2) {
            pose.rotation.angle() =
                cubic(from.rotation.angle(), to.rotation.angle(), h * v.angular[k - 1][0], h * v.angular[k][0], s);
        } else {
            const Vec<3> turn = angle_between<3>(from.rotation, to.rotation);
            const Vec<3> angle =
                cubic<Vec<3>>(Vec<3>::Zero(), turn, h * v.angular[k - 1], h * angle_rate(turn, v.angular[k]), s);
            pose.rotation = (rotation_of<3>(angle) * from.rotation).normalized();
        }
        return pose;
    });
}

} // namespace

template <int D>
PrescribedMotion<D> table_motion(const TimeTable& table)
{
    assert(!table.time.empty() && table.rows.size() == table.time.size());
    std::vector<Pose<D>> poses;
    for (const std::vector<double>& row : table.rows) {
        assert(row.size() >= (D == 2 ? 3 : 7));
        poses.push_back(pose_of_row<D>(row));
    }
    if (table.interpolation == TimeTable::Interpolation::cubic)
        return smooth_motion<D>(table, poses);
    return motion_of_rows<D>(table.time, poses,
                             [poses](long k, double s) { return linear_between<D>(poses[k - 1], poses[k], s); });
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
