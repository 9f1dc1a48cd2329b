// Sides of boxes in planes of the grid to round-off: the added mass is that of the sides in the planes.
#include "two_boxes.hpp"

#include "gapflow/complex/plane_poses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow::testing {
namespace {

constexpr int cells = 64;

/// 0.32 cells above each other, at places along x, in cells, and turned.
Eigen::MatrixXd mass_of_turned(double upper, double lower, double degrees = 0)
{
    const Grid<2> grid = grid_of_boxes();
    const double dx = grid.dx(), angle = degrees * std::numbers::pi / 180;
    Scene<2> scene =
        two_boxes(grid, {pose<2>(dx * Vec<2>(upper, 32 + 4.16), angle), pose<2>(dx * Vec<2>(lower, 32 - 4.16), angle)});
    put_into_planes(grid, scene.solids);
    return mass_of_boxes(grid, scene.solids);
}

TEST(AlignedSides, ArePlacedInPlanesOfTheGrid)
{
    const Grid<3> grid = unit_grid<3>(cells);
    const double dx = grid.dx();
    Scene<3> scene(grid);
    Pose<3> at = pose<3>(dx * Vec<3>(16 + 1e-9, 16 - 2e-10, 16.3));
    at.rotation = Rotation<3>(Eigen::AngleAxisd(1e-10, Vec<3>(1, 2, -1).normalized()));
    scene.add("box", make_box<3>(dx * Vec<3>(8, 6, 4)), at);
    scene.solids.back().centre = dx * Vec<3>(15, 16, 16);
    const Vec<3> before = scene.solids.back().centre;
    put_into_planes(grid, scene.solids);
    const Solid<3>& box = scene.solids.back();
    EXPECT_LT((box.shape.rotation() - Mat<3>::Identity()).norm(), 1e-15);
    const Vec<3> place = box.shape.to_world(Vec<3>::Zero()) / dx;
    EXPECT_NEAR(place[0], 16, 1e-13);
    EXPECT_NEAR(place[1], 16, 1e-13);
    EXPECT_NEAR(place[2], 16.3, 1e-13); // not in a plane
    EXPECT_NEAR((box.centre - before)[0] / dx, -1e-9, 1e-13);
}

TEST(AlignedSides, BeyondAPeriodicDomainAreInPlanesToo)
{
    const Grid<2> grid(Vec<2>::Zero(), 1.0, Index<2>(14, 14), all_sides<2>(SideKind::periodic), 2, Communicator(MPI_COMM_SELF));
    Scene<2> scene(grid);
    scene.add("slab", make_box<2>(Vec<2>(46, 9)), pose<2>(Vec<2>(7 + 1e-9, 7.2), 0));
    put_into_planes(grid, scene.solids);
    EXPECT_NEAR(scene.solids.back().shape.to_world(Vec<2>::Zero())[0], 7, 1e-13);
    const GridPlanes<2> planes(grid);
    for (const int plane : {-100, -17, 0, 14, 31, 100})
        EXPECT_EQ(plane_beside<2>(planes, 0, plane + 1e-9).value_or(0.5), plane);
}

TEST(AlignedSides, HaveTheAddedMassOfThePlaneToRoundOff)
{
    const Eigen::MatrixXd M = mass_of_turned(32, 32);
    for (const double off : {1e-12, 1e-10, 1e-9, 3e-9})
        for (const auto& [upper, lower] :
             {std::pair(off, off), std::pair(off, -off), std::pair(0.0, off), std::pair(-off, 0.0)})
            EXPECT_LT(mass_difference(mass_of_turned(32 + upper, 32 + lower), M), 1e-7) << off << ": " << upper << ' ' << lower;
    for (const double degrees : {1e-12, 1e-10, 1e-9, 1e-8})
        EXPECT_LT(mass_difference(mass_of_turned(32, 32, degrees), M), 1e-7) << degrees;
}

template <int D>
Eigen::MatrixXd mass_in_planes(const Grid<D>& grid, Scene<D>& scene)
{
    put_into_planes(grid, scene.solids);
    return mass_on_parts(grid, scene.solids);
}

// A facet in a plane of the grid is covered as a box's side is; a layer of no thickness beside it would be fluid of the gap. In the plane and in space.
template <int D>
Eigen::MatrixXd mass_of_facets(bool facets, double off)
{
    const Grid<D> grid = unit_grid<D>(16);
    const double dx = grid.dx();
    Scene<D> scene(grid);
    for (const int side : {1, -1}) {
        Vec<D> x = Vec<D>::Constant(8), size = Vec<D>::Constant(4);
        x[0] += off;
        x[1] = 8.3 + side * 2.005;
        std::unique_ptr<Shape<D>> box = make_box<D>(Vec<D>(dx * size));
        scene.add("box", facets ? make_mesh<D>(box->display_mesh(0), "box") : std::move(box), pose<D>(Vec<D>(dx * x)));
        scene.solids.back().motion = Motion::free;
    }
    return mass_in_planes(grid, scene);
}

template <int D>
void compare_facets_with_boxes()
{
    const Eigen::MatrixXd boxes = mass_of_facets<D>(false, 0);
    for (const double off : {0.0, 1e-10, -3e-10, 2e-9})
        EXPECT_LT(mass_difference(mass_of_facets<D>(true, off), boxes), 1e-6) << D << ", " << off;
}

TEST(AlignedSides, OfFacetsAreThoseOfBoxes)
{
    compare_facets_with_boxes<2>();
    compare_facets_with_boxes<3>();
}

// Ends of a cylinder that lies along another axis than its own to round-off, in planes or 1e-10 beside them: its mass along itself was 18 % too small.
TEST(AlignedSides, EndsOfCylindersAreInPlanes)
{
    const Grid<3> grid = unit_grid<3>(16);
    const auto along_itself = [&](const Rotation<3>& turn, double off) {
        Scene<3> scene(grid);
        Pose<3> at = pose<3>(grid.dx() * Vec<3>::Constant(8 + off));
        at.rotation = turn;
        scene.add("cylinder", make_cylinder(2.7 * grid.dx(), 6 * grid.dx()), at);
        scene.solids.back().motion = Motion::free;
        const Vec<3> axis = turn * unit<3>(0);
        return axis.dot(mass_in_planes(grid, scene).topLeftCorner<3, 3>() * axis);
    };
    const double exact = along_itself(Rotation<3>::Identity(), 0);
    const Rotation<3> turned(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec<3>(0, 0, 1)));
    for (const double off : {0.0, 1e-10, -2e-9})
        EXPECT_NEAR(along_itself(turned, off) / exact, 1, 1e-8) << off;
}

} // namespace
} // namespace gapflow::testing
