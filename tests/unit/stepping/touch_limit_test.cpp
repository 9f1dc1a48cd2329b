// The step's limit by surfaces that meet on the way: no body passes a wall or another body, however long steps are.
#include "gapflow/core/error.hpp"
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

constexpr int cells = 32;

Scene tank()
{
    Scene scene;
    scene.dimension = 2;
    scene.size = {1, 1, 0};
    scene.cells = {cells, cells, 1};
    scene.cfl = 10;
    scene.max_step = 1;
    return scene;
}

BodyScene thrown(BodyScene::ShapeKind shape, std::array<double, 3> velocity)
{
    BodyScene body;
    body.name = "b";
    body.shape = shape;
    body.radius = 0.08;
    body.size = {0.1, 0.16, 0};
    body.position = {0.4, 0.2, 0};
    body.velocity = velocity;
    body.density = 100;
    return body;
}

// The deepest overlap in some steps, in cells.
double overlap(const Scene& scene, int steps)
{
    Simulation<2> simulation(scene, Communicator());
    double deepest = 0;
    for (int i = 0; i < steps; ++i) {
        simulation.step(1e9);
        for (const GapState& gap : simulation.gaps())
            deepest = std::max(deepest, -gap.thickness * cells);
        for (const RigidBody<2>& body : simulation.bodies())
            EXPECT_TRUE((body.pose.position.array() > 0).all() && (body.pose.position.array() < 1).all()) << body.name;
    }
    return deepest;
}

TEST(TouchLimit, ThrownBodiesStopAtTheWall)
{
    for (const auto shape : {BodyScene::ShapeKind::ball, BodyScene::ShapeKind::box}) {
        Scene scene = tank();
        scene.bodies = {thrown(shape, {0, -2.2, 0})};
        EXPECT_LT(overlap(scene, 4), 0.001);
    }
}

TEST(TouchLimit, AFallFromRestInOneStepEndsOnTheFloor)
{
    Scene scene = tank();
    scene.gravity = {0, -1, 0};
    scene.sides[3].kind = SideScene::Kind::open;
    scene.max_step = 5;
    scene.bodies = {thrown(BodyScene::ShapeKind::ball, {})};
    EXPECT_LT(overlap(scene, 4), 0.001);
}

TEST(TouchLimit, AThrownBodyDoesNotPassAnotherOne)
{
    Scene scene = tank();
    scene.bodies = {thrown(BodyScene::ShapeKind::ball, {3, 0, 0}), thrown(BodyScene::ShapeKind::box, {})};
    scene.bodies[1].name = "target";
    scene.bodies[1].position = {0.65, 0.2, 0};
    EXPECT_LT(overlap(scene, 4), 0.001);
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 4; ++i)
        simulation.step(1e9);
    EXPECT_LT(simulation.bodies()[0].pose.position[0], simulation.bodies()[1].pose.position[0] - 0.12);
}

// Its end would sweep through the wall and out of it again.
TEST(TouchLimit, ABarThatTurnsStopsAtTheWall)
{
    Scene scene = tank();
    BodyScene bar = thrown(BodyScene::ShapeKind::box, {});
    bar.size = {0.36, 0.1, 0};
    bar.position = {0.5, 0.15, 0};
    bar.angular_velocity = {1, 0, 0};
    scene.bodies = {bar};
    EXPECT_LT(overlap(scene, 4), 0.001);
}

// What does not meet anything is not held up.
TEST(TouchLimit, StepsAlongAWallAreAsLongAsWithoutIt)
{
    Scene scene = tank();
    scene.cfl = 4;
    scene.gap.threshold = 0; // films limit the step
    BodyScene box = thrown(BodyScene::ShapeKind::box, {1, 0, 0});
    box.position = {0.3, 0.08, 0};
    scene.bodies = {box};
    Simulation<2> simulation(scene, Communicator());
    EXPECT_GT(simulation.step(1e9).dt * cells, 2) << "in cells; the flow at its corners is 1.7 times as fast";
}

TEST(TouchLimit, PrescribedBodiesThatMeetAreRefusedByName)
{
    Scene scene = tank();
    scene.sides[3].kind = SideScene::Kind::open;
    BodyScene driven = thrown(BodyScene::ShapeKind::ball, {0, -2.2, 0});
    driven.motion = BodyScene::Motion::prescribed;
    scene.bodies = {driven};
    const auto message = [&] {
        try {
            Simulation<2> simulation(scene, Communicator());
            for (int i = 0; i < 3; ++i)
                simulation.step(1e9);
        } catch (const ComputationError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(message().find("prescribed motion drives 'b' and 'wall:y_low' into each other at time 0.05"), std::string::npos)
        << message();
    scene.bodies.push_back(driven);
    scene.bodies[0].velocity = {3, 0, 0};
    scene.bodies[1].name = "post";
    scene.bodies[1].position = {0.7, 0.2, 0};
    scene.bodies[1].motion = BodyScene::Motion::fixed;
    scene.bodies[1].velocity = {};
    EXPECT_NE(message().find("prescribed motion drives 'b' and 'post' into each other at time 0.0"), std::string::npos)
        << message();
}

} // namespace
} // namespace gapflow
