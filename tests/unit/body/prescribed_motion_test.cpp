#include "gapflow/body/move.hpp"
#include "gapflow/body/prescribed_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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
