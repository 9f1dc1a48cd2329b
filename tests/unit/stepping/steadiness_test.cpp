// When a flow counts as steady.
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/steadiness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace gapflow {
namespace {

// Fluid at rest between a wall and one that starts to slide.
Scene started_shear(double step, double density = 1)
{
    Scene scene;
    scene.dimension = 2;
    scene.size = {0.5, 1, 0};
    scene.cells = {8, 16, 1};
    scene.sides[0].kind = scene.sides[1].kind = SideScene::Kind::periodic;
    scene.sides[3].velocity = {1, 0, 0};
    scene.viscosity = 1;
    scene.density = density;
    scene.end = 100;
    scene.max_step = step;
    scene.until_steady = 1e-3;
    return scene;
}

double unsteadiness_at(double time, double step)
{
    Simulation<2> simulation(started_shear(step), Communicator());
    double r = 0;
    while (simulation.time() < time)
        r = simulation.step(time).unsteadiness;
    return r;
}

// The deviation from u = y decays with the rate nu pi^2; the measure is the deviation, not less and a third more at most, whatever the step.
TEST(Steadiness, IsWhatWillStillChange)
{
    const double coarse = unsteadiness_at(0.4, 0.008), fine = unsteadiness_at(0.4, 0.002);
    EXPECT_NEAR(coarse / fine, 1, 0.25);
    // u = y - a sin(pi y), a = (2 / pi) e^(-nu pi^2 t)
    for (const auto& [time, measured] : {std::pair(0.4, fine), std::pair(0.6, unsteadiness_at(0.6, 0.002))}) {
        const double a = 2 / M_PI * std::exp(-M_PI * M_PI * time), square = 1.0 / 3 - 2 * a / M_PI + 0.5 * a * a;
        const double left = a / std::sqrt(2.0 * square);
        EXPECT_GT(measured, 0.98 * left) << time;
        EXPECT_LT(measured, 1.35 * left) << time;
    }
}

// The last row of a run that goes on to its end tells how steady it was, as those before do.
TEST(Steadiness, IsToldAtTheEndToo)
{
    Scene scene = started_shear(0.01);
    scene.end = 0.3;
    scene.until_steady = 1e-6;
    Simulation<2> simulation(scene, Communicator());
    double before = 0, last = 0;
    while (simulation.time() < scene.end) {
        before = last;
        last = simulation.step(scene.end).unsteadiness;
    }
    EXPECT_GT(last, 0.8 * before);
    EXPECT_LT(last, before);
}

long steps_until_settled(Scene scene, double& time)
{
    Simulation<2> simulation(scene, Communicator());
    while (!simulation.settled() && simulation.steps() < 5000)
        simulation.step(scene.end);
    time = simulation.time();
    return simulation.steps();
}

// It ends within a tenth of the time after which the flow is its final one to the tolerance.
TEST(Steadiness, AFlowSettles)
{
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        Scene scene = started_shear(0.002);
        scene.until_steady = tolerance;
        double time = 0;
        steps_until_settled(scene, time);
        const double settled = std::log(2 / M_PI * std::sqrt(1.5) / tolerance) / (M_PI * M_PI);
        EXPECT_GT(time, settled) << tolerance;
        EXPECT_LT(time, 1.1 * settled + 0.02) << tolerance; // ten steps
    }
}

// In a large vessel that the fluid hardly crosses, too: the time in which viscosity reaches across it does not count.
TEST(Steadiness, ItsOwnTimeCounts)
{
    Scene scene = started_shear(0.002);
    scene.size = {32, 1, 0};
    scene.cells = {512, 16, 1};
    double time = 0;
    steps_until_settled(scene, time);
    EXPECT_LT(time, 1.1 * std::log(2 / M_PI * std::sqrt(1.5) / 1e-3) / (M_PI * M_PI) + 0.02);
}

TEST(Steadiness, NotBeforeTablesEnd)
{
    Scene scene = started_shear(0.05);
    scene.sides[3] = {};
    scene.sides[0].kind = SideScene::Kind::inflow;
    scene.sides[0].table.time = {0, 2, 3};
    scene.sides[0].table.rows = {{0, 0}, {0, 0}, {1, 0}};
    scene.sides[1].kind = SideScene::Kind::open;
    double time = 0;
    steps_until_settled(scene, time);
    EXPECT_GT(time, 3);
}

// In creeping flow the density, and with it the time of a step, has no meaning: the same at any density.
TEST(Steadiness, ScalesWithTheDensity)
{
    double time = 0, time_of_light = 0;
    const long steps = steps_until_settled(started_shear(0.01), time),
               steps_of_light = steps_until_settled(started_shear(1e-8, 1e-6), time_of_light);
    EXPECT_NEAR(steps_of_light, steps, 2);
    EXPECT_NEAR(time_of_light / time, 1e-6, 1e-7);
}

// A flow that runs down is steady in the end, though its own relative change stays the same.
TEST(Steadiness, WhatComesToRestIsSteady)
{
    Scene scene = started_shear(0.01);
    scene.sides[3].velocity = {};
    scene.fluid_velocity = {1, 0, 0};
    double time = 0;
    EXPECT_LT(steps_until_settled(scene, time), 1000);
    EXPECT_GT(time, 0.5);
}

// A disk that lies on the bottom moves by round-off, which has no size to be compared with.
TEST(Steadiness, WhatNeverMovesIsSteadyAtOnce)
{
    Scene scene;
    scene.dimension = 2;
    scene.size = {1, 1, 0};
    scene.cells = {32, 32, 1};
    scene.density = 1000;
    scene.viscosity = 1e-3;
    scene.gravity = {0, -9.81, 0};
    scene.end = 10;
    scene.max_step = 0.05;
    scene.until_steady = 1e-3;
    BodyScene disk;
    disk.name = "disk";
    disk.shape = BodyScene::ShapeKind::ball;
    disk.radius = 0.2;
    disk.position = {0.5, 0.2, 0};
    disk.density = 3000;
    scene.bodies = {disk};
    double time = 0;
    EXPECT_LE(steps_until_settled(scene, time), 20);
    // One that is let fall gathers speed: not settled while it does.
    scene.bodies[0].position[1] = 0.6;
    scene.max_step = 0.01;
    Simulation<2> falling(scene, Communicator());
    while (falling.time() < 0.2)
        falling.step(0.2);
    EXPECT_FALSE(falling.settled());
}

// An oscillation is not, though it stands still twice a period.
TEST(Steadiness, AnOscillationIsNot)
{
    Scene scene = started_shear(0.05);
    scene.sides[0].kind = scene.sides[1].kind = SideScene::Kind::wall;
    scene.sides[3] = {};
    scene.size = {1, 1, 0};
    scene.cells = {16, 16, 1};
    scene.viscosity = 0;
    scene.until_steady = 0.1;
    BodyScene ball;
    ball.name = "ball";
    ball.shape = BodyScene::ShapeKind::ball;
    ball.radius = 0.2;
    ball.position = {0.5, 0.5, 0};
    ball.density = 5;
    ball.velocity = {0.05, 0, 0};
    ball.spring = SpringScene{{0.5, 0.5, 0}, 0.5, 0};
    scene.bodies = {ball};
    Simulation<2> simulation(scene, Communicator());
    while (simulation.time() < 20) {
        simulation.step(20);
        ASSERT_FALSE(simulation.settled()) << simulation.time();
    }
}

} // namespace
} // namespace gapflow
