// Mouths between two corners: nothing depends on which of the two is a little ahead, and little changes as one wall goes on.
#include "two_boxes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow::testing {
namespace {

/// 0.32 cells above each other, at places along x, in cells, and turned towards each other.
Eigen::MatrixXd mass_of_plates(double upper, double lower, double towards = 0, double middle = 32)
{
    const Grid<2> grid = grid_of_boxes();
    const double dx = grid.dx();
    const Scene<2> scene = two_boxes(
        grid, {pose<2>(dx * Vec<2>(upper, middle + 4.16), -towards), pose<2>(dx * Vec<2>(lower, middle - 4.16), towards)});
    return mass_of_boxes(grid, scene.solids);
}

TEST(Mouths, BetweenTwoCornersBelongToBothBodies)
{
    const Eigen::MatrixXd M = mass_of_plates(32.3, 32.3);
    for (const double off : {-1e-6, -1e-8, 1e-8, 1e-6}) // 6e-3 where the line moves with the corner's solid
        EXPECT_LT(mass_difference(mass_of_plates(32.3, 32.3 + off), M), 1e-4) << off;
    // The mirror image of the upper plate's motions are the lower one's, though one of the corners is the first.
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(M(k, k), M(3 + k, 3 + k), 1e-4 * M(k, k)) << k;
}

// Each corner lies in front of the other plate's side, by less and less: their ways to the other plate cross. Two mouths one behind the other are 7 % off.
TEST(Mouths, OfTwoCornersThatFaceEachOthersSides)
{
    const Eigen::MatrixXd M = mass_of_plates(32.3, 32.3);
    for (const double angle : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4})
        EXPECT_LT(mass_difference(mass_of_plates(32.3 + 4 * angle, 32.3 + 4 * angle, angle), M), 1e-7 + 20 * angle) << angle;
}

TEST(Mouths, ChangeLittleAsOneWallGoesOn)
{
    // Beyond the end of the upper plate the lower one goes on. Against four times as many cells; up to 2.4 % off where the angle seen at a distance counts.
    const auto opening = [](double shift) {
        const Eigen::MatrixXd M = mass_of_plates(32.3, 32.3 + shift, 0, 32.21);
        return M(1, 1) - 2 * M(1, 4) + M(4, 4);
    };
    const double aligned = opening(0);
    EXPECT_NEAR(opening(0.1) / aligned, 1.0000, 0.002);
    EXPECT_NEAR(opening(0.25) / aligned, 0.9931, 0.002);
    EXPECT_NEAR(opening(0.5) / aligned, 0.9725, 0.008);
}

/// Of a wedge of 20 degrees, 6.6 cells high and 8 wide, that moves out of a slot of the same angle between two boxes, 0.001 cells beside them.
double mass_out_of_a_slot(const Rotation<3>& turn)
{
    const Grid<3> grid = unit_grid<3>(24);
    const double dx = grid.dx(), high = 6.6, half = 10 * std::numbers::pi / 180, wide = high * std::tan(half), gap = 0.001,
                 thick = 2;
    const Vec<3> centre(12.21, 11.83, 12.37);
    SurfaceMesh<3> prism;
    for (const double z : {-4.0, 4.0})
        for (const Vec<2>& x : {Vec<2>(0, -high / 2), Vec<2>(wide, high / 2), Vec<2>(-wide, high / 2)})
            prism.vertices.push_back(dx * Vec<3>(x[0], x[1], z));
    prism.elements = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    prism.patch = {0, 1, 2, 2, 3, 3, 4, 4};
    Scene<3> scene(grid);
    Pose<3> at = pose<3>(dx * centre);
    at.rotation = turn;
    scene.add("wedge", make_mesh<3>(prism, "wedge"), at);
    scene.solids.back().motion = Motion::free;
    for (const int side : {-1, 1}) { // each along one side of the wedge; below the tip they overlap
        const Vec<3> along(side * std::sin(half), std::cos(half), 0), out(side * std::cos(half), -std::sin(half), 0);
        at = pose<3>(Vec<3>(dx * (centre + turn * Vec<3>(Vec<3>(0, -high / 2, 0) + 1.5 * along + (gap + thick / 2) * out))));
        at.rotation = turn * Rotation<3>(Eigen::AngleAxisd(0.5 * std::numbers::pi - side * half, Vec<3>(0, 0, 1)));
        scene.add("wall", make_box<3>(dx * Vec<3>(11, thick, 8)), at);
    }
    const Vec<3> way = turn * Vec<3>(0, 1, 0);
    return way.dot(mass_on_parts(grid, scene.solids).topLeftCorner<3, 3>() * way);
}

// The gap ends at the wedge's tip. Where this is askew to the grid nodes lie at many distances from it; flow along it has all of its way all the same.
TEST(Mouths, OfEdgesAskewToTheGridHoldTheFlowAlongThem)
{
    const double straight = mass_out_of_a_slot(Rotation<3>::Identity());
    for (const double angle : {40.0, 65.0}) {
        const Rotation<3> turn(Eigen::AngleAxisd(angle * std::numbers::pi / 180, Vec<3>(1, 2, -1).normalized()));
        EXPECT_NEAR(mass_out_of_a_slot(turn) / straight, 1, 0.05) << angle; // 0.8 without
    }
}

} // namespace
} // namespace gapflow::testing
