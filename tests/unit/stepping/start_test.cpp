// What a simulation makes of bodies that touch or overlap at the start.
#include "gapflow/core/error.hpp"
#include "gapflow/step/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

Scene closed_box(int cells)
{
    Scene scene;
    scene.size = {1, 1, 0};
    scene.cells = {cells, cells, 1};
    scene.end = 0.1;
    scene.max_step = 0.01;
    return scene;
}

BodyScene ball(const std::string& name, double radius, double x, double y, double density = 1)
{
    BodyScene body;
    body.name = name;
    body.radius = radius;
    body.position = {x, y, 0};
    body.density = density;
    return body;
}

BodyScene box(const std::string& name, double width, double height, double x, double y, double degrees = 0)
{
    BodyScene body = ball(name, 0, x, y);
    body.shape = BodyScene::ShapeKind::box;
    body.size = {width, height, 0};
    body.angle = degrees * std::numbers::pi / 180;
    return body;
}

double energy(const StepReport& report)
{
    return report.energy_fluid + report.energy_bodies;
}

// A body on the floor that moves into it at the start.
Scene falling_onto_the_floor(const BodyScene& body)
{
    Scene scene = closed_box(32);
    scene.contact.restitution = 1;
    scene.bodies = {body};
    scene.bodies[0].velocity = {0, -1, 0};
    return scene;
}

TEST(Start, ATouchingDiskRebounds)
{
    for (const double density : {0.3, 1.0, 3.0}) {
        Simulation<2> simulation(falling_onto_the_floor(ball("disk", 0.15, 0.5, 0.15, density)), Communicator());
        const double start = energy(simulation.initial_report());
        EXPECT_GT(start, 1.5 * 0.5 * density * std::numbers::pi * 0.0225); // with the fluid's
        for (int i = 0; i < 3; ++i) {
            EXPECT_LE(energy(simulation.step(1)), 1.002 * start) << density;
            EXPECT_NEAR(simulation.bodies()[0].twist[1], 1, 0.1) << density;
        }
    }
}

TEST(Start, ABoxThatFallsFlatStartsAtRest)
{
    for (const double density : {1.0, 10.0}) {
        Scene scene = falling_onto_the_floor(box("box", 0.3, 0.3, 0.5, 0.15));
        scene.bodies[0].density = density;
        scene.gap.roughness = 0.1 / 32;
        Simulation<2> simulation(scene, Communicator());
        EXPECT_EQ(energy(simulation.initial_report()), 0) << density;
        EXPECT_THAT(simulation.initial_report().notes,
                    testing::Contains(testing::HasSubstr("'box' and 'wall:y_low' lie flat")));
        EXPECT_EQ(energy(simulation.step(1)), 0) << density;
    }
}

// A disk moves into another that it overlaps by `overlap` cells.
Scene two_disks(double overlap)
{
    Scene scene = closed_box(48);
    scene.bodies = {ball("a", 0.1, 0.4, 0.5), ball("b", 0.1, 0.6 - overlap / 48, 0.5)};
    scene.bodies[0].velocity = {0.4, 0, 0};
    return scene;
}

TEST(Start, OverlapsAddNothingToTheEnergy)
{
    const double touching = energy(Simulation<2>(two_disks(0), Communicator()).initial_report());
    EXPECT_LT(touching, 0.01);
    for (double overlap : {1e-5, 0.05, 0.2, 0.9, 3.0}) {
        Simulation<2> simulation(two_disks(overlap), Communicator());
        EXPECT_NEAR(energy(simulation.initial_report()), touching, 0.03 * touching) << overlap;
        const auto& bodies = simulation.bodies();
        EXPECT_NEAR((bodies[1].pose.position - bodies[0].pose.position).norm(), 0.2, 1e-8 / 48);
        EXPECT_NEAR(bodies[0].pose.position[0], 0.4 - 0.5 * overlap / 48, 1e-6 / 48); // half each
        EXPECT_THAT(simulation.initial_report().notes, testing::Contains(testing::HasSubstr("'a' and 'b' by")));
        simulation.step(simulation.scene().end);
        for (const auto& body : bodies)
            EXPECT_LT(body.twist.norm(), 0.5) << overlap;
    }
}

