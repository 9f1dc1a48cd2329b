// A grid that follows a body, on parts.
#include "unit/step/scenes.hpp"

#include "gapflow/step/advance.hpp"
#include "gapflow/step/simulation.hpp"
#include "gapflow/step/start.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapflow {
namespace {

Scene on_following_grid(int dimension, int cells)
{
    Scene scene = box_of_fluid(dimension, cells, SideScene::Kind::far);
    scene.tolerance = 1e-12;
    scene.follow = FollowScene{"first", {true, true, true}};
    return scene;
}

// Nothing changes around it: over a grid that stays its speed changes by 0.5 % as it passes cells.
template <int D>
void check_coasting(double accuracy)
{
    Scene scene = on_following_grid(D, D == 2 ? 32 : 16);
    scene.bodies = {body("first", BodyScene::ShapeKind::ball, {0.413, 0.537, 0.521}, {0.8, 0.6, D == 2 ? 0.0 : -0.3})};
    Simulation<D> simulation(scene, Communicator());
    const Twist<D> start = simulation.bodies()[0].twist;
    for (int k = 0; k < 6; ++k) {
        simulation.step(100);
        EXPECT_LT((simulation.bodies()[0].twist - start).norm(), accuracy);
        EXPECT_LT(simulation.fluid_wrenches()[0].norm(), accuracy);
    }
    EXPECT_GT((simulation.bodies()[0].centre() - to_vec<D>(scene.bodies[0].position)).norm(), 2 * scene.spacing());
    EXPECT_LT((simulation.grid().origin() - simulation.bodies()[0].centre() + to_vec<D>(scene.bodies[0].position)).norm(),
              1e-12);
}

TEST(Following, ABodyAloneKeepsItsVelocity2D)
{
    check_coasting<2>(1e-9);
}

TEST(Following, ABodyAloneKeepsItsVelocity3D)
{
    check_coasting<3>(1e-9);
}

/// A disk that drives towards a box, and the box that comes to the disk at rest in a stream.
std::array<Scene, 2> approaching()
{
    std::array<Scene, 2> scenes;
    for (int k = 0; k < 2; ++k) {
        Scene scene = on_following_grid(2, 40);
        const Triple speed{0.8, 0.1, 0};
        BodyScene disk = body("first", BodyScene::ShapeKind::ball, {0.413, 0.537, 0}, speed);
        disk.motion = BodyScene::Motion::prescribed;
        BodyScene box = body("box", BodyScene::ShapeKind::box, {0.68, 0.56, 0});
        box.size = {0.17, 0.13, 0};
        box.angle = 0.3;
        box.density = 2;
        if (k == 1) {
            scene.follow.reset();
            disk.velocity = {};
            box.velocity = scene.fluid_velocity = {-speed[0], -speed[1], 0};
        }
        scene.bodies = {disk, box};
        scene.max_step = 0.01;
        scenes[k] = scene;
    }
    return scenes;
}

TEST(Following, IsTheSceneSeenFromTheBody)
{
    const auto [moving, still] = approaching();
    Simulation<2> follows(moving, Communicator()), stays(still, Communicator());
    const Vec<2> stream = to_vec<2>(still.fluid_velocity);
    for (int k = 0; k < 6; ++k) {
        follows.step(100);
        stays.step(100);
        ASSERT_NEAR(follows.time(), stays.time(), 1e-12);
        const RigidBody<2>&a = follows.bodies()[1], &b = stays.bodies()[1];
        EXPECT_LT((a.centre() - b.centre() + follows.time() * stream).norm(), 1e-10) << k;
        EXPECT_LT((a.twist - b.twist + stream_twist<2>(stream)).norm(), 1e-8) << k;
        EXPECT_LT((follows.fluid_wrenches()[1] - stays.fluid_wrenches()[1]).norm(), 1e-6 * stays.fluid_wrenches()[1].norm())
            << k;
        const UnknownVector<2> p = follows.reduced_pressure(), q = stays.reduced_pressure();
        double difference = 0, largest = 0;
        for_each_index<2>(follows.grid().low(), follows.grid().high(), [&](const Index<2>& c) {
            difference = std::max(difference, std::abs(p.cells(c) - q.cells(c)));
            largest = std::max(largest, std::abs(q.cells(c)));
        });
        EXPECT_LT(difference, 1e-6 * largest) << k;
    }
    EXPECT_GT(follows.bodies()[1].twist[0], 0.02); // the disk pushes it
}

// Over a grid that stays grid and sides take some of the impulse. Two of the three have a gap with mouths.
TEST(Following, BodiesKeepTheirImpulseTogether)
{
    Scene scene = on_following_grid(2, 40);
    const double dx = scene.spacing();
    BodyScene plate = body("first", BodyScene::ShapeKind::box, {0.45, 0.5, 0}, {0.3, 0.5, 0});
    plate.size = {8 * dx, 3.2 * dx, 0};
    plate.angle = 0.2;
    BodyScene other = plate;
    other.name = "other";
    const double up = 3.2 * dx + 0.4 * dx;
    other.position = {0.45 - up * std::sin(0.2), 0.5 + up * std::cos(0.2), 0};
    other.velocity = {-0.1, 0.4, 0};
    BodyScene disk = body("disk", BodyScene::ShapeKind::ball, {0.72, 0.46, 0}, {0, 0.3, 0});
    disk.density = 2;
    scene.bodies = {plate, other, disk};
    Model<2> model(scene, Communicator(), Task::motion);
    State<2> state(model);
    StepReport report;
    StageTimers timers;
    Instant<2> now = start_on_parts(model, state, report, timers);
    const auto impulse = [&] {
        Vec<2> sum = Vec<2>::Zero();
        for (std::size_t b = 0; b < 3; ++b)
            sum += (now.impulse[b] + momentum(state.bodies[b])).head<2>();
        return sum;
    };
    const Vec<2> first = impulse();
    for (int k = 1; k <= 6; ++k) {
        const double dt = 0.01;
        now = advance(model, now, Step{k, state.time, dt, state.dt, k * dt}, state, report, timers);
        EXPECT_LT((impulse() - first).norm(), 1e-8 * first.norm()) << k;
    }
    EXPECT_GT((state.bodies[0].twist.head<2>() - to_vec<2>(plate.velocity)).norm(), 0.01);
}

TEST(Following, GoesOnFromAStoredStateBitForBit)
{
    Scene scene = approaching()[0];
    scene.bodies[0].motion = BodyScene::Motion::free;
    expect_to_go_on<2>(scene);
}

} // namespace
} // namespace gapflow
