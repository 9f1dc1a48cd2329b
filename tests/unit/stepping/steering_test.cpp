// Forces and prescribed velocities that change between steps.
#include "gapflow/core/error.hpp"
#include "gapflow/step/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gapflow {
namespace {

Scene scene_with(int dimension, BodyScene::Motion motion)
{
    Scene scene;
    scene.dimension = dimension;
    const double depth = dimension == 2 ? 0.0 : 2.0;
    scene.size = {2, 2, depth};
    scene.cells = {16, 16, dimension == 2 ? 1 : 16};
    scene.end = 1;
    scene.max_step = 0.02;
    BodyScene body;
    body.name = "body";
    body.shape = BodyScene::ShapeKind::box;
    body.size = {0.5, 0.4, depth / 4};
    body.position = {1, 1, depth / 2};
    body.density = 3.0;
    body.motion = motion;
    body.velocity = {motion == BodyScene::Motion::prescribed ? 0.5 : 0.0, 0, 0};
    scene.bodies = {body};
    return scene;
}

// m dV/dt = F + fluid force, for the force that was set last.
TEST(Control, AForceActsFromTheNextStepOn)
{
    Simulation<3> simulation(scene_with(3, BodyScene::Motion::free), Communicator());
    simulation.step(1);
    EXPECT_LT(simulation.bodies()[0].twist.norm(), 1e-12);
    simulation.set_force(0, {9, 9, 9}, {9, 9, 9});
    const Vec<3> force(0, 1, -2);
    simulation.set_force(0, force, {0, 0.1, 0});
    const StepReport report = simulation.step(1);
    const RigidBody<3>& body = simulation.bodies()[0];
    const Twist<3>& fluid = simulation.fluid_wrenches()[0];
    EXPECT_LT((body.mass * body.twist.head<3>() - report.dt * (force + fluid.head<3>())).norm(), 1e-9);
    EXPECT_LT((body.angular_momentum - report.dt * (Vec<3>(0, 0.1, 0) + fluid.tail<3>())).norm(), 1e-9);
    // The fluid takes its share of both: 0.77 and 0.87 of them are left to the body.
    EXPECT_NEAR(body.mass * body.twist[1], 0.77 * report.dt * force[1], 0.01 * report.dt);
    EXPECT_NEAR(body.mass * body.twist[2], 0.87 * report.dt * force[2], 0.02 * report.dt);
}

// A gap of h closes by half of F / m dt^2 at most; the step before it was long.
TEST(Control, ASuddenForceShortensTheNextStep)
{
    Scene scene = scene_with(2, BodyScene::Motion::free);
    constexpr double h = 0.02;
    scene.bodies[0].position[1] = 0.2 + h;
    Simulation<2> simulation(scene, Communicator());
    EXPECT_EQ(simulation.step(1).dt, scene.max_step);
    const double force = 1e3;
    simulation.set_force(0, {0, -force}, Spin<2>(0));
    const double dt = simulation.step(1).dt, mass = simulation.bodies()[0].mass;
    EXPECT_LE(0.5 * force / mass * dt * dt, scene.gap_cfl * h * (1 + 1e-9));
    EXPECT_LT(dt, scene.max_step / 2);
}

TEST(Control, APrescribedVelocityGoesOnFromWhereTheBodyIs)
{
    Simulation<2> simulation(scene_with(2, BodyScene::Motion::prescribed), Communicator());
    simulation.step(0.02);
    simulation.set_velocity(0, {0, -1}, Spin<2>(2));
    EXPECT_EQ(simulation.bodies()[0].twist, Twist<2>(0, -1, 2));
    simulation.step(0.03);
    const Pose<2>& pose = simulation.bodies()[0].pose;
    EXPECT_LT((pose.position - Vec<2>(1.01, 0.99)).norm(), 1e-14);
    EXPECT_NEAR(pose.rotation.angle(), 0.02, 1e-14);
}

TEST(Control, StepsDoNotGoBack)
{
    Simulation<2> simulation(scene_with(2, BodyScene::Motion::free), Communicator());
    simulation.step(0.02);
    for (const double time : {0.02, 0.01, double(NAN)})
        EXPECT_THROW(simulation.step(time), InputError);
    EXPECT_EQ(simulation.step(0.03).time, 0.03); // the state is as it was
}

TEST(Control, RefusesWhatTheMotionDoesNotAllow)
{
    Simulation<2> free(scene_with(2, BodyScene::Motion::free), Communicator());
    Simulation<2> prescribed(scene_with(2, BodyScene::Motion::prescribed), Communicator());
    const auto message = [](auto&& call) -> std::string {
        try {
            call();
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_THAT(message([&] {
                    prescribed.set_force(0, {0, 1}, Spin<2>(0));
                }),
                testing::HasSubstr("force on body 'body': its motion is not \"free\""));
    EXPECT_THAT(message([&] {
                    free.set_velocity(0, {0, 1}, Spin<2>(0));
                }),
                testing::HasSubstr("velocity of body 'body': its motion is not \"prescribed\""));
    EXPECT_THAT(message([&] { free.set_force(0, {0, NAN}, Spin<2>(0)); }), testing::HasSubstr("is not finite"));
    EXPECT_EQ(free.bodies()[0].force, Vec<2>(0, 0));
}

} // namespace
} // namespace gapflow
