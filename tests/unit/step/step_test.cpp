// The Lagrangian step of ideal fluid on parts: energy, impulse, angular impulse, restart.
#include "unit/step/parts_run.hpp"
#include "unit/step/scenes.hpp"

#include "gapflow/step/advance.hpp"
#include "gapflow/step/energy_change.hpp"
#include "gapflow/step/simulation.hpp"
#include "gapflow/step/start.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace gapflow {
namespace {

SolverOptions exact()
{
    SolverOptions options;
    options.tolerance = 1e-12;
    return options;
}

template <int D>
Twist<D> random_twist(std::mt19937& random)
{
    std::uniform_real_distribution<double> number(-1, 1);
    Twist<D> twist;
    for (int k = 0; k < twist_size<D>; ++k)
        twist[k] = number(random);
    return twist;
}

/// Disks and boxes (3D: balls, a capsule), two of them with a gap of a fifth of a cell.
template <int D>
Scene three_bodies()
{
    Scene scene = box_of_fluid(D, D == 2 ? 32 : 16, SideScene::Kind::wall);
    const double dx = scene.spacing();
    BodyScene box = body("box", D == 2 ? BodyScene::ShapeKind::box : BodyScene::ShapeKind::capsule, {0.35, 0.4, 0.5});
    box.size = {0.3, 0.2, 0.2};
    box.length = 0.12;
    BodyScene ball = body("ball", BodyScene::ShapeKind::ball, {0.35, 0.5 + (D == 2 ? 0.1 : 0.14) + 0.2 * dx, 0.5});
    BodyScene other = body("other", BodyScene::ShapeKind::ball, {0.78, 0.7, 0.52});
    if (D == 3)
        ball.radius = box.radius = 0.12;
    scene.bodies = {box, ball, other};
    return scene;
}

template <int D>
void check_identity()
{
    const Scene scene = three_bodies<D>();
    const Model<D> model(scene, Communicator(), Task::motion);
    std::mt19937 random(7);
    for (int trial = 0; trial < 4; ++trial) {
        std::vector<RigidBody<D>> moved = model.bodies;
        std::vector<Twist<D>> V = model.twists(moved), next = V;
        for (std::size_t b = 0; b < moved.size(); ++b) {
            V[b] = random_twist<D>(random);
            next[b] = V[b] + 0.2 * random_twist<D>(random);
            const Twist<D> way = 0.3 * scene.spacing() * V[b];
            displace<D>(moved[b], way.template head<D>(), way.template tail<spin_size<D>>());
        }
        V[2].setZero(); // at rest
        next[2].setZero();
        moved[2] = model.bodies[2];
        const auto before = placed(model, model.bodies, model.masses(model.bodies, 0.0)),
                   after = placed(model, moved, model.masses(moved, 0.0));
        const PotentialFlow<D> a = flow_of_twists(*before, V, exact()), b = flow_of_twists(*after, next, exact());
        const std::vector<Twist<D>> P = fluid_impulse(*before, a), P_next = fluid_impulse(*after, b);
        double whole = 0, sum = 0, scale = 0;
        for (std::size_t s = 0; s < V.size(); ++s) {
            whole += 0.5 * (V[s].dot(P_next[s]) - next[s].dot(P[s]));
            scale += std::abs(V[s].dot(P_next[s]));
        }
        const EnergyChange change = energy_change(*before, a, *after, b);
        for (double part : change.work)
            sum += part;
        EXPECT_NEAR(sum, whole, 1e-9 * scale) << "trial " << trial;
        EXPECT_EQ(change.group[0], change.group[1]) << "neighbours";
        EXPECT_EQ(change.group[2], -1) << "a body at rest does no work";
        EXPECT_GT(std::abs(whole), 1e-4 * scale);
    }
}

TEST(EnergyChange, SumsUpToThatOfTheImpulses2D)
{
    check_identity<2>();
}

TEST(EnergyChange, SumsUpToThatOfTheImpulses3D)
{
    check_identity<3>();
}

// Far from each other bodies change the energy nearly as they do alone.
TEST(EnergyChange, IsEachBodysOwn)
{
    Scene both = box_of_fluid(2, 40, SideScene::Kind::wall);
    both.bodies = {body("left", BodyScene::ShapeKind::ball, {0.213, 0.231}),
                   body("right", BodyScene::ShapeKind::ball, {0.787, 0.764})};
    for (BodyScene& one : both.bodies)
        one.radius = 2 * both.spacing();
    const Model<2> model(both, Communicator(), Task::motion);
    const auto change = [&](bool left, bool right) {
        std::vector<RigidBody<2>> moved = model.bodies;
        std::vector<Twist<2>> V = model.twists(moved);
        V[0].setZero();
        V[1].setZero();
        if (left)
            V[0][0] = 1;
        if (right)
            V[1][1] = 1;
        displace<2>(moved[0], 0.5 * both.spacing() * V[0].head<2>(), Spin<2>::Zero());
        displace<2>(moved[1], 0.5 * both.spacing() * V[1].head<2>(), Spin<2>::Zero());
        const auto before = placed(model, model.bodies, model.masses(model.bodies, 0.0)),
                   after = placed(model, moved, model.masses(moved, 0.0));
        return energy_change(*before, flow_of_twists(*before, V, exact()), *after, flow_of_twists(*after, V, exact()));
    };
    const auto of = [](const EnergyChange& found, int solid) {
        return found.group[solid] < 0 ? 0.0 : found.work[found.group[solid]];
    };
    const EnergyChange first = change(true, false), second = change(false, true), both_move = change(true, true);
    const std::array<double, 2> one{of(first, 0), of(first, 1)}, other{of(second, 0), of(second, 1)},
        all{of(both_move, 0), of(both_move, 1)};
    EXPECT_NE(both_move.group[0], both_move.group[1]);
    const double largest = std::max(std::abs(one[0]), std::abs(other[1]));
    EXPECT_GT(std::abs(one[0] - other[1]), 0.5 * largest); // exchanged they would not do
    EXPECT_NEAR(all[0], one[0], 0.1 * largest);
    EXPECT_NEAR(all[1], other[1], 0.1 * largest);
}

double kinetic_energy(const Simulation<2>& simulation)
{
    const Budget<2> sums = simulation.budget();
    return sums.energy_grid + sums.energy_film + sums.energy_bodies;
}

// With velocities that are carried over the grid the disk loses a third of its energy here.
TEST(Step, DiskCoastsWithoutLoss)
{
    for (const double density : {0.1, 1.0, 10.0}) {
        Scene scene = box_of_fluid(2, 51, SideScene::Kind::far);
        BodyScene disk = body("disk", BodyScene::ShapeKind::ball, {0.33, 0.37}, {0.8, 0.6, 0});
        disk.radius = 3.2 / 51;
        disk.density = density;
        scene.bodies = {disk};
        Simulation<2> simulation(scene, Communicator());
        const double energy = kinetic_energy(simulation), end = 6 * disk.radius;
        while (simulation.time() < end) {
            simulation.step(end);
            EXPECT_NEAR(simulation.bodies()[0].twist.head<2>().norm(), 1, 0.005);
        }
        EXPECT_NEAR(kinetic_energy(simulation), energy, 1e-4 * energy);
        EXPECT_LT(std::abs(simulation.correction().sum), 0.08);
    }
}

// What a round surface covers of a plane that it has just passed goes as the root of the depth: by its rate at the place the force is a thousand times that of the step.
TEST(Step, RoundBodiesThatTouchAPlaneOfTheGridCoast)
{
    for (const bool capsule : {false, true})
        for (const double beyond : {0.0, 1e-4}) {
            Scene scene = box_of_fluid(2, 24, SideScene::Kind::wall);
            const double dx = scene.spacing();
            BodyScene round = body("round", capsule ? BodyScene::ShapeKind::capsule : BodyScene::ShapeKind::ball, {0.47, 0, 0},
                                   {0.6, -0.8, 0});
            round.radius = 2.4 * dx;
            round.length = 3 * dx;
            round.angle = 0.7;
            const double top = round.radius + (capsule ? 0.5 * round.length * std::sin(round.angle) : 0.0);
            round.position[1] = (15 + beyond) * dx - top;
            scene.bodies = {round};
            Model<2> model(scene, Communicator(), Task::motion);
            State<2> state(model);
            StepReport report;
            StageTimers timers;
            Instant<2> start = start_on_parts(model, state, report, timers);
            const double energy = start.energy + gapflow::kinetic_energy(state.bodies[0]), dt = 0.3 * dx;
            const Instant<2> end = advance(model, start, Step{1, 0, dt, 0, dt}, state, report, timers);
            EXPECT_NEAR(end.energy + gapflow::kinetic_energy(state.bodies[0]), energy, 2e-5 * energy)
                << capsule << " " << beyond;
            EXPECT_LT(std::abs(report.corrected_energy), 0.01 * energy) << capsule << " " << beyond;
            EXPECT_TRUE(report.notes.empty());
        }
}

// Impulse and angular impulse of bodies and fluid about a point of the world are kept in boundless fluid: the rates of the fluid's part about the
// body's centre, which moves and turns, have the right signs.
template <int D>
void check_impulse()
{
    Scene scene = box_of_fluid(D, D == 2 ? 48 : 28, SideScene::Kind::far);
    BodyScene capsule = body("capsule", BodyScene::ShapeKind::capsule, {0.47, 0.52, 0.49}, {0.6, 0.3, D == 2 ? 0.0 : -0.2});
    capsule.radius = 3.0 * scene.spacing();
    capsule.length = 5.0 * scene.spacing();
    capsule.angular_velocity = {D == 2 ? 3.0 : 1.0, 2.0, -1.5};
    scene.bodies = {capsule};
    Model<D> model(scene, Communicator(), Task::motion);
    State<D> state(model);
    StepReport report;
    StageTimers timers;
    Instant<D> now = start_on_parts(model, state, report, timers);
    const auto momenta = [&] {
        Twist<D> P = now.impulse[0] + momentum(state.bodies[0]);
        P.template tail<spin_size<D>>() += moment<D>(state.bodies[0].centre(), Vec<D>(P.template head<D>()));
        return P;
    };
    const Twist<D> first = momenta();
    double turned = 0;
    for (int k = 1; k <= 30; ++k) {
        const double dt = 0.01;
        now = advance(model, now, Step{k, state.time, dt, state.dt, k * dt}, state, report, timers);
        turned += dt * state.bodies[0].twist.template tail<spin_size<D>>().norm();
    }
    const Twist<D> last = momenta();
    const double linear = first.template head<D>().norm(), angular = first.template tail<spin_size<D>>().norm();
    EXPECT_GT(turned, 0.4);
    EXPECT_LT((last - first).template head<D>().norm(), 0.02 * linear);
    EXPECT_LT((last - first).template tail<spin_size<D>>().norm(), 0.02 * std::max(angular, linear * 0.5));
}

TEST(Step, KeepsImpulseInBoundlessFluid2D)
{
    check_impulse<2>();
}

TEST(Step, KeepsImpulseInBoundlessFluid3D)
{
    check_impulse<3>();
}

// Aligned on planes of the grid, too, where slivers become passages within the way over which the force is found: with the old potentials there the energy is
// a hundred times too large.
TEST(Step, ForcesOnPlatesAreDifferencesOfTheEnergy)
{
    for (const double degrees : {0.0, 20.0}) {
        const Scene scene = two_plates(16.3, 16.15, 0.3, degrees);
        const Model<2> model(scene, Communicator(), Task::motion);
        std::vector<Twist<2>> V = model.twists(model.bodies);
        V[0] << 0.3, -1, 4;
        V[1] << -0.2, 1, -3;
        const auto at = [&](const std::vector<RigidBody<2>>& bodies) {
            return placed(model, bodies, model.masses(bodies, 0.0));
        };
        auto here = at(model.bodies);
        ASSERT_FALSE(here->complex.mouths.empty());
        PotentialFlow<2> flow = flow_of_twists(*here, V, exact());
        const Instant<2> instant = instant_of<2>(model, model.bodies, std::move(here), flow);
        ASSERT_EQ(instant.displaced.size(), 6u);
        for (const Displaced<2>& one : instant.displaced) {
            std::array<double, 2> energy;
            for (int end = 0; end < 2; ++end) {
                std::vector<RigidBody<2>> bodies = model.bodies;
                const double way = (end == 0 ? -0.5 : 0.5) * one.way;
                Vec<2> shift = Vec<2>::Zero();
                Spin<2> turn = Spin<2>::Zero();
                if (one.component < 2)
                    shift[one.component] = way;
                else
                    turn[0] = way;
                displace<2>(bodies[one.solid], shift, turn);
                const auto there = at(bodies);
                const std::vector<Twist<2>> P = fluid_impulse(*there, flow_of_twists(*there, V, exact()));
                energy[end] = 0.5 * (V[0].dot(P[0]) + V[1].dot(P[1]));
            }
            const double expected = (energy[1] - energy[0]) / one.way,
                         scale = instant.energy / (scene.spacing() * (one.component < 2 ? 1 : 1.0 / 6 / 32));
            EXPECT_NEAR(instant.force[one.solid][one.component], expected, 1e-3 * std::abs(expected) + 1e-4 * scale)
                << degrees << " degrees, component " << one.component << " of " << one.solid;
        }
    }
}

// Edges almost in planes of the grid: rows are joined with each other by conductances of 1e8 times those of the grid, and with the rest by those of the grid.
TEST(Step, DisplacedBodiesHaveTheEnergyOfTheirFlow)
{
    Scene scene = box_of_fluid(3, 12, SideScene::Kind::wall);
    scene.gap.roughness = 0;
    const double dx = scene.spacing(), gap = 0.3;
    for (const double side : {-1.0, 1.0}) {
        BodyScene plate = body(side < 0 ? "lower" : "upper", BodyScene::ShapeKind::box,
                               {6 * dx, 6 * dx, (6.1 + side * (1 + 0.5 * gap)) * dx});
        plate.size = {6 * dx, 6 * dx, 2 * dx};
        plate.quaternion = {1, side * 2e-6, 5e-7, 0};
        scene.bodies.push_back(plate);
    }
    const Model<3> model(scene, Communicator(), Task::motion);
    std::vector<Twist<3>> V = model.twists(model.bodies);
    V[0] << 0.1, 0.2, -1, 0, 0, 0;
    V[1] << 0, -0.1, 1, 0, 0, 0;
    const auto at = [&](const std::vector<RigidBody<3>>& bodies) { return placed(model, bodies, model.masses(bodies, 0.0)); };
    auto here = at(model.bodies);
    const PotentialFlow<3> flow = flow_of_twists(*here, V, exact());
    const Instant<3> instant = instant_of<3>(model, model.bodies, std::move(here), flow);
    ASSERT_EQ(instant.displaced.size(), 12u);
    for (const Displaced<3>& one : instant.displaced)
        for (const EnergyTerms<3>* end : {&one.low, &one.high}) {
            if (one.component >= 3)
                continue;
            std::vector<RigidBody<3>> bodies = model.bodies;
            bodies[one.solid].pose.position[one.component] += (end == &one.low ? -0.5 : 0.5) * one.way;
            const auto there = at(bodies);
            const std::vector<Twist<3>> P = fluid_impulse(*there, flow_of_twists(*there, V, exact()));
            const double whole = 0.5 * (V[0].dot(P[0]) + V[1].dot(P[1])) - instant.energy,
                         known = end->energy(flow) - EnergyTerms<3>(*instant.placed, *instant.placed).energy(flow);
            EXPECT_NEAR(known, whole, 2e-3 * instant.energy) << "component " << one.component << " of " << one.solid;
        }
}

// A capsule that turns about its contact with a plate: the distance of its other end has no minimum there.
TEST(Step, GapsThatTurnAboutAContactLimitIt)
{
    Scene scene = box_of_fluid(2, 48, SideScene::Kind::wall);
    const double dx = scene.spacing(), radius = 2 * dx, tilt = 0.03;
    scene.gap.roughness = 0.005 * dx;
    BodyScene capsule = body("capsule", BodyScene::ShapeKind::capsule, {0.5, radius + 0.5 * 8 * dx * std::sin(tilt), 0});
    capsule.radius = radius;
    capsule.length = 8 * dx;
    capsule.angle = tilt;
    capsule.density = 100;
    // The low end rests: the centre moves as the angle does.
    capsule.angular_velocity = {-5, 0, 0};
    capsule.velocity = {0, -5 * 4 * dx * std::cos(tilt), 0};
    scene.bodies = {capsule};
    Simulation<2> simulation(scene, Communicator());
    const double least = 0.005 * dx / (8 * dx); // where the roughness takes over
    for (int k = 0; k < 12; ++k) {
        const double before = simulation.bodies()[0].pose.rotation.angle();
        simulation.step(1);
        const double after = simulation.bodies()[0].pose.rotation.angle();
        if (before > 2 * least) {
            EXPECT_GT(after, 0.6 * before) << "step " << k;
        }
    }
    EXPECT_LT(simulation.bodies()[0].pose.rotation.angle(), 0.2 * tilt);
}

// Boxes that stand on each other and in a corner, all in contact: nothing moves, and the solves converge.
TEST(Step, AStackInACornerStands)
{
    Scene scene = box_of_fluid(2, 32, SideScene::Kind::wall);
    scene.gravity = {0, -1, 0};
    const double dx = scene.spacing();
    scene.gap.roughness = 0.005 * dx;
    double top = 0;
    for (const auto& [width, height] : {std::pair{6.3, 4.2}, {5.1, 3.3}, {6.3, 4.0}}) {
        BodyScene box = body("box" + std::to_string(scene.bodies.size()), BodyScene::ShapeKind::box,
                             {0.5 * width * dx, (top + 0.5 * height) * dx, 0});
        box.size = {width * dx, height * dx, 0};
        box.density = 3;
        scene.bodies.push_back(box);
        top += height;
    }
    Simulation<2> simulation(scene, Communicator());
    const std::vector<RigidBody<2>> start = simulation.bodies();
    while (simulation.time() < 1)
        simulation.step(1);
    EXPECT_LT(simulation.steps(), 100);
    for (std::size_t b = 0; b < start.size(); ++b)
        EXPECT_LT((simulation.bodies()[b].centre() - start[b].centre()).norm(), 0.05 * dx) << b;
}

// A cylinder that slides along a wall is drawn to it, and stops there: the force towards the wall grows as the inverse root of the gap, and what its trapezium errs the
// contact gives back. It is not taken from the motion along the wall: this had a twentieth less after the step.
TEST(Step, ABodyThatMeetsAWallKeepsItsImpulseAlongIt)
{
    Scene scene = box_of_fluid(2, 32, SideScene::Kind::wall);
    scene.gap.roughness = 0;
    BodyScene disk = body("disk", BodyScene::ShapeKind::ball, {0.31185, 0.15 + 3e-6, 0}, {0.4617, -0.1617, 0});
    disk.radius = 0.15;
    disk.density = 1;
    scene.bodies = {disk};
    PartsRun<2> run(scene);
    const auto along = [&] { return run.now.impulse[0][0] + momentum(run.state.bodies[0])[0]; };
    const double impulse = along(), energy = run.energy();
    double corrected = 0;
    for (int k = 0; k < 8; ++k) {
        run.step(5e-6);
        corrected += std::abs(run.report.corrected_energy);
        EXPECT_LE(run.energy(), energy * (1 + 1e-6));
    }
    EXPECT_NEAR(run.state.bodies[0].twist[1], 0, 1e-3);
    EXPECT_LT(run.energy(), 0.92 * energy); // what goes towards the wall is lost
    EXPECT_NEAR(along(), impulse, 2e-3 * impulse);
    EXPECT_LT(corrected, 1e-3 * energy);
}

// What lies flat on a wall and moves into it has met it: no velocity has brought the energy that its gap, as thin as the roughness, would have. Along the wall it goes on.
template <int D>
void expect_no_flat_closing()
{
    Scene scene = box_of_fluid(D, D == 2 ? 32 : 16, SideScene::Kind::wall);
    const double dx = scene.spacing();
    scene.contact.restitution = 1;
    scene.gap.roughness = 0.005 * dx;
    BodyScene box = body("box", BodyScene::ShapeKind::box, {0.5, 1 - 2 * dx, 0.5}, {0.3, 0.4, 0});
    box.size = {8 * dx, 4 * dx, 6 * dx};
    BodyScene behind = body("behind", BodyScene::ShapeKind::box, {0.5, 1 - 5.5 * dx, 0.5}, {0.3, 0.5, 0}); // flat on it
    behind.size = {5 * dx, 3 * dx, 4 * dx};
    behind.density = 100;
    BodyScene disk = body("disk", BodyScene::ShapeKind::ball, {2 * dx, 0.3, 0.5}, {-0.1, 0, 0});
    disk.radius = 2 * dx;
    scene.bodies = {box, behind, disk};
    const PartsRun<D> run(scene);
    EXPECT_NEAR(run.state.bodies[0].twist[0], 0.3, 1e-9);
    EXPECT_NEAR(run.state.bodies[0].twist[1], 0, 1e-9);
    EXPECT_NEAR(run.state.bodies[1].twist[1], 0, 1e-9);
    EXPECT_EQ(run.state.bodies[2].twist[0], -0.1) << "a round surface rebounds";
    EXPECT_LT(run.now.energy, 5 * kinetic_energy(run.state.bodies[0]));
    EXPECT_THAT(run.report.notes, ::testing::Contains(::testing::HasSubstr("lie flat on each other")));
}

TEST(Step, WhatLiesFlatOnAWallDoesNotStartIntoIt2D)
{
    expect_no_flat_closing<2>();
}

TEST(Step, WhatLiesFlatOnAWallDoesNotStartIntoIt3D)
{
    expect_no_flat_closing<3>();
}

// A light disk on a stiff spring is pressed by one of 2000 times its mass: with it the oscillation is as visible as its mass makes it, where it turns back too.
TEST(Step, AHeavyBodyThatPressesASprungOneShowsItsOscillation)
{
    Scene scene = box_of_fluid(2, 32, SideScene::Kind::wall);
    const double dx = scene.spacing();
    scene.gap.roughness = 0.005 * dx;
    BodyScene sprung = body("sprung", BodyScene::ShapeKind::ball, {0.5, 0.3, 0});
    sprung.radius = 2 * dx;
    sprung.spring = SpringScene{{0.5, 0.3, 0}, 1e6, 0};
    BodyScene heavy = body("heavy", BodyScene::ShapeKind::ball, {0.5, 0.3 + 6.01 * dx, 0}, {0, -0.2, 0});
    heavy.radius = 4 * dx;
    heavy.density = 500;
    scene.bodies = {sprung, heavy};
    scene.max_step = 0.1;
    Simulation<2> simulation(scene, Communicator());
    double start = 0, least = 0;
    for (int k = 0; k < 400 && simulation.bodies()[1].twist[1] < 0.1; ++k) {
        const StepReport report = simulation.step(scene.end);
        const double energy = report.energy_fluid + report.energy_bodies;
        start = k == 0 ? energy : start;
        EXPECT_LT(energy, 1.02 * start) << "step " << k + 1;
        least = std::min(least, simulation.bodies()[0].pose.position[1] - 0.3);
    }
    EXPECT_LT(least, -1e-3 * dx);
    EXPECT_GT(simulation.bodies()[1].twist[1], 0.1); // thrown back
}

// A corner whose sides both look at an open side of the domain, in the middle of a cell: as it passes that the energy is continuous (the moment of inertia jumped by 10 %).
TEST(Step, ACornerPassesAnOpenSide)
{
    Scene scene = box_of_fluid(2, 32, SideScene::Kind::wall);
    scene.sides[2].kind = SideScene::Kind::open;
    const double dx = scene.spacing(), w = 7 * dx, h = 4.2 * dx;
    std::array<TwistMatrix<2>, 2> N;
    for (const int in : {0, 1}) {
        BodyScene box =
            body("box", BodyScene::ShapeKind::box, {0.513, std::sqrt(0.125) * (w - h) + (in ? 1e-6 : -1e-6) * dx, 0});
        box.size = {w, h, 0};
        box.angle = std::numbers::pi / 4;
        scene.bodies = {box};
        const Model<2> model(scene, Communicator(), Task::motion);
        const auto here = placed(model, model.bodies, model.masses(model.bodies, 0.0));
        for (int k = 0; k < 3; ++k) {
            std::vector<Twist<2>> V = model.twists(model.bodies);
            V[0] = Twist<2>::Unit(k);
            N[in].col(k) = fluid_impulse(*here, flow_of_twists(*here, V, exact()))[0];
        }
    }
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(N[0](k, k), N[1](k, k), 1e-3 * N[0](k, k)) << k;
}

// A disk slides down a fixed one without friction. The contact's normal turns with it, which is no impact: the acceleration goes on, and gravity does no more work
// than the way tells.
TEST(Step, WhatSlidesOnARoundSurfaceMeetsItOnce)
{
    Scene scene = box_of_fluid(2, 32, SideScene::Kind::wall);
    scene.gravity = {0, -1, 0};
    scene.max_step = 0.02;
    const double dx = scene.spacing(), angle = 0.5;
    scene.gap.roughness = 0.01 * dx;
    BodyScene base = body("base", BodyScene::ShapeKind::ball, {0.5, 0.35, 0});
    base.radius = 6 * dx;
    base.motion = BodyScene::Motion::fixed;
    const double apart = 9.01 * dx;
    BodyScene disk =
        body("disk", BodyScene::ShapeKind::ball, {0.5 + apart * std::sin(angle), 0.35 + apart * std::cos(angle), 0});
    disk.radius = 3 * dx;
    disk.density = 20;
    scene.bodies = {base, disk};
    Simulation<2> simulation(scene, Communicator());
    const double volume = std::numbers::pi * disk.radius * disk.radius;
    double start = 0, energy = 0;
    for (int k = 0; k < 24; ++k) {
        const StepReport report = simulation.step(scene.end);
        const double kinetic = report.energy_fluid + report.energy_bodies,
                     whole = kinetic + 19 * volume * simulation.bodies()[1].pose.position[1];
        if (k == 3)
            start = whole;
        energy = kinetic;
        if (k > 3) {
            EXPECT_NEAR(whole, start, 0.01 * energy) << "step " << k + 1;
        }
    }
    EXPECT_GT(energy, 5 * 0.02 * volume);
}

// So is it where the way of a step leads bodies by a little into each other, and they are moved apart again.
TEST(Step, WhatSlidesOnABodyThatTurnsMeetsItOnce)
{
    Scene scene = box_of_fluid(2, 58, SideScene::Kind::wall);
    scene.size = {0.0145, 0.0125, 0};
    scene.cells = {58, 50, 1};
    scene.gravity = {0, -9.81, 0};
    scene.max_step = 2.8e-4;
    scene.gap.roughness = 2.5e-7;
    BodyScene flap = body("flap", BodyScene::ShapeKind::capsule, {0.005474936905516543, 0.006722186484780355, 0});
    flap.radius = 0.0004544753517611566;
    flap.length = 0.0022845817411077966;
    flap.angle = std::numbers::pi / 18;
    flap.density = 15.9;
    flap.hinge = HingeScene{{0.00435, 0.0065238297567431, 0}};
    BodyScene ball = body("ball", BodyScene::ShapeKind::ball, {0.0052207873546596985, 0.008163540212018785, 0});
    ball.radius = 0.001009113580017453;
    ball.density = 5.34;
    scene.bodies = {flap, ball};
    Simulation<2> simulation(scene, Communicator());
    double start = 0;
    for (int k = 0; k < 20; ++k) {
        const StepReport report = simulation.step(scene.end);
        const double kinetic = report.energy_fluid + report.energy_bodies;
        double whole = kinetic;
        for (const RigidBody<2>& b : simulation.bodies())
            whole += 9.81 * (b.mass - scene.density * b.volume) * b.centre()[1];
        start = k == 1 ? whole : start;
        if (k > 1) {
            EXPECT_NEAR(whole, start, 5e-3 * kinetic) << "step " << k + 1;
        }
    }
}

// Sum of fluid and bodies: the work of gravity is the whole change of energy, contacts lose.
TEST(Step, GravityDoesTheWork)
{
    Scene scene = box_of_fluid(2, 32, SideScene::Kind::wall);
    scene.gravity = {0, -1, 0};
    BodyScene disk = body("disk", BodyScene::ShapeKind::ball, {0.41, 0.7, 0});
    disk.density = 2;
    scene.bodies = {disk};
    Simulation<2> simulation(scene, Communicator());
    const double weight = disk.density.value() * M_PI * 0.01 - M_PI * 0.01;
    const double end = 0.8;
    while (simulation.time() < end) {
        simulation.step(end);
        const double work = weight * (0.7 - simulation.bodies()[0].centre()[1]);
        EXPECT_NEAR(kinetic_energy(simulation), work, 0.004 * work + 1e-9);
    }
    EXPECT_LT(simulation.bodies()[0].centre()[1], 0.6);
}

TEST(Step, GoesOnFromAStoredStateBitForBit)
{
    Scene scene = three_bodies<2>();
    scene.gravity = {0, -1, 0};
    scene.bodies[0].density = 3;
    scene.bodies[1].velocity = {0.2, -0.1, 0};
    scene.max_step = 0.02;
    expect_to_go_on<2>(scene);
}

// Sides in planes of the grid at angles of the round-off of a step: they lie in them, not on one side above and on the other below, which made the plates' mouths
// those of other gaps, and a twentieth of the speed with which they are pulled apart one along them.
TEST(Step, SidesInPlanesOfTheGridLieInThemToRoundOff)
{
    std::vector<Twist<2>> first;
    for (const double angle : {0.0, 1e-26, 1e-14}) {
        Scene scene = box_of_fluid(2, 32, SideScene::Kind::wall);
        BodyScene upper = body("upper", BodyScene::ShapeKind::box, {0.5, 0.565, 0}),
                  lower = body("lower", BodyScene::ShapeKind::box, {0.5, 0.435, 0});
        upper.size = lower.size = {0.25, 0.125, 0};
        upper.angle = lower.angle = angle;
        scene.bodies = {upper, lower};
        const Model<2> model(scene, Communicator(), Task::motion);
        const auto at = placed(model, model.bodies, model.masses(model.bodies, 0.0));
        std::vector<Twist<2>> V(model.bodies.size() + model.walls.solids.size(), Twist<2>::Zero());
        V[0] = Twist<2>(0, 1, 0);
        V[1] = Twist<2>(0, -1, 0);
        const std::vector<Twist<2>> P = fluid_impulse(*at, flow_of_twists(*at, V, exact()));
        if (first.empty())
            first = P;
        for (std::size_t s = 0; s < 2; ++s) {
            EXPECT_NEAR(P[s][0], 0, 1e-7 * std::abs(P[s][1])) << angle;
            EXPECT_LT((P[s] - first[s]).norm(), 1e-7 * first[s].norm()) << angle;
        }
    }
}

/// Steps of what lies at rest: it stays so, and nothing is told.
void expect_to_rest(const Scene& scene, int steps)
{
    Simulation<2> simulation(scene, Communicator());
    for (int k = 0; k < steps; ++k) {
        const StepReport report = simulation.step(scene.end);
        EXPECT_THAT(report.notes, ::testing::IsEmpty()) << "step " << k + 1;
        EXPECT_LT(kinetic_energy(simulation), 1e-12) << "step " << k + 1;
    }
}

// Contacts leave of a velocity what is round-off: no impulse may do work along it.
TEST(Step, WhatLiesStaysAtRest)
{
    for (const double viscosity : {0.0, 0.05}) {
        Scene scene = box_of_fluid(2, 40, SideScene::Kind::wall);
        scene.viscosity = viscosity;
        scene.gravity = {0, -9.81, 0};
        scene.max_step = 0.003;
        scene.contact.friction = 1;
        scene.gap.roughness = viscosity > 0 ? 1e-4 : 0;
        BodyScene box = body("box", BodyScene::ShapeKind::box, {0.5772, 0.0457, 0});
        box.size = {0.278, 0.0914, 0};
        box.density = 2;
        scene.bodies = {box};
        expect_to_rest(scene, 15);
    }
}

TEST(Step, ABallOnTwoEdgesStaysAtRest)
{
    for (const double viscosity : {0.0, 0.0066}) {
        Scene scene = box_of_fluid(2, 47, SideScene::Kind::wall);
        scene.size = {0.01175, 0.0135, 0};
        scene.cells = {47, 54, 1};
        scene.viscosity = viscosity;
        scene.gravity = {0, -9.81, 0};
        scene.max_step = 2.7e-4;
        scene.contact.friction = 0.1;
        for (const double x : {0.0021964905076492383, 0.007916798245108329}) {
            BodyScene box = body(x < 0.005 ? "left" : "right", BodyScene::ShapeKind::box, {x, 0.004497489193956284, 0});
            box.size = {0.004029692262540909, 0.00125, 0};
            box.motion = BodyScene::Motion::fixed;
            scene.bodies.push_back(box);
        }
        BodyScene ball = body("ball", BodyScene::ShapeKind::ball, {0.005056644376378784, 0.006310555265515504, 0});
        ball.radius = 0.001458096759957434;
        ball.density = 7.675;
        scene.bodies.push_back(ball);
        Simulation<2> simulation(scene, Communicator());
        for (int k = 0; k < 8; ++k) {
            simulation.step(scene.end);
            EXPECT_LT(kinetic_energy(simulation), 1e-9) << viscosity << " step " << k + 1;
        }
    }
}

} // namespace
} // namespace gapflow
