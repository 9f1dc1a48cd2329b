// The viscous step alone, without pressure: decay of a wave, linear flow, momentum and energy.
#include "gapflow/viscosity/viscous_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

constexpr double density = 1.3, viscosity = 0.7;

template <int D>
struct World {
    Grid<D> grid;
    Coupling<D> coupling;
    std::vector<std::unique_ptr<Shape<D>>> shapes;
    ViscousBodies<D> bodies;

    /// A periodic box of side 1, with a free ball of radius 0.23 if asked for.
    World(int n, bool with_ball) : grid(Vec<D>::Zero(), 1.0 / n, Index<D>::Constant(n), periodic(), 4, Communicator())
    {
        std::vector<Solid<D>> solids;
        if (with_ball) {
            shapes.push_back(make_ball<D>(0.23));
            Pose<D> pose;
            pose.position = Vec<D>::Constant(0.513) + 0.01 * unit<D>(1);
            solids.push_back({"ball", PlacedShape<D>(*shapes.back(), pose), pose.position, Motion::free});
            TwistMatrix<D> mass = TwistMatrix<D>::Identity() * 0.2;
            mass(D, D) = 0.01;
            bodies.mass.push_back(mass);
            bodies.twists.push_back(Twist<D>::Zero());
        }
        coupling = couple<D>(grid, solids, bodies.mass, {density, FractionMode::cut_cell},
                             [](int, int) {
                                 GapSettings none;
                                 none.film = false;
                                 return none;
                             },
                             {});
    }
    static std::array<SideKind, 2 * D> periodic()
    {
        std::array<SideKind, 2 * D> sides;
        sides.fill(SideKind::periodic);
        return sides;
    }
    ViscousSolution<D> step(FaceField<D>& u, double dt)
    {
        exchange(grid, u);
        const ViscousSystem<D> system = viscous_system(coupling, viscosity, dt, u, bodies);
        ViscousSolution<D> result = solve_viscous_system(system, u, bodies, 1e-12);
        EXPECT_TRUE(result.report.converged);
        EXPECT_LT(result.report.iterations, 40);
        return result;
    }
    template <class F>
    void for_each_open_face(F&& f) const
    {
        for (int axis = 0; axis < D; ++axis)
            for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& face) {
                if (coupling.system.conductance(axis, face) > 0) {
                    const int cut = coupling.fractions->cut(axis, face);
                    f(axis, face, cut >= 0 ? coupling.fractions->faces[cut].open_centroid : grid.face_centre(axis, face),
                      density * coupling.open(axis, face) * std::pow(grid.dx(), D));
                }
            });
    }
};

// u_x = sin(2 pi y) decays by 1 / (1 + nu dt k^2), k^2 = (2 - 2 cos(2 pi dx)) / dx^2 on the grid, for any dt.
template <int D>
void check_wave()
{
    World<D> world(16, false);
    const double dx = world.grid.dx(), k2 = (2 - 2 * std::cos(2 * std::numbers::pi * dx)) / (dx * dx);
    for (double dt : {1e-4, 1e-2, 10.0}) {
        FaceField<D> u(world.grid);
        world.for_each_open_face([&](int axis, const Index<D>& f, const Vec<D>& x, double) {
            u(axis, f) = axis == 0 ? std::sin(2 * std::numbers::pi * x[1]) : 0.0;
        });
        world.step(u, dt);
        const double decay = 1 / (1 + viscosity / density * dt * k2);
        world.for_each_open_face([&](int axis, const Index<D>& f, const Vec<D>& x, double) {
            EXPECT_NEAR(u(axis, f), axis == 0 ? decay * std::sin(2 * std::numbers::pi * x[1]) : 0.0, 1e-9);
        });
    }
}

TEST(ViscousSolution, WaveDecaysAsTheGridsExactSolution2D)
{
    check_wave<2>();
}

TEST(ViscousSolution, WaveDecaysAsTheGridsExactSolution3D)
{
    check_wave<3>();
}

// Flow at rest relative to the ball, and turning with it as far as the lattice is linear: nothing changes.
template <int D>
void check_common_motion()
{
    World<D> world(16, true);
    for (int k = 0; k < D; ++k)
        world.bodies.twists[0][k] = 0.3 + k;
    FaceField<D> u(world.grid);
    world.for_each_open_face([&](int axis, const Index<D>& f, const Vec<D>&, double) { u(axis, f) = 0.3 + axis; });
    const ViscousSolution<D> step = world.step(u, 0.5);
    EXPECT_LT((step.twists[0] - world.bodies.twists[0]).norm(), 1e-10);
    world.for_each_open_face(
        [&](int axis, const Index<D>& f, const Vec<D>&, double) { EXPECT_NEAR(u(axis, f), 0.3 + axis, 1e-10); });
}

TEST(ViscousSolution, CommonMotionStays2D)
{
    check_common_motion<2>();
}

TEST(ViscousSolution, CommonMotionStays3D)
{
    check_common_motion<3>();
}

// A moving, turning ball in fluid at rest: linear momentum of both is conserved, energy falls, and what the body feels is what it gets.
template <int D>
void check_balance()
{
    World<D> world(16, true);
    world.bodies.twists[0] = Twist<D>::LinSpaced(0.4, 1.7);
    FaceField<D> u(world.grid);
    world.for_each_open_face([&](int axis, const Index<D>& f, const Vec<D>& x, double) {
        u(axis, f) = 0.2 * std::cos(2 * std::numbers::pi * x[(axis + 1) % D]);
    });
    auto momentum_and_energy = [&](const Twist<D>& V) {
        Eigen::Matrix<double, D + 1, 1> sum;
        const Twist<D> L = world.bodies.mass[0] * V;
        sum << L.template head<D>(), 0.5 * V.dot(L);
        world.for_each_open_face([&](int axis, const Index<D>& f, const Vec<D>&, double mass) {
            sum[axis] += mass * u(axis, f);
            sum[D] += 0.5 * mass * u(axis, f) * u(axis, f);
        });
        return sum;
    };
    const auto before = momentum_and_energy(world.bodies.twists[0]);
    const ViscousSolution<D> step = world.step(u, 0.05);
    const auto after = momentum_and_energy(step.twists[0]);
    EXPECT_LT((after - before).template head<D>().norm(), 1e-10 * before.template head<D>().norm());
    EXPECT_LT(after[D], 0.9 * before[D]);
    const Twist<D> gained = world.bodies.mass[0] * (step.twists[0] - world.bodies.twists[0]);
    EXPECT_LT((gained - step.impulses[0]).norm(), 1e-9 * gained.norm());
}

TEST(ViscousSolution, ConservesMomentumAndLosesEnergy2D)
{
    check_balance<2>();
}

TEST(ViscousSolution, ConservesMomentumAndLosesEnergy3D)
{
    check_balance<3>();
}

} // namespace
} // namespace gapflow
