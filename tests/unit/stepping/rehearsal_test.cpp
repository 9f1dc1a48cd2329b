// What the first step expects.
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapflow {
namespace {

Scene closed_box(double size, int cells)
{
    Scene scene;
    scene.size = {size, size, 0};
    scene.cells = {cells, cells, 1};
    scene.end = 1;
    scene.max_step = 0.01;
    return scene;
}

BodyScene ball(double radius, double x, double y, double density)
{
    BodyScene body;
    body.name = "ball";
    body.radius = radius;
    body.position = {x, y, 0};
    body.density = density;
    return body;
}

double energy(const StepReport& report)
{
    return report.energy_fluid + report.energy_bodies;
}

TEST(Rehearsal, ABodyFallsInItsFirstStep)
{
    for (double viscosity : {0.0, 1e-3}) {
        Scene scene = closed_box(1, 32);
        scene.gravity = {0, -1, 0};
        scene.viscosity = viscosity;
        scene.bodies = {ball(0.15, 0.52, 0.55, 4)};
        Simulation<2> simulation(scene, Communicator());
        const RigidBody<2>* body = &simulation.bodies()[0];
        const double from = body->pose.position[1];
        const StepReport report = simulation.step(scene.end);
        ASSERT_EQ(&simulation.bodies()[0], body);
        const double mean = 0.5 * body->twist[1] * report.dt;
        EXPECT_LT(mean, -1e-5);
        EXPECT_NEAR(body->pose.position[1] - from, mean, 0.01 * std::abs(mean)) << "at rest at first, evenly accelerated";
        EXPECT_EQ(simulation.steps(), 1);
        EXPECT_EQ(simulation.time(), report.dt);
    }
}

// Without the pressure of a step before, the viscous step would drag the fluid with the velocity that the ball has without added mass, over a
// hundred times what it gets, and the ball would go down.
TEST(Rehearsal, ALightBallInViscousFluidStartsWithItsAddedMass)
{
    Scene scene = closed_box(1, 24);
    scene.gravity = {0, -1, 0};
    scene.bodies = {ball(0.15, 0.52, 0.45, 0.01)};
    scene.viscosity = 0.05;
    scene.max_step = 0.5 / (24 * 24 * scene.viscosity);
    const double end = scene.max_step;
    Simulation<2> once(scene, Communicator());
    const double volume = once.bodies()[0].mass / 0.01, from = once.bodies()[0].pose.position[1];
    const StepReport report = once.step(end);
    const double risen = once.bodies()[0].pose.position[1] - from;
    EXPECT_GT(risen, 0);
    EXPECT_LT(energy(report), 1.02 * 0.99 * volume * risen);

    scene.max_step = end / 64;
    Simulation<2> often(scene, Communicator());
    while (often.time() < end)
        often.step(end);
    EXPECT_NEAR(risen, often.bodies()[0].pose.position[1] - from, 0.15 * risen);
    EXPECT_NEAR(once.bodies()[0].twist[1], often.bodies()[0].twist[1], 0.15 * once.bodies()[0].twist[1]);
}

// Heads at their film's mouths are bounded by the work that they do, against velocities that the film is expected to have.
TEST(Rehearsal, PlatesThatOpenAtSpeedGainNothingInTheirFirstStep)
{
    Scene scene = closed_box(4, 64);
    BodyScene plate;
    plate.shape = BodyScene::ShapeKind::box;
    plate.size = {1, 0.5, 0};
    plate.density = 2;
    for (double up : {1.0, -1.0}) {
        plate.name = up > 0 ? "upper" : "lower";
        plate.position = {2, 2 + up * 0.255, 0};
        plate.velocity = {0, up * 0.1, 0};
        scene.bodies.push_back(plate);
    }
    Simulation<2> simulation(scene, Communicator());
    const double start = energy(simulation.initial_report());
    EXPECT_LT(energy(simulation.step(scene.end)), 1.0002 * start);
}

} // namespace
} // namespace gapflow
