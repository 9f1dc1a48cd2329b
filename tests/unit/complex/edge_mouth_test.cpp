// Mouths of gaps at sharp edges near other walls, in 3D: where the dividing planes lead, and what flows through them.
#include "checks.hpp"

#include "gapflow/complex/inertia.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace gapflow::testing {
namespace {

constexpr int cells = 16;

/// Two boxes of 6 x 5 x 3 cells across a gap; or both as meshes.
void add_boxes(Scene<3>& scene, double gap, const Rotation<3>& turn, const Vec<3>& middle,
               const Vec<2>& offset = Vec<2>::Zero(), bool meshes = false)
{
    for (const int side : {1, -1}) {
        const Vec<3> x(side * 0.5 * offset[0], side * 0.5 * offset[1], side * 0.5 * (gap + 3));
        Pose<3> at = pose<3>(Vec<3>((middle + turn * x) / cells));
        at.rotation = turn;
        std::unique_ptr<Shape<3>> box = make_box<3>(Vec<3>(6, 5, 3) / cells);
        scene.add("box", meshes ? make_mesh<3>(box->display_mesh(0), "box") : std::move(box), at);
    }
}
Rotation<3> turned(const Vec<3>& axis, double angle)
{
    return Rotation<3>(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// Of the links' planes.
double area_of_mouths(const Complex<3>& complex)
{
    double area = 0;
    for (const CornerLink<3>& link : complex.links)
        area += link.mouth >= 0 ? link.open : 0.0;
    return area;
}

TEST(EdgeMouths, GoOnceAroundAGap)
{
    const Grid<3> grid = unit_grid<3>(cells);
    for (const double gap : {0.5, 0.2, 1e-3})
        for (const auto& turn :
             {turned({1, 0, 0}, 0), turned({0, 0, 1}, 0.3), turned({1, 2, -1}, 0.5), turned({1, 1, 0.3}, 1.1)}) {
            Scene<3> scene(grid);
            add_boxes(scene, gap, turn, {8.31, 7.83, 8.12});
            const Complex<3> complex = build_complex<3>(grid, scene.solids);
            EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12);
            double area = 0;
            for (const CornerLink<3>& link : complex.links)
                if (link.mouth >= 0) {
                    const GapMouth<3>& mouth = complex.mouths[link.mouth];
                    area += link.open;
                    EXPECT_NEAR((mouth.end - mouth.at).norm(), gap, 1e-9);
                    EXPECT_NEAR(mouth.sides[0].gap + mouth.sides[1].gap, 1, 1e-12); // inside, outside
                }
            EXPECT_NEAR(area, 22 * gap, 0.002 * 22 * gap); // but for what is too small to be a part
        }
}

// Of a mesh that is not convex the way from an edge might lead through itself.
TEST(EdgeMouths, OfMeshesThatAreConvex)
{
    const Grid<3> grid = unit_grid<3>(cells);
    const auto area_of = [&](const Scene<3>& scene) {
        double area = 0;
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        for (const CornerLink<3>& link : complex.links)
            area += link.mouth >= 0 ? link.open : 0.0;
        return area;
    };
    for (const auto& turn : {turned({1, 2, -1}, 0.5), turned({1, 1, 0.3}, 1.1)}) {
        Scene<3> scene(grid);
        add_boxes(scene, 0.2, turn, {8.31, 7.83, 8.12}, {0, 0}, true);
        EXPECT_NEAR(area_of(scene), 22 * 0.2, 0.002 * 22 * 0.2);
    }
    SurfaceMesh<3> two = make_box<3>(Vec<3>(6, 5, 1) / cells)->display_mesh(0);
    const int vertices = static_cast<int>(two.vertices.size());
    for (const std::array<int, 3>& e : std::vector(two.elements))
        two.elements.push_back({e[0] + vertices, e[1] + vertices, e[2] + vertices});
    for (const Vec<3>& x : std::vector(two.vertices))
        two.vertices.push_back(x + Vec<3>(0, 0, 1.2 / cells));
    two.patch.assign(two.elements.size(), 0);
    Scene<3> scene(grid);
    scene.add("two plates", make_mesh<3>(two, "two plates"), pose<3>(Vec<3>(Vec<3>(8.31, 7.83, 8.12) / cells)));
    EXPECT_EQ(area_of(scene), 0);
}

// The way back from an edge to the one across is another one where they are inclined to each other: it is one mouth all the same.
TEST(EdgeMouths, OfEdgesInclinedALittle)
{
    const Grid<3> grid = unit_grid<3>(cells);
    for (const Vec<3>& axis : {Vec<3>(1, 0, 0), Vec<3>(0, 1, 0)}) {
        Scene<3> scene(grid);
        for (const int side : {1, -1}) {
            Pose<3> at = pose<3>(Vec<3>(Vec<3>(8.31, 7.83, 8.12 + side * 1.6) / cells));
            if (side > 0)
                at.rotation = turned(axis, 1e-6);
            scene.add("box", make_box<3>(Vec<3>(6, 5, 3) / cells), at);
        }
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        EXPECT_NEAR(area_of_mouths(complex), 22 * 0.2, 0.002 * 22 * 0.2) << axis.transpose();
    }
}

// Where a gap widens towards its end each of the two edges there may lie in front of the other body's face: their ways cross.
TEST(EdgeMouths, OfEdgesInFrontOfEachOthersFaces)
{
    const Grid<3> grid = unit_grid<3>(cells);
    for (const double angle : {1e-3, 1e-2}) {
        const double inside = 0.5 * 0.2 * angle; // of the upper edge; the foot of the lower one is 0.2 angle inside
        Scene<3> scene(grid);
        for (const int side : {1, -1}) {
            Pose<3> at =
                pose<3>(Vec<3>(Vec<3>(8.31 + (side > 0 ? 1.5 * angle + inside : 0.0), 7.83, 8.12 + side * 1.6) / cells));
            if (side > 0)
                at.rotation = turned({0, 1, 0}, angle);
            scene.add("box", make_box<3>(Vec<3>(6, 5, 3) / cells), at);
        }
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12);
        EXPECT_NEAR(area_of_mouths(complex), 22 * 0.2, 0.01 * 22 * 0.2) << angle;
    }
}

// Edges of which each lies over the other body's face on one side of their crossing: the mouth goes over from one to the other.
TEST(EdgeMouths, OfEdgesThatCross)
{
    const Grid<3> grid = unit_grid<3>(cells);
    for (const double angle : {1e-7, 1e-5, 1e-3}) {
        Scene<3> scene(grid);
        for (const int side : {1, -1}) {
            Pose<3> at = pose<3>(Vec<3>(Vec<3>(8.31, 7.83, 8.12 + side * 1.6) / cells));
            if (side > 0)
                at.rotation = turned({0, 0, 1}, angle);
            scene.add("box", make_box<3>(Vec<3>(6, 5, 3) / cells), at);
        }
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12);
        EXPECT_NEAR(area_of_mouths(complex), 22 * 0.2, 0.002 * 22 * 0.2) << angle;
    }
}

