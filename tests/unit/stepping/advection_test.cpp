#include "gapflow/stepping/advection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace gapflow {
namespace {

constexpr double pi = std::numbers::pi;

template <int D>
Grid<D> square_grid(int n, SideKind kind, int ghost = 3)
{
    std::array<SideKind, 2 * D> sides;
    sides.fill(kind);
    return Grid<D>(Vec<D>::Zero(), 1.0 / n, Index<D>::Constant(n), sides, ghost, Communicator());
}

template <int D>
void for_owned(const Grid<D>& grid, const std::function<void(int, const Index<D>&)>& f)
{
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& i) { f(axis, i); });
}

template <int D>
FaceField<D> sampled(const Grid<D>& grid, const std::function<Vec<D>(const Vec<D>&)>& velocity)
{
    FaceField<D> u(grid);
    for_owned<D>(grid, [&](int axis, const Index<D>& f) { u(axis, f) = velocity(grid.face_centre(axis, f))[axis]; });
    fill_velocity_ghosts(grid, u, BoundaryVelocity<D>{});
    return u;
}

// Velocities everywhere, ghosts too: a field that does not end at the domain's sides.
template <int D>
FaceField<D> sampled_everywhere(const Grid<D>& grid, const std::function<Vec<D>(const Vec<D>&)>& velocity)
{
    FaceField<D> u(grid);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(u[axis].block().low, u[axis].block().high,
                          [&](const Index<D>& f) { u(axis, f) = velocity(grid.face_centre(axis, f))[axis]; });
    return u;
}

template <int D>
double mean_difference(const Grid<D>& grid, const FaceField<D>& a, const FaceField<D>& b)
{
    double sum = 0;
    long count = 0;
    for_owned<D>(grid, [&](int axis, const Index<D>& f) {
        sum += std::abs(a(axis, f) - b(axis, f));
        ++count;
    });
    return grid.comm().sum(sum) / static_cast<double>(grid.comm().sum(count));
}

template <int D>
void constant_stays(SideKind kind)
{
    const Grid<D> grid = square_grid<D>(8, kind);
    Vec<D> value = Vec<D>::LinSpaced(0.37, -0.81);
    BoundaryVelocity<D> sides;
    sides.velocity.fill(value);
    FaceField<D> u = sampled<D>(grid, [&](const Vec<D>&) { return value; });
    fill_velocity_ghosts(grid, u, sides);
    for (AdvectionScheme scheme : {AdvectionScheme::semi_lagrangian, AdvectionScheme::maccormack}) {
        FaceField<D> result(grid);
        advect(grid, result, u, u, 0.13, scheme, sides);
        for_owned<D>(grid, [&](int axis, const Index<D>& f) { EXPECT_EQ(result(axis, f), value[axis]); });
    }
}

TEST(Advection, KeepsAConstantVelocityToTheLastBit)
{
    for (SideKind kind : {SideKind::periodic, SideKind::open, SideKind::inflow}) {
        constant_stays<2>(kind);
        constant_stays<3>(kind);
    }
}

TEST(Advection, FillsGhostsBeyondWallsInflowAndOpenSides)
{
    const std::array<SideKind, 4> kinds{SideKind::wall, SideKind::open, SideKind::inflow, SideKind::wall};
    const Grid<2> grid(Vec<2>::Zero(), 0.25, Index<2>(4, 4), kinds, 3, Communicator(MPI_COMM_SELF));
    FaceField<2> u(grid);
    for_owned<2>(grid, [&](int axis, const Index<2>& f) { u(axis, f) = 1 + 100 * axis + 10 * f[0] + f[1]; });
    BoundaryVelocity<2> sides;
    sides.velocity[2] = Vec<2>(-5, 7);
    fill_velocity_ghosts(grid, u, sides);
    EXPECT_EQ(u(0, Index<2>(0, 1)), 0);    // on the wall x = 0
    EXPECT_EQ(u(0, Index<2>(-2, 1)), -22); // odd: u(2, 1) = 22
    EXPECT_EQ(u(1, Index<2>(-1, 1)), 102); // even: v(0, 1)
    EXPECT_EQ(u(1, Index<2>(-3, 1)), 122); // v(2, 1)
    EXPECT_EQ(u(0, Index<2>(4, 1)), 42);   // open side: the boundary face keeps its value
    EXPECT_EQ(u(0, Index<2>(6, 1)), 42);
    EXPECT_EQ(u(1, Index<2>(5, 1)), 132); // v(3, 1)
    EXPECT_EQ(u(1, Index<2>(2, 0)), 7);   // inflow
    EXPECT_EQ(u(1, Index<2>(2, -3)), 7);
    EXPECT_EQ(u(0, Index<2>(2, -1)), -5);
    EXPECT_EQ(u(1, Index<2>(2, 4)), 0); // wall at the top
    EXPECT_EQ(u(1, Index<2>(2, 6)), -u(1, Index<2>(2, 2)));
    EXPECT_EQ(u(0, Index<2>(2, 5)), u(0, Index<2>(2, 2)));
    EXPECT_EQ(u(1, Index<2>(-2, 6)), -u(1, Index<2>(1, 2))); // corner of two walls
}

