#include "gapflow/body/move.hpp"
#include "gapflow/body/rigid_body.hpp"

#include "gapflow/core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapflow {
namespace {

RigidBody<3> top(const Vec<3>& inertia, const Vec<3>& omega)
{
    RigidBody<3> body;
    body.name = "top";
    body.mass = 2;
    body.inertia = inertia.asDiagonal();
    Twist<3> twist;
    twist << 0, 0, 0, omega;
    set_initial_twist(body, twist);
    return body;
}

void free_step(RigidBody<3>& body, double dt)
{
    move(body, 0, dt);
    finish_step(body, twist_after<3>(body, Twist<3>::Zero()), dt);
}

// Largest relative change of energy over a number of steps of free tumbling.
double energy_change(RigidBody<3>& body, double energy, int steps, double dt)
{
    double worst = 0;
    for (int step = 0; step < steps; ++step) {
        free_step(body, dt);
        worst = std::max(worst, std::abs(kinetic_energy(body) / energy - 1));
    }
    return worst;
}

TEST(RigidBody, FreeTumblingKeepsAngularMomentumAndEnergy)
{
    const double dt = 0.05;
    RigidBody<3> body = top(Vec<3>(1, 2, 3), Vec<3>(0.5, 0.6, 0.6));
    const Vec<3> L = body.angular_momentum;
    EXPECT_LT(energy_change(body, kinetic_energy(body), 10000, dt), 1e-4);
    EXPECT_LT((body.angular_momentum - L).norm(), 1e-10 * L.norm());
    EXPECT_LT((world_inertia(body) * body.twist.tail<3>() - L).norm(), 1e-10 * L.norm());
    EXPECT_NEAR(body.pose.rotation.norm(), 1, 1e-15);
}

// Turning over about the unstable axis: energy swings by (dt omega)^2 / 24, the same after any time.
TEST(RigidBody, EnergyDoesNotDriftWhileTheBodyTurnsOver)
{
    const double dt = 0.05;
    RigidBody<3> body = top(Vec<3>(1, 2, 3), Vec<3>(0.02, 1.0, 0.01));
    const double energy = kinetic_energy(body);
    const double first = energy_change(body, energy, 1000, dt);
    energy_change(body, energy, 8000, dt);
    EXPECT_LT(first, dt * dt / 20);
    EXPECT_LT(energy_change(body, energy, 1000, dt), 1.02 * first);
}

TEST(RigidBody, RotationIsSecondOrder)
{
    auto orientation = [](int steps) {
        RigidBody<3> body = top(Vec<3>(1, 2, 3), Vec<3>(0.7, 0.9, -0.4));
        for (int step = 0; step < steps; ++step)
            free_step(body, 2.0 / steps);
        return body.pose.rotation;
    };
    const auto exact = orientation(20000);
    const double coarse = exact.angularDistance(orientation(40)), fine = exact.angularDistance(orientation(80));
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05);
    EXPECT_LT(fine, 1e-3);
}

TEST(RigidBody, SymmetricTopPrecessesAtItsRate)
{
    // Inertia (1, 1, 2): the axis precesses about L at |L| / 1.
    RigidBody<3> body = top(Vec<3>(1, 1, 2), Vec<3>(0.3, 0, 1));
    const Vec<3> L = body.angular_momentum;
    const double dt = 1e-3;
    for (int step = 0; step < 1000; ++step)
        free_step(body, dt);
    const Vec<3> axis = rotation_of<3>(L) * Vec<3>::UnitZ();
    EXPECT_LT((body.pose.matrix().col(2) - axis).norm(), 1e-6);
}

TEST(RigidBody, RefusesAHopelessStep)
{
    RigidBody<3> body = top(Vec<3>(1, 20, 300), Vec<3>(300, 200, 100));
    try {
        move(body, 0, 1.0);
        FAIL() << "no error";
    } catch (const ComputationError& error) {
        EXPECT_NE(std::string(error.what()).find("'top' turns by"), std::string::npos);
    }
}

