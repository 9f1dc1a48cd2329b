// Runs on graded grids.
#include "gapflow/scene/graded_widths.hpp"
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/added_mass.hpp"
#include "gapflow/stepping/advection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {
namespace {

using Kind = SideScene::Kind;

// A domain from -half to half along every axis with a core from -core to core of cells of an edge of 1 / n; all sides of one kind.
Scene graded_scene(int dimension, double half, double core, int n, double growth, Kind kind)
{
    Scene scene;
    scene.dimension = dimension;
    CoreScene cells;
    cells.spacing = 1.0 / n;
    cells.growth = growth;
    for (int axis = 0; axis < dimension; ++axis) {
        scene.size[axis] = 2 * half;
        scene.origin[axis] = -half;
        cells.low[axis] = -core;
        cells.high[axis] = core;
        cells.below[axis] = cells.above[axis] =
            graded_widths((half - core) * n, growth, std::numeric_limits<double>::infinity());
        scene.cells[axis] = static_cast<int>(std::lround(2 * core * n) + 2 * static_cast<long>(cells.below[axis].size()));
        scene.sides[2 * axis].kind = scene.sides[2 * axis + 1].kind = kind;
    }
    scene.core = cells;
    return scene;
}

// The same domain with equal cells.
Scene uniform_scene(int dimension, double half, int n, Kind kind)
{
    Scene scene = graded_scene(dimension, half, half, n, 1.1, kind);
    scene.core.reset();
    return scene;
}

BodyScene ball(double radius, Triple position)
{
    BodyScene body;
    body.name = "ball";
    body.shape = BodyScene::ShapeKind::ball;
    body.radius = radius;
    body.position = position;
    return body;
}

// A domain four times as wide at next to the same cells: what is left is the share of the grading.
TEST(GradedSpacing, AddedMassAsOnEqualCells)
{
    const Triple place{0.013, 0.007, 0};
    Scene uniform = uniform_scene(2, 8, 8, Kind::wall), graded = graded_scene(2, 8, 2, 8, 1.1, Kind::wall);
    uniform.bodies = graded.bodies = {ball(1, place)};
    const AddedMass exact = added_mass(uniform, Communicator()), found = added_mass(graded, Communicator());
    for (int axis = 0; axis < 2; ++axis)
        EXPECT_NEAR(found.matrix(axis, axis) / exact.matrix(axis, axis), 1, 3e-3);
    EXPECT_LT(graded.cells[0], uniform.cells[0] / 1.5);
}

// Aspect ratios of 5 to 500 and fine cells beside walls and open sides.
TEST(GradedSpacing, MultigridKeepsItsIterations)
{
    for (const int dimension : {2, 3})
        for (const double half : {10.0, 200.0})
            for (const Kind kind : {Kind::wall, Kind::open, Kind::far}) {
                Scene scene = graded_scene(dimension, half, 1.5, dimension == 2 ? 12 : 6, dimension == 2 ? 1.1 : 1.2, kind);
                scene.bodies = {ball(1, {0.013, 0.007, dimension == 3 ? 0.003 : 0.0})};
                const AddedMass found = added_mass(scene, Communicator());
                EXPECT_LE(*std::max_element(found.iterations.begin(), found.iterations.end()), 12)
                    << dimension << "D, " << half << ", side " << static_cast<int>(kind);
            }
}

// Kinetic energy of the potential flow around a moving body is half of its added mass times its speed squared: rows, gradient, and the
// faces' volumes belong together.
TEST(GradedSpacing, EnergyIsThatOfTheAddedMass)
{
    for (const int dimension : {2, 3}) {
        Scene scene = graded_scene(dimension, 6, 1.5, 6, 1.15, Kind::wall);
        scene.bodies = {ball(1, {0.013, 0.007, dimension == 3 ? 0.003 : 0.0})};
        scene.tolerance = 1e-11;
        const AddedMass mass = added_mass(scene, Communicator());
        scene.bodies[0].velocity = {0.7, -0.4, dimension == 3 ? 0.2 : 0.0};
        scene.initial = Scene::Initial::potential;
        scene.end = 1;
        scene.max_step = 0.1;
        const Eigen::VectorXd v = Eigen::Map<const Eigen::VectorXd>(scene.bodies[0].velocity.data(), dimension);
        const double exact = 0.5 * v.dot(mass.matrix.topLeftCorner(dimension, dimension) * v);
        const double found = dimension == 2 ? Simulation<2>(scene, Communicator()).initial_report().energy_fluid
                                            : Simulation<3>(scene, Communicator()).initial_report().energy_fluid;
        EXPECT_NEAR(found / exact, 1, 1e-8) << dimension;
    }
}

// The fluid of all open faces moves with this velocity.
template <int D>
void expect_uniform_flow(const Simulation<D>& simulation, const Triple& velocity, double tolerance)
{
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(simulation.grid().low(), owned_faces_end(simulation.grid(), axis), [&](const Index<D>& f) {
            if (simulation.coupling().open(axis, f) > 0) {
                EXPECT_NEAR(simulation.velocity().grid(axis, f), velocity[axis], tolerance) << axis << ": " << f.transpose();
            }
        });
}

// Fluid and a body of its density that move together go on so.
template <int D>
void expect_uniform_motion(double viscosity)
{
    Scene scene = graded_scene(D, 4, 1.5, 4, 1.2, Kind::far);
    scene.bodies = {ball(0.8, {-0.3, 0.007, D == 3 ? 0.003 : 0.0})};
    scene.fluid_velocity = {1, 0.3, D == 2 ? 0.0 : -0.2};
    scene.bodies[0].velocity = scene.fluid_velocity;
    scene.bodies[0].motion = BodyScene::Motion::free;
    scene.bodies[0].density = 1;
    scene.viscosity = viscosity;
    scene.end = 1;
    scene.max_step = 0.05;
    Simulation<D> simulation(scene, Communicator());
    for (int k = 0; k < 5; ++k)
        simulation.step(1);
    const Simulation<D>& after = simulation;
    for (int axis = 0; axis < D; ++axis) {
        EXPECT_NEAR(after.bodies()[0].twist[axis], scene.fluid_velocity[axis], 1e-12);
    }
    expect_uniform_flow(after, scene.fluid_velocity, 1e-11);
}

TEST(GradedSpacing, KeepsUniformMotion2D)
{
    expect_uniform_motion<2>(0);
}

TEST(GradedSpacing, KeepsUniformMotion3D)
{
    expect_uniform_motion<3>(0);
}

TEST(GradedSpacing, KeepsUniformMotionOfViscousFluid)
{
    expect_uniform_motion<2>(0.05);
}

// A row of vortices that a stream carries through cells that grow; returns the largest error of the velocity.
double error_of_carried_wave(int n)
{
    Scene scene = graded_scene(2, 2, 0.5, n, std::pow(1.2, 8.0 / n), Kind::far);
    scene.fluid_velocity = {1, 0, 0};
    scene.end = 1;
    scene.max_step = 0.25 / n;
    const Model<2> model(scene, Communicator());
    const Grid<2>& grid = model.grid;
    const auto wave = [](double x) { return std::exp(-8 * x * x); };
    FaceField<2> u(grid), next(grid);
    const auto fill = [&](double time) {
        for (int axis = 0; axis < 2; ++axis)
            for_each_index<2>(u[axis].block().low, u[axis].block().high, [&](const Index<2>& f) {
                u(axis, f) = axis == 0 ? 1.0 : wave(grid.face_centre(1, f)[0] - time);
            });
    };
    fill(0);
    const int steps = 2 * n;
    for (int k = 0; k < steps; ++k) {
        for (int axis = 0; axis < 2; ++axis)
            next[axis] = u[axis];
        advect<2>(grid, next, u, u, 1.0 / steps, AdvectionScheme::maccormack, {});
        for (int axis = 0; axis < 2; ++axis)
            for_each_index<2>(grid.low(), owned_faces_end(grid, axis), [&](const Index<2>& f) { u(axis, f) = next(axis, f); });
    }
    double error = 0;
    for_each_index<2>(grid.low(), owned_faces_end(grid, 1), [&](const Index<2>& f) {
        const double x = grid.face_centre(1, f)[0];
        if (std::abs(x) < 1.8 && std::abs(grid.face_centre(1, f)[1]) < 0.5)
            error = std::max(error, std::abs(u(1, f) - wave(x - 1)));
    });
    return error;
}

TEST(GradedSpacing, AdvectionIsOfSecondOrder)
{
    const double coarse = error_of_carried_wave(8), fine = error_of_carried_wave(16), finest = error_of_carried_wave(32);
    EXPECT_LT(fine, coarse / 2.5);
    EXPECT_LT(finest, fine / 2.8);
    EXPECT_LT(finest, 0.03);
}

// Couette flow between walls, cells of any width across: linear, so exact.
TEST(GradedSpacing, CouetteFlowIsExact)
{
    Scene scene = graded_scene(2, 2, 0.5, 8, 1.2, Kind::wall);
    scene.sides[0].kind = scene.sides[1].kind = Kind::periodic;
    scene.core->below[0].clear();
    scene.core->above[0].clear();
    scene.size[0] = 1;
    scene.origin[0] = -0.5;
    scene.cells[0] = 8;
    scene.sides[2].velocity = {-1, 0, 0};
    scene.sides[3].velocity = {1, 0, 0};
    scene.viscosity = 1;
    scene.density = 1e-6;
    scene.end = 1;
    scene.max_step = 0.05;
    Simulation<2> simulation(scene, Communicator());
    while (simulation.steps() < 60)
        simulation.step(10);
    const Grid<2>& grid = simulation.grid();
    for (int j = 0; j < grid.cells()[1]; ++j)
        EXPECT_NEAR(simulation.velocity().grid(0, Index<2>(3, j)), 0.5 * grid.centre_place(1, j), 1e-5) << j;
}

// Everything moves together, the grid too: nothing changes.
template <int D>
void expect_uniform_motion_with_the_grid(double viscosity)
{
    Scene scene = graded_scene(D, 4, 1.5, 4, 1.2, Kind::far);
    scene.bodies = {ball(0.6, {-0.3, 0.007, D == 3 ? 0.003 : 0.0}), ball(0.3, {0.605, 0.1, 0})};
    scene.bodies[1].name = "other"; // 2D: a film between the two
    scene.fluid_velocity = {1, 0.3, D == 2 ? 0.0 : -0.2};
    for (BodyScene& body : scene.bodies) {
        body.velocity = scene.fluid_velocity;
        body.motion = BodyScene::Motion::free;
        body.density = 1;
    }
    scene.viscosity = viscosity;
    scene.follow = FollowScene{"ball", {true, true, true}};
    scene.end = 4;
    scene.max_step = 0.05;
    Simulation<D> simulation(scene, Communicator());
    while (simulation.time() < 2)
        simulation.step(2); // out of the core of a grid that stays
    const Simulation<D>& after = simulation;
    EXPECT_FALSE(after.outside_core());
    EXPECT_TRUE(D == 3 || after.coupling().network.nodes > 0);
    for (int axis = 0; axis < D; ++axis) {
        EXPECT_NEAR(after.grid().origin()[axis], -4 + 2 * scene.fluid_velocity[axis], 1e-11);
        for (const RigidBody<D>& body : after.bodies())
            EXPECT_NEAR(body.twist[axis], scene.fluid_velocity[axis], 1e-11);
    }
    expect_uniform_flow(after, scene.fluid_velocity, 1e-10);
}

TEST(FollowingGrid, KeepsUniformMotion2D)
{
    expect_uniform_motion_with_the_grid<2>(0);
}

TEST(FollowingGrid, KeepsUniformMotion3D)
{
    expect_uniform_motion_with_the_grid<3>(0);
}

TEST(FollowingGrid, KeepsUniformMotionOfViscousFluid)
{
    expect_uniform_motion_with_the_grid<2>(0.05);
}

// A heavy disk falls from rest, far from sides or in a channel whose fluid is at rest ahead (an inflow of zero, along which the grid goes):
// its speed after a while on a grid that follows it and on one that stays; returns the difference, relative.
double difference_of_falls(int n, bool channel = false)
{
    double speed[2];
    for (const bool follows : {false, true}) {
        Scene scene = graded_scene(2, 6, follows ? 1.5 : 3, n, 1.2, Kind::far);
        if (channel) {
            const Kind kinds[] = {Kind::wall, Kind::wall, Kind::inflow, Kind::open};
            for (int side = 0; side < 4; ++side)
                scene.sides[side].kind = kinds[side];
        }
        scene.bodies = {ball(0.5, {0.013, follows ? 0.3 : 1.5, 0})};
        scene.bodies[0].motion = BodyScene::Motion::free;
        scene.bodies[0].density = 3;
        scene.gravity = {0, -1, 0};
        scene.viscosity = 0.05;
        scene.end = 2;
        scene.max_step = 0.2 / n;
        if (follows)
            scene.follow = FollowScene{"ball", {!channel, true, false}};
        Simulation<2> simulation(scene, Communicator());
        while (simulation.time() < scene.end)
            simulation.step(scene.end);
        speed[follows] = simulation.bodies()[0].twist[1];
    }
    EXPECT_LT(speed[0], -0.5);
    return std::abs(speed[1] / speed[0] - 1);
}

TEST(FollowingGrid, FallsAsOnAGridThatStays)
{
    const double coarse = difference_of_falls(8), fine = difference_of_falls(16);
    EXPECT_LT(coarse, 0.02);
    EXPECT_LT(fine, 0.005);
    EXPECT_LT(fine, coarse);
}

TEST(FollowingGrid, FallsInAChannelAsOnAGridThatStays)
{
    const double coarse = difference_of_falls(8, true), fine = difference_of_falls(16, true);
    EXPECT_LT(coarse, 0.02);
    EXPECT_LT(fine, 0.005);
    EXPECT_LT(fine, coarse);
}

// What a step depends on is in the stored state: the same bits afterwards.
TEST(FollowingGrid, GoesOnFromAStoredState)
{
    Scene scene = graded_scene(2, 4, 1.5, 4, 1.2, Kind::far);
    scene.bodies = {ball(0.5, {0, 0, 0})};
    scene.bodies[0].motion = BodyScene::Motion::free;
    scene.bodies[0].density = 3;
    scene.gravity = {0.3, -1, 0};
    scene.end = 4;
    scene.max_step = 0.05;
    scene.follow = FollowScene{"ball", {true, true, false}};
    Simulation<2> whole(scene, Communicator());
    for (int k = 0; k < 10; ++k)
        whole.step(4);
    Simulation<2> again(scene, Communicator(), whole.state());
    EXPECT_EQ(again.grid().origin(), whole.grid().origin());
    for (int k = 0; k < 5; ++k) {
        whole.step(4);
        again.step(4);
    }
    EXPECT_NE(whole.grid().origin()[1], -4);
    EXPECT_EQ(again.grid().origin(), whole.grid().origin());
    EXPECT_EQ(again.bodies()[0].twist, whole.bodies()[0].twist);
}

// A body that leaves the core is told of.
TEST(GradedSpacing, KnowsWhatLeavesTheCore)
{
    Scene scene = graded_scene(2, 4, 1.5, 4, 1.2, Kind::far);
    scene.bodies = {ball(0.5, {0.9, 0, 0})};
    scene.bodies[0].motion = BodyScene::Motion::free;
    scene.bodies[0].velocity = {1, 0, 0};
    scene.bodies[0].density = 5;
    scene.end = 1;
    scene.max_step = 0.05;
    Simulation<2> simulation(scene, Communicator());
    EXPECT_FALSE(simulation.outside_core());
    while (simulation.time() < 0.3)
        simulation.step(0.3);
    ASSERT_TRUE(simulation.outside_core());
    EXPECT_NE(simulation.outside_core()->find("body 'ball' reaches out of the core"), std::string::npos)
        << *simulation.outside_core();
}

} // namespace
} // namespace gapflow