TEST(Advection, WeighsTheFourFacesAroundTheFoot)
{
    const Grid<2> grid = square_grid<2>(8, SideKind::periodic);
    const double dx = grid.dx();
    const FaceField<2> u = sampled<2>(grid, [](const Vec<2>&) { return Vec<2>(1, 0.5); });
    FaceField<2> spike(grid), result(grid);
    spike(0, Index<2>(3, 3)) = 16;
    fill_velocity_ghosts(grid, spike, BoundaryVelocity<2>{});
    advect(grid, result, u, spike, 0.5 * dx, AdvectionScheme::semi_lagrangian, BoundaryVelocity<2>{});
    EXPECT_NEAR(result(0, Index<2>(3, 3)), 16 * 0.5 * 0.75, 1e-14);
    EXPECT_NEAR(result(0, Index<2>(4, 3)), 16 * 0.5 * 0.75, 1e-14);
    EXPECT_NEAR(result(0, Index<2>(4, 4)), 16 * 0.5 * 0.25, 1e-14);
    EXPECT_EQ(result(0, Index<2>(2, 3)), 0);
    EXPECT_EQ(result(1, Index<2>(3, 3)), 0);
}

// In a linear field interpolation is exact: the result is u at the midpoint rule's foot.
template <int D>
void rotation_is_traced()
{
    const Grid<D> grid = square_grid<D>(8, SideKind::open);
    Spin<D> omega = Spin<D>::LinSpaced(0.9, 0.4);
    const Vec<D> centre = Vec<D>::Constant(0.45);
    auto rigid = [&](const Vec<D>& x) { return spin_velocity<D>(omega, x - centre); };
    const FaceField<D> u = sampled_everywhere<D>(grid, rigid);
    const double dt = 0.1;
    FaceField<D> semi(grid), corrected(grid);
    advect(grid, semi, u, u, dt, AdvectionScheme::semi_lagrangian, BoundaryVelocity<D>{});
    advect(grid, corrected, u, u, dt, AdvectionScheme::maccormack, BoundaryVelocity<D>{});
    for_owned<D>(grid, [&](int axis, const Index<D>& f) {
        if ((f.array() < 2).any() || (f.array() > 5).any())
            return;
        const Vec<D> x = grid.face_centre(axis, f);
        const Vec<D> foot = x - dt * rigid(x - 0.5 * dt * rigid(x));
        EXPECT_NEAR(semi(axis, f), rigid(foot)[axis], 1e-14);
        // A linear field leaves MacCormack nothing to correct but the two traces' third-order mismatch.
        EXPECT_NEAR(corrected(axis, f), rigid(foot)[axis], std::pow(dt, 3));
    });
}

TEST(Advection, TracesRigidRotationFromFaceCentres)
{
    rotation_is_traced<2>();
    rotation_is_traced<3>();
}

// Error at t = 0.25 of a field constant along the streamlines of a Taylor-Green vortex, which does not change in time.
double vortex_error(int n, AdvectionScheme scheme)
{
    const Grid<2> grid = square_grid<2>(n, SideKind::periodic);
    const double k = 2 * pi;
    auto stream = [&](const Vec<2>& x) { return std::sin(k * x[0]) * std::sin(k * x[1]); };
    const FaceField<2> u = sampled<2>(grid, [&](const Vec<2>& x) {
        return Vec<2>(std::sin(k * x[0]) * std::cos(k * x[1]), -std::cos(k * x[0]) * std::sin(k * x[1]));
    });
    const FaceField<2> exact =
        sampled<2>(grid, [&](const Vec<2>& x) { return Vec<2>(std::sin(2 * stream(x)), std::cos(3 * stream(x))); });
    FaceField<2> carried = exact, next(grid);
    for (int step = 0; step < n / 4; ++step) {
        advect(grid, next, u, carried, 1.0 / n, scheme, BoundaryVelocity<2>{});
        std::swap(next, carried);
        fill_velocity_ghosts(grid, carried, BoundaryVelocity<2>{});
    }
    return mean_difference(grid, carried, exact);
}

TEST(Advection, SemiLagrangianIsFirstOrderAndMacCormackSecondInASteadyVortex)
{
    const double coarse = vortex_error(64, AdvectionScheme::semi_lagrangian);
    const double fine = vortex_error(128, AdvectionScheme::semi_lagrangian);
    EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.2) << coarse << " " << fine;
    const double coarse_mc = vortex_error(64, AdvectionScheme::maccormack);
    const double fine_mc = vortex_error(128, AdvectionScheme::maccormack);
    EXPECT_NEAR(std::log2(coarse_mc / fine_mc), 2.0, 0.25) << coarse_mc << " " << fine_mc;
    EXPECT_LT(fine_mc, 0.1 * fine);
}

