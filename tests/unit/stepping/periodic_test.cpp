// A periodic side is no place: what happens at it happens elsewhere in the same way.
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
    for (SideScene& side : scene.sides)
        side.kind = SideScene::Kind::periodic;
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

} // namespace
} // namespace gapflow
