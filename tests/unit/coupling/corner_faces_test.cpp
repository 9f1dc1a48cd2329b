// What the singular flow around corners adds: the closed form, and added masses of bodies whose corners lie anywhere on the grid.
#include "parts_energy.hpp"

#include "gapflow/complex/corner_faces.hpp"

#include <gtest/gtest.h>

namespace gapflow::testing {
namespace {

TEST(CornerFaces, GainIsThatOfTheSingularFieldWhateverTheFacesDirection)
{
    for (const double angle : {0.0, 0.3, 0.5, 0.8, 1.0}) { // over pi
        const double nu = 1 / (2 - angle);
        const auto phi = [&](double x, double y, double turn) {
            return std::pow(std::hypot(x, y), nu) * std::cos(nu * (std::atan2(y, x) + turn));
        };
        for (const double theta : {0.3, 1.1, 2.0}) { // of the face, from a wall
            const double flux = std::sin(nu * theta), difference = phi(0.5, -0.5, theta) - phi(0.5, 0.5, theta);
            EXPECT_NEAR(flux / difference, 1 + corner_gain(angle * std::numbers::pi), 1e-12);
        }
    }
    EXPECT_NEAR(corner_gain(std::numbers::pi), 0, 1e-14);
}

/// 2 T over the density of unit twists of a box in a closed box of 64 x 64 cells, in cells.
std::array<double, 3> masses(const Vec<2>& size, const Vec<2>& at, double angle = 0)
{
    const int n = 64;
    const Grid<2> grid = unit_grid<2>(n);
    Scene<2> scene(grid);
    scene.add("box", make_box<2>(size / n), pose<2>(at / n, angle));
    std::array<double, 3> masses;
    for (int c = 0; c < 3; ++c) {
        Twist<2> twist = Twist<2>::Zero();
        twist[c] = 1;
        masses[c] = 2 *
                    PartsEnergy<2>(grid, scene.solids,
                                   {Twist<2>::Zero(), Twist<2>::Zero(), Twist<2>::Zero(), Twist<2>::Zero(), twist}, false)
                        .energy /
                    1.3 * std::pow(n, c < 2 ? 2 : 4);
    }
    return masses;
}

// Exact: a five-point grid of 64, 128 and 256 cells, extrapolated with the order 4/3 of its right corners.
TEST(CornerFaces, AddedMassOfABoxWhereverItsCornersLie)
{
    const std::array<double, 3> exact{91.403, 297.129, 1894.0};
    for (const Vec<2>& shift :
         {Vec<2>(0, 0), Vec<2>(0.5, 0), Vec<2>(0, 0.5), Vec<2>(0.1, 0.1), Vec<2>(0.3, 0.1), Vec<2>(0.8, 0.6)}) {
        const std::array<double, 3> found = masses({16, 8}, Vec<2>(32, 32) + shift);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c] / exact[c], 1, c < 2 ? 0.006 : 0.03) << shift.transpose() << ", component " << c;
    }
}

TEST(CornerFaces, AddedMassOfAPlateWhoseEndsLieAtPlanesOfTheGrid)
{
    for (const double thickness : {0.01, 0.5, 1.0}) {
        const double fine = masses({16, thickness}, Vec<2>(32.31, 32.47))[1];
        for (const double y : {0.0, 0.4}) {
            const std::array<double, 3> found = masses({16, thickness}, Vec<2>(32, 32 - 0.5 * thickness + y));
            EXPECT_NEAR(found[1] / fine, 1, 0.025) << thickness << ", " << y; // 0.05 to 0.1 without
            EXPECT_GT(found[0], 0);
        }
    }
}

/// Exact by symmetry: the flow past a long prism's edges is that in the plane.
TEST(CornerFaces, EdgesInSpaceAreCornersInThePlane)
{
    const int n = 16;
    const Grid<2> plane = unit_grid<2>(n);
    const Grid<3> space = unit_grid<3>(n);
    for (const Vec<2>& at : {Vec<2>(8, 8), Vec<2>(8.3, 8.1)}) {
        Scene<2> flat(plane);
        flat.add("box", make_box<2>(Vec<2>(4, 2) / n), pose<2>(at / n));
        Scene<3> prism(space);
        prism.add("box", make_box<3>(Vec<3>(4.0 / n, 2.0 / n, 3)), pose<3>(Vec<3>(at[0] / n, at[1] / n, 0.5)));
        std::vector<Twist<2>> flat_twists(flat.solids.size(), Twist<2>::Zero());
        std::vector<Twist<3>> twists(prism.solids.size(), Twist<3>::Zero());
        flat_twists.back()[1] = twists.back()[1] = 1;
        const double in_plane = PartsEnergy<2>(plane, flat.solids, flat_twists, false).energy,
                     in_space = PartsEnergy<3>(space, prism.solids, twists, false).energy;
        EXPECT_NEAR(in_space / in_plane, 1, 0.01);
    }
}

} // namespace
} // namespace gapflow::testing
