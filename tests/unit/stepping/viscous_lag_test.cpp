// Steps of so viscous fluid that forces on bodies lag behind: they follow the bodies, and no energy is gained.
#include "gapflow/step/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace gapflow {
namespace {

BodyScene body(const std::string& name, BodyScene::ShapeKind shape, double x, double y, double density, double degrees)
{
    BodyScene b;
    b.name = name;
    b.shape = shape;
    b.position = {x, y, 0};
    b.density = density;
    b.angle = degrees * std::numbers::pi / 180;
    return b;
}

// Two heavy capsules and a light box, nu dt / dx^2 = 1000 with the longest step.
Scene heavy_and_light()
{
    Scene scene;
    scene.size = {1, 1, 0};
    scene.cells = {32, 32, 1};
    scene.gravity = {0.3, -1, 0};
    scene.viscosity = 48.828125;
    scene.gap.roughness = 0.001;
    scene.gap.exit = GapScene::Exit::reversible;
    scene.contact.friction = 0.3;
    scene.end = 1;
    scene.max_step = 0.02;
    BodyScene box = body("box", BodyScene::ShapeKind::box, 0.3328, 0.3615, 0.5, 17.75);
    box.size = {0.1549, 0.1626, 0};
    BodyScene one = body("one", BodyScene::ShapeKind::capsule, 0.4421, 0.4639, 50, 160.7);
    one.radius = 0.04365;
    one.length = 0.02815;
    one.velocity = {-0.6878, -0.0555, 0};
    BodyScene other = body("other", BodyScene::ShapeKind::capsule, 0.1946, 0.4454, 50, 41.85);
    other.radius = 0.04888;
    other.length = 0.09582;
    scene.bodies = {box, one, other};
    return scene;
}

TEST(ViscousLag, StepsFollowTheBodies)
{
    const Scene scene = heavy_and_light();
    Simulation<2> simulation(scene, Communicator());
    const StepReport& start = simulation.initial_report();
    const double energy = start.energy_fluid + start.energy_bodies;
    std::vector<std::string> notes;
    double longest = 0;
    while (simulation.time() < 0.05) {
        const StepReport report = simulation.step(scene.end);
        EXPECT_LE(report.energy_fluid + report.energy_bodies, 1.01 * energy) << "step " << report.step;
        notes.insert(notes.end(), report.notes.begin(), report.notes.end());
        longest = std::max(longest, report.dt);
    }
    EXPECT_THAT(notes, testing::Contains(testing::HasSubstr("steps are no longer than 0.0008")));
    EXPECT_GT(longest, 0.0016); // where motion is steady
    Simulation<2> restored(scene, Communicator(), simulation.state());
    EXPECT_EQ(restored.step(scene.end).dt, simulation.step(scene.end).dt);
}

} // namespace
} // namespace gapflow
