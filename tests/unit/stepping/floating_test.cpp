// Floats in a water level, a side of the kind "surface": draught, energy, frequency, notes.
#include "gapflow/stepping/added_mass.hpp"
#include "gapflow/stepping/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

// A tank 3 wide and 1.5 deep, gravity 1, and a box of 0.5 x 0.4 that only goes up and down.
Scene tank_with_float(double density, double height)
{
    Scene scene;
    scene.dimension = 2;
    scene.size = {3, 1.5, 0};
    scene.cells = {48, 24, 1};
    scene.gravity = {0, -1, 0};
    scene.sides[3].kind = SideScene::Kind::surface;
    BodyScene box;
    box.name = "float";
    box.shape = BodyScene::ShapeKind::box;
    box.size = {0.5, 0.4, 0};
    box.position = {1.5, 1.5 + height, 0};
    box.density = density;
    box.free = {false, true, false, false, false, false};
    scene.bodies = {box};
    scene.end = 20;
    scene.max_step = 0.05;
    return scene;
}

template <int D>
double whole_energy(const Simulation<D>& simulation, const StepReport& report)
{
    double energy = report.energy_fluid + report.energy_bodies;
    for (const RigidBody<D>& body : simulation.bodies())
        energy += gravity_energy<D>(body, to_vec<D>(simulation.scene().gravity), simulation.scene().density);
    return energy;
}

// Runs to an end; the largest rise of the energy over the start's, over the largest kinetic energy.
template <int D>
double largest_rise(Simulation<D>& simulation, double end)
{
    const double start = whole_energy(simulation, simulation.initial_report());
    double rise = 0, kinetic = 0;
    while (simulation.time() < end) {
        const StepReport report = simulation.step(end);
        EXPECT_TRUE(report.notes.empty()) << report.notes.front();
        rise = std::max(rise, whole_energy(simulation, report) - start);
        kinetic = std::max(kinetic, report.energy_fluid + report.energy_bodies);
    }
    return rise / kinetic;
}

TEST(Floating, AtItsDraughtABodyStaysAtRest)
{
    for (const double density : {0.05, 0.5, 0.9}) {
        Scene scene = tank_with_float(density, 0.2 - 0.4 * density);
        scene.bodies[0].free.fill(true);
        scene.bodies[0].size = {0.9, 0.4, 0}; // upright it is stable
        Simulation<2> simulation(scene, Communicator());
        while (simulation.time() < 1)
            simulation.step(1);
        EXPECT_NEAR(simulation.bodies()[0].twist.norm(), 0, 1e-9) << density;
        EXPECT_NEAR(simulation.fluid_wrenches()[0][1], density * 0.36, 1e-9) << density;
    }
}

TEST(Floating, SettlesAtItsDraughtAndGainsNoEnergy)
{
    for (const double density : {0.2, 0.5, 0.9}) {
        Scene scene = tank_with_float(density, -0.05);
        scene.viscosity = 0.02;
        Simulation<2> simulation(scene, Communicator());
        EXPECT_LT(largest_rise(simulation, scene.end), 1e-3) << density;
        const double draught = 1.5 - (simulation.bodies()[0].centre()[1] - 0.2);
        EXPECT_NEAR(draught, 0.4 * density, 0.01 * 0.4) << density;
    }
}

} // namespace
} // namespace gapflow