// A face of a gap whose neighbours lend and take in several directions: it would have a negative weight, and the system no solution.
TEST(EdgeMouths, LeaveWeightsPositive)
{
    const Grid<3> grid = unit_grid<3>(36);
    Scene<3> scene(grid);
    const Rotation<3> turn(
        Eigen::Quaterniond(0.9999997231221133, 0.000537435886363695, -0.0001095487839814736, -0.0005029089666439655)
            .normalized());
    for (const Vec<3>& x : {Vec<3>(1.4672968771452815, 1.5053392416777391, 1.6445972553611163),
                            Vec<3>(1.4673561794241685, 1.505629427225766, 1.374597417813781)}) {
        Pose<3> at = pose<3>(Vec<3>(x / 3));
        at.rotation = turn;
        scene.add("plate", make_box<3>(Vec<3>(12, 12, 3) / 36), at);
    }
    const std::span<const Solid<3>> solids = scene.solids;
    const Complex<3> complex = build_complex<3>(grid, solids);
    const Inertia<3> inertia =
        find_inertia<3>(grid, complex, find_gap_arms<3>(grid, solids, complex), find_mouth_arms<3>(grid, solids, complex));
    for (std::size_t k = 0; k < complex.pieces.size(); ++k)
        EXPECT_GE(inertia.piece_weight[k], 0) << k;
}

TEST(EdgeMouths, InPlanesOfTheGrid)
{
    const Grid<3> grid = unit_grid<3>(cells);
    Scene<3> scene(grid);
    add_boxes(scene, 0.25, turned({1, 0, 0}, 0), {8, 7.5, 7.8}); // sides at 5, 11 and 5, 10
    const Complex<3> complex = build_complex<3>(grid, scene.solids);
    double area = 0;
    for (const GapMouth<3>& mouth : complex.mouths) {
        EXPECT_GE(mouth.axis, 0);
        EXPECT_GE(mouth.piece, 0);
        area += mouth.area;
    }
    EXPECT_NEAR(area, 22 * 0.25, 1e-9);
    EXPECT_EQ(find_mouth_arms<3>(grid, scene.solids, complex).size(), 22U);
}

TEST(EdgeMouths, WhatLeavesArrives)
{
    const Grid<3> grid = unit_grid<3>(cells);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(0, 1);
    const auto vector = [&] { return Vec<3>(number(random) - 0.5, number(random) - 0.5, number(random) - 0.5); };
    int arms = 0;
    for (int k = 0; k < 12; ++k) {
        Scene<3> scene(grid);
        add_boxes(scene, std::pow(10, -6 * number(random)), turned(vector(), 6.28 * number(random)), Vec<3>(8, 8, 8) + vector(),
                  {4 * number(random) - 2, 4 * number(random) - 2});
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12) << k;
        for (const MouthArm<3>& arm : find_mouth_arms<3>(grid, scene.solids, complex)) {
            ++arms;
            double out = 0, in = 0;
            for (const auto& [row, weight] : arm.rows)
                (weight > 0 ? out : in) += weight;
            EXPECT_TRUE(std::isfinite(arm.resistance) && arm.resistance > 0) << k;
            EXPECT_NEAR(out + in, 0, 1e-12) << k;
            EXPECT_LE(out, 1 + 1e-12) << k;
            EXPECT_TRUE(arm.flux.allFinite() && arm.mass.allFinite()) << k;
        }
    }
    EXPECT_GT(arms, 200);
}

} // namespace
} // namespace gapflow::testing
