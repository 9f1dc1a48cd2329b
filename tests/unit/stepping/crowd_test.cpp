// Balls packed so closely that films are everywhere and hardly anything joins some pores to the rest.
#include "gapflow/stepping/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gapflow {
namespace {

/// n^3 balls of 8 cells diameter near the points of a lattice, 0 to 0.6 cells between neighbours.
Scene crowd(int n)
{
    constexpr double spacing = 8.3;
    const int cells = static_cast<int>(std::ceil(spacing * n));
    Scene scene;
    scene.dimension = 3;
    scene.size = Triple{1.0 * cells, 1.0 * cells, 1.0 * cells};
    scene.cells = {cells, cells, cells};
    scene.gravity = {0, 0, -1};
    scene.end = 1;
    scene.max_step = 0.01;
    for (int k = 0; k < n * n * n; ++k) {
        BodyScene body;
        body.name = "ball" + std::to_string(k);
        body.shape = BodyScene::ShapeKind::ball;
        body.radius = 4;
        const std::array<int, 3> place{k % n, k / n % n, k / n / n};
        for (int axis = 0; axis < 3; ++axis) {
            const double golden = 0.6180339887498949 * (3 * k + axis + 1);
            body.position[axis] = spacing * (place[axis] + 0.5) + 0.15 * (2 * (golden - std::floor(golden)) - 1);
        }
        body.density = 2;
        scene.bodies.push_back(body);
    }
    return scene;
}

TEST(Crowd, IterationsStayBounded)
{
    Simulation<3> simulation(crowd(3), Communicator());
    EXPECT_GT(simulation.initial_report().film_nodes, 1000);
    EXPECT_LE(simulation.step(1).iterations, 18); // 14, and 28 where multigrid takes pores for open to the films beside them
}

} // namespace
} // namespace gapflow
