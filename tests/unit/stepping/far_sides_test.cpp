// Far sides: as if the fluid went on.
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/added_mass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gapflow {
namespace {

using Kind = SideScene::Kind;

// A ball of radius 1 in a box of edge `size` around it, `cells` a radius; all sides far, or with a wall below it.
Scene ball_in_box(int dimension, double size, int cells, Kind below = Kind::far)
{
    Scene scene;
    scene.dimension = dimension;
    const int n = static_cast<int>(std::lround(size * cells));
    scene.size = {size, size, dimension == 2 ? 0.0 : size};
    scene.cells = {n, n, dimension == 2 ? 1 : n};
    for (int side = 0; side < 2 * dimension; ++side)
        scene.sides[side].kind = Kind::far;
    scene.sides[2 * dimension - 2].kind = below;
    const double middle = 0.5 * size + 0.003;
    BodyScene ball;
    ball.name = "ball";
    ball.shape = BodyScene::ShapeKind::ball;
    ball.radius = 1;
    ball.position = {middle, middle, dimension == 2 ? 0.0 : middle};
    if (below == Kind::wall)
        ball.position[dimension - 1] = 1.43;
    scene.bodies = {ball};
    return scene;
}

void expect_small_share_of_the_box(int dimension, double size, int cells, Kind below, double share)
{
    const AddedMass small = added_mass(ball_in_box(dimension, size, cells, below), Communicator());
    const AddedMass large = added_mass(ball_in_box(dimension, 2 * size, cells, below), Communicator());
    for (int axis = 0; axis < dimension; ++axis)
        EXPECT_NEAR(small.matrix(axis, axis) / large.matrix(axis, axis), 1, share) << dimension << "D, axis " << axis;
    EXPECT_LE(*std::max_element(small.iterations.begin(), small.iterations.end()), 12);
    EXPECT_LE(*std::max_element(large.iterations.begin(), large.iterations.end()), 12);
}

TEST(FarSides, LeaveLittleOfTheBoxInTheAddedMass)
{
    expect_small_share_of_the_box(2, 20, 8, Kind::far, 3e-4);
    expect_small_share_of_the_box(3, 10, 4, Kind::far, 2e-4);
}

TEST(FarSides, AboveAWallFadeFromItsMirrorImageToo)
{
    expect_small_share_of_the_box(2, 20, 6, Kind::wall, 3e-3);
}

// The conductance of a face to the pressure 0 at infinity, by hand: half a cell and 1 / kappa.
TEST(FarSides, HandValues)
{
    Scene scene = ball_in_box(2, 8, 1);
    scene.density = 2;
    const Model<2> model(scene, Communicator());
    const Coupling<2> coupling = model.coupled(model.bodies);
    const double r2 = 4 * 4 + 2.5 * 2.5; // of the face beside cell (0, 1) from the middle (4, 4)
    EXPECT_NEAR(coupling.system.conductance(0, Index<2>(0, 1)), 1 / (2 * (0.5 + r2 / 4)), 1e-14);
    EXPECT_EQ(coupling.system.components.at(0).grounded, true);
}

// Uniform flow through far sides on all sides stays what it is.
template <int D>
void expect_uniform_flow()
{
    Scene scene = ball_in_box(D, 4, 4);
    scene.bodies.clear();
    scene.fluid_velocity = {1, 0.3, D == 2 ? 0.0 : -0.2};
    scene.end = 1;
    scene.max_step = 0.1;
    Simulation<D> simulation(scene, Communicator());
    for (int k = 0; k < 5; ++k)
        simulation.step(1);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(simulation.grid().low(), owned_faces_end(simulation.grid(), axis), [&](const Index<D>& f) {
            EXPECT_NEAR(simulation.velocity().grid(axis, f), scene.fluid_velocity[axis], 1e-12);
        });
}

TEST(FarSides, KeepUniformFlow2D)
{
    expect_uniform_flow<2>();
}

TEST(FarSides, KeepUniformFlow3D)
{
    expect_uniform_flow<3>();
}

// Where fluid comes in, the velocity along the side goes on without vorticity: exact for the linear flow (b x + c y, c x - b y).
TEST(FarSides, BringInNoVorticity)
{
    const int n = 8;
    std::array<SideKind, 4> sides;
    sides.fill(SideKind::far);
    const Grid<2> grid(Vec<2>(-4, -4), 1, Index<2>(n, n), sides, 4, Communicator());
    const double b = -0.7, c = 0.4;
    FaceField<2> u(grid);
    auto exact = [&](int axis, const Index<2>& f) {
        const Vec<2> x = grid.face_centre(axis, f);
        return axis == 0 ? b * x[0] + c * x[1] : c * x[0] - b * x[1];
    };
    for (int axis = 0; axis < 2; ++axis)
        for_each_index<2>(grid.low(), owned_faces_end(grid, axis), [&](const Index<2>& f) { u(axis, f) = exact(axis, f); });
    fill_velocity_ghosts(grid, u, {});
    int in = 0, out = 0;
    for (int j = 1; j < n; ++j) { // beyond the high side of x
        const Index<2> side(n, j), ghost(n, j);
        if (u(0, side) + u(0, Index<2>(n, j - 1)) < 0) {
            EXPECT_NEAR(u(1, ghost), exact(1, ghost), 1e-12);
            ++in;
        } else {
            EXPECT_EQ(u(1, ghost), u(1, Index<2>(n - 1, j)));
            ++out;
        }
    }
    EXPECT_GT(in, 0);
    EXPECT_EQ(in + out, n - 1);
}

// Two vortices of opposite sign carry each other out of a box of edge 4 through the high side of x; returns the share of their energy that
// is left in it.
double left_by_a_vortex_pair(Kind kind, int n)
{
    Scene scene;
    scene.size = {4, 4, 0};
    scene.cells = {n, n, 1};
    for (int side = 0; side < 4; ++side)
        scene.sides[side].kind = kind;
    scene.end = 8;
    scene.max_step = 0.05;
    Simulation<2> simulation(scene, Communicator());
    const Grid<2>& grid = simulation.grid();
    auto stream_function = [&](const Vec<2>& x) {
        double sum = 0;
        for (const int sign : {-1, 1})
            sum += sign * std::log((x - Vec<2>(2, 2 + 0.4 * sign)).squaredNorm() + 0.04);
        return sum;
    };
    FaceField<2>& u = const_cast<FluidVelocity<2>&>(simulation.velocity()).grid; // no scene starts like this
    for (int axis = 0; axis < 2; ++axis)
        for_each_index<2>(grid.low(), owned_faces_end(grid, axis), [&](const Index<2>& f) {
            const Vec<2> half = 0.5 * grid.dx() * unit<2>(1 - axis), x = grid.face_centre(axis, f);
            u(axis, f) = (axis ? -1 : 1) * (stream_function(x + half) - stream_function(x - half)) / grid.dx();
        });
    fill_velocity_ghosts(grid, u, {});
    const double before = simulation.budget().energy_grid;
    while (simulation.time() < scene.end)
        simulation.step(scene.end);
    return simulation.budget().energy_grid / before;
}

TEST(FarSides, LetAVortexPairGo)
{
    char text[120];
    const double far = left_by_a_vortex_pair(Kind::far, 64), finer = left_by_a_vortex_pair(Kind::far, 128),
                 open = left_by_a_vortex_pair(Kind::open, 64);
    std::snprintf(text, sizeof text, "far %.2g %%, with twice the cells %.2g %%; open %.2g %%", 100 * far, 100 * finer,
                  100 * open);
    RecordProperty("left", text);
    EXPECT_LT(far, 0.01) << text;
    EXPECT_LT(finer, 0.01) << text;
}

} // namespace
} // namespace gapflow
