// Periodic boxes driven by a mean pressure gradient.
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapflow {
namespace {

using Kind = SideScene::Kind;

// Of size 1 along y and z, periodic along x and z.
Scene channel(int dimension, int cells)
{
    Scene scene;
    scene.dimension = dimension;
    scene.size = {1, 1, dimension == 2 ? 0.0 : 1.0};
    scene.cells = {cells, cells, dimension == 2 ? 1 : cells};
    for (int s : {0, 1, 4, 5})
        scene.sides[s].kind = Kind::periodic;
    scene.density = 1e-6;
    scene.viscosity = 1;
    scene.max_step = 2e-7;
    scene.cfl = 5;
    return scene;
}

template <int D>
StepReport after(Simulation<D>& simulation, int steps)
{
    StepReport report;
    for (int i = 0; i < steps; ++i)
        report = simulation.step(1e9);
    return report;
}

template <int D>
void poiseuille()
{
    for (int cells : {6, 9}) {
        Scene scene = channel(D, cells);
        scene.pressure_gradient = Triple{-12, 0, 0};
        Simulation<D> driven(scene, Communicator());
        const StepReport by_gradient = after(driven, 60);
        EXPECT_EQ(by_gradient.pressure_gradient_x, -12);
        EXPECT_NEAR(by_gradient.mean_velocity_x, 1, 2e-4) << cells << " cells";
        EXPECT_NEAR(by_gradient.mean_velocity_y, 0, 1e-9);
        scene.pressure_gradient.reset();
        scene.mean_velocity = Triple{1, 0, 0};
        Simulation<D> kept(scene, Communicator());
        const StepReport by_velocity = after(kept, 80);
        EXPECT_NEAR(by_velocity.mean_velocity_x, 1, 1e-5);
        EXPECT_NEAR(by_velocity.pressure_gradient_x / -12, 1, 4e-4) << cells << " cells";
        EXPECT_EQ(by_velocity.pressure_gradient_y, 0);
    }
}

TEST(Drive, PoiseuilleFlow2D)
{
    poiseuille<2>();
}

TEST(Drive, PoiseuilleFlow3D)
{
    poiseuille<3>();
}

BodyScene ball(const std::string& name, double radius, const Triple& position, double density)
{
    BodyScene body;
    body.name = name;
    body.shape = BodyScene::ShapeKind::ball;
    body.radius = radius;
    body.position = position;
    body.density = density;
    return body;
}

// Everything periodic.
Scene box(int dimension, int cells)
{
    Scene scene;
    scene.dimension = dimension;
    scene.size = {1, 1, dimension == 2 ? 0.0 : 1.0};
    scene.cells = {cells, cells, dimension == 2 ? 1 : cells};
    for (SideScene& side : scene.sides)
        side.kind = Kind::periodic;
    scene.max_step = 0.02;
    return scene;
}

// Bodies of the fluid's density with a film between them: bulk, film, mouths and bodies all get the same acceleration.
template <int D>
void all_fall_together(double viscosity)
{
    Scene scene = box(D, D == 2 ? 24 : 14);
    scene.density = 2;
    scene.viscosity = viscosity;
    scene.pressure_gradient = Triple{-3, 1, 0};
    scene.bodies = {ball("one", 0.2, {0.29, 0.5, 0.5}, 2), ball("two", 0.2, {0.7, 0.53, 0.5}, 2)};
    Simulation<D> simulation(scene, Communicator());
    const StepReport report = after(simulation, 6);
    ASSERT_GT(report.film_nodes, 0);
    const double t = simulation.time();
    const Vec<D> u = t * (1.5 * unit<D>(0) - 0.5 * unit<D>(1));
    const Grid<D>& grid = simulation.grid();
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& f) {
            if (simulation.coupling().open(axis, f) > 0.1) {
                EXPECT_NEAR(simulation.velocity().grid(axis, f), u[axis], 1e-7 * t);
            }
        });
    for (const RigidBody<D>& body : simulation.bodies()) {
        EXPECT_LT((body.twist.template head<D>() - u).norm(), 1e-7 * t);
        EXPECT_LT(body.twist.template tail<spin_size<D>>().norm(), 1e-6 * t);
    }
    EXPECT_NEAR(report.mean_velocity_x, u[0], 1e-7 * t);
    EXPECT_NEAR(report.mean_velocity_y, u[1], 1e-7 * t);
}

