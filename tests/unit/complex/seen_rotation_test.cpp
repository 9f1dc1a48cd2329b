// What the planes of the grid miss of a turning solid: against sums over planes, its derivative, and the added mass as a wall passes a plane.
#include "../grid/scenes.hpp"

#include "gapflow/complex/seen_rotation.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace gapflow::testing {
namespace {

constexpr double dx = 1.0 / 24;

/// A solid of a shape, its places and lengths in cells.
template <int D>
struct One {
    Grid<D> grid = unit_grid<D>(24, all_sides<D>(SideKind::open));
    Scene<D> scene{grid};

    One(std::unique_ptr<Shape<D>> shape, const Vec<D>& at, double angle)
    {
        scene.add("solid", std::move(shape), pose<D>(dx * at, angle));
    }
    PlacedSolid<D> placed(int component = 0, double step = 0) const
    {
        const std::vector<Solid<D>> solids{moved(scene.solids[0], component, step, dx)};
        return place_solids<D>(grid, GridPlanes<D>(grid), solids, Vec<D>::Zero(), Vec<D>::Constant(24)).at(0);
    }
    SpinMatrix<D> seen(int component = 0, double step = 0) const
    {
        const PlacedSolid<D> at = placed(component, step);
        return seen_rotation<D>(at, at.reference);
    }
};

TEST(SeenRotation, OfABoxBetweenPlanesIsThatOfItsSections)
{
    // 6.4 x 3.7 cells about (12.3, 11.9): planes normal to y at 11, 12, 13, normal to x at 10 ... 15.
    const One<2> box(make_box<2>(dx * Vec<2>(6.4, 3.7)), {12.3, 11.9}, 0);
    // Second moments of a section of the length a, less those of its faces.
    const auto moment = [](double a) { return (a * a * a - a) / 12; };
    EXPECT_NEAR(box.seen()(0, 0), (3 - 3.7) * moment(6.4) + (6 - 6.4) * moment(3.7), 1e-8);
    // In 3D, 5 planes more normal to z: of each pair of axes.
    const One<3> block(make_box<3>(dx * Vec<3>(6.4, 3.7, 5.1)), {12.3, 11.9, 12.2}, 0);
    const SpinMatrix<3> S = block.seen();
    const Vec<3> size(6.4, 3.7, 5.1), planes(6, 3, 5);
    for (int k = 0; k < 3; ++k) {
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        double expected = 0;
        for (const auto& [d, across] : {std::pair{u, v}, {v, u}})
            expected += (planes[d] - size[d]) * size[k] * moment(size[across]);
        EXPECT_NEAR(S(k, k), expected, 1e-7) << k;
    }
}

TEST(SeenRotation, ABallThatTurnsIsNotSeen)
{
    EXPECT_EQ(One<2>(make_ball<2>(3.3 * dx), {12.3, 11.9}, 0).seen().norm(), 0);
    EXPECT_EQ(One<3>(make_ball<3>(3.3 * dx), {12.3, 11.9, 12.4}, 0).seen().norm(), 0);
}

TEST(SeenRotation, OfACapsuleIsThatOfManySegments)
{
    for (const double degrees : {0.0, 17.0, 90.0, 133.0}) {
        const double a = degrees * std::numbers::pi / 180, radius = 1.7, half = 2.6;
        const Vec<2> c(12.27, 11.81), axis(std::cos(a), std::sin(a));
        const auto place = [&](double s) { // along the outline
            const double end = s < 0.5 ? 1 : -1,
                         phi = (s < 0.5 ? 2 * s : 2 * s - 1) * std::numbers::pi - 0.5 * std::numbers::pi;
            const Vec<2> across(-axis[1], axis[0]);
            return Vec<2>(c + end * (half * axis + radius * (std::cos(phi) * axis + std::sin(phi) * across)));
        };
        double sum = 0;
        const int count = 200000;
        const auto add = [&](const Vec<2>& x, const Vec<2>& y, bool flat) {
            const int steps = 1 + static_cast<int>((y - x).norm() / 1e-4);
            const Vec<2> way = (y - x) / steps, normal(way[1], -way[0]);
            for (int k = 0; k < steps; ++k) {
                const Vec<2> at = x + (k + 0.5) * way;
                const double lever = (at - c).dot(way) / way.norm();
                for (int d = 0; d < 2; ++d) {
                    const double slope = flat ? way[1 - d] / way.norm() : 0; // of the velocity along the plane
                    sum -= (at[d] - std::floor(at[d]) - 0.5) * (lever * lever - slope * slope / 12) * normal[d];
                }
            }
        };
        for (int k = 0; k < count; ++k)
            add(place(static_cast<double>(k) / count), place(k + 1 < count ? static_cast<double>(k + 1) / count : 0.0),
                2 * (k + 1) % count == 0);
        const One<2> capsule(make_capsule<2>(radius * dx, 2 * half * dx), c, a);
        EXPECT_NEAR(capsule.seen()(0, 0), sum, 2e-3) << degrees;
    }
}

template <int D>
void rate_is_that_of_differences(const One<D>& one)
{
    const PlacedSolid<D> here = one.placed();
    const auto rate = seen_rotation_rate<D>(here, here.reference);
    const double step = 1e-4;
    for (int k = 0; k < twist_size<D>; ++k) {
        const SpinMatrix<D> difference = (one.seen(k, step) - one.seen(k, -step)) / (2 * step);
        EXPECT_LT((rate[k] - difference).norm(), 1e-4 * (1 + difference.norm())) << k;
    }
}

TEST(SeenRotation, RateIsThatOfDifferences)
{
    rate_is_that_of_differences<2>({make_box<2>(dx * Vec<2>(6.4, 3.7)), {12.3, 11.9}, 0.31});
    rate_is_that_of_differences<2>({make_capsule<2>(1.7 * dx, 5.2 * dx), {12.3, 11.9}, 0.31});
    rate_is_that_of_differences<3>({make_box<3>(dx * Vec<3>(6.4, 3.7, 5.1)), {12.3, 11.9, 12.2}, 0.43});
}

} // namespace
} // namespace gapflow::testing
