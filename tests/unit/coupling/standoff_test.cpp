// Roughness as a distance between surfaces: gaps of walls that are nearer are those of walls at that distance.
#include "direct_mass.hpp"
#include "parts_energy.hpp"
#include "world.hpp"

#include "gapflow/stepping/standoff.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapflow {
namespace {

Scene two_boxes(double gap, double roughness, double degrees, bool parts)
{
    Scene scene;
    scene.dimension = 2;
    scene.parts = parts;
    scene.density = 1;
    scene.size = {24, 24, 0};
    scene.cells = {24, 24, 1};
    scene.gap.roughness = roughness;
    const double a = degrees * M_PI / 180;
    for (const double side : {-1.0, 1.0}) {
        BodyScene box;
        box.name = side < 0 ? "lower" : "upper";
        box.shape = BodyScene::ShapeKind::box;
        box.size = {10, 4, 0};
        box.angle = a;
        const double up = side * (2 + 0.5 * gap);
        box.position = {12.31 - up * std::sin(a), 12.17 + up * std::cos(a), 0};
        scene.bodies.push_back(box);
    }
    return scene;
}

double opening(const Scene& scene, double degrees)
{
    const World<2> world(scene);
    const double a = degrees * M_PI / 180;
    Eigen::VectorXd V = Eigen::VectorXd::Zero(6);
    V.segment<2>(0) = -0.5 * Vec<2>(-std::sin(a), std::cos(a));
    V.segment<2>(3) = -V.segment<2>(0);
    return V.dot(direct_added_mass(world.coupling) * V);
}

TEST(Standoff, PlatesNearerThanTheirRoughnessAreAtIt)
{
    for (const double degrees : {0.0, 25.0})
        for (const double roughness : {0.1, 0.01}) {
            const double at = opening(two_boxes(roughness, 0, degrees, true), degrees);
            for (const double share : {0.5, 0.1, 1e-4}) {
                const double near = opening(two_boxes(share * roughness, roughness, degrees, true), degrees);
                EXPECT_NEAR(near / at, 1, 0.02) << degrees << ' ' << roughness << ' ' << share;
            }
            EXPECT_GT(opening(two_boxes(0.1 * roughness, 0, degrees, true), degrees), 3 * at);
            EXPECT_EQ(opening(two_boxes(1.01 * roughness, roughness, degrees, true), degrees),
                      opening(two_boxes(1.01 * roughness, 0, degrees, true), degrees));
        }
}

TEST(Standoff, AsFilmsHaveIt)
{
    for (const double share : {0.5, 0.1}) {
        const double parts = opening(two_boxes(share * 0.05, 0.05, 0, true), 0),
                     films = opening(two_boxes(share * 0.05, 0.05, 0, false), 0);
        EXPECT_NEAR(parts / films, 1, 0.03) << share;
    }
}

Scene wheel_on_the_ground(double distance, double roughness, double x)
{
    Scene scene;
    scene.dimension = 2;
    scene.parts = true;
    scene.density = 1;
    scene.size = {32, 16, 0};
    scene.cells = {32, 16, 1};
    scene.sides[3].kind = SideScene::Kind::open;
    scene.gap.roughness = roughness;
    BodyScene wheel;
    wheel.name = "wheel";
    wheel.shape = BodyScene::ShapeKind::ball;
    wheel.radius = 5;
    wheel.position = {x, 5 + distance, 0};
    scene.bodies.push_back(wheel);
    return scene;
}

TEST(Standoff, AWheelThatTouchesTheGroundIsAtItsRoughness)
{
    for (const double x : {16.0, 16.31, 16.5}) // on a plane of the grid, between two
        for (const double roughness : {0.1, 1e-2, 1e-4}) {
            const World<2> at(wheel_on_the_ground(roughness, 0, x)), touching(wheel_on_the_ground(0, roughness, x));
            const Eigen::MatrixXd exact = direct_added_mass(at.coupling), mass = direct_added_mass(touching.coupling);
            for (const int c : {0, 1})
                EXPECT_NEAR(mass(c, c) / exact(c, c), 1, roughness < 0.1 ? 2e-3 : 0.02) << x << ' ' << roughness << ' ' << c;
        }
}

TEST(Standoff, ABoxThatLiesOnTheGroundIsAtItsRoughness)
{
    const auto lying = [](double distance, double roughness) {
        Scene scene = wheel_on_the_ground(distance, roughness, 16.3);
        BodyScene& box = scene.bodies[0];
        box.shape = BodyScene::ShapeKind::box;
        box.size = {10, 4, 0};
        box.position = {16.3, 2 + distance, 0};
        return World<2>(scene);
    };
    for (const double roughness : {0.1, 1e-2, 1e-4}) {
        const Eigen::MatrixXd exact = direct_added_mass(lying(roughness, 0).coupling),
                              mass = direct_added_mass(lying(0, roughness).coupling);
        for (const int c : {0, 1})
            EXPECT_NEAR(mass(c, c) / exact(c, c), 1, 0.025) << roughness << ' ' << c;
    }
}

/// Added mass across the gap of the uppermost of five boxes, the four below at the distance `lower` from each other.
double mass_over_a_column(double lower, double upper, double roughness)
{
    Scene scene = two_boxes(0, roughness, 0, true);
    scene.bodies.resize(1);
    scene.bodies[0].size = {10, 3, 0};
    scene.bodies[0].position = {12.31, 2.67, 0};
    for (int k = 1; k < 5; ++k) {
        BodyScene box = scene.bodies.back();
        box.name = "box" + std::to_string(k);
        box.position[1] += 3 + (k == 4 ? upper : lower);
        scene.bodies.push_back(box);
    }
    return direct_added_mass(World<2>(scene).coupling)(13, 13);
}

TEST(Standoff, WhatIsMovedApartMeetsNoOther)
{
    const double roughness = 0.01;
    for (const double upper : {0.1, 0.21, 0.3, 0.6, 0.99})
        EXPECT_NEAR(mass_over_a_column(0, upper * roughness, roughness) / mass_over_a_column(roughness, roughness, 0), 1, 0.02)
            << upper;
    EXPECT_NEAR(mass_over_a_column(-0.5 * roughness, 1.05 * roughness, roughness) /
                    mass_over_a_column(roughness, 1.05 * roughness, 0),
                1, 0.02);
}

/// What pairs of solids lack that have a roughness of `cells`.
template <int D>
std::function<Standoffs<D>(const std::vector<Solid<D>>&)> rough(const Grid<D>& grid, double cells)
{
    Scene scene;
    scene.gap.roughness = cells * grid.dx();
    return [&grid, scene](const std::vector<Solid<D>>& solids) { return rough_solids<D>(scene, grid, solids).standoffs; };
}

template <int D>
void check_derivative(testing::Scene<D>& scene, const Grid<D>& grid, double roughness)
{
    std::vector<Twist<D>> twists(scene.solids.size(), Twist<D>::Zero());
    std::mt19937 random(7);
    for (std::size_t s = 0; s < twists.size(); ++s) {
        if (scene.solids[s].wall)
            continue;
        scene.solids[s].motion = Motion::prescribed;
        for (double& v : twists[s])
            v = std::uniform_real_distribution<double>(-1, 1)(random);
    }
    const testing::PoseError without = testing::compare<D>(grid, scene.solids, twists),
                             with = testing::compare<D>(grid, scene.solids, twists, rough<D>(grid, roughness));
    EXPECT_LT(without.error, 1e-5) << without.solid << ' ' << without.component;
    EXPECT_LT(with.error, 1e-5) << with.solid << ' ' << with.component;
}

template <int D>
void check_derivatives()
{
    const Grid<D> grid = testing::unit_grid<D>(D == 3 ? 8 : 16, testing::all_sides<D>(SideKind::open));
    const double cell = grid.dx();
    Pose<D> first = testing::pose<D>(Vec<D>::Constant(0.41), 0.37);
    first.position[1] += 0.013;
    const Vec<D> way = first.rotation * unit<D>(0), aside = first.rotation * unit<D>(1);
    for (const double gap : {0.1, 0.2}) { // nearer ones are moved apart
        testing::Scene<D> balls(grid), over(grid);
        balls.add("a", make_ball<D>(0.17), first);
        balls.add("b", make_ball<D>(0.13), testing::pose<D>(first.position + (0.3 + gap * cell) * way));
        check_derivative<D>(balls, grid, 0.3);
        over.add("box", make_box<D>(Vec<D>::Constant(0.3)), first);
        over.add("ball", make_ball<D>(0.13), testing::pose<D>(first.position + (0.28 + gap * cell) * way + 0.03 * aside));
        check_derivative<D>(over, grid, 0.3);
    }
}

TEST(Standoff, EnergyDerivativesKnowIt)
{
    check_derivatives<2>();
    check_derivatives<3>();
}

} // namespace
} // namespace gapflow
