#include "gapflow/body/move.hpp"
#include "gapflow/body/prescribed_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace gapflow {
namespace {

constexpr double pi = std::numbers::pi;

TEST(PrescribedMotion, AngleVectorsAndRotationsAreInverse)
{
    for (double size : {0.0, 1e-9, 1e-5, 0.3, 3.1}) {
        const Vec<3> angle = size * Vec<3>(1, -2, 2) / 3;
        const auto q = rotation_of<3>(angle);
        EXPECT_NEAR(q.norm(), 1, 1e-15);
        const auto start = rotation_of<3>(Vec<3>(0.4, 0.1, -0.9));
        EXPECT_LT((angle_between<3>(start, q * start) - angle).norm(), 1e-15 + 1e-14 * size);
    }
}

TEST(PrescribedMotion, ConstantTwistIsExactAndItsOwnMean)
{
    Pose<3> start;
    start.position = Vec<3>(1, 2, 3);
    start.rotation = rotation_of<3>(Vec<3>(0.2, -0.5, 0.1));
    const Vec<3> centre_of_mass(0.3, 0.1, -0.2), velocity(1, -0.5, 0.2), omega(0.4, 1.2, -0.7);
    const auto motion = constant_motion<3>(start, centre_of_mass, velocity, omega);
    EXPECT_EQ(motion(0).position, start.position);
    Twist<3> twist;
    twist << velocity, omega;
    EXPECT_LT((prescribed_twist<3>(motion, centre_of_mass, 5.0, 5.3) - twist).norm(), 1e-13);
    const Pose<3> later = motion(2);
    const Vec<3> centre = start.position + start.matrix() * centre_of_mass + 2 * velocity;
    EXPECT_LT((later.position + later.matrix() * centre_of_mass - centre).norm(), 1e-14);
    EXPECT_LT(later.rotation.angularDistance(rotation_of<3>(2 * omega) * start.rotation), 1e-14);
}

TEST(PrescribedMotion, Table2D)
{
    const TimeTable table{"", {1, 2, 4}, {{0, 0, 0}, {1, 2, 3 * pi}, {1, 0, 3 * pi}}};
    const auto motion = table_motion<2>(table);
    EXPECT_EQ(motion(0.0).position, Vec<2>(0, 0));
    EXPECT_NEAR((motion(1.25).position - Vec<2>(0.25, 0.5)).norm(), 0, 1e-15);
    EXPECT_NEAR(motion(1.5).rotation.angle(), 1.5 * pi, 1e-14);
    EXPECT_EQ(motion(9.0).position, Vec<2>(1, 0));
    EXPECT_EQ(motion(2.0).position, Vec<2>(1, 2));
    // Mean over a step that spans a row: displacement over dt; more than a turn keeps its sign and size.
    EXPECT_NEAR((prescribed_twist<2>(motion, Vec<2>::Zero(), 1.0, 3.0) - Twist<2>(0.5, 0.5, 1.5 * pi)).norm(), 0, 1e-14);
    // Beyond the ends the body rests.
    EXPECT_EQ((prescribed_twist<2>(motion, Vec<2>::Zero(), 4.0, 5.0)), Twist<2>(Twist<2>::Zero()));
}

TEST(PrescribedMotion, Table3DTurnsByTheShortestWayAtConstantSpeed)
{
    const double s = std::sqrt(0.5);
    const TimeTable table{"", {0, 2}, {{0, 0, 0, 2, 0, 0, 0}, {2, 0, 4, -s, 0, 0, -s}}}; // unnormalised; -q is q
    const auto motion = table_motion<3>(table);
    Twist<3> twist;
    twist << 1, 0, 2, 0, 0, pi / 4;
    EXPECT_LT((prescribed_twist<3>(motion, Vec<3>::Zero(), 0.3, 0.8) - twist).norm(), 1e-14);
    // With the centre of mass off the origin its mean velocity is the chord's.
    const Vec<3> c(1, 0, 0);
    const Twist<3> mean = prescribed_twist<3>(motion, c, 0.0, 2.0);
    EXPECT_LT((mean.head<3>() - Vec<3>((2 - 1) / 2.0, 0.5, 2)).norm(), 1e-14);
}

/// Largest jump of the twist's change from one short step to the next, over the largest change: of a motion with bounded acceleration small.
template <int D>
double roughness(const PrescribedMotion<D>& motion, double from, double to, int steps)
{
    const double dt = (to - from) / steps;
    std::vector<Twist<D>> twist;
    for (int k = 0; k < steps; ++k)
        twist.push_back(prescribed_twist<D>(motion, Vec<D>::Zero(), from + k * dt, from + (k + 1) * dt));
    double jump = 0, change = 0;
    for (int k = 1; k + 1 < steps; ++k) {
        jump = std::max(jump, (twist[k + 1] - 2 * twist[k] + twist[k - 1]).norm());
        change = std::max(change, (twist[k] - twist[k - 1]).norm());
    }
    return jump / change;
}

TEST(PrescribedMotion, CubicTablesAccelerateSmoothlyAtTheirRows)
{
    TimeTable flat{"", {}, {}, TimeTable::Interpolation::cubic}, solid = flat;
    for (int k = 0; k <= 50; ++k) { // a period
        const double t = 0.02 * k, phase = 2 * pi * t + 0.1;
        flat.time.push_back(t);
        flat.rows.push_back({std::sin(phase), 3.0, 0.5 * std::cos(phase)});
        const Rotation<3> q = rotation_of<3>(Vec<3>(0, 0, 3 * pi * t)) * rotation_of<3>(Vec<3>(0.8 * std::sin(phase), 0.2, 0));
        solid.time.push_back(t);
        const double sign = k % 3 == 0 ? -1 : 1; // of q and -q alike
        solid.rows.push_back({std::sin(phase), 0, 1, sign * q.w(), sign * q.x(), sign * q.y(), sign * q.z()});
    }
    const auto motion = table_motion<2>(flat);
    const auto tumble = table_motion<3>(solid);
    for (const double t : {0.111, 0.1538, 0.3, 0.4, 0.487, 0.6493, 0.83}) { // with the tops
        const double phase = 2 * pi * t + 0.1;
        EXPECT_NEAR(motion(t).position[0], std::sin(phase), 1e-6);
        EXPECT_EQ(motion(t).position[1], 3);
        EXPECT_NEAR(motion(t).rotation.angle(), 0.5 * std::cos(phase), 1e-6);
        const Rotation<3> q = rotation_of<3>(Vec<3>(0, 0, 3 * pi * t)) * rotation_of<3>(Vec<3>(0.8 * std::sin(phase), 0.2, 0));
        EXPECT_LT(angle_between<3>(q, tumble(t).rotation).norm(), 1e-5) << t;
    }
    EXPECT_LT(roughness<2>(motion, 0.05, 0.95, 360), 0.04); // eight steps a row: of the exact motion 0.016
    EXPECT_LT(roughness<3>(tumble, 0.05, 0.95, 360), 0.08);
    flat.interpolation = solid.interpolation = TimeTable::Interpolation::linear;
    EXPECT_GT(roughness<2>(table_motion<2>(flat), 0.05, 0.95, 360), 0.9);
    EXPECT_GT(roughness<3>(table_motion<3>(solid), 0.05, 0.95, 360), 0.9);
}

TEST(PrescribedMotion, CubicTablesTakeGivenVelocitiesAndHoldPlateaus)
{
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    TimeTable table{"",
                    {0, 1, 2, 3},
                    {{0, 0, 0, 1, unknown, -2}, {1, 0, 0, 1, unknown, 2}, {1, 0, 1, 0, unknown, 0}, {1, 0, 1, 0, unknown, 0}},
                    TimeTable::Interpolation::cubic};
    const auto motion = table_motion<2>(table);
    EXPECT_NEAR((prescribed_twist<2>(motion, Vec<2>::Zero(), 0, 1e-7) - Twist<2>(1, 0, -2)).norm(), 0, 1e-5);
    EXPECT_NEAR((prescribed_twist<2>(motion, Vec<2>::Zero(), 1 - 1e-7, 1) - Twist<2>(1, 0, 2)).norm(), 0, 1e-5);
    EXPECT_NEAR(motion(0.5).rotation.angle(), -0.5, 1e-15);
    EXPECT_EQ(motion(2.5).rotation.angle(), 1);
    // 3D: the angular velocities at both ends of a long turn.
    const Vec<3> w0(1, -2, 0.5), w1(0.3, 0.8, -1);
    const Rotation<3> q = rotation_of<3>(Vec<3>(2, 1, -1));
    const TimeTable turn{"",
                         {0, 1},
                         {{0, 0, 0, 1, 0, 0, 0, 0, 0, 0, w0[0], w0[1], w0[2]},
                          {0, 0, 0, q.w(), q.x(), q.y(), q.z(), 0, 0, 0, w1[0], w1[1], w1[2]}},
                         TimeTable::Interpolation::cubic};
    const auto tumble = table_motion<3>(turn);
    EXPECT_LT((prescribed_twist<3>(tumble, Vec<3>::Zero(), 0, 1e-7).tail<3>() - w0).norm(), 1e-5);
    EXPECT_LT((prescribed_twist<3>(tumble, Vec<3>::Zero(), 1 - 1e-7, 1).tail<3>() - w1).norm(), 1e-5);
    EXPECT_LT(angle_between<3>(tumble(1 - 1e-12).rotation, q).norm(), 1e-11);
}

TEST(PrescribedMotion, CubicTablesCountTurnsBeyondAHalf)
{
    // A turn about a skew axis at constant speed, 170 degrees a row: five rows are more than two turns.
    const Vec<3> step = 170.0 / 180 * pi * Vec<3>(1, 2, -2) / 3;
    TimeTable table{"", {}, {}, TimeTable::Interpolation::cubic};
    for (int k = 0; k < 8; ++k) {
        const Rotation<3> q = rotation_of<3>(k * step);
        table.time.push_back(k);
        table.rows.push_back({0, 0, 0, q.w(), q.x(), q.y(), q.z()});
    }
    Twist<3> twist = Twist<3>::Zero();
    twist.tail<3>() = step;
    for (const double t : {0.2, 1.3, 3.6, 6.4})
        EXPECT_LT((prescribed_twist<3>(table_motion<3>(table), Vec<3>::Zero(), t, t + 0.3) - twist).norm(), 1e-9) << t;
}

TEST(PrescribedMotion, MovesTheBody)
{
    RigidBody<2> body;
    body.motion = Motion::prescribed;
    body.prescribed =
        std::make_shared<PrescribedMotion<2>>(constant_motion<2>(body.pose, body.centre_of_mass, Vec<2>(1, 0), Spin<2>(0.5)));
    move(body, 1.0, 0.5);
    EXPECT_NEAR((body.pose.position - Vec<2>(1.5, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR(body.pose.rotation.angle(), 0.75, 1e-15);
    EXPECT_NEAR((predicted_twist(body, 1.0, 0.5) - Twist<2>(1, 0, 0.5)).norm(), 0, 1e-14);
    body.motion = Motion::fixed;
    move(body, 3.0, 0.5);
    EXPECT_NEAR(body.pose.rotation.angle(), 0.75, 1e-15);
    EXPECT_EQ(predicted_twist(body, 3.0, 0.5), Twist<2>(Twist<2>::Zero()));
}

} // namespace
} // namespace gapflow