TEST(RigidBody, UniformAccelerationIsFollowedExactlyAfterTheFirstStep)
{
    RigidBody<2> body;
    body.mass = 3;
    body.inertia(0, 0) = 0.5;
    body.centre_of_mass = Vec<2>(0.3, -0.1);
    Twist<2> wrench(3, -6, 0.25); // accelerations 1, -2, 0.5
    const double dt = 0.1;
    set_initial_twist<2>(body, Twist<2>(0.2, 0.4, 0.1));
    const Vec<2> start = body.centre();
    for (int step = 0; step < 5; ++step) {
        move(body, step * dt, dt);
        finish_step(body, twist_after<2>(body, dt * wrench), dt);
    }
    // V^n is exact; the first step lacks dt^2/2 of acceleration, the others have it.
    const double t = 5 * dt, lost = 0.5 * dt * dt;
    EXPECT_NEAR((body.twist - Twist<2>(0.2 + t, 0.4 - 2 * t, 0.1 + 0.5 * t)).norm(), 0, 1e-14);
    EXPECT_NEAR((body.centre() - start - Vec<2>(0.2 * t + 0.5 * t * t - lost, 0.4 * t - t * t + 2 * lost)).norm(), 0, 1e-14);
    EXPECT_NEAR(body.pose.rotation.angle(), 0.1 * t + 0.25 * t * t - 0.5 * lost, 1e-14);
    EXPECT_NEAR((predicted_twist(body, t, dt) - body.twist - dt * Twist<2>(1, -2, 0.5)).norm(), 0, 1e-14);

    finish_step(body, Twist<2>(Twist<2>::Zero()), dt, 0.0);
    EXPECT_EQ(predicted_twist(body, t, dt), Twist<2>(Twist<2>::Zero()));
    finish_step(body, Twist<2>(1, 0, 0), dt, 0.25);
    EXPECT_NEAR((predicted_twist(body, t, dt) - Twist<2>(1.25, 0, 0)).norm(), 0, 1e-14);
}

// Of what an impact of others does to a body: no more than twice the acceleration before, or the least one given.
TEST(RigidBody, WhatAnImpactElsewhereDoesIsNoAccelerationThatGoesOn)
{
    RigidBody<2> body;
    body.mass = 3;
    body.inertia(0, 0) = 0.75; // 0.25 a mass
    const Twist<2> before(0.3, 0.4, 0), none = Twist<2>::Zero();
    EXPECT_DOUBLE_EQ(lasting_part<2>(body, Twist<2>(0.6, 0.7, 0.4), before, 0), 1);
    EXPECT_DOUBLE_EQ(lasting_part<2>(body, Twist<2>(0, 100, 0), before, 0), 0.01);
    EXPECT_DOUBLE_EQ(lasting_part<2>(body, Twist<2>(0, 0, 200), before, 0), 0.01);
    EXPECT_DOUBLE_EQ(lasting_part<2>(body, Twist<2>(0, 100, 0), none, 10), 0.1);
    EXPECT_DOUBLE_EQ(lasting_part<2>(body, Twist<2>(0, 100, 0), none, 0), 0);
    EXPECT_DOUBLE_EQ(lasting_part<2>(body, none, none, 0), 1);
}

