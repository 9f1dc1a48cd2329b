// An inflow that changes in time: every step ends with the flow of its end.
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

template <int D>
void check_inflow()
{
    Scene scene;
    scene.dimension = D;
    scene.size = {2, 1, D == 2 ? 0.0 : 1.0};
    scene.cells = {24, 12, D == 2 ? 1 : 12};
    SideScene inflow;
    inflow.kind = SideScene::Kind::inflow;
    inflow.table.time = {0, 1};
    inflow.table.rows = {std::vector<double>(D, 0.0), std::vector<double>(D, 0.0)};
    inflow.table.rows[1][0] = 1;
    scene.sides[0] = inflow;
    scene.sides[1].kind = SideScene::Kind::open;
    BodyScene ball;
    ball.name = "ball";
    ball.shape = BodyScene::ShapeKind::ball;
    ball.radius = 0.21;
    ball.position = {0.8, 0.45, D == 2 ? 0.0 : 0.5};
    ball.motion = BodyScene::Motion::fixed;
    scene.bodies = {ball};
    scene.end = 0.3;
    scene.max_step = 0.1;
    Simulation<D> simulation(scene, Communicator());
    while (simulation.time() < scene.end) {
        const StepReport report = simulation.step(scene.end);
        EXPECT_LT(report.divergence_max, 1e-7);
        EXPECT_NEAR(simulation.velocity().grid(0, Index<D>::Zero()), simulation.time(), 1e-12);
    }
}

TEST(Inflow, EveryStepEndsWithItsOwnInflow2D)
{
    check_inflow<2>();
}

TEST(Inflow, EveryStepEndsWithItsOwnInflow3D)
{
    check_inflow<3>();
}

} // namespace
} // namespace gapflow
