// Constrained and sprung bodies in fluid, through the whole time step.
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

// A body in a closed box full of fluid.
Scene box_of_fluid(int dimension, int n)
{
    Scene scene;
    scene.dimension = dimension;
    scene.size = {2, 2, dimension == 2 ? 0.0 : 2.0};
    scene.cells = {n, n, dimension == 2 ? 1 : n};
    scene.end = 1;
    scene.max_step = 0.02;
    BodyScene body;
    body.name = "body";
    body.shape = BodyScene::ShapeKind::box;
    body.size = {0.7, 0.4, dimension == 2 ? 0.0 : 0.5};
    body.position = {0.37, 0.9, dimension == 2 ? 0.0 : 1.1};
    body.angle = 0.0;
    body.density = 3.0;
    scene.bodies = {body};
    return scene;
}

TEST(ConstraintInFluid, HeldComponentsStayZero2D)
{
    Scene scene = box_of_fluid(2, 32);
    scene.gravity = {0.7, -1, 0};
    scene.bodies[0].free = {false, true, false, false, false, false};
    Simulation<2> simulation(scene, Communicator());
    EXPECT_GT(simulation.coupling().network.nodes, 0); // 0.02 from the wall: pushed sideways by a film
    for (int i = 0; i < 10; ++i)
        simulation.step(1);
    const RigidBody<2>& body = simulation.bodies()[0];
    EXPECT_LT(body.twist[1], -1e-2);
    EXPECT_EQ(body.twist[0], 0);
    EXPECT_EQ(body.twist[2], 0);
    EXPECT_EQ(body.pose.position[0], 0.37);
    EXPECT_EQ(body.pose.rotation.angle(), 0);
    EXPECT_GT(std::abs(simulation.fluid_wrenches()[0][0]), 1e-3); // the fluid's force is reported whole
}

TEST(ConstraintInFluid, HeldComponentsStayZero3D)
{
    Scene scene = box_of_fluid(3, 16);
    scene.gravity = {0.3, -1, 0.7};
    scene.bodies[0].free = {false, false, true, true, false, false};
    scene.bodies[0].angular_velocity = {1, 0, 0};
    Simulation<3> simulation(scene, Communicator());
    for (int i = 0; i < 3; ++i)
        simulation.step(1);
    const Twist<3> V = simulation.bodies()[0].twist;
    EXPECT_GT(V[2], 1e-3);
    EXPECT_GT(V[3], 0.5);
    for (int k : {0, 1, 4, 5})
        EXPECT_EQ(V[k], 0) << k;
    EXPECT_EQ(simulation.bodies()[0].pose.position[0], 0.37);
}

TEST(ConstraintInFluid, HingedBodyTurnsAboutItsPoint2D)
{
    Scene scene = box_of_fluid(2, 32);
    scene.gravity = {0, -1, 0};
    scene.bodies[0].position = {1.0, 1.1, 0};
    scene.bodies[0].hinge = HingeScene{{0.65, 1.2, 0}, {1, 0, 0}};
    Simulation<2> simulation(scene, Communicator());
    const Vec<2> in_body =
        simulation.bodies()[0].pose.matrix().transpose() * (Vec<2>(0.65, 1.2) - simulation.bodies()[0].pose.position);
    for (int i = 0; i < 20; ++i) {
        simulation.step(1);
        const RigidBody<2>& body = simulation.bodies()[0];
        const Vec<2> hinge = body.pose.position + body.pose.matrix() * in_body;
        EXPECT_LT((hinge - Vec<2>(0.65, 1.2)).norm(), 1e-14);
        EXPECT_LT(velocity_at<2>(body.twist, hinge - body.centre()).norm(), 1e-13);
    }
    EXPECT_LT(simulation.bodies()[0].twist[2], -1e-2);
}