TEST(Drive, EverythingAcceleratesAlike2D)
{
    all_fall_together<2>(0);
    all_fall_together<2>(0.01);
}

TEST(Drive, EverythingAcceleratesAlike3D)
{
    all_fall_together<3>(0);
    all_fall_together<3>(0.01);
}

// A ball and its own images, with films between them, and between two balls and theirs in a box of twice the length: the same flow.
TEST(Drive, ABallHasFilmsWithItsOwnImages)
{
    const auto flow = [](int balls, BodyScene::Motion motion) {
        Scene scene = box(2, 16);
        scene.size[0] = balls;
        scene.cells[0] = 16 * balls;
        scene.viscosity = 0.1;
        scene.density = 2;
        scene.pressure_gradient = Triple{-1, 0.5, 0};
        for (int i = 0; i < balls; ++i) {
            scene.bodies.push_back(ball("ball_" + std::to_string(i), 0.48, {0.51 + i, 0.5, 0}, 2));
            scene.bodies.back().motion = motion;
        }
        Simulation<2> simulation(scene, Communicator());
        return after(simulation, 8);
    };
    for (const BodyScene::Motion motion : {BodyScene::Motion::fixed, BodyScene::Motion::free}) {
        const StepReport one = flow(1, motion), two = flow(2, motion);
        EXPECT_GT(one.film_nodes, 0);
        EXPECT_EQ(2 * one.film_nodes, two.film_nodes);
        EXPECT_NEAR(one.mean_velocity_x / two.mean_velocity_x, 1, 3e-3); // masters are on one side, or on both
        EXPECT_NEAR(one.mean_velocity_y / two.mean_velocity_y, 1, 3e-3);
        if (motion == BodyScene::Motion::free) { // all accelerates alike
            EXPECT_NEAR(one.mean_velocity_x, 0.5 * one.time, 1e-7 * one.time);
        }
    }
}

// A heavy disk, and a light one, in a part of a tall tank: no volume passes, and the gradient carries the weight in the end.
TEST(Drive, GravityIsBalancedAsInATallTank)
{
    for (double density : {3.0, 0.2}) {
        Scene scene = box(2, 24);
        scene.viscosity = 0.3;
        scene.gravity = {0, -1, 0};
        scene.bodies = {ball("disk", 0.2, {0.5, 0.5, 0}, density)};
        Simulation<2> simulation(scene, Communicator());
        double most = 0;
        StepReport report;
        for (int i = 0; i < 60; ++i) {
            report = simulation.step(1e9);
            if (i > 2) // the first step knows no other forces yet
                most = std::max(most, std::abs(report.mean_velocity_y));
        }
        const double speed = simulation.bodies()[0].twist[1];
        EXPECT_EQ(speed<0, density> 1);
        EXPECT_LT(most, 0.02 * std::abs(speed));
        EXPECT_NEAR(report.mean_velocity_y, 0, 1e-4 * std::abs(speed));
        EXPECT_NEAR(report.pressure_gradient_y, -(density - 1) * simulation.bodies()[0].volume,
                    0.01 * std::abs(density - 1) * 0.126);
        EXPECT_EQ(report.pressure_gradient_x, 0);
    }
}

