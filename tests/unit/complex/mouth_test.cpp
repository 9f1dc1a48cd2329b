// Mouths of gaps at sharp corners near other walls, in 2D: the outlet's resistance, and how they divide cells.
#include "checks.hpp"

#include "gapflow/complex/inertia.hpp"
#include "gapflow/complex/mouth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace gapflow::testing {
namespace {

constexpr double pi = std::numbers::pi;

/// Two boxes of 6 x 3 cells across a gap.
void add_boxes(Scene<2>& scene, double gap, double angle, const Vec<2>& middle, double offset = 0)
{
    for (const int side : {1, -1}) {
        const Vec<2> x(side * 0.5 * offset, side * 0.5 * (gap + 3));
        scene.add("box", make_box<2>(Vec<2>(6, 3) / 16), pose<2>(Vec<2>((middle + Rotation<2>(angle) * x) / 16), angle));
    }
}

std::unique_ptr<Shape<2>> triangle(const std::vector<Vec<2>>& corners)
{
    SurfaceMesh<2> mesh;
    mesh.vertices = corners;
    mesh.elements = {{0, 1}, {1, 2}, {2, 0}};
    mesh.patch.assign(3, 0);
    return make_mesh<2>(mesh, "triangle");
}

double sum_of(const MouthArm<2>& arm, bool positive)
{
    double sum = 0;
    for (const auto& [row, weight] : arm.rows)
        sum += positive == (weight > 0) ? weight : 0;
    return sum;
}

TEST(Mouths, OutletOfAThinChannel)
{
    // One wall goes on, or both turn by a right angle: the conformal maps of the two.
    for (const double h : {1e-2, 1e-6}) {
        EXPECT_NEAR(outlet_resistance(h, {pi / 2, 0}, 1), 2 / pi * (std::log(pi / (4 * h)) + 0.75), 0.04);
        EXPECT_NEAR(outlet_resistance(h, {pi / 2, pi / 2}, 1), 1 / pi * (std::log(pi / (2 * h)) + 0.75), 0.02);
        EXPECT_DOUBLE_EQ(outlet_resistance(h, {pi / 2, pi / 4}, 1), outlet_resistance(h, {pi / 4, pi / 2}, 1));
    }
}

TEST(Mouths, TwoCornersAreOneMouth)
{
    const Grid<2> grid = unit_grid<2>(16);
    for (const double angle : {0.0, 0.3, pi / 4, 1.2}) {
        Scene<2> scene(grid);
        add_boxes(scene, 0.2, angle, {8.3, 7.8});
        const Complex<2> complex = build_complex<2>(grid, scene.solids);
        ASSERT_EQ(complex.mouths.size(), 2U) << angle;
        EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12);
        std::array<double, 2> open{};
        for (const CornerLink<2>& link : complex.links)
            if (link.mouth >= 0)
                open[link.mouth] += link.open;
        for (int m = 0; m < 2; ++m) {
            EXPECT_NEAR(open[m], 0.2, 1e-9) << angle;
            EXPECT_NEAR((complex.mouths[m].end - complex.mouths[m].at).norm(), 0.2, 1e-9);
            EXPECT_NEAR(complex.mouths[m].sides[0].gap + complex.mouths[m].sides[1].gap, 1, 1e-12); // inside, outside
        }
    }
}

TEST(Mouths, OfAcuteCornersAndThinPlates)
{
    // Whatever lies behind the corner: on one side a gap, on the other fluid into which two walls turn away.
    const Grid<2> grid = unit_grid<2>(16);
    for (const double angle : {pi / 9, pi / 4, 0.0}) {
        const double thick = angle > 0 ? 6 * std::sin(angle) : 0.1; // of a triangle; of a plate
        Scene<2> scene(grid);
        scene.add("floor", make_box<2>(Vec<2>(12, 2) / 16), pose<2>(Vec<2>(8.03, 5.7) / 16, 0));
        if (angle > 0)
            scene.add("triangle", triangle({Vec<2>(0, 0), Vec<2>(6, 0) / 16, Vec<2>(6 * std::cos(angle), thick) / 16}),
                      pose<2>(Vec<2>(5.3, 6.9) / 16, 0));
        else
            scene.add("plate", make_box<2>(Vec<2>(6, thick) / 16), pose<2>(Vec<2>(8.3, 6.9 + 0.5 * thick) / 16, 0));
        const Complex<2> complex = build_complex<2>(grid, scene.solids);
        int mouths = 0;
        for (const GapMouth<2>& mouth : complex.mouths)
            if (std::abs(mouth.at[0] - 5.3) < 1e-6) {
                ++mouths;
                const int out = mouth.sides[0].gap < mouth.sides[1].gap ? 0 : 1;
                EXPECT_DOUBLE_EQ(mouth.sides[1 - out].gap, 1) << angle;
                EXPECT_LT(mouth.sides[out].gap, 1e-12) << angle;
                // The floor goes on: a turn by the angle outside the corner.
                EXPECT_NEAR(mouth.sides[out].angle, angle > 0 ? pi - angle : pi / 2 + std::asin(0.9), 1e-5) << angle;
                EXPECT_NEAR(mouth.sides[out].apex, 1, 1e-6) << angle;
            }
        EXPECT_EQ(mouths, 1) << angle;
    }
}

TEST(Mouths, InAPlaneOfTheGrid)
{
    const Grid<2> grid = unit_grid<2>(16);
    Scene<2> scene(grid);
    add_boxes(scene, 0.25, 0, {8, 7.8}); // sides at 5 and 11
    const Complex<2> complex = build_complex<2>(grid, scene.solids);
    ASSERT_EQ(complex.mouths.size(), 2U);
    for (const GapMouth<2>& mouth : complex.mouths)
        EXPECT_EQ(mouth.axis, 0);
    const std::vector<MouthArm<2>> arms = find_mouth_arms<2>(grid, scene.solids, complex);
    ASSERT_EQ(arms.size(), 2U);
    // As beside it.
    Scene<2> beside(grid);
    add_boxes(beside, 0.25, 0, {8 + 1e-4, 7.8});
    const std::vector<MouthArm<2>> there = find_mouth_arms<2>(grid, beside.solids, build_complex<2>(grid, beside.solids));
    ASSERT_EQ(there.size(), 2U);
    const auto most = [](const std::vector<MouthArm<2>>& of) { return std::max(of[0].resistance, of[1].resistance); };
    EXPECT_NEAR(most(arms), most(there), 1e-3 * most(there)); // that which leads inside from the plane
}

TEST(Mouths, WhatLeavesArrives)
{
    const Grid<2> grid = unit_grid<2>(16);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(0, 1);
    int arms = 0;
    for (int k = 0; k < 300; ++k) {
        Scene<2> scene(grid);
        add_boxes(scene, std::pow(10, -6 * number(random)), 6.28 * number(random),
                  {7 + 2 * number(random), 7 + 2 * number(random)}, 4 * number(random) - 2);
        const Complex<2> complex = build_complex<2>(grid, scene.solids);
        EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12) << k;
        for (const MouthArm<2>& arm : find_mouth_arms<2>(grid, scene.solids, complex)) {
            ++arms;
            EXPECT_TRUE(std::isfinite(arm.resistance) && arm.resistance > 0) << k;
            EXPECT_NEAR(sum_of(arm, true) + sum_of(arm, false), 0, 1e-12) << k;
            EXPECT_LE(sum_of(arm, true), 1 + 1e-12) << k;
            EXPECT_TRUE(arm.flux.allFinite() && arm.mass.allFinite()) << k;
        }
    }
    EXPECT_GT(arms, 600);
}

} // namespace
} // namespace gapflow::testing
