// What a scene's place and side do not change: a periodic side is no place, and a mirrored scene does the mirrored thing.
#include "gapflow/stepping/simulation.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

constexpr int cells = 24;
constexpr double dx = 1.0 / cells;

Scene periodic_scene()
{
    Scene scene;
    scene.size = {1, 1, 0};
    scene.cells = {cells, cells, 1};
    scene.sides.fill({SideScene::Kind::periodic});
    scene.tolerance = 1e-13;
    scene.end = 1;
    scene.max_step = 0.25 * dx;
    return scene;
}

BodyScene body(const std::string& name, BodyScene::ShapeKind shape, double radius, const Triple& position,
               const Triple& velocity, double density)
{
    BodyScene body;
    body.name = name;
    body.shape = shape;
    body.radius = radius;
    body.position = position;
    body.velocity = velocity;
    body.density = density;
    return body;
}

/// Twists of all bodies after a number of steps of the scene moved by whole cells along both axes.
std::vector<Twist<2>> moved_by(Scene scene, int along_x, int along_y, int steps)
{
    for (BodyScene& b : scene.bodies) {
        b.position[0] += along_x * dx;
        b.position[1] += along_y * dx;
    }
    Simulation<2> simulation(scene, Communicator());
    for (int k = 0; k < steps; ++k)
        simulation.step(scene.end);
    std::vector<Twist<2>> twists;
    for (const auto& b : simulation.bodies())
        twists.push_back(b.twist);
    return twists;
}

void expect_the_same_everywhere(const Scene& scene, int steps)
{
    const std::vector<Twist<2>> here = moved_by(scene, 0, 0, steps);
    for (int k = 1; k < cells; ++k) {
        const std::vector<Twist<2>> there = moved_by(scene, k, (5 * k) % cells, steps);
        for (std::size_t b = 0; b < here.size(); ++b)
            EXPECT_LT((there[b] - here[b]).norm(), 1e-9) << scene.bodies[b].name << " moved by " << k;
    }
}

// A capsule of four cells, whose tips a single closed face separates from the fluid behind, and a ball that drives it.
TEST(Periodic, ThinBodiesCrossTheSeam)
{
    Scene scene = periodic_scene();
    BodyScene capsule = body("capsule", BodyScene::ShapeKind::capsule, 1.1 * dx, {0.51, 0.53, 0}, {-0.2, 0.19, 0}, 0.07);
    capsule.length = 3.3 * dx;
    capsule.angle = 0.7;
    scene.bodies = {capsule, body("ball", BodyScene::ShapeKind::ball, 4.2 * dx, {0.83, 0.61, 0}, {-0.3, 0, 0}, 2)};
    expect_the_same_everywhere(scene, 8);
}

// Two balls, one above the other, that meet: fluid leaves their film to both sides.
TEST(Periodic, FilmsCrossTheSeam)
{
    Scene scene = periodic_scene();
    scene.bodies = {body("low", BodyScene::ShapeKind::ball, 4.2 * dx, {0.5, 0.25, 0}, {0, 0.5, 0}, 1.5),
                    body("high", BodyScene::ShapeKind::ball, 4.2 * dx, {0.5, 0.25 + 9.5 * dx, 0}, {0, -0.5, 0}, 1.5)};
    expect_the_same_everywhere(scene, 8);
}

// A flap that is locked between its hinge and a wall, at two corners, one of which pushes with nothing: whether that one counts as closed is round-off, and no
// impact after which the bulk's pressure starts anew. Above a ball that falls between a floor and a ceiling, with a cell in the middle between its film's mouths.
TEST(Mirrored, ALockedFlapBesideABall)
{
    const double cell = 0.00025, width = 47 * cell;
    std::array<std::vector<Twist<2>>, 2> twists;
    for (const bool mirrored : {false, true}) {
        Scene scene;
        scene.size = {width, 33 * cell, 0};
        scene.cells = {47, 33, 1};
        scene.gravity = {0, -9.81, 0};
        scene.density = 1000;
        scene.viscosity = 0.014040681349616568;
        scene.tolerance = 1e-13;
        scene.end = 1;
        scene.max_step = 0.00034736698863344106;
        const auto place = [&](double x) { return mirrored ? width - x : x; };
        BodyScene flap;
        flap.name = "flap";
        flap.shape = BodyScene::ShapeKind::box;
        flap.size = {0.0026069819164640778, 0.0008937534264539138, 0};
        flap.position = {place(0.01044650904176796), 0.0043998829796412075, 0};
        flap.density = 130.16152880405986;
        flap.hinge.emplace();
        flap.hinge->point = {place(0.009143018083535922), 0.0043998829796412075, 0};
        scene.bodies = {flap, body("ball", BodyScene::ShapeKind::ball, 0.0007627949213652477,
                                   {place(0.005875), 0.0070125000000000005, 0}, {0, 0, 0}, 2104.249797627973)};
        Simulation<2> simulation(scene, Communicator());
        for (int k = 0; k < 10; ++k)
            simulation.step(scene.end);
        for (const auto& b : simulation.bodies())
            twists[mirrored].push_back(b.twist);
    }
    const Twist<2>&here = twists[0][1], &there = twists[1][1];
    EXPECT_GT(-here[1], 1e-3);
    EXPECT_LT((here - Twist<2>(-there[0], there[1], -there[2])).norm(), 1e-9 * here.norm());
}

} // namespace
} // namespace gapflow
