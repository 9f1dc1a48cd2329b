// Places and measures of a graded grid, and face fractions where cells differ in width.
#include "scenes.hpp"

namespace gapflow::testing {
namespace {

// A core of 6 cells of 0.5 along every axis, 3 wider cells below and 2 above.
template <int D>
Grid<D> graded_grid()
{
    Grading<D> grading;
    for (int axis = 0; axis < D; ++axis) {
        grading.below[axis] = {1.2, 1.4, 1.6};
        grading.above[axis] = {1.5, 2.0};
    }
    return Grid<D>(Vec<D>::Constant(-1), 0.5, Index<D>::Constant(11), all_sides<D>(SideKind::wall), 3,
                   Communicator(MPI_COMM_SELF), grading);
}

TEST(GradedGrid, PlacesByHand)
{
    const auto grid = graded_grid<2>();
    EXPECT_TRUE(grid.graded());
    const double expected[] = {-1, -0.2, 0.5, 1.1, 1.6, 2.1, 2.6, 3.1, 3.6, 4.1, 4.85, 5.85};
    for (int i = 0; i <= 11; ++i)
        EXPECT_NEAR(grid.face_place(0, i), expected[i], 1e-14) << i;
    EXPECT_NEAR(grid.centre_place(1, 0), -0.6, 1e-14);
    EXPECT_NEAR(grid.face_place(0, -2), -1 - 2 * 0.8, 1e-14); // beyond the domain as wide as the last cell
    EXPECT_NEAR(grid.face_place(0, 13), 5.85 + 2 * 1.0, 1e-14);
    EXPECT_NEAR(grid.size()[0], 6.85, 1e-14);
    EXPECT_EQ(grid.width(0, 5), 1.0);
    EXPECT_EQ(grid.width(0, 0), 1.6);
    EXPECT_NEAR(grid.spread(0, 1), 1.5, 1e-15);
    EXPECT_NEAR(grid.spread(0, 3), 1.1, 1e-15);
    EXPECT_NEAR(grid.relative_area(0, Index<2>(4, 10)), 2.0, 1e-15);
    EXPECT_NEAR(grid.relative_volume(Index<2>(0, 10)), 3.2, 1e-15);
    EXPECT_EQ(grid.largest_width(), 2.0);
}

TEST(GradedGrid, FindsItsCells)
{
    const auto grid = graded_grid<3>();
    for (int i = -6; i < 17; ++i)
        for (const double f : {0.001, 0.5, 0.999}) {
            const double x = grid.face_place(1, i) + f * 0.5 * grid.width(1, i);
            EXPECT_EQ(grid.cell_of(Vec<3>(2, x, 3))[1], i) << x;
        }
    for (int i = 0; i < 10; ++i) {
        EXPECT_NEAR(grid.lattice_place(0, grid.cell_centre(Index<3>(i, i, i)))[2], i, 1e-12);
        EXPECT_NEAR(grid.lattice_place(1, grid.face_centre(0, Index<3>(i, i, i)))[0], i, 1e-12);
        const Vec<3> half = 0.5 * (grid.cell_centre(Index<3>(i, i, i)) + grid.cell_centre(Index<3>(i + 1, i + 1, i + 1)));
        EXPECT_NEAR(grid.lattice_place(0, half)[1], i + 0.5, 1e-12);
    }
}

TEST(GradedGrid, WithoutOuterCellsIsUniform)
{
    const Grid<2> grid(Vec<2>(0, 1), 0.25, Index<2>(8, 4), all_sides<2>(SideKind::wall), 2, Communicator(MPI_COMM_SELF),
                       Grading<2>{});
    EXPECT_FALSE(grid.graded());
    EXPECT_TRUE(grid.in_core(Index<2>(-3, 100)));
    EXPECT_EQ(grid.relative_area(0, Index<2>(9, 9)), 1.0);
}

// A ball that reaches far out of the core: parts of every face make up its area, the hulls of cells are closed, and the volume is right.
template <int D>
void expect_closed_cells(double volume, double tolerance)
{
    const Grid<D> grid = graded_grid<D>();
    const Vec<D> centre = Vec<D>::Constant(2.43);
    Scene<D> scene(grid);
    const int ball = scene.add("ball", make_ball<D>(2.9), pose<D>(centre));
    const FaceClipper<D> clipper(grid, scene.solids, FractionMode::cut_cell);
    const FaceFractions<D> fractions = face_fractions(grid, clipper);
    double measured = 0;
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& f) {
            const double area = grid.relative_area(axis, f);
            const double own = fraction_in(clipped(clipper, axis, f), ball);
            EXPECT_EQ(fractions.open(axis, f), clipped(clipper, axis, f).open);
            if (f[axis] > 0) {
                EXPECT_NEAR(fractions.open(axis, f) + own, area, 1e-12 * area);
            }
            measured += own * grid.face_area() * grid.dx() * grid.spread(axis, f[axis]) / D;
        });
    EXPECT_NEAR(measured, volume, tolerance * volume);
    EXPECT_LT(sum_of_body_flux(grid, fractions, ball + 1)[ball].norm(), 1e-11);
}

TEST(GradedGrid, CutsFacesOfAnyWidth)
{
    expect_closed_cells<2>(std::acos(-1.0) * 2.9 * 2.9, 0.05);
    expect_closed_cells<3>(4.0 / 3 * std::acos(-1.0) * 2.9 * 2.9 * 2.9, 0.05);
}

} // namespace
} // namespace gapflow::testing
