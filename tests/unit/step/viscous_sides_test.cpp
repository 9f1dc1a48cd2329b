// Viscous fluid on parts between given pressures, and with inflow.
#include "unit/step/parts_run.hpp"
#include "unit/step/scenes.hpp"

#include "gapflow/scene/time_table.hpp"
#include "gapflow/step/viscosity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

constexpr double pi = std::numbers::pi;

/// Fluid that flows along x between walls, cells to its height 1.
template <int D>
Scene channel_of(int cells, double length, SideScene::Kind in, SideScene::Kind out, double value)
{
    Scene scene = box_of_fluid(D, cells, SideScene::Kind::periodic);
    scene.size[0] = length;
    scene.cells[0] = static_cast<int>(std::lround(length * cells));
    scene.sides[2].kind = scene.sides[3].kind = SideScene::Kind::wall;
    scene.sides[0].kind = in;
    scene.sides[1].kind = out;
    for (int side = 0; side < 2; ++side) {
        std::vector<double> row(scene.sides[side].kind == SideScene::Kind::pressure ? 1 : D, 0.0);
        if (scene.sides[side].kind == SideScene::Kind::open)
            continue;
        row[0] = side ? 0.0 : value;
        scene.sides[side].table = {"", {0}, {row}};
    }
    scene.viscosity = 1;
    scene.tolerance = 1e-12;
    return scene;
}

constexpr auto pressure = SideScene::Kind::pressure;

/// Mean over a face of a grid with `cells` to the channel's height of y (1 - y)/2.
double parabola(double y, int cells)
{
    return 0.5 * (y * (1 - y) - 1.0 / (12.0 * cells * cells));
}

// Plane Poiseuille flow, in the sides too; slow, for what comes in has lost its head.
template <int D>
void check_poiseuille()
{
    constexpr double small = 1e-9;
    const int cells = D == 2 ? 6 : 4; // without a compact middle
    const Scene scene = channel_of<D>(cells, 1.5, pressure, pressure, 1.5 * small);
    PartsRun<D> run(scene);
    for (int k = 0; k < 12; ++k)
        run.step(0.4);
    const Grid<D>& grid = run.model.grid;
    double worst = 0;
    for_each_index<D>(grid.low(), Index<D>(grid.high() + step<D>(0)), [&](const Index<D>& f) {
        worst = std::max(worst, std::abs(run.state.velocity.grid(0, f) / small - parabola(grid.face_centre(0, f)[1], cells)));
    });
    EXPECT_LT(worst, 1e-7);
    EXPECT_NEAR(run.report.dissipation_grid / (small * small), 1.5 / 12, 1e-7);
    const UnknownVector<D> p = reduced_pressure(run.state);
    const double level = p.cells(grid.low()) / small + grid.cell_centre(grid.low())[0];
    for_each_index<D>(grid.low(), grid.high(),
                      [&](const Index<D>& c) { EXPECT_NEAR(p.cells(c) / small, level - grid.cell_centre(c)[0], 1e-6); });
}

TEST(ViscousSides, FlowBetweenPressuresIsAParabola2D)
{
    check_poiseuille<2>();
}

TEST(ViscousSides, FlowBetweenPressuresIsAParabola3D)
{
    check_poiseuille<3>();
}

/// Bodies in a channel: one held, one free, one through the side.
Scene bodies_in_channel(double drop)
{
    Scene scene = channel_of<2>(16, 2, pressure, pressure, drop);
    scene.bodies = {body("held", BodyScene::ShapeKind::ball, {0.71, 0.43, 0}),
                    body("free", BodyScene::ShapeKind::box, {1.31, 0.62, 0}),
                    body("through", BodyScene::ShapeKind::ball, {0.03, 0.77, 0})};
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    scene.bodies[0].radius = 0.17;
    scene.bodies[1].size = {0.23, 0.11, 0};
    scene.bodies[1].angle = 0.4;
    return scene;
}

// A stage: the pressures' work is what the energy gains, what is dissipated, and what the integrator loses.
TEST(ViscousSides, PressuresDoTheWorkThatIsDissipated)
{
    PartsRun<2> run(bodies_in_channel(3));
    run.step(0.02);
    const auto energy = [&] {
        find_forces(run.now);
        double sum = run.now.energy;
        for (std::size_t b = 1; b < 3; ++b)
            sum += 0.5 * run.now.flow.twists[b].dot(mass_matrix(run.state.bodies[b]) * run.now.flow.twists[b]);
        return sum;
    };
    ViscousLoads<2> loads;
    for (const double dt : {1e-4, 0.01, 1.0}) {
        loads.sides = {3 * dt, 0.4 * dt, 0, 0};
        const double before = energy();
        const ViscousStep<2> stage =
            add_viscosity(*run.now.placed, run.model.masses(run.state.bodies, 0.0), loads, 1.0, dt, 1e-11, run.now.flow);
        EXPECT_GT(stage.work, 0);
        EXPECT_NEAR((energy() - before + stage.dissipated + stage.lost - stage.work) / stage.work, 0, 1e-9) << dt;
    }
}

