// Pressure sides: what they drive, and that equal pressures all around drive nothing.
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/side_pressure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gapflow {
namespace {

using Kind = SideScene::Kind;

SideScene pressure_side(double pressure)
{
    SideScene side;
    side.kind = Kind::pressure;
    side.table = {"", {0}, {{pressure}}};
    return side;
}

Scene channel(int dimension, double low, double high)
{
    Scene scene;
    scene.dimension = dimension;
    scene.size = {2, 1, dimension == 2 ? 0.0 : 1.0};
    scene.cells = {16, 8, dimension == 2 ? 1 : 8};
    scene.density = 4;
    scene.sides[0] = pressure_side(low);
    scene.sides[1] = pressure_side(high);
    scene.end = 1;
    scene.max_step = 0.01;
    return scene;
}

template <int D>
double largest_speed(const Simulation<D>& simulation)
{
    double largest = 0;
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(simulation.grid().low(), owned_faces_end(simulation.grid(), axis), [&](const Index<D>& f) {
            largest = std::max(largest, std::abs(simulation.velocity().grid(axis, f)));
        });
    return largest;
}

// From rest the fluid of the channel has the acceleration (p_low - p_high) / (rho length).
template <int D>
void expect_acceleration()
{
    Simulation<D> simulation(channel(D, 1e5 + 3, 1e5 + 1), Communicator());
    const StepReport report = simulation.step(1);
    EXPECT_LT(report.divergence_max, 1e-8);
    double worst = 0;
    for_each_index<D>(simulation.grid().low(), owned_faces_end(simulation.grid(), 0), [&](const Index<D>& f) {
        worst = std::max(worst, std::abs(simulation.velocity().grid(0, f) - report.dt * 2 / (4 * 2)));
    });
    EXPECT_LT(worst, 1e-9);
    const Index<D> first = Index<D>::Zero(), last = simulation.grid().cells() - Index<D>::Ones();
    const UnknownVector<D> p = simulation.reduced_pressure();
    auto full = [&](const Index<D>& c) { return p.cells(c) + simulation.hydrostatic(simulation.grid().cell_centre(c)); };
    EXPECT_NEAR(full(first), 1e5 + 3 - 2.0 / 32, 1e-7);
    EXPECT_NEAR(full(last), 1e5 + 1 + 2.0 / 32, 1e-7);
}

TEST(SidePressure, AcceleratesAChannel2D)
{
    expect_acceleration<2>();
}

TEST(SidePressure, AcceleratesAChannel3D)
{
    expect_acceleration<3>();
}

// The fluid that comes in loses its head: p_low - p_high = rho u^2 / 2 in steady flow. The table reaches its value at once.
TEST(SidePressure, SteadyFlowHasTheHeadOfTheDifference)
{
    Scene scene = channel(2, 0, 0);
    scene.sides[0].table = {"", {0, 0.01}, {{0}, {8}}};
    scene.max_step = 0.05;
    Simulation<2> simulation(scene, Communicator());
    while (simulation.time() < 10)
        simulation.step(10);
    EXPECT_NEAR(largest_speed(simulation), std::sqrt(2 * 8.0 / 4), 1e-3);
}

// The side's pressure is that of its highest point, hydrostatic below: as an open top's.
TEST(SidePressure, HydrostaticSideDrivesNothing)
{
    Scene scene = channel(2, 7, 0);
    scene.gravity = {0, -10, 0};
    scene.sides[1] = {};
    scene.sides[3].kind = Kind::open;
    scene.reference_pressure = 7;
    Simulation<2> simulation(scene, Communicator());
    for (int k = 0; k < 3; ++k)
        simulation.step(1);
    EXPECT_LT(largest_speed(simulation), 1e-9);
    EXPECT_NEAR(simulation.hydrostatic(Vec<2>(0.3, 0.25)), 7 + 4 * 10 * 0.75, 1e-12);
}

// Poiseuille flow: mean velocity (p_low - p_high) h^2 / (12 mu length). The layers of the two sides bear half a cell more drag each than their
// length is.
TEST(SidePressure, DrivesPoiseuilleFlow)
{
    Scene scene = channel(2, 24, 0);
    scene.density = 1e-6;
    scene.viscosity = 1;
    scene.max_step = 1e-6;
    scene.end = 1e-4;
    Simulation<2> simulation(scene, Communicator());
    for (int k = 0; k < 40; ++k)
        simulation.step(scene.end);
    double flow = 0;
    for (int j = 0; j < 8; ++j)
        flow += simulation.velocity().grid(0, Index<2>(8, j)) / 8;
    EXPECT_NEAR(flow, 16.0 / 17, 1e-3);
    const UnknownVector<2> p = simulation.reduced_pressure();
    const double gradient = (p.cells(Index<2>(6, 4)) - p.cells(Index<2>(10, 4))) / (4 * simulation.grid().dx());
    EXPECT_NEAR(flow, gradient / 12, 1e-3);
}

// The same through the film of a narrow gap between a wall and a block that reaches through both sides, h^3 / (12 mu length) times the difference.
TEST(SidePressure, DrivesTheFilmOfAGap)
{
    Scene scene = channel(2, 101, 100);
    scene.viscosity = 1;
    scene.density = 1e-3;
    scene.max_step = 2e-4;
    BodyScene block;
    block.name = "block";
    block.shape = BodyScene::ShapeKind::box;
    block.size = {4, 0.4, 0};
    block.position = {1, 0.22, 0};
    block.motion = BodyScene::Motion::fixed;
    scene.bodies = {block};
    Simulation<2> simulation(scene, Communicator());
    for (int k = 0; k < 5; ++k)
        simulation.step(1);
    ASSERT_FALSE(simulation.velocity().film.empty());
    const double expected = std::pow(0.02, 2) / 12 * (1.0 / 2);
    for (const Vec<2>& u : simulation.velocity().film)
        EXPECT_NEAR(u[0], expected, 0.01 * expected);
}

// A ball half out of one of two sides whose pressures rise together: pressure all around it, and no force.
template <int D>
void expect_no_force()
{
    Scene scene = channel(D, 0, 0);
    for (int side : {0, 1})
        scene.sides[side].table = {"", {0, 0.001}, {{0}, {50}}};
    BodyScene ball;
    ball.name = "ball";
    ball.shape = BodyScene::ShapeKind::ball;
    ball.radius = 0.22; // no films at the walls
    ball.position = {0.07, 0.52, D == 2 ? 0.0 : 0.47};
    ball.density = scene.density;
    scene.bodies = {ball};
    const Model<D> model(scene, Communicator());
    const Coupling<D> coupling = model.coupled(model.bodies);
    const Twist<D> beyond = wrenches_from_beyond(model, coupling, 1)[0];
    EXPECT_GT(beyond[0], 5);
    EXPECT_LT((beyond + 50 * closure(coupling)[0]).norm(), 1e-10)
        << beyond.transpose() << "; " << 50 * closure(coupling)[0].transpose();
    Simulation<D> simulation(scene, Communicator());
    simulation.step(1);
    EXPECT_LT(simulation.fluid_wrenches()[0].norm(), 1e-6);
    EXPECT_LT(simulation.bodies()[0].twist.norm(), 1e-8);
    EXPECT_LT(largest_speed(simulation), 1e-7);
}

TEST(SidePressure, SurroundsABodyThatSticksOut2D)
{
    expect_no_force<2>();
}

TEST(SidePressure, SurroundsABodyThatSticksOut3D)
{
    expect_no_force<3>();
}

} // namespace
} // namespace gapflow
