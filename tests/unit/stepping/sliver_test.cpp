// Faces that a body leaves open by a few hundredths: what squeezes through them does not feed itself.
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace gapflow {
namespace {

// Two hinged flaps in line, tip to tip: a light one rises, a heavy one falls past it. Viscosity acts over 2e-4 to 1 of a cell's square in
// a step. In a closed tank kinetic energy stays below what weight gives over the flaps' lengths.
class Flaps : public testing::TestWithParam<double> {};

TEST_P(Flaps, TipsPassAndEnergyStaysBounded)
{
    const double dx = 0.00025, length = 0.002812949237867956, height = 0.005640570162536141;
    Scene scene;
    scene.size = {34 * dx, 44 * dx, 0};
    scene.cells = {34, 44, 1};
    scene.gravity = {0, -1, 0};
    scene.density = 1000;
    scene.viscosity = GetParam();
    scene.end = 0.11;
    scene.max_step = 0.00094;
    for (const bool left : {true, false}) {
        BodyScene flap;
        flap.name = left ? "left" : "right";
        flap.shape = BodyScene::ShapeKind::box;
        flap.size = {length, 0.00085398601405935, 0};
        flap.position = {left ? 0.002831025381066 : 0.005668974618934, height, 0};
        flap.angle = left ? 0 : std::numbers::pi;
        flap.density = left ? 141.0 : 16216;
        flap.hinge.emplace();
        flap.hinge->point = {left ? 0.001424550762132 : 0.007075449237868, height, 0};
        scene.bodies.push_back(flap);
    }
    Simulation<2> simulation(scene, Communicator());
    double weight = 0;
    for (const auto& body : simulation.bodies())
        weight += std::abs(body.mass - scene.density * body.volume);
    while (simulation.time() < scene.end) {
        const StepReport report = simulation.step(scene.end);
        ASSERT_LT(report.energy_fluid + report.energy_bodies, weight * length) << "at " << report.time;
    }
}

INSTANTIATE_TEST_SUITE_P(Viscosities, Flaps, testing::Values(9e-6, 9e-5, 9e-4, 9e-2));

} // namespace
} // namespace gapflow