double translation_error(int n, AdvectionScheme scheme)
{
    const Grid<3> grid = square_grid<3>(n, SideKind::periodic);
    const Vec<3> velocity(1.0, 0.6, -0.3);
    const double dt = 0.7 / n;
    auto wave = [&](double t) {
        return [=](const Vec<3>& x) {
            const Vec<3> y = 2 * pi * (x - t * velocity);
            return Vec<3>(std::sin(y[0] + y[2]), std::cos(y[1]) * std::sin(y[0]), std::sin(y[2] + y[1]));
        };
    };
    const FaceField<3> u = sampled<3>(grid, [&](const Vec<3>&) { return velocity; });
    FaceField<3> carried = sampled<3>(grid, wave(0)), next(grid);
    const int steps = n / 4;
    for (int step = 0; step < steps; ++step) {
        advect(grid, next, u, carried, dt, scheme, BoundaryVelocity<3>{});
        std::swap(next, carried);
        fill_velocity_ghosts(grid, carried, BoundaryVelocity<3>{});
    }
    return mean_difference(grid, carried, sampled<3>(grid, wave(steps * dt)));
}

TEST(Advection, OrdersIn3D)
{
    EXPECT_NEAR(std::log2(translation_error(24, AdvectionScheme::semi_lagrangian) /
                          translation_error(48, AdvectionScheme::semi_lagrangian)),
                1.0, 0.2);
    EXPECT_NEAR(
        std::log2(translation_error(24, AdvectionScheme::maccormack) / translation_error(48, AdvectionScheme::maccormack)), 2.0,
        0.3);
}

TEST(Advection, MacCormackMakesNoNewExtremaAndCanBeSwitchedOff)
{
    const int n = 32;
    const Grid<2> grid = square_grid<2>(n, SideKind::periodic);
    const FaceField<2> u = sampled<2>(grid, [](const Vec<2>&) { return Vec<2>(0.8, 0.55); });
    const FaceField<2> square = sampled<2>(grid, [](const Vec<2>& x) {
        return Vec<2>::Constant((x - Vec<2>::Constant(0.5)).cwiseAbs().maxCoeff() < 0.22 ? 1.0 : 0.0);
    });
    FaceField<2, std::int8_t> first_order(grid, 0);
    for_owned<2>(grid, [&](int axis, const Index<2>& f) { first_order(axis, f) = f[0] % 2; });
    const double dt = 0.6 / n;
    const BoundaryVelocity<2> sides;
    FaceField<2> sharp(grid), smooth(grid), mixed(grid);
    advect(grid, sharp, u, square, dt, AdvectionScheme::maccormack, sides);
    advect(grid, smooth, u, square, dt, AdvectionScheme::semi_lagrangian, sides);
    advect<2>(grid, mixed, u, square, dt, AdvectionScheme::maccormack, sides, &first_order);
    double largest_correction = 0;
    for_owned<2>(grid, [&](int axis, const Index<2>& f) {
        EXPECT_GE(sharp(axis, f), 0);
        EXPECT_LE(sharp(axis, f), 1);
        EXPECT_EQ(mixed(axis, f), (f[0] % 2 ? smooth : sharp)(axis, f));
        largest_correction = std::max(largest_correction, std::abs(sharp(axis, f) - smooth(axis, f)));
    });
    EXPECT_GT(largest_correction, 0.1);
}

TEST(Advection, StaysInBoundsWhateverTheVelocity)
{
    for (SideKind kind : {SideKind::wall, SideKind::open, SideKind::periodic}) {
        const Grid<3> grid = square_grid<3>(6, kind, 2);
        FaceField<3> u = sampled<3>(grid, [](const Vec<3>& x) -> Vec<3> {
            return 1e12 * Vec<3>(std::sin(9 * x[1]), std::cos(7 * x[2]), std::sin(8 * x[0] - 1));
        });
        u(1, grid.low()) = std::nan("");
        const FaceField<3> carried = sampled<3>(grid, [](const Vec<3>& x) -> Vec<3> { return x; });
        FaceField<3> result(grid);
        advect(grid, result, u, carried, 1.0, AdvectionScheme::maccormack, BoundaryVelocity<3>{});
        for_owned<3>(grid, [&](int axis, const Index<3>& f) { EXPECT_LE(std::abs(result(axis, f)), 1.0); });
    }
}

TEST(Advection, FeetBeyondAWallAreTakenOnTheWall)
{
    const Grid<2> grid = square_grid<2>(8, SideKind::wall);
    // Blows out of the wall x = 0 (not a flow that keeps the wall): feet of the first faces lie beyond it.
    const FaceField<2> u = sampled_everywhere<2>(grid, [](const Vec<2>&) { return Vec<2>(1, 0); });
    const FaceField<2> carried = sampled_everywhere<2>(grid, [](const Vec<2>& x) { return Vec<2>(x[0], x[0]); });
    FaceField<2> result(grid);
    advect(grid, result, u, carried, 2 * grid.dx(), AdvectionScheme::semi_lagrangian, BoundaryVelocity<2>{});
    EXPECT_NEAR(result(0, Index<2>(1, 3)), 0.0, 1e-15);
    EXPECT_NEAR(result(1, Index<2>(0, 3)), 0.0, 1e-15);
    EXPECT_NEAR(result(0, Index<2>(5, 3)), 3 * grid.dx(), 1e-15);
}

} // namespace
} // namespace gapflow
