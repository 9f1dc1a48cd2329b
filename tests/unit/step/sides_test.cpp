// Sides of the domain with a velocity or a pressure of their own, on parts.
#include "unit/step/scenes.hpp"

#include "gapflow/scene/time_table.hpp"
#include "gapflow/step/energy_change.hpp"
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace gapflow {
namespace {

enum class Ends { inflow, pressure };

/// Walls along x; at x = 0 inflow or pressure, the other end open or under pressure 0. `table`: rows of time and value.
template <int D>
Scene channel(int cells, Ends ends, const std::vector<std::pair<double, double>>& table)
{
    Scene scene = box_of_fluid(D, cells, SideScene::Kind::wall);
    scene.tolerance = 1e-12;
    SideScene &low = scene.sides[0], &high = scene.sides[1];
    low.kind = ends == Ends::inflow ? SideScene::Kind::inflow : SideScene::Kind::pressure;
    high.kind = ends == Ends::inflow ? SideScene::Kind::open : SideScene::Kind::pressure;
    for (const auto& [time, value] : table) {
        low.table.time.push_back(time);
        low.table.rows.push_back(ends == Ends::inflow ? std::vector<double>(D, 0.0) : std::vector<double>(1));
        low.table.rows.back()[0] = value;
    }
    if (ends == Ends::pressure)
        high.table = {"", {0}, {{0.0}}};
    return scene;
}

template <int D, class F>
void for_each_cell(const Simulation<D>& simulation, F&& f)
{
    for_each_index<D>(simulation.grid().low(), simulation.grid().high(), f);
}

// The velocity is that of the side everywhere, the pressure that of the acceleration, and at the open end lower by 1/2 rho u^2 than that of fluid at rest beyond.
TEST(Sides, PlugFlow)
{
    Scene scene = channel<2>(16, Ends::inflow, {{0, 0.5}, {0.3, 0.2}, {1, 1.6}});
    scene.density = 3;
    scene.max_step = 0.05;
    Simulation<2> simulation(scene, Communicator());
    while (simulation.time() < 0.6) {
        const double before = value_at(scene.sides[0].table, simulation.time()).at(0);
        const StepReport report = simulation.step(simulation.time() < 0.3 ? 0.3 : 0.6);
        const double u = value_at(scene.sides[0].table, simulation.time()).at(0);
        EXPECT_LT(report.divergence_max, 1e-10);
        EXPECT_NEAR(report.energy_fluid, 0.5 * 3 * u * u, 1e-11);
        const UnknownVector<2> p = simulation.reduced_pressure();
        for_each_cell(simulation, [&](const Index<2>& c) {
            EXPECT_NEAR(simulation.velocity().grid(0, c), u, 1e-11);
            EXPECT_NEAR(simulation.velocity().grid(1, c), 0, 1e-11);
            const double x = simulation.grid().cell_centre(c)[0];
            EXPECT_NEAR(p.cells(c), 3 * ((u - before) / report.dt * (1 - x) - 0.25 * (u * u + before * before)), 1e-9);
        });
    }
}

// dp/(rho L), whatever the table: its integral is exact.
TEST(Sides, AColumnBetweenTwoPressures)
{
    Scene scene = channel<3>(8, Ends::pressure, {{0, 1}, {0.11, 1}, {0.33, -2}, {0.5, 4}});
    scene.density = 2;
    scene.max_step = 0.07;
    Simulation<3> simulation(scene, Communicator());
    double work = 0;
    while (simulation.time() < 0.6) {
        const double t = simulation.time(), before = integral_to(scene.sides[0].table, t).at(0) / 2;
        simulation.step(0.6);
        const double u = integral_to(scene.sides[0].table, simulation.time()).at(0) / 2;
        for_each_cell(simulation, [&](const Index<3>& c) { EXPECT_NEAR(simulation.velocity().grid(0, c), u, 1e-11); });
        work += 0.5 * (u + before) * 2 * (u - before); // pressure integrated over the step by the mean flux
        EXPECT_NEAR(simulation.budget().energy_grid, 0.5 * 2 * u * u, 1e-11);
        EXPECT_NEAR(simulation.budget().energy_grid, work, 1e-11);
    }
    EXPECT_NEAR(integral_to(scene.sides[0].table, 0.6).at(0), 0.11 - 0.11 + 0.17 + 0.4, 1e-12);
}

/// A turned box in the middle of a channel.
BodyScene box_in_channel(double density)
{
    BodyScene box = body("box", BodyScene::ShapeKind::box, {0.47, 0.53, 0});
    box.size = {0.31, 0.17, 0};
    box.angle = 0.4;
    box.density = density;
    return box;
}

// All accelerates as one.
TEST(Sides, ANeutralBodyGoesWithTheFluid)
{
    for (const Ends ends : {Ends::inflow, Ends::pressure}) {
        Scene scene = ends == Ends::inflow ? channel<2>(24, ends, {{0, 0}, {1, 0.5}}) : channel<2>(24, ends, {{0, 0.5}});
        scene.bodies = {box_in_channel(1)};
        scene.max_step = 0.05;
        Simulation<2> simulation(scene, Communicator());
        for (int k = 0; k < 3; ++k)
            simulation.step(100);
        const Twist<2>& V = simulation.bodies()[0].twist;
        EXPECT_NEAR(V[0], 0.5 * simulation.time(), 1e-9);
        EXPECT_NEAR(V[1], 0, 1e-9);
        EXPECT_NEAR(V[2], 0, 1e-8);
        EXPECT_NEAR(simulation.fluid_wrenches()[0][0], 0.5 * 0.31 * 0.17, 1e-9);
    }
}

// A body that is held in a stream which accelerates bears the force of one that accelerates against it in fluid at rest, and the displaced fluid's weight in the
// accelerated frame. Speeds are small: the rest goes as their square.
TEST(Sides, AnAcceleratedStreamHasTheForceOfAnAcceleratedBody)
{
    constexpr double small = 1e-7;
    Scene held = channel<2>(24, Ends::inflow, {{0, 0}, {1, small}}), moved = channel<2>(24, Ends::inflow, {{0, 0}});
    held.max_step = moved.max_step = 0.1;
    BodyScene box = box_in_channel(1);
    box.motion = BodyScene::Motion::fixed;
    held.bodies = {box};
    box.motion = BodyScene::Motion::prescribed;
    moved.bodies = {box};
    moved.follow = FollowScene{"box", {true, false, false}};
    Simulation<2> stream(held, Communicator()), still(moved, Communicator());
    stream.step(100);
    still.set_velocity(0, Vec<2>(-small * stream.time(), 0), Spin<2>::Zero());
    still.step(100);
    const Twist<2> a = stream.fluid_wrenches()[0], b = still.fluid_wrenches()[0];
    EXPECT_NEAR(a[0] - b[0], small * 0.31 * 0.17, 1e-6 * a[0]);
    EXPECT_NEAR(a[1], b[1], 1e-6 * a[0]);
    EXPECT_NEAR(a[2], b[2], 1e-6 * a[0]);
    EXPECT_GT(a[0], 2 * small * 0.31 * 0.17);
}

// Half of a channel is shut from its middle on. By the momentum that enters and leaves, and Bernoulli's pressures there, the step bears 1/2 rho (U^2 H - u^2 h): that is what the
// energy loses where it is put further downstream by whole cells.
TEST(Sides, AStepInAChannelBearsTheDifferenceOfMomentum)
{
    constexpr int cells = 16;
    constexpr double dx = 1.0 / cells, height = 0.53, fast = 1 / (1 - height);
    const auto energy = [&](int shift) {
        Scene scene = channel<2>(cells, Ends::inflow, {{0, 1}});
        scene.size[0] = 6;
        scene.cells[0] = 6 * cells;
        BodyScene step = body("step", BodyScene::ShapeKind::box, {5.02 + shift * dx, height - 0.5, 0});
        step.size = {4, 1, 0};
        step.motion = BodyScene::Motion::fixed;
        scene.bodies = {step};
        scene.max_step = 0.01;
        Simulation<2> simulation(scene, Communicator());
        EXPECT_LT(simulation.step(100).divergence_max, 1e-9);
        const UnknownVector<2> p = simulation.reduced_pressure();
        EXPECT_NEAR(p.cells(Index<2>(0, 2)), -0.5, 1e-3);
        EXPECT_NEAR(p.cells(Index<2>(6 * cells - 1, cells - 2)), -0.5 * fast * fast, 1e-3);
        return simulation.initial_report().energy_fluid;
    };
    EXPECT_NEAR((energy(4) - energy(0)) / (4 * dx), 0.5 * (1 - fast), 1e-4);
}

// Walls that slide in their plane do nothing to ideal fluid, in gaps neither.
template <int D>
void check_sliding()
{
    Scene scene = box_of_fluid(D, D == 2 ? 24 : 12, SideScene::Kind::wall);
    const double dx = scene.spacing();
    BodyScene ball = body("ball", BodyScene::ShapeKind::ball, {0.31, 2.7 * dx, 0.37}, {0.3, 0.2, 0});
    BodyScene plate = body("plate", BodyScene::ShapeKind::box, {0.71, 1.5 * dx, 0.54}, {0.1, 0.1, 0});
    ball.radius = 2.4 * dx;
    plate.size = {4.2 * dx, 2.2 * dx, 4.3 * dx};
    plate.angle = 0.03;
    scene.bodies = {ball};
    if (D == 2)
        scene.bodies.push_back(plate);
    scene.max_step = 0.02;
    scene.tolerance = 1e-12;
    Scene slides = scene;
    slides.sides[2].velocity = {3, 0, D == 2 ? 0.0 : 1.0};
    slides.sides[3].velocity = {-2, 0, 0};
    Simulation<D> a(scene, Communicator()), b(slides, Communicator());
    for (int k = 0; k < (D == 2 ? 4 : 1); ++k) {
        a.step(100);
        b.step(100);
        for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
            EXPECT_LT((a.bodies()[body].twist - b.bodies()[body].twist).norm(), 1e-9);
            EXPECT_LT((a.fluid_wrenches()[body] - b.fluid_wrenches()[body]).norm(), 1e-9);
        }
        EXPECT_NEAR(a.budget().energy_grid, b.budget().energy_grid, 1e-12);
    }
}

TEST(Sides, SlidingWallsDoNothing)
{
    check_sliding<2>();
    check_sliding<3>();
}

/// Three bodies, one through a side, a gap in it.
template <int D>
Scene bodies_in_sides(Ends ends)
{
    Scene scene = channel<D>(D == 2 ? 24 : 12, ends, {{0, 0.7}});
    const double dx = scene.spacing();
    BodyScene first = body("first", BodyScene::ShapeKind::ball, {0.03, 0.41, 0.47}), second = first,
              third = body("third", BodyScene::ShapeKind::ball, {0.6, 0.5, 0.47});
    first.radius = second.radius = third.radius = 2.6 * dx;
    second.name = "second";
    second.position[1] += 5.2 * dx + 0.3 * dx;
    scene.bodies = {first, second, third};
    return scene;
}

// 1/2 z . (Q' - Q) z' of the twists and what is given at the sides, which is the same at both places.
template <int D>
void check_identity(Ends ends)
{
    const Scene scene = bodies_in_sides<D>(ends);
    const Model<D> model(scene, Communicator(), Task::motion);
    SolverOptions options;
    options.tolerance = 1e-13;
    std::vector<RigidBody<D>> moved = model.bodies;
    std::vector<Twist<D>> V = model.twists(moved), next = V;
    for (int b = 0; b < 3; ++b)
        for (int k = 0; k < D; ++k) {
            V[b][k] = std::sin(3.0 * b + k);
            next[b][k] = V[b][k] + 0.2 * std::cos(5.0 * b + k);
            moved[b].pose.position[k] += 0.3 * scene.spacing() * std::cos(1.0 + b + k);
        }
    const GivenSides<D> sides = given_sides(model, 1.0);
    const auto before = placed(model, model.bodies, model.masses(model.bodies, 0.0)),
               after = placed(model, moved, model.masses(moved, 0.0));
    const PotentialFlow<D> a = flow_of_twists(*before, V, options, {}, sides),
                           b = flow_of_twists(*after, next, options, {}, sides);
    const std::vector<Twist<D>> P = fluid_impulse(*before, a), P_next = fluid_impulse(*after, b);
    double whole = (energy_of_sides(*after, b) - energy_of_sides(*before, a)) * (ends == Ends::inflow ? 1 : -1), sum = 0,
           scale = 0;
    for (std::size_t s = 0; s < V.size(); ++s) {
        whole += 0.5 * (V[s].dot(P_next[s]) - next[s].dot(P[s]));
        scale += std::abs(V[s].dot(P_next[s]));
    }
    for (const double part : energy_change(*before, a, *after, b).work)
        sum += part;
    EXPECT_NEAR(sum, whole, 1e-9 * scale);
    EXPECT_GT(std::abs(whole), 1e-4 * scale);
}

TEST(Sides, ChangesOfEnergySumUpToThoseOfTheImpulses)
{
    check_identity<2>(Ends::inflow);
    check_identity<2>(Ends::pressure);
    check_identity<3>(Ends::inflow);
    check_identity<3>(Ends::pressure);
}

// At fixed twists and givens, by the energy of inflow and the Routhian of pressures. Of the bodies that a side cuts, and of the one beside them.
template <int D>
void check_forces(Ends ends)
{
    const Scene scene = bodies_in_sides<D>(ends);
    const Model<D> model(scene, Communicator(), Task::motion);
    SolverOptions options;
    options.tolerance = 1e-13;
    std::vector<Twist<D>> V = model.twists(model.bodies);
    for (int b = 0; b < 3; ++b)
        for (int k = 0; k < D; ++k)
            V[b][k] = std::sin(3.0 * b + k);
    const GivenSides<D> sides = given_sides(model, 1.0);
    const auto flow_at = [&](const Placed<D>& at) { return flow_of_twists(at, V, options, {}, sides); };
    const auto energy = [&](int solid, int component, double way) {
        std::vector<RigidBody<D>> bodies = model.bodies;
        bodies[solid].pose.position[component] += way;
        const auto at = placed(model, bodies, model.masses(bodies, 0.0));
        const PotentialFlow<D> flow = flow_at(*at);
        const std::vector<Twist<D>> P = fluid_impulse(*at, flow);
        double sum = energy_of_sides(*at, flow) * (ends == Ends::inflow ? 1 : -1);
        for (std::size_t s = 0; s < V.size(); ++s)
            sum += 0.5 * V[s].dot(P[s]);
        return sum;
    };
    auto here = placed(model, model.bodies, model.masses(model.bodies, 0.0));
    PotentialFlow<D> flow = flow_at(*here);
    const Instant<D> instant = instant_of<D>(model, model.bodies, std::move(here), std::move(flow));
    const double way = 1e-5 * scene.spacing();
    double largest = 0;
    for (int b = 0; b < 3; ++b)
        largest = std::max(largest, instant.force[b].template head<D>().norm());
    for (int b = 0; b < 2; ++b)
        for (int k = 0; k < D; ++k)
            EXPECT_NEAR(instant.force[b][k], (energy(b, k, way) - energy(b, k, -way)) / (2 * way), 1e-4 * largest)
                << b << " " << k;
}

TEST(Sides, ForcesAreDifferencesOfTheEnergy)
{
    check_forces<2>(Ends::inflow);
    check_forces<2>(Ends::pressure);
    check_forces<3>(Ends::inflow);
    check_forces<3>(Ends::pressure);
}

// The forces of displaced plates, one of which reaches into the side.
TEST(Sides, ForcesAtMouthsAreDifferencesOfTheEnergy)
{
    for (const Ends ends : {Ends::inflow, Ends::pressure}) {
        Scene scene = channel<2>(32, ends, {{0, 0.7}});
        scene.gap.roughness = 0;
        scene.bodies = two_plates(3.0, 16.15, 0.3, 20).bodies;
        const Model<2> model(scene, Communicator(), Task::motion);
        SolverOptions options;
        options.tolerance = 1e-13;
        std::vector<Twist<2>> V = model.twists(model.bodies);
        V[0] << 0.3, -1, 4;
        V[1] << -0.2, 1, -3;
        const GivenSides<2> sides = given_sides(model, 1.0);
        const auto energy = [&](const std::vector<RigidBody<2>>& bodies) {
            const auto at = placed(model, bodies, model.masses(bodies, 0.0));
            const PotentialFlow<2> flow = flow_of_twists(*at, V, options, {}, sides);
            const std::vector<Twist<2>> P = fluid_impulse(*at, flow);
            return 0.5 * (V[0].dot(P[0]) + V[1].dot(P[1])) + energy_of_sides(*at, flow) * (ends == Ends::inflow ? 1 : -1);
        };
        auto here = placed(model, model.bodies, model.masses(model.bodies, 0.0));
        PotentialFlow<2> flow = flow_of_twists(*here, V, options, {}, sides);
        const Instant<2> instant = instant_of<2>(model, model.bodies, std::move(here), std::move(flow));
        ASSERT_EQ(instant.displaced.size(), 6u);
        double largest = 0;
        for (const Twist<2>& force : instant.force)
            largest = std::max(largest, force.norm());
        for (const Displaced<2>& one : instant.displaced) {
            std::array<double, 2> value;
            for (int end = 0; end < 2; ++end) {
                std::vector<RigidBody<2>> there = model.bodies;
                Twist<2> by = Twist<2>::Zero();
                by[one.component] = (end ? 0.5 : -0.5) * one.way;
                displace<2>(there[one.solid], by.head<2>(), by.tail<1>());
                value[end] = energy(there);
            }
            EXPECT_NEAR(instant.force[one.solid][one.component], (value[1] - value[0]) / one.way, 2e-5 * largest)
                << one.solid << " " << one.component;
        }
    }
}

TEST(Sides, GoOnFromAStoredStateBitForBit)
{
    for (const Ends ends : {Ends::inflow, Ends::pressure}) {
        Scene scene = channel<2>(24, ends, {{0, 0.1}, {1, 0.7}});
        scene.bodies = {box_in_channel(2)};
        scene.max_step = 0.03;
        expect_to_go_on<2>(scene);
    }
}

} // namespace
} // namespace gapflow
