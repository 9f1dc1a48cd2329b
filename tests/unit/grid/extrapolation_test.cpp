#include "gapflow/grid/extrapolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace gapflow {
namespace {

template <int D>
Grid<D> square_grid(int n, SideKind kind)
{
    std::array<SideKind, 2 * D> sides;
    sides.fill(kind);
    return Grid<D>(Vec<D>::Zero(), 1.0 / n, Index<D>::Constant(n), sides, 3, Communicator(MPI_COMM_SELF));
}

template <int D>
struct Case {
    Grid<D> grid;
    FaceField<D> u;
    FaceField<D, std::int8_t> valid;

    Case(int n, SideKind kind, const std::function<bool(const Vec<D>&)>& fluid,
         const std::function<double(const Vec<D>&)>& value)
        : grid(square_grid<D>(n, kind)), u(grid, std::nan("")), valid(grid, 1)
    {
        for_owned([&](int axis, const Index<D>& f) {
            const Vec<D> x = grid.face_centre(axis, f);
            valid(axis, f) = fluid(x);
            if (valid(axis, f))
                u(axis, f) = value(x);
        });
    }
    void for_owned(const std::function<void(int, const Index<D>&)>& f) const
    {
        for (int axis = 0; axis < D; ++axis)
            for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& i) { f(axis, i); });
    }
};

template <int D>
void constant_stays(SideKind kind)
{
    Case<D> c(
        12, kind, [](const Vec<D>& x) { return (x - Vec<D>::Constant(0.4)).norm() > 0.35; },
        [](const Vec<D>&) { return 0.37; });
    extrapolate(c.grid, c.u, c.valid, 8);
    c.for_owned([&](int axis, const Index<D>& f) {
        EXPECT_GT(c.valid(axis, f), 0);
        EXPECT_NEAR(c.u(axis, f), 0.37, 1e-15);
    });
}

TEST(Extrapolation, KeepsAConstant)
{
    for (SideKind kind : {SideKind::wall, SideKind::periodic}) {
        constant_stays<2>(kind);
        constant_stays<3>(kind);
    }
}

// Fluid left of x = 1/2 (faces normal to y), velocity 3 x + 2: layer by layer along each row.
TEST(Extrapolation, IsLinearInTheFirstLayerAndConstantBeyondWithZeroOutOfReach)
{
    Case<2> c(
        8, SideKind::wall, [](const Vec<2>& x) { return x[0] < 0.5; }, [](const Vec<2>& x) { return 3 * x[0] + 2; });
    extrapolate(c.grid, c.u, c.valid, 3);
    const double first = 3 * (4.5 / 8) + 2;
    for (int j = 0; j <= 8; ++j) {
        EXPECT_NEAR(c.u(1, Index<2>(3, j)), 3 * (3.5 / 8) + 2, 1e-15);
        EXPECT_NEAR(c.u(1, Index<2>(4, j)), first, 1e-14);
        EXPECT_NEAR(c.u(1, Index<2>(5, j)), first, 1e-14);
        EXPECT_NEAR(c.u(1, Index<2>(6, j)), first, 1e-14);
        EXPECT_EQ(c.u(1, Index<2>(7, j)), 0);
        for (int i = 0; i < 8; ++i)
            EXPECT_EQ(c.valid(1, Index<2>(i, j)), i < 4 ? 1 : i < 7 ? i - 2 : 0);
    }
}

TEST(Extrapolation, AveragesOverDirectionsAndFallsBackToTheMean)
{
    Case<2> c(
        8, SideKind::wall, [](const Vec<2>&) { return true; }, [](const Vec<2>&) { return 0.0; });
    auto& u = c.u[0];
    auto& valid = c.valid[0];
    valid(Index<2>(3, 3)) = 0; // lines from all four directions
    u(Index<2>(2, 3)) = 1;
    u(Index<2>(1, 3)) = 5; // 2 * 1 - 5 = -3
    u(Index<2>(3, 4)) = 4; // 8
    for (const Index<2>& f : {Index<2>(0, 6), Index<2>(2, 6), Index<2>(1, 5), Index<2>(1, 6)})
        valid(f) = 0; // (1, 6): the only valid neighbour is (1, 7), nothing in line behind it
    u(Index<2>(1, 7)) = 9;
    extrapolate(c.grid, c.u, c.valid, 1);
    EXPECT_DOUBLE_EQ(u(Index<2>(3, 3)), (-3.0 + 8.0) / 4);
    EXPECT_DOUBLE_EQ(u(Index<2>(1, 6)), 9);
}

TEST(Extrapolation, IsSecondOrderInTheFirstLayer)
{
    auto value = [](const Vec<2>& x) { return std::sin(3 * x[0] + 1) * std::cos(2 * x[1]); };
    auto error = [&](int n) {
        Case<2> c(
            n, SideKind::wall, [](const Vec<2>& x) { return (x - Vec<2>(0.5, 0.5)).norm() > 0.3; }, value);
        extrapolate(c.grid, c.u, c.valid, 4);
        double worst = 0;
        c.for_owned([&](int axis, const Index<2>& f) {
            if (c.valid(axis, f) == 2)
                worst = std::max(worst, std::abs(c.u(axis, f) - value(c.grid.face_centre(axis, f))));
        });
        return worst;
    };
    EXPECT_NEAR(std::log2(error(64) / error(128)), 2.0, 0.3);
}

TEST(Extrapolation, ReachesAcrossPeriodicSides)
{
    Case<2> c(
        8, SideKind::periodic, [](const Vec<2>& x) { return x[0] > 0.45 && x[0] < 0.95; }, [](const Vec<2>&) { return 1.5; });
    extrapolate(c.grid, c.u, c.valid, 2);
    EXPECT_EQ(c.valid(1, Index<2>(0, 2)), 2);
    EXPECT_EQ(c.valid(1, Index<2>(1, 2)), 3);
    EXPECT_DOUBLE_EQ(c.u(1, Index<2>(1, 2)), 1.5);
    EXPECT_DOUBLE_EQ(c.u(1, Index<2>(8, 2)), 1.5);
}

} // namespace
} // namespace gapflow