TEST(RigidBody, MassFromDensityOrGiven)
{
    RigidBody<3> body;
    body.shape = make_box<3>(Vec<3>(1, 2, 3));
    set_density(body, 0.5);
    EXPECT_NEAR(body.mass, 3, 1e-14);
    EXPECT_NEAR(body.inertia(0, 0), 3 * (4 + 9) / 12.0, 1e-14);
    EXPECT_NEAR(body.volume, 6, 1e-14);
    set_mass<3>(body, 7, Vec<3>(1, 2, 3).asDiagonal());
    const double s = std::sqrt(0.5);
    body.pose.rotation = Eigen::Quaterniond(s, 0, 0, s); // x axis -> y axis
    TwistMatrix<3> M = TwistMatrix<3>::Zero();
    M.diagonal() << 7, 7, 7, 2, 1, 3;
    EXPECT_NEAR((mass_matrix(body) - M).norm(), 0, 1e-14);

    Twist<3> twist;
    twist << 1, 2, 3, 0.1, 0.2, 0.3;
    set_initial_twist(body, twist);
    EXPECT_NEAR(kinetic_energy(body), 0.5 * (7 * 14 + 2 * 0.01 + 0.04 + 3 * 0.09), 1e-13);
    place<3>(body, Vec<3>(1, 0, 0), body.pose.rotation);
    EXPECT_NEAR((angular_momentum_about<3>(body, Vec<3>::Zero()) - Vec<3>(0.2, 0.2 - 21, 0.9 + 14)).norm(), 0, 1e-13);
    EXPECT_NEAR((momentum(body).head<3>() - Vec<3>(7, 14, 21)).norm(), 0, 1e-14);
}

TEST(RigidBody, ReducedGravityActsOnWhatTheBodyWeighsMoreThanFluid)
{
    RigidBody<2> body;
    body.shape = make_box<2>(Vec<2>(2, 1));
    set_density(body, 3.0);
    body.force = Vec<2>(0.5, 0);
    body.torque[0] = 0.25;
    EXPECT_NEAR((explicit_wrench<2>(body, Vec<2>(0, -10), 1.0) - Twist<2>(0.5, -40, 0.25)).norm(), 0, 1e-13);
    // Centre of mass off the centre of volume by (0, -0.2) in the body, turned by 90 degrees: it lies at +0.2 in x, and the
    // buoyancy 20 upwards acts 0.2 to the left of it.
    body.centre_of_mass = Vec<2>(0, -0.2);
    body.pose.rotation = Eigen::Rotation2D<double>(std::acos(0.0));
    EXPECT_NEAR((explicit_wrench<2>(body, Vec<2>(0, -10), 1.0) - Twist<2>(0.5, -40, 0.25 - 4)).norm(), 0, 1e-13);
    // A container carries the weight of the fluid in it.
    body.shape = make_inside_out<2>(make_box<2>(Vec<2>(2, 1)));
    set_mass<2>(body, 1, SpinMatrix<2>::Identity());
    EXPECT_NEAR(explicit_wrench<2>(body, Vec<2>(0, -10), 1.0)[1], -30, 1e-13);
}

template <int D>
RigidBody<D> float_of(std::shared_ptr<const Shape<D>> shape, const Vec<D>& up, double level)
{
    RigidBody<D> body;
    body.shape = std::move(shape);
    set_density(body, 0.6);
    body.centre_of_mass += 0.03 * unit<D>(0); // the centre of volume is another point
    body.water = WaterLevel<D>{{up, level}, 1.3 * 9.0};
    return body;
}

// Gravity's and buoyancy's wrench is what the energy falls by along each motion, whether the body is above, below or in the level.
template <int D>
void expect_conservative(RigidBody<D> body, const Vec<D>& up)
{
    const Vec<D> g = -9 * up;
    for (const double height : {-1.1, -0.4, -0.1, 0.05, 0.3, 0.9}) {
        place<D>(body, body.centre() + (body.water->plane.offset + height - up.dot(body.centre())) * up, body.pose.rotation);
        const Twist<D> w = explicit_wrench<D>(body, g, 1.3);
        const double small = 1e-4;
        Twist<D> of_section = Twist<D>::Zero();
        for (int k = 0; k < twist_size<D>; ++k) {
            const auto moved_by = [&](double way) {
                RigidBody<D> other = body;
                const Twist<D> motion = way * Twist<D>::Unit(k);
                displace<D>(other, motion.template head<D>(), motion.template tail<spin_size<D>>());
                return other;
            };
            const RigidBody<D> back = moved_by(-small), forth = moved_by(small);
            EXPECT_NEAR((gravity_energy<D>(back, g, 1.3) - gravity_energy<D>(forth, g, 1.3)) / (2 * small), w[k], 2e-5)
                << "motion " << k << " at " << height;
            of_section[k] =
                (explicit_wrench<D>(back, g, 1.3) - explicit_wrench<D>(forth, g, 1.3)).template head<D>().dot(up) / (2 * small);
        }
        // How buoyancy falls along each motion, by the section alone.
        Twist<D> rise = Twist<D>::Zero();
        rise.template head<D>() = up;
        EXPECT_NEAR((displacement(body).stiffness * rise - of_section).norm(), 0, 2e-4) << height;
    }
}