TEST(ConstraintInFluid, HingedBodyTurnsAboutASkewAxis)
{
    Scene scene = box_of_fluid(3, 16);
    scene.gravity = {0, -1, 0};
    scene.bodies[0].position = {1.0, 1.1, 0.9};
    const Vec<3> axis = Vec<3>(1, 0.5, 2).normalized(), point(0.65, 1.2, 1.0);
    scene.bodies[0].hinge = HingeScene{{point[0], point[1], point[2]}, {axis[0], axis[1], axis[2]}};
    scene.bodies[0].angular_velocity = {2 * axis[0], 2 * axis[1], 2 * axis[2]};
    Simulation<3> simulation(scene, Communicator());
    const Vec<3> in_body = point - simulation.bodies()[0].pose.position; // not turned at the start
    for (int i = 0; i < 5; ++i) {
        simulation.step(1);
        const RigidBody<3>& body = simulation.bodies()[0];
        EXPECT_LT((body.pose.position + body.pose.matrix() * in_body - point).norm(), 1e-14);
        EXPECT_LT((body.pose.matrix() * axis - axis).norm(), 1e-14); // axis: the same in the body, not turned at the start
        EXPECT_LT(velocity_at<3>(body.twist, point - body.centre()).norm(), 1e-13);
        EXPECT_LT((body.twist.tail<3>().cross(axis)).norm(), 1e-13);
    }
}

TEST(ConstraintInFluid, BodyWithoutAFreeDirectionIsAFixedOne)
{
    Scene scene = box_of_fluid(2, 32);
    scene.gravity = {0, -1, 0};
    scene.bodies[0].free = {};
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 3; ++i)
        simulation.step(1);
    EXPECT_EQ(simulation.bodies()[0].twist, (Twist<2>(Twist<2>::Zero())));
    EXPECT_NEAR(simulation.budget().energy_grid, 0, 1e-15);
}

// A cylinder (radius a) on a spring in the middle of a circular container (radius b):
// w^2 = k / (m + rho pi a^2 (b^2 + a^2) / (b^2 - a^2)).
TEST(SpringInFluid, FrequencyHasTheAddedMass)
{
    constexpr double pi = std::numbers::pi, a = 0.5, b = 1.0, density = 2.0;
    Scene scene;
    scene.dimension = 2;
    scene.size = {2.2, 2.2, 0};
    scene.cells = {44, 44, 1};
    BodyScene outer, inner;
    outer.name = "container";
    outer.shape = inner.shape = BodyScene::ShapeKind::ball;
    outer.radius = b;
    outer.inside_out = true;
    outer.motion = BodyScene::Motion::fixed;
    outer.position = {1.1, 1.1, 0};
    inner.name = "cylinder";
    inner.radius = a;
    inner.density = density;
    inner.position = {1.1 + 0.01, 1.1, 0};
    inner.spring = SpringScene{{1.1, 1.1, 0}, 100, 0};
    scene.bodies = {outer, inner};
    const double mass = pi * a * a * (density + (b * b + a * a) / (b * b - a * a)), T = 2 * pi * std::sqrt(mass / 100);
    scene.end = 2 * T;
    scene.max_step = T / 60;
    Simulation<2> simulation(scene, Communicator());
    // Released at rest: the velocity passes through 0 after half a period.
    double energy = simulation.budget().energy_bodies, before = 0, half = 0;
    EXPECT_NEAR(energy, 0.5 * 100 * 1e-4, 1e-12);
    while (half == 0 && simulation.time() < scene.end) {
        const StepReport report = simulation.step(scene.end);
        const double v = simulation.bodies()[1].twist[0];
        if (before < 0 && v >= 0)
            half = report.time - report.dt * v / (v - before);
        before = v;
        EXPECT_NEAR(report.energy_bodies + report.energy_fluid, energy, 0.1 * energy);
    }
    EXPECT_NEAR(2 * half / T, 1, 0.01);
}

TEST(SpringInFluid, StepsResolveItsPeriodUnlessNothingIsSeenOfIt)
{
    Scene scene = box_of_fluid(2, 32);
    scene.max_step = 1;
    scene.bodies[0].position = {1, 1, 0};
    const double mass = 3.0 * 0.7 * 0.4;
    scene.bodies[0].spring = SpringScene{{1.1, 1, 0}, 1e4 * mass, 0};
    const double dt = Simulation<2>(scene, Communicator()).step(1).dt;
    EXPECT_NEAR(dt, 2 * std::numbers::pi / 100 / 20, 1e-12);
    scene.bodies[0].spring->anchor = {1, 1, 0};
    EXPECT_GT(Simulation<2>(scene, Communicator()).step(1).dt, 0.1);
}

} // namespace
} // namespace gapflow
