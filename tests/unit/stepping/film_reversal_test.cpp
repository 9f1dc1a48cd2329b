// Plates that approach each other in ideal flow: the film stops them, and they part as they came.
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gapflow {
namespace {

constexpr double start = 0.02;

Scene plates(int cells)
{
    Scene scene;
    scene.size = {4, 4, 0};
    scene.cells = {cells, cells, 1};
    scene.initial = Scene::Initial::potential;
    scene.max_step = 0.32 / cells;
    scene.gap_cfl = 4.0 / cells;
    for (int side : {1, -1}) {
        BodyScene plate;
        plate.name = side > 0 ? "upper" : "lower";
        plate.shape = BodyScene::ShapeKind::box;
        plate.size = {1, 0.5, 0};
        plate.position = {2, 2 + side * (0.25 + start / 2), 0};
        plate.velocity = {0, -0.5 * side, 0};
        plate.density = 2;
        scene.bodies.push_back(plate);
    }
    return scene;
}

struct Gap {
    double thickness, rate, turning;
};

Gap gap(const Simulation<2>& simulation)
{
    const auto &upper = simulation.bodies()[0], &lower = simulation.bodies()[1];
    return {upper.pose.position[1] - lower.pose.position[1] - 0.5, upper.twist[1] - lower.twist[1],
            std::max(std::abs(upper.twist[2]), std::abs(lower.twist[2]))};
}

TEST(FilmTurn, PlatesPartAsTheyCame)
{
    Simulation<2> simulation(plates(64), Communicator());
    double thinnest = 1, impulse = 0, speed = 0;
    for (Gap before = gap(simulation); simulation.time() < 0.2 && speed == 0;) {
        simulation.step(0.2);
        const Gap now = gap(simulation);
        thinnest = std::min(thinnest, now.thickness);
        for (const GapState& state : simulation.gaps())
            impulse += state.contact_impulse;
        if (now.rate < 0) {
            EXPECT_LT(now.turning, 1e-6) << "at " << now.thickness; // the scene is symmetric
        }
        if (now.thickness > start)
            speed = before.rate + (start - before.thickness) / (now.thickness - before.thickness) * (now.rate - before.rate);
        before = now;
    }
    EXPECT_GT(thinnest, 0);
    EXPECT_LT(thinnest, 1e-4 * 4 / 64);
    EXPECT_EQ(impulse, 0);
    EXPECT_NEAR(speed, 1, 0.03); // 0.98
}

// With steps of an eighth of the gap: heads are taken with the flux expected at a mouth, which follows the gap's thickness. (With the film's speed alone
// the plates come back with 0.956.)
TEST(FilmMouths, LongStepsCostPlatesLittleSpeed)
{
    Scene scene = plates(64);
    scene.gap_cfl = 8.0 / 64;
    scene.tolerance = 1e-13; // a tilt grows while the plates approach
    Simulation<2> simulation(scene, Communicator());
    Gap before = gap(simulation), now = before;
    for (; simulation.time() < 0.2 && now.thickness <= start; now = gap(simulation)) {
        before = now;
        simulation.step(0.2);
    }
    const double share = (start - before.thickness) / (now.thickness - before.thickness);
    EXPECT_NEAR(before.rate + share * (now.rate - before.rate), 1, 0.025); // 0.980
}

// The first step, which knows no accelerations: plates that open by a fifth of their gap. (With the film's speed alone 3.7 % of the energy is lost.)
TEST(FilmMouths, PlatesThatOpenKeepTheirEnergy)
{
    Scene scene = plates(64);
    scene.max_step = 0.01;
    scene.gap_cfl = 0.25;
    for (int b = 0; b < 2; ++b) {
        scene.bodies[b].velocity[1] = b == 0 ? 0.1 : -0.1;
        scene.bodies[b].position[1] = 2 + (b == 0 ? 1 : -1) * 0.255;
    }
    Simulation<2> simulation(scene, Communicator());
    auto energy = [&] {
        const Budget<2> budget = simulation.budget();
        return budget.energy_grid + budget.energy_film + budget.energy_bodies;
    };
    const double first = energy();
    for (int step = 0; step < 4; ++step) {
        simulation.step(1);
        EXPECT_NEAR(energy() / first, 1, 0.01) << step;
    }
}

// What leaves as a jet gives nothing back: the plates stay together.
TEST(FilmTurn, NotWithJets)
{
    Scene scene = plates(64);
    scene.gap.exit = GapScene::Exit::jet;
    Simulation<2> simulation(scene, Communicator());
    while (simulation.time() < 0.1)
        simulation.step(0.1);
    EXPECT_LT(gap(simulation).thickness, start);
    EXPECT_LE(gap(simulation).rate, 0);
}

// A plate that leaves a floor does as it does alone, whatever films there are elsewhere: a ball close to the floor, held, has a
// curved one.
TEST(FilmTurn, ACurvedFilmElsewhereChangesNothing)
{
    Scene scene;
    scene.size = {2, 1, 0};
    scene.cells = {48, 24, 1};
    scene.max_step = 0.02;
    BodyScene plate, ball;
    plate.name = "plate";
    plate.shape = BodyScene::ShapeKind::box;
    plate.size = {0.6, 0.2, 0};
    plate.position = {0.5, 0.1002, 0};
    plate.velocity = {0, 0.02, 0};
    plate.density = 0.1;
    ball.name = "ball";
    ball.shape = BodyScene::ShapeKind::ball;
    ball.radius = 0.1;
    ball.position = {1.7, 0.11, 0};
    ball.motion = BodyScene::Motion::fixed;
    double risen[2];
    for (int with_ball : {0, 1}) {
        scene.bodies = {plate};
        if (with_ball)
            scene.bodies.push_back(ball);
        Simulation<2> simulation(scene, Communicator());
        while (simulation.time() < 0.1)
            simulation.step(0.1);
        risen[with_ball] = simulation.bodies()[0].pose.position[1] - plate.position[1];
    }
    EXPECT_NEAR(risen[1], risen[0], 1e-3 * risen[0]); // 10 % with films of first order beside a curved one
}

// Plates that near each other from three cells: while their gap is about a cell the bulk takes up much of what leaves by the mouths, and their
// heads do not give that back too. (Counted twice the energy rose by a quarter.)
TEST(FilmMouths, WhatTheBulkTakesUpIsNotRegained)
{
    Scene scene = plates(64);
    for (int side : {0, 1})
        scene.bodies[side].position[1] += (side == 0 ? 0.5 : -0.5) * (0.2 - start);
    scene.max_step = 0.005;
    scene.gap_cfl = 0.125;
    Simulation<2> simulation(scene, Communicator());
    const double energy = simulation.initial_report().energy_fluid + simulation.initial_report().energy_bodies;
    double highest = 0;
    while (gap(simulation).thickness > 0.02 && simulation.time() < 1) {
        const StepReport report = simulation.step(1);
        highest = std::max(highest, report.energy_fluid + report.energy_bodies);
    }
    EXPECT_LT(gap(simulation).thickness, 0.1);
    EXPECT_LT(highest, 1.005 * energy);
}

} // namespace
} // namespace gapflow
