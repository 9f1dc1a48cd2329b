// A grid that follows a body, on parts.
#include "unit/step/parts_run.hpp"
#include "unit/step/scenes.hpp"

#include "gapflow/step/advance.hpp"
#include "gapflow/step/simulation.hpp"
#include "gapflow/step/start.hpp"
#include "gapflow/step/viscosity.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

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
    for (const double viscosity : {0.0, 0.01}) {
        Scene scene = approaching()[0];
        scene.bodies[0].motion = BodyScene::Motion::free;
        scene.viscosity = viscosity;
        expect_to_go_on<2>(scene);
    }
}

// The same in viscous fluid: two bodies that are towed, and the same held in a stream. Their vorticity goes over the grid and leaves through its sides.
TEST(Following, ViscousFluidIsTheSameSeenFromTheBody)
{
    auto scenes = approaching();
    for (Scene& scene : scenes) {
        scene.viscosity = 0.01;
        scene.max_step = 0.015;
        for (int side = 0; side < 4; ++side)
            scene.sides[side].kind = SideScene::Kind::open;
        scene.bodies[1].velocity = scene.bodies[0].velocity;
        scene.bodies[1].motion = BodyScene::Motion::prescribed;
    }
    Simulation<2> follows(scenes[0], Communicator()), stays(scenes[1], Communicator());
    const Vec<2> stream = to_vec<2>(scenes[1].fluid_velocity);
    const auto difference = [&] {
        double largest = 0;
        for (int axis = 0; axis < 2; ++axis)
            for_each_index<2>(follows.grid().low(), follows.grid().high(), [&](const Index<2>& f) {
                if (follows.coupling().system.conductance(axis, f) > 0)
                    largest = std::max(
                        largest, std::abs(follows.velocity().grid(axis, f) + stream[axis] - stays.velocity().grid(axis, f)));
            });
        return largest;
    };
    while (follows.time() < 0.2) {
        follows.step(100);
        stays.step(100);
        ASSERT_NEAR(follows.time(), stays.time(), 1e-12);
        EXPECT_LT(difference(), 1e-6) << follows.time();
        const UnknownVector<2> p = follows.reduced_pressure(), q = stays.reduced_pressure();
        double of_pressure = 0;
        for_each_index<2>(follows.grid().low(), follows.grid().high(),
                          [&](const Index<2>& c) { of_pressure = std::max(of_pressure, std::abs(p.cells(c) - q.cells(c))); });
        EXPECT_LT(of_pressure, 1e-5) << follows.time();
        EXPECT_LT((follows.fluid_wrenches()[1] - stays.fluid_wrenches()[1]).norm(), 1e-6) << follows.time();
    }
    // The force on the body that is followed is that of all places on the grid, of one that is held that of one place.
    RecordProperty("forces",
                   std::to_string(follows.fluid_wrenches()[0][0]) + ", " + std::to_string(stays.fluid_wrenches()[0][0]) + "; " +
                       std::to_string(follows.fluid_wrenches()[0][1]) + ", " + std::to_string(stays.fluid_wrenches()[0][1]));
    EXPECT_LT((follows.fluid_wrenches()[0] - stays.fluid_wrenches()[0]).norm(), 0.1 * stays.fluid_wrenches()[0].norm());
    EXPECT_LT(follows.fluid_wrenches()[0][0], -0.01); // drag
}

// A neutral body and a stream go on together, on a grid that stays too, where the body covers and uncovers faces (by 2 % of its speed and a spin of 0.1 if solids had
// the means of the remainder in another gauge).
TEST(Following, ABodyThatAViscousStreamCarriesGoesWithIt)
{
    for (const bool follows : {true, false}) {
        Scene scene = on_following_grid(2, 24);
        if (!follows)
            scene.follow.reset();
        scene.viscosity = 0.01;
        scene.fluid_velocity = {0.6, -0.2, 0};
        scene.bodies = {body("first", BodyScene::ShapeKind::box, {0.413, 0.537, 0}, scene.fluid_velocity)};
        scene.bodies[0].size = {0.23, 0.17, 0};
        scene.bodies[0].angle = 0.3;
        PartsRun<2> run(scene);
        for (int k = 0; k < 5; ++k) {
            run.step(0.05);
            EXPECT_LT((run.state.bodies[0].twist - stream_twist<2>(to_vec<2>(scene.fluid_velocity))).norm(), 1e-9) << k;
            EXPECT_LT(run.state.wrenches[0].norm(), 1e-8) << k;
        }
    }
}

