// Sides of boxes in planes of the grid to round-off, and mouths between two corners: the added mass is that of the sides in the planes, and nothing depends on which
// of two corners is a little ahead.
#include "../grid/scenes.hpp"
#include "direct_mass.hpp"

#include "gapflow/complex/plane_poses.hpp"
#include "gapflow/coupling/parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow::testing {
namespace {

constexpr int cells = 64;

/// Two boxes of 16 x 8 cells, 0.32 cells above each other, at places along x, in cells, and turned, `towards` each other; their twists in radii of the boxes. Over the fluid's mass that one displaces.
Eigen::MatrixXd mass_of_plates(double upper, double lower, double degrees = 0, double middle = 32, double towards = 0)
{
    const Grid<2> grid = unit_grid<2>(cells);
    const double dx = grid.dx(), angle = degrees * std::numbers::pi / 180;
    Scene<2> scene(grid);
    for (const double side : {1.0, -1.0}) {
        scene.add(side > 0 ? "upper" : "lower", make_box<2>(dx * Vec<2>(16, 8)),
                  pose<2>(dx * Vec<2>(side > 0 ? upper : lower, middle + side * 4.16), angle - side * towards));
        scene.solids.back().motion = Motion::free;
    }
    put_into_planes(grid, scene.solids);
    const Complex<2> complex = build_complex<2>(grid, scene.solids);
    const Inertia<2> inertia = find_inertia<2>(grid, complex, find_gap_arms<2>(grid, scene.solids, complex),
                                               find_mouth_arms<2>(grid, scene.solids, complex));
    const std::vector<TwistMatrix<2>> mass(scene.solids.size(), TwistMatrix<2>::Identity());
    Eigen::MatrixXd M = direct_added_mass(couple_parts<2>(grid, scene.solids, mass, 1.0, complex, inertia));
    for (const int spin : {2, 5}) {
        M.row(spin) /= 8 * dx;
        M.col(spin) /= 8 * dx;
    }
    return M / (128 * dx * dx);
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    const Eigen::VectorXd scale = b.diagonal().cwiseSqrt().cwiseInverse();
    return (scale.asDiagonal() * (a - b) * scale.asDiagonal()).cwiseAbs().maxCoeff();
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

TEST(AlignedSides, HaveTheAddedMassOfThePlaneToRoundOff)
{
    const Eigen::MatrixXd M = mass_of_plates(32, 32);
    for (const double off : {1e-12, 1e-10, 1e-9, 3e-9})
        for (const auto& [upper, lower] :
             {std::pair(off, off), std::pair(off, -off), std::pair(0.0, off), std::pair(-off, 0.0)})
            EXPECT_LT(difference(mass_of_plates(32 + upper, 32 + lower), M), 1e-7) << off << ": " << upper << ' ' << lower;
    for (const double degrees : {1e-12, 1e-10, 1e-9, 1e-8})
        EXPECT_LT(difference(mass_of_plates(32, 32, degrees), M), 1e-7) << degrees;
}

TEST(Mouths, BetweenTwoCornersBelongToBothBodies)
{
    const Eigen::MatrixXd M = mass_of_plates(32.3, 32.3);
    for (const double off : {-1e-6, -1e-8, 1e-8, 1e-6})
        EXPECT_LT(difference(mass_of_plates(32.3, 32.3 + off), M), 2e-4) << off;
    // The mirror image of the upper plate's motions are the lower one's, though one of the corners is the first.
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(M(k, k), M(3 + k, 3 + k), 1e-4 * M(k, k)) << k;
}

// Each corner lies in front of the other plate's side, by less and less: the lines from both cross, and between them is nothing. Two mouths one behind the other have 7 % less
// resistance than one of two corners; a source spread over slivers made the mass of these 15 times as large.
TEST(Mouths, OfTwoCornersThatFaceEachOthersSides)
{
    const Eigen::MatrixXd M = mass_of_plates(32.3, 32.3);
    for (const double angle : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4})
        EXPECT_LT(difference(mass_of_plates(32.3 + 4 * angle, 32.3 + 4 * angle, 0, 32, angle), M), 0.08) << angle;
}

TEST(Mouths, ChangeLittleAsOneWallGoesOn)
{
    // Beyond the end of the upper plate the lower one goes on. Against eight times as many cells.
    const auto opening = [](double shift) {
        const Eigen::MatrixXd M = mass_of_plates(32.3, 32.3 + shift, 0, 32.21);
        return M(1, 1) - 2 * M(1, 4) + M(4, 4);
    };
    const double aligned = opening(0);
    EXPECT_NEAR(opening(0.1) / aligned, 0.9982, 0.005);
    EXPECT_NEAR(opening(0.25) / aligned, 0.9908, 0.005);
    EXPECT_NEAR(opening(0.5) / aligned, 0.9698, 0.005);
}

} // namespace
} // namespace gapflow::testing
