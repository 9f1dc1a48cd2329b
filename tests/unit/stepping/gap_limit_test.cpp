// The step's limit by gaps: a film that hardly changes its bodies' motion may change by any factor in a step, and acts as over many small steps.
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapflow {
namespace {

// A plate, `density` times as heavy as the fluid, closes a gap of 0.003 with unit speed.
Scene plate(double density, double viscosity)
{
    Scene scene;
    scene.dimension = 2;
    scene.size = {2, 1, 0};
    scene.cells = {32, 16, 1};
    scene.viscosity = viscosity;
    scene.sides[3].kind = SideScene::Kind::open;
    scene.max_step = 1;
    scene.gap.roughness = 0.005 / 16;
    BodyScene box;
    box.name = "box";
    box.shape = BodyScene::ShapeKind::box;
    box.size = {0.6, 0.3, 0};
    box.position = {0.97, 0.153, 0};
    box.velocity = {0, -1, 0};
    box.density = density;
    box.free = {false, true, false, false, false, false};
    scene.bodies = {box};
    return scene;
}

// Over the way from h0 to h viscosity takes mu L^3 / (2 m) (1 / h^2 - 1 / h0^2) of the speed, the film's inertia, rho L^3 / (12 h), half of its
// growth over m.
TEST(GapLimit, AStepBeyondItsGapsPartKeepsTheRightSpeed)
{
    const double viscosity = 2e-3, h0 = 0.003, L = 0.6;
    Scene scene = plate(1e4, viscosity);
    scene.max_step = 0.4 * h0;
    Simulation<2> simulation(scene, Communicator());
    EXPECT_EQ(simulation.step(1e9).dt, scene.max_step) << "gap_cfl alone allows 0.25";
    const RigidBody<2>& box = simulation.bodies()[0];
    const double h = box.pose.position[1] - 0.15, lost = 1 + box.twist[1];
    const double by_viscosity = viscosity * std::pow(L, 3) / (2 * box.mass) * (1 / (h * h) - 1 / (h0 * h0));
    const double by_inertia = std::pow(L, 3) / 12 * (1 / h - 1 / h0) / (2 * box.mass);
    EXPECT_NEAR(h, h0 - scene.max_step * (1 - 0.5 * lost), 0.05 * lost * scene.max_step);
    // The resistance at the end of the step would take 0.049, its mean 0.025.
    EXPECT_NEAR(lost, by_viscosity + by_inertia, 0.1 * (by_viscosity + by_inertia));
}

TEST(GapLimit, AFilmThatSlowsThePlateFollowsItsGap)
{
    const Scene scene = plate(2, 1e-4);
    Simulation<2> simulation(scene, Communicator());
    EXPECT_LE(simulation.step(1e9).dt, 0.25 * 0.003 * (1 + 1e-9));
}

// Drag that takes a fifth of the speed in a step is no reason for smaller ones: it takes what it takes over many. (An implicit step with the way's mean
// resistance takes 0.88 of it here.)
TEST(GapLimit, DragThatTakesAFifthOfTheSpeed)
{
    const double viscosity = 1e-2, h0 = 0.003, L = 0.6;
    Scene scene = plate(1e4, viscosity);
    scene.max_step = 0.4 * h0;
    Simulation<2> simulation(scene, Communicator());
    EXPECT_GT(simulation.step(1e9).dt, 0.36 * h0) << "gap_cfl alone allows 0.25";
    EXPECT_GT(simulation.step(1e9).dt, 0.2 * h0) << "0.3 of the gap";
    const RigidBody<2>& box = simulation.bodies()[0];
    const double h = box.pose.position[1] - 0.15, lost = 1 + box.twist[1];
    const double by_viscosity = viscosity * std::pow(L, 3) / (2 * box.mass) * (1 / (h * h) - 1 / (h0 * h0));
    const double by_inertia = std::pow(L, 3) / 12 * (1 / h - 1 / h0) / (2 * box.mass);
    EXPECT_NEAR(lost, by_viscosity + by_inertia, 0.07 * (by_viscosity + by_inertia));
}

// A plate that comes down slowly limits no step by its film's drag where the flow elsewhere is much faster: what the step misses of its speed is little
// beside that.
TEST(GapLimit, ASlowPlateInFastFlow)
{
    const double viscosity = 2e-4, h0 = 0.001, L = 0.6, V = 0.04;
    Scene scene = plate(1e4, viscosity);
    scene.bodies[0].position = {0.97, 0.15 + h0, 0};
    scene.bodies[0].velocity = {0, -V, 0};
    scene.max_step = 0.01; // 0.4 of the gap, half of the speed
    BodyScene fast;
    fast.name = "fast";
    fast.shape = BodyScene::ShapeKind::box;
    fast.size = {0.4, 0.2, 0};
    fast.position = {0.97, 0.72, 0};
    fast.motion = BodyScene::Motion::prescribed;
    scene.bodies.push_back(fast);
    EXPECT_LT(Simulation<2>(scene, Communicator()).step(1e9).dt, 0.75 * scene.max_step);
    scene.bodies[1].velocity = {1.2, 0, 0};
    Simulation<2> simulation(scene, Communicator());
    EXPECT_EQ(simulation.step(1e9).dt, scene.max_step);
    const RigidBody<2>& box = simulation.bodies()[0];
    const double h = box.pose.position[1] - 0.15, lost = V + box.twist[1];
    const double by_viscosity = viscosity * std::pow(L, 3) / (2 * box.mass) * (1 / (h * h) - 1 / (h0 * h0));
    EXPECT_NEAR(lost, by_viscosity, 0.15 * by_viscosity);
}

// A step that the gap limits takes from the plate what the way takes as well, and nearly so where drag takes much of the speed in a step.
TEST(GapLimit, DragOfStepsThatTheGapLimits)
{
    const double viscosity = 1e-2, h0 = 0.003, L = 0.6;
    Scene scene = plate(1e4, viscosity);
    scene.long_ways = false;
    Simulation<2> simulation(scene, Communicator());
    const auto lost = [&] {
        const RigidBody<2>& box = simulation.bodies()[0];
        const double h = box.pose.position[1] - 0.15;
        const double by_viscosity = viscosity * std::pow(L, 3) / (2 * box.mass) * (1 / (h * h) - 1 / (h0 * h0));
        const double by_inertia = std::pow(L, 3) / 12 * (1 / h + 1 / h0) / (2 * box.mass);
        return (1 + box.twist[1]) / (by_viscosity + by_inertia);
    };
    simulation.step(1e9);
    EXPECT_NEAR(lost(), 1, 0.05);
    simulation.step(1e9);
    EXPECT_NEAR(lost(), 1, 0.05);
    while (simulation.bodies()[0].twist[1] < -0.5)
        simulation.step(1e9);
    EXPECT_NEAR(lost(), 1, 0.13);
}

// A plate that nothing slows may close its gap in one step; its surface does not pass the floor's.
TEST(GapLimit, SurfacesThatMeet)
{
    const Scene scene = plate(1e9, 0);
    Simulation<2> simulation(scene, Communicator());
    EXPECT_GT(simulation.step(1e9).dt, 0.9 * 0.003);
    const double h = simulation.bodies()[0].pose.position[1] - 0.15;
    EXPECT_GT(h, -1e-9);
    EXPECT_LT(h, 0.005 / 16) << "the roughness";
}

// Surfaces without roughness: the inertia of their film has no bound as they touch, and every gap limits the step.
TEST(GapLimit, HoldsWithoutRoughness)
{
    Scene scene = plate(1e9, 0);
    scene.gap.roughness = 0;
    Simulation<2> simulation(scene, Communicator());
    EXPECT_LE(simulation.step(1e9).dt, 0.25 * 0.003 * (1 + 1e-9));
}

// Without time.long_ways every gap limits the step.
TEST(GapLimit, HoldsWithoutLongWays)
{
    Scene scene = plate(1e9, 0);
    scene.long_ways = false;
    Simulation<2> simulation(scene, Communicator());
    EXPECT_LE(simulation.step(1e9).dt, 0.25 * 0.003 * (1 + 1e-9));
}

// A run that is resumed after such a step goes on with the same bits.
TEST(GapLimit, SameFuture)
{
    Scene scene = plate(1e4, 2e-3);
    scene.max_step = 0.0012;
    Simulation<2> one(scene, Communicator());
    one.step(1e9);
    Simulation<2> two(scene, Communicator(), one.state());
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(one.step(1e9).dt, two.step(1e9).dt);
        EXPECT_EQ(one.bodies()[0].twist, two.bodies()[0].twist);
    }
}

} // namespace
} // namespace gapflow