// Slow flow past a body that is held: in the steady state the pressures' power is dissipated, and the impulses on body and walls are those of the pressures.
TEST(ViscousSides, PowerIsDissipatedInSteadyFlow)
{
    constexpr double small = 1e-8;
    Scene scene = bodies_in_channel(small);
    scene.bodies.resize(1);
    PartsRun<2> run(scene);
    for (int k = 0; k < 14; ++k)
        run.step(0.3);
    const Grid<2>& grid = run.model.grid;
    double flux = 0, out = 0;
    for (int j = 0; j < grid.cells()[1]; ++j) {
        flux += run.now.flux(0, Index<2>(0, j)) * grid.dx();
        out += run.now.flux(0, Index<2>(grid.cells()[0], j)) * grid.dx();
    }
    EXPECT_NEAR(out / flux, 1, 1e-9);
    EXPECT_NEAR(run.report.dissipation_grid / (small * flux), 1, 1e-6);
}

// Pressures that change accelerate the fluid against its friction: a column without walls as ideal fluid.
TEST(ViscousSides, AColumnBetweenTwoPressures)
{
    Scene scene = channel_of<2>(8, 1, pressure, pressure, 0);
    scene.sides[2].kind = scene.sides[3].kind = SideScene::Kind::periodic;
    scene.sides[0].table = {"", {0, 0.11, 0.33, 0.5}, {{1e-6}, {1e-6}, {-2e-6}, {4e-6}}};
    scene.density = 2;
    PartsRun<2> run(scene);
    for (int k = 0; k < 6; ++k)
        run.step(0.07);
    const double u = integral_to(scene.sides[0].table, run.state.time).at(0) / 2;
    for_each_index<2>(run.model.grid.low(), Index<2>(run.model.grid.high() + step<2>(0)),
                      [&](const Index<2>& f) { EXPECT_NEAR(run.state.velocity.grid(0, f), u, 1e-5 * std::abs(u)); });
}

// Uniform inflow becomes a parabola further downstream.
TEST(ViscousSides, InflowBecomesAParabola)
{
    const Scene scene = channel_of<2>(12, 3, SideScene::Kind::inflow, SideScene::Kind::open, 1);
    PartsRun<2> run(scene);
    for (int k = 0; k < 40; ++k)
        run.step(0.05);
    EXPECT_LT(largest_divergence(run.now, run.state.velocity), 1e-9);
    for (int j = 0; j < 12; ++j) {
        EXPECT_NEAR(run.state.velocity.grid(0, Index<2>(0, j)), 1, 1e-12);
        EXPECT_NEAR(run.state.velocity.grid(0, Index<2>(26, j)), 12 * parabola((j + 0.5) / 12, 12), 0.01) << j;
    }
}

// The drag of a cylinder in a channel at a Reynolds number of 10, 3.6 cells a diameter, is that of films on the same grid: 0.5 % less; in a channel of length 3 1.2 % more, with 24 cells 0.7 %.
TEST(ViscousSides, ACylinderInAChannelHasTheDragOfFilms)
{
    std::array<double, 2> drag;
    for (const bool parts : {false, true}) {
        Scene scene = channel_of<2>(12, 2, SideScene::Kind::inflow, SideScene::Kind::open, 1);
        scene.sides[0].velocity = {1, 0, 0};
        scene.parts = parts;
        scene.tolerance = 1e-8;
        scene.viscosity = 0.03;
        scene.max_step = 0.02;
        scene.bodies = {body("cylinder", BodyScene::ShapeKind::ball, {0.813, 0.487, 0})};
        scene.bodies[0].radius = 0.15;
        scene.bodies[0].motion = BodyScene::Motion::fixed;
        Simulation<2> run(scene, Communicator());
        while (run.time() < 1)
            run.step(1);
        drag[parts] = run.fluid_wrenches()[0][0];
    }
    EXPECT_NEAR(drag[1] / drag[0], 1, 0.02);
}

