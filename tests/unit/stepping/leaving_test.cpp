// Bodies that leave the domain through an open side, and bodies thinner than the extrapolated flow on their two sides: energy stays bounded.
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace gapflow {
namespace {

// A box of 1, its top open, and a disk below the top.
Scene disk_below_open_top()
{
    Scene scene;
    scene.dimension = 2;
    scene.size = {1, 1, 0};
    scene.cells = {64, 64, 1};
    scene.sides[3].kind = SideScene::Kind::open;
    BodyScene disk;
    disk.name = "disk";
    disk.shape = BodyScene::ShapeKind::ball;
    disk.radius = 0.12;
    disk.position = {0.53, 0.84, 0};
    disk.motion = BodyScene::Motion::prescribed;
    disk.velocity = {0, 1, 0};
    scene.bodies = {disk};
    scene.end = 0.4;
    scene.max_step = 0.01;
    return scene;
}

int count(const std::vector<std::string>& notes, const std::string& words)
{
    return static_cast<int>(std::count_if(notes.begin(), notes.end(),
                                          [&](const std::string& note) { return note.find(words) != std::string::npos; }));
}

TEST(Leaving, EnergyStaysBoundedAndTheRunSaysSo)
{
    const Scene scene = disk_below_open_top();
    Simulation<2> simulation(scene, Communicator());
    const double start = simulation.initial_report().energy_fluid;
    std::vector<std::string> notes;
    while (simulation.time() < scene.end) {
        const StepReport report = simulation.step(scene.end);
        EXPECT_LT(report.energy_fluid, 1.1 * start) << "at " << report.time;
        notes.insert(notes.end(), report.notes.begin(), report.notes.end());
    }
    EXPECT_EQ(count(notes, "'disk' is on its way out of the domain through the side y_high"), 1);
    EXPECT_EQ(count(notes, "'disk' has left the domain"), 1);
}

// What comes in from outside is no news.
TEST(Leaving, BodiesThatEnterAreNotMentioned)
{
    Scene scene = disk_below_open_top();
    scene.bodies[0].position[1] = 1.13;
    scene.bodies[0].velocity[1] = -1;
    Simulation<2> simulation(scene, Communicator());
    while (simulation.time() < 0.3)
        EXPECT_TRUE(simulation.step(0.3).notes.empty());
}

// A light disk rises out of the top, another one stays below.
Scene disk_that_rises()
{
    Scene scene = disk_below_open_top();
    scene.gravity = {0, -1, 0};
    scene.bodies[0].motion = BodyScene::Motion::free;
    scene.bodies[0].density = 0.5;
    BodyScene other = scene.bodies[0];
    other.name = "other";
    other.position = {0.3, 0.3, 0};
    other.velocity = {0, 0, 0};
    other.density = 1.5;
    scene.bodies.push_back(other);
    return scene;
}

TEST(Leaving, ARemovedBodyTakesItsMomentumAlongAndChangesNothingElse)
{
    Scene scene = disk_that_rises();
    Simulation<2> kept(scene, Communicator());
    scene.leaving = Scene::Leaving::remove;
    Simulation<2> removed(scene, Communicator());
    std::vector<std::string> notes;
    bool leaving = false;
    int after = 0;
    double energy_then = 0;
    while (after < 20) {
        const StepReport report = removed.step(10);
        kept.step(10);
        leaving = leaving || report.leaving;
        notes.insert(notes.end(), report.notes.begin(), report.notes.end());
        ASSERT_LT(removed.time(), 5);
        after += removed.removed(0) ? 1 : 0;
        EXPECT_LT(report.divergence_max, 1e-5);
        const Budget<2> with = kept.budget(), without = removed.budget();
        if (after == 0) {
            ASSERT_EQ(kept.bodies()[1].twist, removed.bodies()[1].twist);
        } else if (after == 1) { // the step that it left in
            const RigidBody<2>& disk = kept.bodies()[0];
            const Vec<2> momentum = disk.mass * disk.twist.head<2>();
            const double energy =
                0.5 * disk.mass * disk.twist.head<2>().squaredNorm() + 0.5 * disk.inertia(0) * disk.twist[2] * disk.twist[2];
            EXPECT_NEAR((without.momentum + momentum - with.momentum).norm(), 0, 1e-14);
            EXPECT_NEAR(without.energy_bodies + energy, with.energy_bodies, 1e-14);
            EXPECT_EQ(without.energy_grid, with.energy_grid);
            energy_then = without.energy_grid + without.energy_bodies;
        } else {
            EXPECT_LT(without.energy_grid + without.energy_bodies,
                      1.01 * energy_then); // the other disk has reached its terminal speed
        }
    }
    EXPECT_TRUE(leaving);
    EXPECT_EQ(count(notes, "'disk' has left the domain at time"), 1);
    EXPECT_EQ(count(notes, "is taken out of the scene"), 1);
    EXPECT_FALSE(removed.removed(1));
    EXPECT_EQ(removed.bodies()[0].twist.norm(), 0);
}

// Of a crowd the first one is named.
TEST(Leaving, ACrowdIsToldOfOnce)
{
    for (const auto leaving : {Scene::Leaving::warn, Scene::Leaving::remove}) {
        Scene scene = disk_below_open_top();
        scene.leaving = leaving;
        BodyScene disk = scene.bodies[0];
        disk.motion = BodyScene::Motion::free;
        disk.density = 1;
        disk.radius = 0.06;
        scene.bodies.clear();
        for (int i = 0; i < 4; ++i) {
            disk.name = i == 0 ? "disk" : "grain_000" + std::to_string(i);
            disk.position = {0.15 + 0.23 * i, 0.9, 0};
            scene.bodies.push_back(disk);
        }
        CrowdScene crowd;
        crowd.name = "grain";
        crowd.first = 1;
        crowd.number = 3;
        scene.crowds = {crowd};
        Simulation<2> simulation(scene, Communicator());
        std::vector<std::string> notes;
        while (simulation.outside().size() < 4) {
            const StepReport report = simulation.step(10);
            notes.insert(notes.end(), report.notes.begin(), report.notes.end());
            ASSERT_LT(simulation.time(), 2);
        }
        for (const char* does : {"is on its way out", "has left the domain"}) {
            EXPECT_EQ(count(notes, std::string("'disk' ") + does), 1);
            EXPECT_EQ(count(notes, does), 2);
        }
        EXPECT_EQ(count(notes, "the first of crowd 'grain'"), 2);
    }
}

TEST(Leaving, ARemovedBodyStaysOutWhenTheRunGoesOn)
{
    Scene scene = disk_that_rises();
    scene.leaving = Scene::Leaving::remove;
    Simulation<2> whole(scene, Communicator());
    while (!whole.removed(0))
        whole.step(10);
    Simulation<2> second(scene, Communicator(), whole.state());
    EXPECT_TRUE(second.removed(0));
    for (int i = 0; i < 5; ++i) {
        whole.step(10);
        second.step(10);
    }
    EXPECT_EQ(whole.bodies()[1].pose.position, second.bodies()[1].pose.position);
    EXPECT_EQ(whole.bodies()[0].pose.position, second.bodies()[0].pose.position);
}

// A stream between two open sides comes from a reservoir that moves with it: nothing holds it up.
TEST(Leaving, UniformStreamStays)
{
    Scene scene;
    scene.dimension = 2;
    scene.size = {1, 1, 0};
    scene.cells = {16, 16, 1};
    scene.sides[0].kind = scene.sides[1].kind = SideScene::Kind::open;
    scene.fluid_velocity = {0.7, 0, 0};
    scene.end = 0.2;
    scene.max_step = 0.02;
    Simulation<2> simulation(scene, Communicator());
    while (simulation.time() < scene.end)
        simulation.step(scene.end);
    EXPECT_NEAR(simulation.velocity().grid(0, Index<2>(7, 8)), 0.7, 1e-12);
}

// A hinged plate two cells thick swings down in ideal fluid: whole energy does not grow.
TEST(ThinBody, HingedPlateOfTwoCellsGainsNoEnergy)
{
    Scene scene;
    scene.dimension = 2;
    scene.size = {1, 1, 0};
    scene.cells = {64, 64, 1};
    scene.gravity = {0, -1, 0};
    BodyScene flap;
    flap.name = "flap";
    flap.shape = BodyScene::ShapeKind::capsule;
    flap.radius = 1.0 / 64;
    flap.length = 0.385;
    flap.position = {0.5, 0.5, 0};
    flap.density = 2.0;
    flap.hinge.emplace();
    flap.hinge->point = {0.3075, 0.5, 0};
    scene.bodies = {flap};
    scene.end = 4;
    scene.max_step = 0.005;
    Simulation<2> simulation(scene, Communicator());
    const double weight = simulation.bodies()[0].mass - simulation.bodies()[0].volume;
    double highest = 0, most = 0;
    while (simulation.time() < scene.end) {
        const StepReport report = simulation.step(scene.end);
        const double kinetic = report.energy_fluid + report.energy_bodies;
        most = std::max(most, kinetic);
        highest = std::max(highest, kinetic + weight * (simulation.bodies()[0].centre()[1] - 0.5));
    }
    EXPECT_LT(highest, 0.02 * most);
}

} // namespace
} // namespace gapflow
