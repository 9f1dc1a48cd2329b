// A simulation that goes on from its stored state does what it would have done: bit for bit.
#include "gapflow/step/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <numeric>

namespace gapflow {
namespace {

BodyScene body(const std::string& name, BodyScene::ShapeKind shape, const Triple& position, double density)
{
    BodyScene b;
    b.name = name;
    b.shape = shape;
    b.position = position;
    b.density = density;
    return b;
}

// A tilted box sinks towards the floor over a film, a ball rolls and slides on it, another is driven over a hinged flap; water
// flows in from the left.
Scene crowd(int dimension)
{
    const bool flat = dimension == 2;
    const int n = flat ? 24 : 10;
    const double z = flat ? 0 : 0.52;
    Scene scene;
    scene.dimension = dimension;
    scene.size = {3, 1, flat ? 0.0 : 1.0};
    scene.cells = {3 * n, n, flat ? 1 : n};
    scene.gravity = {0, -1, 0};
    scene.end = 100;
    scene.max_step = 0.02;
    scene.sides[0].kind = SideScene::Kind::inflow;
    scene.sides[0].velocity = {0.05, 0, 0};
    scene.sides[1].kind = SideScene::Kind::open;
    if (!flat)
        scene.sides[4].kind = scene.sides[5].kind = SideScene::Kind::periodic;
    scene.contact.friction = 0.3;
    scene.contact.restitution = 0.2;

    BodyScene box = body("box", BodyScene::ShapeKind::box, {0.9, 0.2 + 0.6 / n, z}, 3);
    box.size = {0.6, 0.4, 0.5};
    BodyScene ball = body("ball", BodyScene::ShapeKind::ball, {1.6, 0.2, z}, 3);
    ball.radius = 0.2;
    ball.velocity = {0.3, 0, 0};
    BodyScene flap = body("flap", BodyScene::ShapeKind::box, {2.3, 0.5, z}, 2);
    flap.size = {0.3, 0.3, 0.4};
    flap.hinge = HingeScene{{2.3, 0.8, z}, {flat ? 1.0 : 0.0, 0, 1}}; // 2D: the axis is 1
    flap.angular_velocity = {flat ? 0.3 : 0.0, 0, flat ? 0.0 : 0.3};
    flap.spring = SpringScene{{2.35, 0.5, z}, 2.0, 0.1};
    BodyScene driven = body("driven", BodyScene::ShapeKind::ball, {1.6, 0.75, z}, 1);
    driven.radius = 0.15;
    driven.motion = BodyScene::Motion::prescribed;
    driven.velocity = {0.1, 0.02, 0};
    scene.bodies = {box, ball, flap, driven};
    return scene;
}

// Bitwise: NaN is NaN and 0 is not -0.
template <class Map>
void expect_same(const Map& a, const Map& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [name, values] : a) {
        const auto other = b.find(name);
        ASSERT_NE(other, b.end()) << name;
        ASSERT_EQ(values.size(), other->second.size()) << name;
        EXPECT_EQ(std::memcmp(values.data(), other->second.data(), values.size() * sizeof values[0]), 0) << name;
    }
}

void expect_same(const StoredState& a, const StoredState& b)
{
    expect_same(a.numbers, b.numbers);
    expect_same(a.integers, b.integers);
    expect_same(a.fields, b.fields);
}

template <int D>
void expect_same_future(const Scene& scene, int before, int after)
{
    const Communicator comm;
    Simulation<D> one(scene, comm);
    for (int i = 0; i < before; ++i)
        one.step(scene.end);
    const StoredState stored = one.state();
    Simulation<D> two(scene, comm, stored);
    expect_same(two.state(), stored);
    EXPECT_EQ(two.steps(), before);
    bool any_contact = false, any_film = false, any_mouth = false;
    for (int i = 0; i < after; ++i) {
        const StepReport a = one.step(scene.end), b = two.step(scene.end);
        EXPECT_EQ(a.dt, b.dt);
        EXPECT_EQ(a.iterations, b.iterations);
        EXPECT_EQ(a.residual, b.residual);
        EXPECT_EQ(a.divergence_max, b.divergence_max);
        EXPECT_EQ(a.energy_fluid, b.energy_fluid);
        const std::vector<GapState> gaps_a = one.gaps(), gaps_b = two.gaps();
        ASSERT_EQ(gaps_a.size(), gaps_b.size());
        for (std::size_t k = 0; k < gaps_a.size(); ++k) {
            EXPECT_EQ(gaps_a[k].force, gaps_b[k].force);
            EXPECT_EQ(gaps_a[k].opening_rate, gaps_b[k].opening_rate);
            any_contact = any_contact || gaps_a[k].contact_impulse > 0;
        }
        any_film = any_film || !one.coupling().network.films.empty();
        any_mouth = any_mouth || !one.coupling().network.rim.mouths.empty();
        ASSERT_FALSE(::testing::Test::HasFailure()) << "step " << i;
    }
    expect_same(one.state(), two.state());
    EXPECT_TRUE(any_contact && any_film && any_mouth) << "the scene must have what the test is about";
}

TEST(State, SameFutureIn2D)
{
    expect_same_future<2>(crowd(2), 20, 20);
}

TEST(State, SameFutureIn3D)
{
    expect_same_future<3>(crowd(3), 8, 8);
}

// The pressure from before an impact is in the checkpoint.
TEST(State, SameFutureAfterAnImpact)
{
    Simulation<2> simulation(crowd(2), Communicator());
    int before = 0;
    const auto has_met = [&] { // by what every rank has: fields are on the root alone
        const StoredState stored = simulation.state();
        const auto any = [](const auto& arrays) {
            const auto first = arrays.lower_bound("before_impact/");
            return first != arrays.end() && first->first.starts_with("before_impact/");
        };
        return any(stored.numbers) || any(stored.integers);
    };
    for (; before < 40 && !has_met(); ++before)
        simulation.step(100);
    ASSERT_TRUE(has_met());
    expect_same_future<2>(crowd(2), before, 10);
}

// The conductance of mouths with their heads limits the next step and says how much of a gap's change drag takes: a ball touches a box.
TEST(State, SameFutureInViscousContact)
{
    Scene scene;
    scene.size = {1, 1, 0};
    scene.cells = {16, 16, 1};
    scene.gravity = {0, -1, 0};
    scene.viscosity = 0.195;
    scene.end = 100;
    scene.max_step = 0.005;
    scene.contact.friction = 0.3;
    BodyScene ball = body("ball", BodyScene::ShapeKind::ball, {0.582, 0.679, 0}, 50);
    ball.radius = 0.0996;
    ball.velocity = {0.055, -0.0684, 0};
    BodyScene box = body("box", BodyScene::ShapeKind::box, {0.4264, 0.5725, 0}, 0.5);
    box.size = {0.1033, 0.171, 0};
    box.angle = -0.0969;
    box.velocity = {0.0098, -0.0498, 0};
    box.angular_velocity = {-0.63, 0, 0};
    scene.bodies = {ball, box};
    expect_same_future<2>(scene, 3, 5);
}

// Two plates that touch dry are pulled apart: a void grows, breaks off from the rim and drains.
template <int D>
void expect_same_voids(int before, int after)
{
    const bool flat = D == 2;
    Scene scene;
    scene.dimension = D;
    const int n = flat ? 32 : 12;
    scene.size = {2, 2, flat ? 0.0 : 2.0};
    scene.cells = {n, n, flat ? 1 : n};
    scene.sides[3].kind = SideScene::Kind::open;
    scene.reference_pressure = 0.3;
    scene.end = 100;
    scene.max_step = 0.05;
    scene.gap.contact = GapScene::Contact::dry;
    scene.contact.thickness = 1e-3;
    const double z = flat ? 0 : 1.02;
    BodyScene lower = body("lower", BodyScene::ShapeKind::box, {1, 0.6, z}, 2), upper = lower;
    lower.size = upper.size = {0.8, 0.4, 0.7};
    lower.motion = BodyScene::Motion::fixed;
    upper.name = "upper";
    upper.position[1] = 1.001;
    upper.force = {0.01, 1, 0};
    scene.bodies = {lower, upper};
    const Communicator comm;
    Simulation<D> one(scene, comm);
    for (int i = 0; i < before; ++i)
        one.step(scene.end);
    const std::vector<double>& volume = one.voids().volume();
    ASSERT_GT(std::accumulate(volume.begin(), volume.end(), 0.0), 0) << "the checkpoint must have voids";
    const StoredState stored = one.state();
    Simulation<D> two(scene, comm, stored);
    expect_same(two.state(), stored);
    EXPECT_EQ(two.initial_report().divergence_max > 1e-6, false);
    for (int i = 0; i < after; ++i) {
        EXPECT_EQ(one.step(scene.end).divergence_max, two.step(scene.end).divergence_max);
        ASSERT_EQ(one.gaps()[0].void_volume, two.gaps()[0].void_volume) << "step " << i;
    }
    expect_same(one.state(), two.state());
}

TEST(State, SameFutureOfVoidsIn2D)
{
    expect_same_voids<2>(10, 20);
}

TEST(State, SameFutureOfVoidsIn3D)
{
    expect_same_voids<3>(6, 8);
}

TEST(State, SameFutureFromTheStart)
{
    expect_same_future<2>(crowd(2), 0, 10);
}

TEST(State, AccelerationLimitsTheNextStep)
{
    Scene scene;
    scene.size = {2, 1, 0};
    scene.cells = {32, 16, 1};
    scene.gravity = {0, -1, 0};
    scene.sides[3].kind = SideScene::Kind::open;
    scene.end = 100;
    scene.max_step = 1;
    scene.gap_cfl = 0.01;
    scene.bodies = {body("box", BodyScene::ShapeKind::box, {0.97, 0.25, 0}, 3)};
    scene.bodies[0].size = {0.6, 0.4, 0};
    const Communicator comm;
    Simulation<2> one(scene, comm);
    one.step(1e-5); // from rest: the box hardly moves yet
    Simulation<2> two(scene, comm, one.state());
    const double dt = one.step(scene.end).dt;
    EXPECT_LT(dt, 0.5);
    EXPECT_EQ(two.step(scene.end).dt, dt);
}

TEST(State, RefusesAnotherScene)
{
    using testing::HasSubstr;
    const Communicator comm;
    const StoredState stored = Simulation<2>(crowd(2), comm).state();
    auto refusal = [&](const std::function<void(Scene&, StoredState&)>& change) {
        Scene scene = crowd(2);
        StoredState state = stored;
        change(scene, state);
        try {
            Simulation<2>(scene, comm, state);
        } catch (const StateError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_EQ(refusal([](Scene&, StoredState&) {}), "accepted");
    EXPECT_THAT(refusal([](Scene& scene, StoredState&) {
                    scene.cells = {36, 12, 1};
                }),
                HasSubstr("'velocity_x' is not of this"));
    EXPECT_THAT(refusal([](Scene& scene, StoredState&) { scene.bodies.pop_back(); }),
                HasSubstr("it has 4 bodies, the scene 3"));
    EXPECT_THAT(refusal([](Scene& scene, StoredState&) { scene.bodies[1].radius = 0.19; }), HasSubstr("'bodies/mass' was "));
    EXPECT_THAT(refusal([](Scene&, StoredState& s) { s.numbers.erase("time"); }), HasSubstr("it holds no 'time'"));
    EXPECT_THAT(refusal([](Scene&, StoredState& s) { s.numbers["bodies/twist"].pop_back(); }),
                HasSubstr("too few values of 'bodies/twist'"));
    EXPECT_THAT(refusal([](Scene&, StoredState& s) { s.numbers["more"] = {1}; }), HasSubstr("'more' that nothing asks for"));
}

} // namespace
} // namespace gapflow
