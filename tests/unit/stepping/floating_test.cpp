// Floats in a water level, a side of the kind "surface": draught, energy, frequency, notes.
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/added_mass.hpp"

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
        scene.max_step = 0.1;
        Simulation<2> simulation(scene, Communicator());
        EXPECT_LT(largest_rise(simulation, scene.end), 1e-3) << density;
        EXPECT_NEAR(displacement(simulation.bodies()[0]).volume, density * 0.2, 0.01 * density * 0.2) << density;
    }
}

// Dropped into the water, and let go in it so that it jumps out: ideal fluid, disks, which turn too.
TEST(Floating, DisksThatDiveAndJumpGainNoEnergy)
{
    for (const double density : {0.2, 0.9})
        for (const double height : {0.5, -0.4}) {
            Scene scene = tank_with_float(density, height);
            scene.bodies[0].shape = BodyScene::ShapeKind::ball;
            scene.bodies[0].radius = 0.25;
            scene.bodies[0].free.fill(true);
            scene.bodies[0].angular_velocity = {0.3, 0, 0};
            Simulation<2> simulation(scene, Communicator());
            EXPECT_LT(largest_rise(simulation, 4), 0.01) << density << " " << height;
        }
}

// A draught of a thirtieth of a cell and a period of 0.4: steps that fall into the water by more would throw it out with ever more energy (once the largest
// kinetic energy). A flat bottom that passes a plane of faces makes 0.13 of it, of a fluid that is much heavier.
TEST(Floating, ALightFloatIsNotThrownOut)
{
    Scene scene = tank_with_float(0.01, 0.16);
    scene.cells = {24, 12, 1};
    scene.max_step = 0.2;
    Simulation<2> simulation(scene, Communicator());
    EXPECT_LT(largest_rise(simulation, 4), 0.3);
}

// Small oscillations: w^2 = rho g A / (m + m_a), with the grid's own added mass.
TEST(Floating, HeavesAtTheFrequencyOfLinearTheory)
{
    Scene scene = tank_with_float(0.5, 0.015); // draught 0.2; 0.013 below its rest
    scene.bodies[0].position[1] -= 0.028;
    scene.max_step = 0.04;
    const double added = added_mass(scene, Communicator()).matrix(1, 1), frequency = std::sqrt(0.5 / (0.5 * 0.2 + added));
    Simulation<2> simulation(scene, Communicator());
    double before = simulation.bodies()[0].twist[1], turned = 0;
    while (turned == 0) {
        simulation.step(20);
        const double now = simulation.bodies()[0].twist[1];
        if (before > 0 && now <= 0) // half a period
            turned = simulation.time() - 0.5 * 0.04;
        before = now;
        ASSERT_LT(simulation.time(), 10);
    }
    EXPECT_NEAR(turned * frequency, std::numbers::pi, 0.03 * std::numbers::pi);
}

// Half out of an open side a body is on its way out, and is told what it lacks.
TEST(Floating, TheWarningOfAnOpenSideNamesSurfaceSides)
{
    Scene scene = tank_with_float(0.5, -0.1);
    scene.sides[3].kind = SideScene::Kind::open;
    Simulation<2> simulation(scene, Communicator());
    const StepReport report = simulation.step(10);
    ASSERT_EQ(report.notes.size(), 1u);
    EXPECT_NE(report.notes[0].find("on its way out"), std::string::npos);
    EXPECT_NE(report.notes[0].find("write domain.sides.y_high = \"surface\""), std::string::npos);
    scene.gravity = {0.1, -1, 0};
    Simulation<2> oblique(scene, Communicator());
    EXPECT_EQ(oblique.step(10).notes.at(0).find("surface"), std::string::npos);
}

// A box falls by a tenth of a cell through air onto a float, and rests on it above the water.
TEST(Floating, BodiesTouchAboveTheWater)
{
    Scene scene = tank_with_float(0.5, 0);
    BodyScene load = scene.bodies[0];
    load.name = "load";
    load.size = {0.2, 0.1, 0};
    load.position[1] = 1.5 + 0.2 + 0.05 + 0.006;
    scene.bodies.push_back(load);
    Simulation<2> simulation(scene, Communicator());
    while (simulation.time() < 1) {
        simulation.step(1);
        EXPECT_GT((simulation.bodies()[1].centre() - simulation.bodies()[0].centre())[1], 0.25 - 1e-3 * 0.0625);
    }
    EXPECT_LT(simulation.bodies()[0].centre()[1], 1.5); // under the load
    EXPECT_NEAR(simulation.bodies()[0].twist[1], simulation.bodies()[1].twist[1], 1e-6);
}

TEST(Floating, ARestoredRunGoesOnAsTheSame)
{
    const Scene scene = tank_with_float(0.3, 0.05);
    Simulation<2> first(scene, Communicator());
    for (int i = 0; i < 3; ++i)
        first.step(10);
    Simulation<2> second(scene, Communicator(), first.state());
    for (int i = 0; i < 3; ++i) {
        first.step(10);
        second.step(10);
    }
    EXPECT_EQ(first.bodies()[0].twist, second.bodies()[0].twist);
    EXPECT_EQ(first.bodies()[0].pose.position, second.bodies()[0].pose.position);
}

// The level is where the reference pressure acts; a ball of three dimensions settles, too.
TEST(Floating, ABallSettlesInThreeDimensions)
{
    Scene scene;
    scene.dimension = 3;
    scene.size = {1, 1, 1};
    scene.cells = {12, 12, 12};
    scene.gravity = {0, 0, 1}; // the level is below
    scene.sides[4].kind = SideScene::Kind::surface;
    scene.reference_pressure = 3;
    scene.viscosity = 0.02;
    BodyScene ball;
    ball.name = "float";
    ball.shape = BodyScene::ShapeKind::ball;
    ball.radius = 0.25;
    ball.position = {0.5, 0.47, 0.1};
    ball.density = 0.4;
    scene.bodies = {ball};
    scene.max_step = 0.1;
    Simulation<3> simulation(scene, Communicator());
    EXPECT_EQ(simulation.hydrostatic(Vec<3>(0.2, 0.3, 0)), 3);
    EXPECT_LT(largest_rise(simulation, 8), 1e-3);
    const RigidBody<3>& body = simulation.bodies()[0];
    EXPECT_NEAR(displacement(body).volume, 0.4 * body.volume, 0.01 * 0.4 * body.volume);
}

} // namespace
} // namespace gapflow
