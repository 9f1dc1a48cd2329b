// Bodies that leave the domain through an open side, and bodies thinner than the extrapolated flow on their two sides: energy stays bounded.
#include "gapflow/stepping/simulation.hpp"

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
