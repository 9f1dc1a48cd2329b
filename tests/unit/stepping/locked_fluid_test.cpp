// Contacts that hold bodies against fluid which only their motion lets out.
#include "gapflow/step/simulation.hpp"

#include "temporary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <tuple>

namespace gapflow {
namespace {

// Two gears of six teeth on hinges, which turn against each other and touch: between walls that they reach over films they part the domain in two.
Scene gears(const std::string& file)
{
    Scene scene;
    scene.size = {2.0 / 3, 0.375, 0};
    scene.origin = {0.14583333333333334, 0.3125, 0};
    scene.cells = {32, 18, 1};
    scene.contact.friction = 0.3;
    scene.gap.roughness = 1e-5;
    scene.end = scene.max_step = 0.02;
    for (const auto& [name, x, degrees, rate] : {std::tuple("left", 0.33, 13.398834288160982, 0.6463837563774056),
                                                 std::tuple("right", 0.64, 38.50495414228817, -0.9282804679937988)}) {
        BodyScene gear;
        gear.name = name;
        gear.shape = BodyScene::ShapeKind::mesh;
        gear.mesh_file = file;
        gear.position = {x, 0.5, 0};
        gear.angle = degrees * std::numbers::pi / 180;
        gear.density = 1;
        gear.hinge = HingeScene{{x, 0.5, 0}, {1, 0, 0}};
        gear.angular_velocity = {rate, 0, 0};
        scene.bodies.push_back(gear);
    }
    return scene;
}

TEST(LockedFluid, GearsThatTouchGiveWayToIt)
{
    std::ostringstream outline;
    outline.precision(17);
    for (int tooth = 0; tooth < 6; ++tooth)
        for (const auto& [radius, degrees] :
             {std::pair(0.13, 0.0), std::pair(0.17, 6.0), std::pair(0.17, 30.0), std::pair(0.13, 36.0)}) {
            const double angle = (60 * tooth + degrees) * std::numbers::pi / 180;
            outline << radius * std::cos(angle) << ' ' << radius * std::sin(angle) << '\n';
        }
    const test::TemporaryFile gear("gear.txt", outline.str());
    for (const double viscosity : {0.0, 1e-3})
        for (const double roughness : {1e-5, 3e-5}) {
            Scene scene = gears(gear.path());
            scene.viscosity = viscosity;
            scene.gap.roughness = roughness;
            Simulation<2> simulation(scene, Communicator());
            const StepReport& start = simulation.initial_report();
            const StepReport report = simulation.step(scene.end);
            EXPECT_LE(report.energy_fluid + report.energy_bodies, start.energy_fluid + start.energy_bodies) << viscosity;
            EXPECT_LT(report.divergence_max, 1e-5);
            EXPECT_THAT(report.notes, testing::Not(testing::Contains(testing::HasSubstr("did not settle"))));
        }
}

} // namespace
} // namespace gapflow
