// Balls packed so closely that films are everywhere and hardly anything joins some pores to the rest.
#include "gapflow/solver/null_space.hpp"
#include "gapflow/solver/preconditioner.hpp"
#include "gapflow/solver/vectors.hpp"
#include "gapflow/step/simulation.hpp"
#include "unit/stepping/coupled_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
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
    scene.gap.threshold = 1.5;
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

// Most mouths' cells are not in the films' band: what flows through these mouths is in the residual between the films' solve and multigrid.
TEST(Crowd, PreconditionerIsSymmetricAndPositive)
{
    const CoupledSceneOf<3> balls(crowd(3));
    const CoupledSystem<3>& system = balls.coupling.system;
    const CoupledOperator<3> matrix(system);
    const FilmBand<3> band(matrix);
    std::set<long> cells; // of mouths
    for (const Link& link : system.links)
        for (const auto& entry : link.cells)
            cells.insert(entry.first);
    EXPECT_LT(2 * (band.size() - system.nodes), static_cast<int>(cells.size()));
    Preconditioner<3> preconditioner(matrix, BodyMode::never);
    const NullSpace<3> null_space(system);
    const auto sum = [&](const UnknownVector<3>& a, const UnknownVector<3>& b) {
        double result = a.nodes.dot(b.nodes);
        for_each_index<3>(balls.grid.low(), balls.grid.high(), [&](const Index<3>& c) { result += a.cells(c) * b.cells(c); });
        return result;
    };
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto some = [&] {
        UnknownVector<3> v = zero_vector(system);
        for_each_index<3>(balls.grid.low(), balls.grid.high(), [&](const Index<3>& c) {
            if (system.component(c) >= 0)
                v.cells(c) = uniform(random);
        });
        for (double& value : v.nodes)
            value = uniform(random);
        null_space.project(v);
        return v;
    };
    for (int i = 0; i < 3; ++i) {
        const UnknownVector<3> x = some(), y = some();
        UnknownVector<3> bx = zero_vector(system), by = zero_vector(system);
        preconditioner.apply(x, bx, std::sqrt(sum(x, x)));
        preconditioner.apply(y, by, std::sqrt(sum(y, y)));
        const double xx = sum(x, bx), yy = sum(y, by);
        EXPECT_GT(xx, 0);
        EXPECT_GT(yy, 0);
        EXPECT_NEAR(sum(x, by), sum(y, bx), 2e-6 * std::sqrt(xx * yy));
    }
}

} // namespace
} // namespace gapflow
