// The added mass as a flat side of a box passes a plane of the grid: what the open areas beside its corners lend changes with the corners' links.
#include "parts_energy.hpp"

#include <gtest/gtest.h>

namespace gapflow::testing {
namespace {

/// 2 T of each unit twist of a box of 10.3 x 5.3 cells whose right side (2D axis 0) or upper side (1) lies `past` a plane.
std::array<double, 3> masses(int axis, double past)
{
    const int n = 30;
    const Grid<2> grid = unit_grid<2>(n, all_sides<2>(SideKind::open));
    const Vec<2> size(10.3, 5.3);
    Vec<2> at(15.1, 15.1);
    at[axis] = 18 + 2 * (1 - axis) - 0.5 * size[axis] + past;
    Scene<2> scene(grid);
    scene.add("box", make_box<2>(size / n), pose<2>(at / n));
    std::array<double, 3> masses;
    for (int c = 0; c < 3; ++c) {
        Twist<2> twist = Twist<2>::Zero();
        twist[c] = 1;
        masses[c] = 2 * PartsEnergy<2>(grid, scene.solids, {twist}, false).energy;
    }
    return masses;
}

TEST(Lending, AddedMassIsContinuousAsASidePassesAPlane)
{
    for (const int axis : {0, 1}) {
        const std::array<double, 3> before = masses(axis, -1e-8), after = masses(axis, 1e-8);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(after[c] / before[c], 1, c < 2 ? 1e-4 : 1e-3) << "axis " << axis << ", component " << c;
    }
}

} // namespace
} // namespace gapflow::testing
