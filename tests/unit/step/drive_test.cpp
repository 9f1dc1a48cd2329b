// Mean flow along periodic axes, on parts.
#include "unit/step/scenes.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

template <int D>
Scene periodic(int cells)
{
    Scene scene = box_of_fluid(D, cells, SideScene::Kind::periodic);
    scene.tolerance = 1e-12;
    scene.density = 2;
    return scene;
}

/// Flow through a plane across x over its area.
double mean_flow(const Simulation<2>& simulation)
{
    double sum = 0;
    for (int j = 0; j < simulation.grid().cells()[1]; ++j)
        sum += simulation.coupling().open(0, Index<2>(0, j)) * simulation.velocity().grid(0, Index<2>(0, j));
    return sum / simulation.grid().cells()[1];
}

// All accelerates as one, by -G/rho.
template <int D>
void check_acceleration()
{
    Scene scene = periodic<D>(D == 2 ? 20 : 12);
    scene.sides[2].kind = scene.sides[3].kind = SideScene::Kind::wall;
    scene.pressure_gradient = Triple{-0.6, 0, 0};
    scene.fluid_velocity = {0.1, 0, 0};
    BodyScene box = body("box", BodyScene::ShapeKind::box, {0.47, 0.53, 0.4}, {0.1, 0, 0});
    box.size = {0.31, 0.24, 0.27};
    box.angle = 0.4;
    box.density = 2;
    scene.bodies = {box};
    scene.max_step = 0.05;
    Simulation<D> simulation(scene, Communicator());
    const double volume = simulation.bodies()[0].volume;
    for (int k = 0; k < 3; ++k) {
        simulation.step(100);
        const Twist<D>& V = simulation.bodies()[0].twist;
        EXPECT_NEAR(simulation.budget().energy_grid, V[0] * V[0] * (1 - volume), 1e-9);
        const double u = 0.1 + 0.3 * simulation.time();
        EXPECT_NEAR(V[0], u, 1e-9);
        EXPECT_LT(V.template tail<twist_size<D> - 1>().norm(), 1e-8);
        EXPECT_NEAR(simulation.fluid_wrenches()[0][0], 0.3 * 2 * volume, 1e-9);
        EXPECT_NEAR(simulation.velocity().grid(0, Index<D>::Zero()), u, 1e-9);
    }
}

TEST(Drive, AGradientAcceleratesAllAsOne)
{
    check_acceleration<2>();
    check_acceleration<3>();
}

// What the gradient pushes into the box goes into the fluid's momentum and into the body that is held.
TEST(Drive, ABodyThatIsHeldBearsTheRest)
{
    Scene scene = periodic<2>(24);
    scene.pressure_gradient = Triple{-0.6, 0, 0};
    BodyScene disk = body("disk", BodyScene::ShapeKind::ball, {0.47, 0.53, 0});
    disk.radius = 0.23;
    disk.motion = BodyScene::Motion::fixed;
    scene.bodies = {disk};
    scene.max_step = 0.01; // and slow: forces of the speed's square are small
    Simulation<2> simulation(scene, Communicator());
    simulation.step(100);
    const double dt = simulation.time(), pushed = 0.6 * dt, momentum = 2 * mean_flow(simulation),
                 held = dt * simulation.fluid_wrenches()[0][0];
    EXPECT_NEAR(momentum + held, pushed, 1e-5 * pushed);
    EXPECT_GT(momentum, 0.5 * pushed);
    EXPECT_GT(held, 0.2 * pushed);
}

/// Their mass less that of the displaced fluid, times the speed along y.
double heavier_momentum(const Simulation<2>& simulation)
{
    double sum = 0;
    for (const RigidBody<2>& body : simulation.bodies())
        sum += (body.mass - simulation.scene().density * body.volume) * body.twist[1];
    return sum;
}

// A heavy and a light body along a periodic axis: fluid and bodies do not fall in the mean, and the gradient bears their weight but for what they accelerate by.
TEST(Drive, TheMeanVelocityIsKept)
{
    for (const double kept : {0.0, 0.3}) {
        Scene scene = periodic<2>(24);
        scene.gravity = {0, -1, 0};
        BodyScene heavy = body("heavy", BodyScene::ShapeKind::ball, {0.27, 0.53, 0}, {0, kept, 0}),
                  light = body("light", BodyScene::ShapeKind::ball, {0.71, 0.48, 0}, {0, kept, 0});
        heavy.radius = 0.14;
        heavy.density = 5;
        light.density = 0.1;
        scene.bodies = {heavy, light};
        scene.fluid_velocity = {0, kept, 0};
        if (kept != 0)
            scene.mean_velocity = Triple{0, kept, 0};
        scene.max_step = 0.01;
        Simulation<2> simulation(scene, Communicator());
        StepReport last;
        for (int k = 0; k < 3; ++k) {
            const double before = heavier_momentum(simulation), t = simulation.time();
            const StepReport report = last = simulation.step(100);
            EXPECT_NEAR(report.mean_velocity_y, kept, 1e-9);
            double weight = 0;
            for (const RigidBody<2>& body : simulation.bodies())
                weight -= body.mass - 2 * body.volume;
            EXPECT_NEAR((heavier_momentum(simulation) - before) / (simulation.time() - t), weight - report.pressure_gradient_y,
                        1e-3 * std::abs(weight));
        }
        double work = 0;
        for (std::size_t b = 0; b < 2; ++b) {
            const RigidBody<2>& body = simulation.bodies()[b];
            work += (body.mass - 2 * body.volume) * (scene.bodies[b].position[1] - body.centre()[1]);
        }
        const StepReport& first = simulation.initial_report();
        if (kept == 0) {
            EXPECT_NEAR(last.energy_fluid + last.energy_bodies - first.energy_fluid - first.energy_bodies, work, 2e-3 * work);
        }
        EXPECT_LT(simulation.bodies()[0].twist[1], kept - 0.005);
        EXPECT_GT(simulation.bodies()[1].twist[1], kept + 0.005);
    }
}

TEST(Drive, GoesOnFromAStoredStateBitForBit)
{
    Scene scene = periodic<2>(24);
    scene.gravity = {0, -1, 0};
    BodyScene disk = body("disk", BodyScene::ShapeKind::ball, {0.47, 0.53, 0});
    disk.density = 5;
    scene.bodies = {disk};
    scene.max_step = 0.02;
    expect_to_go_on<2>(scene);
}

} // namespace
} // namespace gapflow