// Without a body that is heavier or lighter than the fluid nothing is driven.
// Two bodies leave throats of half a cell between them: what goes through these in films counts as what comes out of them.
template <int D>
void mean_is_flow(BodyScene::Motion motion)
{
    constexpr int cells = D == 2 ? 24 : 16;
    Scene scene = box(D, cells);
    scene.viscosity = 0.1;
    scene.pressure_gradient = Triple{-1, 0, 0};
    for (const double y : {0.26, 0.76}) {
        scene.bodies.push_back(ball(y < 0.5 ? "below" : "above", 0.25 - 0.25 / cells, {0.513, y, 0.5}, 2));
        scene.bodies.back().motion = motion;
    }
    Simulation<D> simulation(scene, Communicator());
    const StepReport report = after(simulation, D == 2 ? 10 : 4);
    EXPECT_GT(report.film_nodes, 0);
    EXPECT_GT(report.mean_velocity_x, 0);
    for (const double x : {0.1, 0.3, 0.45, 0.5, 0.62, 0.9}) {
        FluxScene plane;
        plane.kind = FluxScene::Kind::plane;
        plane.point = {x, 0, 0};
        plane.normal = {1, 0, 0};
        const VolumeFlux flux = simulation.volume_flux(plane);
        EXPECT_NEAR((flux.flux + flux.bodies) / report.mean_velocity_x, 1, motion == BodyScene::Motion::fixed ? 1e-6 : 2e-5)
            << D << "D at " << x;
    }
}

TEST(Drive, MeanVelocityIsTheFlowThroughEveryPlane)
{
    mean_is_flow<2>(BodyScene::Motion::fixed);
    mean_is_flow<3>(BodyScene::Motion::fixed);
    mean_is_flow<2>(BodyScene::Motion::free);
    mean_is_flow<3>(BodyScene::Motion::free);
}

TEST(Drive, NothingIsDrivenByNothing)
{
    Scene scene = box(2, 16);
    scene.gravity = {0, -1, 0};
    scene.bodies = {ball("disk", 0.2, {0.5, 0.5, 0}, 1)};
    EXPECT_FALSE(Simulation<2>(scene, Communicator()).driven());
    scene.bodies[0].density = 2;
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    EXPECT_FALSE(Simulation<2>(scene, Communicator()).driven());
    scene.bodies[0].motion = BodyScene::Motion::free;
    EXPECT_TRUE(Simulation<2>(scene, Communicator()).driven());
}

// Light disks in ideal fluid answer up to three times as strongly as fluid: the mean velocity still comes to what is asked for.
TEST(Drive, MeanVelocityOfLightBodies)
{
    Scene scene = box(2, 32);
    scene.mean_velocity = Triple{0.3, -0.1, 0};
    int number = 0;
    for (double x : {0.25, 0.75})
        for (double y : {0.25, 0.75})
            scene.bodies.push_back(ball("disk_" + std::to_string(++number), 0.2, {x, y, 0}, 0.05));
    Simulation<2> simulation(scene, Communicator());
    const StepReport report = after(simulation, 15);
    EXPECT_NEAR(report.mean_velocity_x, 0.3, 3e-3);
    EXPECT_NEAR(report.mean_velocity_y, -0.1, 1e-3);
}

TEST(Drive, GoesOnFromAStoredState)
{
    Scene scene = box(2, 16);
    scene.viscosity = 0.01;
    scene.mean_velocity = Triple{0.3, 0, 0};
    scene.bodies = {ball("disk", 0.2, {0.5, 0.5, 0}, 3)};
    Simulation<2> first(scene, Communicator());
    after(first, 3);
    Simulation<2> second(scene, Communicator(), first.state());
    for (int i = 0; i < 2; ++i) {
        const StepReport a = first.step(1e9), b = second.step(1e9);
        EXPECT_EQ(a.pressure_gradient_x, b.pressure_gradient_x);
        EXPECT_EQ(a.mean_velocity_x, b.mean_velocity_x);
        EXPECT_NE(a.pressure_gradient_x, 0);
    }
}

} // namespace
} // namespace gapflow