// A disk that begins to fall: its speed, with ever shorter steps.
TEST(Following, DragInViscousFluidIsOfFirstOrderInTime)
{
    std::array<double, 3> speed{};
    for (int k = 0; k < 3; ++k) {
        Scene scene = on_following_grid(2, 24);
        scene.viscosity = 0.01;
        scene.gravity = {6, 0, 0};
        scene.bodies = {body("first", BodyScene::ShapeKind::ball, {0.513, 0.487, 0})};
        scene.bodies[0].density = 2;
        PartsRun<2> run(scene);
        const int steps = 4 << k;
        for (int n = 0; n < steps; ++n)
            run.step(0.24 / steps);
        speed[k] = run.state.bodies[0].twist[0];
    }
    RecordProperty("speed", std::to_string(speed[0]) + ", " + std::to_string(speed[1]) + ", " + std::to_string(speed[2]));
    EXPECT_LT(speed[2], 0.9 * 0.24 * 6 / 3); // of that without drag
    EXPECT_LT(std::abs(speed[2] - speed[1]), 0.6 * std::abs(speed[1] - speed[0]));
}

/// Vortices, weaker towards all sides.
Vec<2> vortices(const Vec<2>& x)
{
    const Vec<2> a = 2 * std::numbers::pi * x;
    return {0.3 * std::sin(a[0]) * std::cos(a[1]) + 0.2 * std::sin(a[1]), -0.3 * std::cos(a[0]) * std::sin(a[1])};
}

// In a periodic box, where nothing else takes any: bodies and vortices keep their impulse together, and their energy.
TEST(Following, BodiesAndVorticesKeepImpulseAndEnergyTogether)
{
    std::array<double, 2> impulse_error{}, energy_error{};
    for (int fine = 0; fine < 2; ++fine) {
        Scene scene = box_of_fluid(2, 32, SideScene::Kind::periodic);
        scene.tolerance = 1e-12;
        scene.follow = FollowScene{"first", {true, true, true}};
        scene.bodies = {body("first", BodyScene::ShapeKind::ball, {0.413, 0.537, 0}, {0.8, 0.3, 0}),
                        body("other", BodyScene::ShapeKind::box, {0.78, 0.61, 0}, {0, -0.2, 0})};
        scene.bodies[0].density = 2;
        scene.bodies[1].size = {0.2, 0.15, 0};
        scene.bodies[1].angle = 0.3;
        PartsRun<2> run(scene, vortices);
        const auto impulse = [&] {
            Vec<2> sum = Vec<2>::Zero();
            for (std::size_t b = 0; b < 2; ++b)
                sum += (run.now.impulse[b] + momentum(run.state.bodies[b])).head<2>();
            return Vec<2>(sum + mean_flux(run.model.grid, run.now.flow.remainder.faces)); // of its velocity
        };
        const Vec<2> first = impulse(), coasting = run.state.bodies[0].twist.head<2>();
        const double energy = run.energy();
        for (int k = 0; k < (fine ? 16 : 8); ++k) {
            run.step(fine ? 0.01 : 0.02);
            impulse_error[fine] = std::max(impulse_error[fine], (impulse() - first).norm());
            energy_error[fine] = std::max(energy_error[fine], std::abs(run.energy() / energy - 1));
        }
        EXPECT_GT((run.state.bodies[0].twist.head<2>() - coasting).norm(), 0.01);
    }
    RecordProperty("impulse", std::to_string(impulse_error[0]) + ", " + std::to_string(impulse_error[1]));
    RecordProperty("energy", std::to_string(energy_error[0]) + ", " + std::to_string(energy_error[1]));
    EXPECT_LT(energy_error[0], 2e-5); // forces settle within 1e-5
    EXPECT_LT(impulse_error[0], 1e-4);
    EXPECT_LT(impulse_error[1], 0.35 * impulse_error[0]);
}

// A disk leaves a vortex behind, which passes the side and is gone; where it stayed in the last cells, all of it would be left.
TEST(Following, VorticityIsLeftBehind)
{
    for (const SideScene::Kind kind : {SideScene::Kind::far, SideScene::Kind::open}) {
        std::array<double, 2> start{}, end{};
        for (int vortex = 0; vortex < 2; ++vortex) {
            Scene scene = box_of_fluid(2, 24, kind);
            scene.follow = FollowScene{"first", {true, true, true}};
            scene.bodies = {body("first", BodyScene::ShapeKind::ball, {0.713, 0.537, 0}, {1, 0, 0})};
            scene.bodies[0].motion = BodyScene::Motion::prescribed;
            scene.bodies[0].radius = 0.06;
            PartsRun<2> run(scene, [&](const Vec<2>& x) {
                const Vec<2> from(x[0] - 0.45, x[1] - 0.48);
                const double speed = 4.0 * vortex * std::exp(-from.squaredNorm() / (0.12 * 0.12));
                return Vec<2>(-speed * from[1], speed * from[0]);
            });
            start[vortex] = run.now.energy;
            for (int k = 0; k < 40; ++k)
                run.step(0.03);
            end[vortex] = run.now.energy;
        }
        RecordProperty(kind == SideScene::Kind::far ? "far" : "open",
                       std::to_string((end[1] - end[0]) / (start[1] - start[0])));
        EXPECT_GT(start[1] - start[0], 1e-3);
        EXPECT_LT(std::abs(end[1] - end[0]), 0.2 * (start[1] - start[0]));
    }
}

} // namespace
} // namespace gapflow
