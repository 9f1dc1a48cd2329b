// Mouths between two corners: nothing depends on which of the two is a little ahead, and little changes as one wall goes on.
#include "two_boxes.hpp"

#include <gtest/gtest.h>

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

} // namespace
} // namespace gapflow::testing