// What a stream without walls carries leaves it; where exits let no vorticity pass it would stay.
TEST(ViscousSides, VorticityLeaves)
{
    Scene scene = channel_of<2>(16, 1, SideScene::Kind::inflow, SideScene::Kind::open, 1);
    scene.sides[2].kind = scene.sides[3].kind = SideScene::Kind::periodic;
    scene.viscosity = 1e-4;
    PartsRun<2> run(scene, [](const Vec<2>& x) {
        return Vec<2>(1 + 0.2 * std::sin(2 * pi * x[1]) * std::cos(2 * pi * x[0]),
                      -0.2 * std::cos(2 * pi * x[1]) * std::sin(2 * pi * x[0]));
    });
    const double start = run.now.energy - 0.5;
    for (int k = 0; k < 120; ++k)
        run.step(0.03);
    EXPECT_GT(start, 5e-3);
    EXPECT_NEAR(run.now.energy, 0.5, 0.04 * start); // 0.02 of it; 0.004 with cells half as wide
}

// A plug of fluid neither changes nor dissipates.
TEST(ViscousSides, PlugFlowIsSteady)
{
    Scene scene = channel_of<2>(8, 1, SideScene::Kind::inflow, SideScene::Kind::open, 1);
    scene.sides[2].kind = scene.sides[3].kind = SideScene::Kind::periodic;
    PartsRun<2> run(scene);
    for (int k = 0; k < 4; ++k) {
        run.step(0.05);
        EXPECT_NEAR(run.now.energy, 0.5, 1e-9);
        EXPECT_NEAR(run.report.dissipation_grid, 0, 1e-9);
    }
}

// A stream through sides that are open or far stays as it is, at the pressure beyond.
TEST(ViscousSides, AStreamGoesThroughOpenSides)
{
    for (const SideScene::Kind kind : {SideScene::Kind::open, SideScene::Kind::far}) {
        Scene scene = box_of_fluid(2, 8, kind);
        scene.fluid_velocity = {1, 0.3, 0};
        scene.viscosity = 0.1;
        scene.tolerance = 1e-12;
        PartsRun<2> run(scene);
        for (int k = 0; k < 3; ++k)
            run.step(0.05);
        const Grid<2>& grid = run.model.grid;
        const UnknownVector<2> p = reduced_pressure(run.state);
        for_each_index<2>(grid.low(), grid.high(), [&](const Index<2>& c) {
            EXPECT_NEAR(run.state.velocity.grid(0, c), 1, 1e-8);
            EXPECT_NEAR(run.state.velocity.grid(1, c), 0.3, 1e-8);
            EXPECT_NEAR(p.cells(c), 0, 1e-7);
        });
    }
}

// The ball cuts corners of cells off whose faces have 4e-6 to 6e-5 of a cell's: the pressure in these and the friction on their faces are 900 times what is beside them and
// cancel. The fluid that turns must see no vortex there (without this the second step diverges).
TEST(ViscousSides, InflowPassesABallWithSliversBesideIt)
{
    Scene scene = channel_of<3>(6, 2, SideScene::Kind::inflow, SideScene::Kind::open, 1);
    scene.sides[4].kind = scene.sides[5].kind = SideScene::Kind::wall;
    scene.bodies = {body("ball", BodyScene::ShapeKind::ball, {0.9, 0.52, 0.47})};
    scene.bodies[0].radius = 0.3;
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    PartsRun<3> run(scene);
    double drag = 0;
    for (int k = 0; k < 3; ++k) {
        drag = run.state.wrenches[0][0];
        run.step(0.05);
    }
    const Grid<3>& grid = run.model.grid;
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis)
        for_each_index<3>(grid.low(), owned_faces_end(grid, axis), [&](const Index<3>& f) {
            largest = std::max(largest, std::abs(run.now.flow.remainder.faces(axis, f)));
        });
    EXPECT_NEAR(run.state.wrenches[0][0], drag, 3e-3 * drag); // settles: 1.0e-3 of it
    EXPECT_LT(largest, 100);                                  // 71; 5500 after one step, of slivers
}

TEST(ViscousSides, GoOnFromAStoredStateBitForBit)
{
    Scene scene = bodies_in_channel(0.5);
    scene.max_step = 0.03;
    expect_to_go_on<2>(scene);
    Scene inflow = channel_of<2>(16, 2, SideScene::Kind::inflow, SideScene::Kind::open, 1);
    inflow.bodies = {scene.bodies[0], scene.bodies[1]};
    inflow.max_step = 0.03;
    expect_to_go_on<2>(inflow);
}

} // namespace
} // namespace gapflow