TEST(RigidBody, BuoyancyAtAWaterLevelIsTheDerivativeOfAnEnergy)
{
    const Vec<2> up2(0, 1);
    RigidBody<2> box = float_of<2>(make_box<2>(Vec<2>(0.8, 0.4)), up2, 0.7);
    place<2>(box, Vec<2>(0.2, 0.7), Rotation<2>(0.4));
    expect_conservative<2>(box, up2);
    RigidBody<2> capsule = float_of<2>(make_capsule<2>(0.3, 0.7), -up2, -0.2);
    place<2>(capsule, Vec<2>(0.2, 0.2), Rotation<2>(-0.6));
    expect_conservative<2>(capsule, Vec<2>(-up2));
    const Vec<3> up3(0, 0, 1);
    const std::vector<std::shared_ptr<const Shape<3>>> shapes{make_box<3>(Vec<3>(0.8, 0.5, 0.6)), make_ball<3>(0.4),
                                                              make_capsule<3>(0.25, 0.6), make_cylinder(0.3, 0.7)};
    for (const std::shared_ptr<const Shape<3>>& shape : shapes) {
        RigidBody<3> body = float_of<3>(shape, up3, 0.1);
        place<3>(body, Vec<3>(0.1, 0.2, 0.1), Eigen::Quaterniond(0.9, 0.2, 0.3, -0.2).normalized());
        expect_conservative<3>(body, up3);
    }
}

TEST(RigidBody, HeldComponentsDoNotMove)
{
    RigidBody<3> body = top(Vec<3>(1, 2, 3), Vec<3>::Zero());
    body.pose.rotation = Eigen::Quaterniond(0.9, 0.3, -0.2, 0.1).normalized();
    body.can_move = {false, true, false, false, false, true};
    Twist<3> impulse;
    impulse << 1, 2, 3, 4, 5, 6;
    for (int step = 0; step < 50; ++step) {
        move(body, 0, 0.05);
        finish_step(body, twist_after<3>(body, (step == 0 ? 1.0 : 0.0) * impulse), 0.05, step > 0);
        EXPECT_EQ(body.twist[0], 0);
        EXPECT_EQ(body.twist[3], 0);
        EXPECT_EQ(body.twist[4], 0);
        EXPECT_NEAR(body.twist[1], 1, 1e-14);
        EXPECT_NEAR(body.twist[5] * world_inertia(body)(2, 2), 6, 1e-12);
    }
}

TEST(RigidBody, SolidViewHasTheCentreOfMass)
{
    RigidBody<2> body;
    body.name = "plate";
    body.shape = make_box<2>(Vec<2>(2, 1));
    body.centre_of_mass = Vec<2>(0.5, 0);
    place<2>(body, Vec<2>(3, 4), Eigen::Rotation2D<double>(std::acos(0.0)));
    const Solid<2> solid = solid_of(body);
    EXPECT_EQ(solid.name, "plate");
    EXPECT_FALSE(solid.wall);
    EXPECT_NEAR((solid.centre - Vec<2>(3, 4)).norm(), 0, 1e-15);
    EXPECT_NEAR((solid.shape.to_world(Vec<2>::Zero()) - Vec<2>(3, 3.5)).norm(), 0, 1e-15);
}

} // namespace
} // namespace gapflow