TEST(Start, TouchingBodiesStayWhereTheyAre)
{
    const Simulation<2> simulation(two_disks(0), Communicator());
    EXPECT_THAT(simulation.initial_report().notes, testing::IsEmpty());
    EXPECT_EQ(simulation.bodies()[0].pose.position[0], 0.4);
}

// The ball is a thousandth of the boxes' mass, and their faces make a wedge: by the metric of mass it leaves it by six cells.
TEST(Start, APinchedBallSharesItsOverlaps)
{
    Scene scene = closed_box(48);
    scene.bodies = {box("l", 0.2, 0.2, 0.3, 0.5, 5), box("r", 0.2, 0.2, 0.7, 0.5, -5),
                    ball("p", 0.1 + 0.5 / 48, 0.5, 0.5, 1e-3)};
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 3; ++i) {
        for (std::size_t b = 0; b < 3; ++b) {
            const Vec<2> start(scene.bodies[b].position[0], scene.bodies[b].position[1]);
            EXPECT_LT((simulation.bodies()[b].pose.position - start).norm() * 48, 0.6) << scene.bodies[b].name;
        }
        simulation.step(scene.end);
    }
}

// Fixed plates that leave half a cell too little: nothing can give way, and nothing is thrown out.
TEST(Start, WhatIsWedgedInStays)
{
    Scene scene = closed_box(48);
    scene.bodies = {box("l", 0.2, 0.4, 0.3, 0.5, 2), box("r", 0.2, 0.4, 0.7, 0.5, -2), ball("p", 0.1 + 0.3 / 48, 0.5, 0.5)};
    scene.bodies[0].motion = scene.bodies[1].motion = BodyScene::Motion::fixed;
    Simulation<2> simulation(scene, Communicator());
    simulation.step(scene.end);
    EXPECT_LT((simulation.bodies()[2].pose.position - Vec<2>(0.5, 0.5)).norm() * 48, 12.0);
    EXPECT_LT(energy(simulation.initial_report()), 1e-6);
}

TEST(Start, WhatCannotBePushedApartIsRefused)
{
    Scene scene = closed_box(48);
    scene.bodies = {box("outer", 0.4, 0.4, 0.5, 0.5), box("inner", 0.2, 0.2, 0.5, 0.5)};
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    EXPECT_THROW(Simulation<2>(scene, Communicator()), InputError);
}

// Boxes flush with each other overlap by their corners, which are nearest to faces that do not face each other.
TEST(Start, FlushBoxesArePushedApart)
{
    for (double overlap : {0.0, 0.2, 1.5}) {
        Scene scene = closed_box(32);
        scene.bodies = {box("a", 0.25, 0.25, 0.3, 0.5), box("b", 0.25, 0.25, 0.55 - overlap / 32, 0.5)};
        Simulation<2> simulation(scene, Communicator());
        EXPECT_NEAR((simulation.bodies()[1].pose.position - simulation.bodies()[0].pose.position).norm(), 0.25, 1e-8);
        EXPECT_NEAR(simulation.bodies()[0].pose.position[1], 0.5, 1e-12);
    }
}

// A box that lies on the floor and moves into it, or off it: a film without thickness takes up none of that at the start.
TEST(Start, FlatContactDrivesNoFilm)
{
    for (double speed : {-1.0, 1.0})
        for (auto motion : {BodyScene::Motion::free, BodyScene::Motion::prescribed}) {
            Scene scene = closed_box(32);
            scene.sides[3].kind = SideScene::Kind::open;
            scene.bodies = {box("p", 0.25, 0.25, 0.5, 0.125)};
            scene.bodies[0].motion = motion;
            scene.bodies[0].velocity = {0, speed, 0};
            Simulation<2> simulation(scene, Communicator());
            EXPECT_LT(simulation.initial_report().energy_fluid, 0.1);
            if (motion == BodyScene::Motion::prescribed && speed < 0) {
                EXPECT_THROW(simulation.step(scene.end), ComputationError);
                continue;
            }
            for (int i = 0; i < 5; ++i)
                simulation.step(scene.end);
            EXPECT_LT(energy(simulation.initial_report()), 0.1);
        }
}

} // namespace
} // namespace gapflow
