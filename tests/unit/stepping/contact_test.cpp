// Contact inside the coupled solve: rest, impact, friction, stacks.
#include "gapflow/scene/parse_scene.hpp"
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/added_mass.hpp"
#include "gapflow/stepping/contact_cones.hpp"
#include "gapflow/stepping/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

BodyScene box(const std::string& name, const Triple& size, const Triple& position)
{
    BodyScene b;
    b.name = name;
    b.shape = BodyScene::ShapeKind::box;
    b.size = size;
    b.position = position;
    b.density = 2.0;
    return b;
}

// A tank of unit cells' width 1/16 with an open top, gravity 1 downwards.
Scene tank(int dimension)
{
    Scene scene;
    scene.dimension = dimension;
    scene.size = dimension == 2 ? Triple{2, 1, 0} : Triple{1, 1, 1};
    scene.cells = dimension == 2 ? std::array<int, 3>{32, 16, 1} : std::array<int, 3>{16, 16, 16};
    scene.sides[2 * dimension - 1].kind = SideScene::Kind::open;
    scene.gravity[dimension - 1] = -1;
    scene.end = 1;
    scene.max_step = 0.02;
    return scene;
}

template <int D>
void check_rest()
{
    Scene scene = tank(D);
    const double height = 0.3, z = 0.5 * height;
    scene.bodies = {D == 2 ? box("box", {0.6, height, 0}, {0.97, z, 0}) : box("box", {0.4, 0.5, height}, {0.47, 0.52, z})};
    Simulation<D> simulation(scene, Communicator());
    const double volume = D == 2 ? 0.6 * height : 0.4 * 0.5 * height;
    for (int i = 0; i < 20; ++i) {
        const StepReport report = simulation.step(scene.end);
        const std::vector<GapState> gaps = simulation.gaps();
        ASSERT_EQ(gaps.size(), 1u);
        if (i > 0) { // the first step finds the contacts
            EXPECT_NEAR(gaps[0].contact_force, volume, 1e-6 * volume);
        }
        EXPECT_LT(simulation.bodies()[0].twist.norm(), 1e-10);
        EXPECT_LT(report.divergence_max, 1e-8);
    }
    EXPECT_NEAR(simulation.bodies()[0].pose.position[D - 1], z, 1e-12);
}

/// Of grid, films and bodies.
double whole_energy(const Simulation<2>& simulation)
{
    const auto budget = simulation.budget();
    return budget.energy_grid + budget.energy_film + budget.energy_bodies;
}

TEST(ContactSet, BoxRestsWithItsWeightLessBuoyancy2D)
{
    check_rest<2>();
}

TEST(ContactSet, BoxRestsWithItsWeightLessBuoyancy3D)
{
    check_rest<3>();
}

TEST(ContactSet, ReboundInAVeryLightFluid)
{
    for (double restitution : {0.0, 0.5, 1.0}) {
        Scene scene = tank(2);
        scene.density = 1e-6;
        scene.gravity = {};
        scene.contact.restitution = restitution;
        BodyScene ball;
        ball.name = "ball";
        ball.radius = 0.2;
        ball.position = {1, 0.3, 0};
        ball.velocity = {0.1, -1, 0};
        ball.density = 1;
        scene.bodies = {ball};
        Simulation<2> simulation(scene, Communicator());
        while (simulation.time() < 0.15)
            simulation.step(0.15);
        EXPECT_NEAR(simulation.bodies()[0].twist[1], restitution, 1e-3);
        EXPECT_NEAR(simulation.bodies()[0].twist[0], 0.1, 1e-3);
        EXPECT_GT(simulation.bodies()[0].pose.position[1], 0.2 - 1e-3 / 16);
    }
}

// Two plates and the film between them, until a layer is left; the film goes on outwards while the plates turn round.
TEST(ContactSet, PlatesReboundFromALayerOfFluidWithoutMoreEnergy)
{
    Scene scene;
    scene.size = {4, 4, 0};
    scene.cells = {64, 64, 1};
    scene.initial = Scene::Initial::potential;
    scene.gap.roughness = 0.002;
    scene.gap.exit = GapScene::Exit::reversible;
    scene.contact.restitution = 1;
    for (int side : {-1, 1}) {
        BodyScene plate = box(side < 0 ? "lower" : "upper", {1, 0.5, 0}, {2, 2 + side * 0.255, 0});
        plate.velocity = {0, -0.5 * side, 0};
        scene.bodies.push_back(plate);
    }
    scene.end = 0.06;
    scene.max_step = 0.005;
    scene.cfl = 0.5;
    scene.gap_cfl = 0.125;
    Simulation<2> simulation(scene, Communicator());
    const auto energy = [&] { return whole_energy(simulation); };
    const double before = energy();
    double most = 0;
    while (simulation.time() < scene.end) {
        simulation.step(scene.end);
        most = std::max(most, energy());
    }
    EXPECT_GT(simulation.bodies()[1].twist[1], 0.2);
    EXPECT_LT(most, 1.001 * before);
}

// A box hits the wall with a corner, from a gap and in touch with it. What transport and heads do to the wedge's film in the step of the impact, for a flow that is to go on as it
// was, gave it 6 % of the energy (random scene 372); in viscous fluid so did a rebound with the speed from before the step, of which drag leaves less (470).
TEST(ContactSet, BoxReboundsOnItsCornerWithoutMoreEnergy)
{
    Scene scene;
    scene.size = {1.2, 1.2, 0};
    scene.cells = {48, 48, 1};
    scene.initial = Scene::Initial::potential;
    scene.contact.restitution = 1;
    scene.end = 1;
    scene.bodies = {box("box", {0.24, 0.32, 0}, {0.6, 0, 0})};
    scene.bodies[0].angle = 0.15;
    scene.bodies[0].density = 0.35;
    scene.bodies[0].velocity = {0, 1, 0};
    const double half = 0.5 * (0.24 * std::sin(0.15) + 0.32 * std::cos(0.15));
    scene.gap.roughness = 1e-4;
    for (const auto& [viscosity, gap] : {std::pair(0.0, 0.0), std::pair(0.0, 1e-3), std::pair(1e-3, 0.0)}) {
        scene.viscosity = viscosity;
        scene.max_step = viscosity > 0 ? 0.02 : 0.001;
        scene.bodies[0].position[1] = 1.2 - half - gap;
        Simulation<2> simulation(scene, Communicator());
        const auto energy = [&] { return whole_energy(simulation); };
        const double before = energy();
        double most = 0;
        for (int i = 0; i < 8; ++i) {
            simulation.step(scene.end);
            most = std::max(most, energy());
        }
        EXPECT_LT(simulation.bodies()[0].twist[1], 0.8) << viscosity << " " << gap; // it has met the wall
        EXPECT_LT(most, 1.002 * before) << viscosity << " " << gap;
    }
}

// It falls flat: the last film's inertia is ten thousand times the box's, and a rebound against it would need as much energy.
TEST(ContactSet, BoxThatFallsFlatGainsNoEnergyByRestitution)
{
    Scene scene;
    scene.size = {1, 1, 0};
    scene.cells = {32, 32, 1};
    scene.contact.restitution = 0.5;
    scene.bodies = {box("box", {0.3, 0.15, 0}, {0.5, 0.12, 0})};
    scene.bodies[0].angle = 2 * std::numbers::pi / 180;
    scene.bodies[0].velocity = {-0.1, -0.3, 0};
    scene.end = 0.25;
    scene.max_step = 0.01;
    Simulation<2> simulation(scene, Communicator());
    const auto energy = [&] { return whole_energy(simulation); };
    const double before = energy();
    while (simulation.time() < scene.end) {
        simulation.step(scene.end);
        ASSERT_LT(energy(), 1.001 * before);
    }
}

TEST(ContactSet, BlockSlidesBeyondTheAngleOfFriction)
{
    for (double friction : {0.297, 0.303}) {
        Scene scene = tank(2);
        scene.gravity = {0.3, -1, 0};
        scene.contact.friction = friction;
        scene.bodies = {box("block", {0.6, 0.3, 0}, {0.8, 0.15, 0})};
        Simulation<2> simulation(scene, Communicator());
        while (simulation.time() < 0.2)
            simulation.step(0.2);
        const double moved = simulation.bodies()[0].pose.position[0] - 0.8;
        if (friction > 0.3)
            EXPECT_LT(std::abs(moved), 1e-9);
        else { // its weight's share along the floor, less friction, moves it and the fluid around
            const double mass = simulation.bodies()[0].mass, weight = mass - scene.density * 0.6 * 0.3;
            const double surge = added_mass(scene, Communicator()).matrix(0, 0);
            const double way = 0.5 * 0.2 * 0.2 * (0.3 - friction) * weight / (mass + surge);
            EXPECT_NEAR(moved / way, 1, 0.05);
        }
    }
}

TEST(ContactSet, StackStandsWithoutOverlap)
{
    Scene scene = tank(2);
    scene.contact.friction = 0.3;
    for (int i = 0; i < 3; ++i)
        scene.bodies.push_back(box("box" + std::to_string(i), {0.5, 0.2, 0}, {1 + 0.03 * (i % 2), 0.1 + 0.2 * i, 0}));
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 25; ++i) {
        simulation.step(scene.end);
        for (const GapState& gap : simulation.gaps())
            EXPECT_GT(gap.thickness, -1e-3 / 16);
    }
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(simulation.bodies()[i].pose.position[1], 0.1 + 0.2 * i, 1e-6);
        EXPECT_LT(simulation.bodies()[i].twist.norm(), 1e-6);
    }
}

TEST(ContactSet, OverlapIsTakenOutWithoutMomentum)
{
    Scene scene = tank(2);
    scene.gravity = {};
    BodyScene left;
    left.name = "left";
    left.radius = 0.2;
    left.position = {0.8, 0.5, 0};
    left.density = 2;
    BodyScene right = left;
    right.name = "right";
    right.position = {0.8 + 0.4 - 1e-3, 0.5, 0};
    scene.bodies = {left, right};
    Simulation<2> simulation(scene, Communicator());
    simulation.step(scene.end);
    const auto& bodies = simulation.bodies();
    EXPECT_NEAR((bodies[1].pose.position - bodies[0].pose.position).norm(), 0.4, 1e-9);
    EXPECT_NEAR(bodies[0].pose.position[0] + bodies[1].pose.position[0], 2.0 - 1e-3, 1e-12);
    EXPECT_LT(bodies[0].twist.norm(), 1e-12);
}

// What is pushed out of one body must not be left in the next, though that was out of reach at first.
TEST(ContactSet, OverlapIsTakenOutThroughABody)
{
    Scene scene = tank(2);
    scene.gravity = {};
    const double dx = 1.0 / 16;
    for (const double x : {0.6, 1.0 - 0.09 * dx, 1.4 - 0.06 * dx}) {
        BodyScene ball;
        ball.name = "ball" + std::to_string(scene.bodies.size());
        ball.radius = 0.2;
        ball.position = {x, 0.5, 0};
        ball.density = 2;
        scene.bodies.push_back(ball);
    }
    Simulation<2> simulation(scene, Communicator());
    simulation.step(scene.end);
    const auto& bodies = simulation.bodies();
    for (int i = 0; i < 2; ++i)
        EXPECT_GT(bodies[i + 1].pose.position[0] - bodies[i].pose.position[0], 0.4 - 1e-5 * dx);
    EXPECT_NEAR(bodies[0].pose.position[0] + bodies[1].pose.position[0] + bodies[2].pose.position[0], 3.0 - 0.15 * dx, 1e-12);
}

// A light capsule falls onto the corner of a box and rolls over it, its film closing by a twentieth a step: what the mouths throw out must
// not be more than what the film gives away. With a fixed margin of 1.3 the energy grew by a factor of 1e13.
TEST(ContactSet, RollingOverACornerGainsNoEnergy)
{
    Scene scene = tank(2);
    scene.size = {1, 1, 0};
    scene.cells = {32, 32, 1};
    scene.max_step = 0.01;
    scene.contact.restitution = 0.5;
    scene.gap.roughness = 1e-3;
    scene.bodies.resize(2);
    BodyScene &box = scene.bodies[0], &capsule = scene.bodies[1];
    box.name = "box";
    box.shape = BodyScene::ShapeKind::box;
    box.size = {0.2228076, 0.1805747, 0};
    box.position = {0.411376, 0.2402691, 0};
    box.velocity = {-0.4424482, 0.235415, 0};
    box.angle = 107.9271 * std::numbers::pi / 180;
    box.density = 2;
    capsule.name = "capsule";
    capsule.shape = BodyScene::ShapeKind::capsule;
    capsule.radius = capsule.length = 0.06466197;
    capsule.position = {0.4442307, 0.5626517, 0};
    capsule.velocity = {-0.0954859, -0.5921148, 0};
    capsule.angle = 234.6267 * std::numbers::pi / 180;
    capsule.density = 0.5;
    Simulation<2> simulation(scene, Communicator());
    auto energy = [&] {
        const Budget<2> budget = simulation.budget();
        double potential = 0;
        for (const auto& body : simulation.bodies()) // less that of the fluid displaced
            potential += (body.mass - scene.density * body.volume) * body.pose.position[1];
        return budget.energy_grid + budget.energy_film + budget.energy_bodies + potential;
    };
    const double start = energy();
    int steps = 0;
    for (; simulation.time() < 0.3 && steps < 400; ++steps)
        simulation.step(0.3);
    EXPECT_LT(steps, 400); // 187
    EXPECT_LT(energy(), start);
}

// A ball meets the wall in a step of a thousandth of the others, and the shock goes through the whole tank. The other bodies
// move on with their new velocities, not with a shock's acceleration over a common step (then one went a cell in a step from rest).
TEST(ContactSet, AnImpactElsewhereThrowsNoBody)
{
    Scene scene = tank(2);
    scene.gravity = {};
    scene.sides[3].kind = SideScene::Kind::wall;
    scene.initial = Scene::Initial::potential;
    BodyScene ball = box("ball", {}, {0.65, 0.62, 0}), ram = box("ram", {}, {0.22, 0.45, 0});
    ball.shape = ram.shape = BodyScene::ShapeKind::ball;
    ball.radius = ram.radius = 0.2;
    ram.density = 8;
    ram.velocity = {-1, 0, 0};
    scene.bodies = {ram, ball};
    Simulation<2> simulation(scene, Communicator());
    bool met = false;
    double shortest = 1;
    for (int step = 0; step < 300 && simulation.time() < 0.3; ++step) {
        const RigidBody<2> before = simulation.bodies()[1];
        const StepReport report = simulation.step(scene.end);
        const RigidBody<2>& after = simulation.bodies()[1];
        shortest = std::min(shortest, report.dt);
        for (const GapState& gap : simulation.gaps())
            met = met || gap.contact_impulse > 0;
        const double speed = std::max(before.twist.head<2>().norm(), after.twist.head<2>().norm());
        EXPECT_LE((after.pose.position - before.pose.position).norm(), 1.5 * report.dt * speed + 1e-3 * simulation.grid().dx());
    }
    EXPECT_TRUE(met);
    EXPECT_LT(shortest, 1e-4);
}

// A ball pushed along a floor that it rests on gains what the push does. The floor is one solid however many periods wide: the
// ball and it have one film.
TEST(ContactSet, BallSlidesAlongAPeriodicFloor)
{
    Scene scene = tank(3);
    scene.cells = {20, 20, 20};
    scene.sides[5].kind = SideScene::Kind::wall;
    for (int side = 0; side < 4; ++side)
        scene.sides[side].kind = SideScene::Kind::periodic;
    scene.gravity = {0.3, 0.1, -1};
    scene.max_step = 0.005;
    BodyScene ball;
    ball.name = "ball";
    ball.radius = 0.2;
    ball.position = {0.511, 0.527, 0.2};
    ball.density = 2.5;
    scene.bodies = {ball};
    Simulation<3> simulation(scene, Communicator());
    while (simulation.time() < 0.2)
        simulation.step(0.2);
    ASSERT_EQ(simulation.gaps().size(), 1u);
    const Vec<3> moved = simulation.bodies()[0].pose.position - Vec<3>(0.511, 0.527, 0.2);
    EXPECT_NEAR(moved[1], moved[0] / 3, 0.02 * moved[0]);
    EXPECT_NEAR(moved[2], 0, 1e-9);
    const double work = (2.5 - 1) * simulation.bodies()[0].volume * (0.3 * moved[0] + 0.1 * moved[1]);
    const Budget<3> budget = simulation.budget();
    EXPECT_NEAR(budget.energy_grid + budget.energy_film + budget.energy_bodies, work, 0.01 * work);
}

// Its rates at the wall are round-off, and no measure of whether it can give way.
TEST(ContactSet, BallSlidesUpAWallThatItHasMet)
{
    Scene scene = tank(2);
    scene.size = {1, 1, 0};
    scene.cells = {32, 32, 1};
    scene.max_step = 0.01;
    scene.contact.friction = 0.3;
    scene.gap.roughness = 1e-3;
    scene.gap.threshold = 1.5; // ends of narrower films add up to 0.4 % in a step as they pass a cell, before the ball arrives
    BodyScene ball;
    ball.name = "ball";
    ball.shape = BodyScene::ShapeKind::ball;
    ball.radius = 0.09;
    ball.position = {0.9, 0.3, 0};
    ball.velocity = {0.3, 0.4, 0};
    ball.density = 8;
    scene.bodies = {ball};
    Simulation<2> simulation(scene, Communicator());
    double energy = simulation.initial_report().energy_fluid + simulation.initial_report().energy_bodies;
    while (simulation.time() < 0.12) {
        const StepReport report = simulation.step(0.12);
        EXPECT_LT(report.energy_fluid + report.energy_bodies, 1.001 * energy);
        energy = report.energy_fluid + report.energy_bodies;
    }
    EXPECT_NEAR(simulation.bodies()[0].pose.position[0], 1 - 0.09 - 1e-3, 1e-6);
}

// A heavy box in a tank's upper corner falls along the side wall, which only the fluid presses it to: that is no impact, and its place goes
// on in second order.
TEST(ContactSet, BoxFallsAlongAWallAsFreely)
{
    Scene scene = tank(2);
    scene.sides[3].kind = SideScene::Kind::wall;
    scene.bodies = {box("box", {0.27, 0.285, 0}, {0.135, 1 - 0.1425, 0})};
    scene.bodies[0].density = 700;
    scene.gap.automatic_roughness = true;
    scene.gap.roughness = automatic_roughness / 16;
    scene.max_step = 0.0085;
    Simulation<2> simulation(scene, Communicator());
    const auto& body = simulation.bodies()[0];
    const double from = body.pose.position[1], pull = 1 - 1 / 700.0;
    while (simulation.time() < 0.4)
        simulation.step(0.4);
    EXPECT_GT(from - body.pose.position[1], 0.07);
    const double gained = 0.5 * body.twist.head<2>().squaredNorm() / (pull * (from - body.pose.position[1]));
    EXPECT_LT(gained, 1.003);
    EXPECT_GT(gained, 0.98);
}

// The automatic roughness holds bodies as the same number does: one that falls comes to rest there, one that starts in touch stays where it is.
TEST(ContactSet, AutomaticRoughnessHoldsAsItsNumberDoes)
{
    Scene scene = tank(2);
    scene.gap.roughness = automatic_roughness / 16;
    scene.bodies = {box("box", {0.3, 0.2, 0}, {1.5, 0.1, 0})};
    BodyScene ball;
    ball.name = "ball";
    ball.shape = BodyScene::ShapeKind::ball;
    ball.radius = 0.2;
    ball.position = {0.5, 0.3, 0};
    ball.density = 5;
    scene.bodies.push_back(ball);
    double heights[2];
    for (const bool automatic : {false, true}) {
        scene.gap.automatic_roughness = automatic;
        Simulation<2> simulation(scene, Communicator());
        while (simulation.time() < 1.5)
            simulation.step(1.5);
        heights[automatic] = simulation.bodies()[1].pose.position[1] - 0.2;
        EXPECT_NEAR(simulation.bodies()[0].pose.position[1] - 0.1, automatic ? 0 : scene.gap.roughness, 1e-7);
    }
    EXPECT_NEAR(heights[1], scene.gap.roughness, 1e-3 * scene.gap.roughness);
    EXPECT_NEAR(heights[0], scene.gap.roughness, 1e-3 * scene.gap.roughness);
}

// A heavy ball pushes a light one down: a contact that closes changes nothing of the heavy one's fall, which goes on in second order.
TEST(ContactSet, AHeavyBallThatStrikesALightOneFallsOn)
{
    Scene scene = tank(2);
    scene.gap.roughness = 1e-3;
    scene.max_step = 0.02;
    for (double y : {0.8, 0.5 - 2e-3}) {
        BodyScene ball;
        ball.name = y > 0.6 ? "heavy" : "light";
        ball.shape = BodyScene::ShapeKind::ball;
        ball.radius = y > 0.6 ? 0.2 : 0.1;
        ball.position = {1 + (y > 0.6 ? 0 : 0.03), y, 0};
        ball.density = y > 0.6 ? 1e4 : 3;
        scene.bodies.push_back(ball);
    }
    Simulation<2> simulation(scene, Communicator());
    const double from = simulation.bodies()[0].pose.position[1], pull = 1 - 1e-4;
    int closed = 0;
    while (simulation.time() < 0.2) {
        simulation.step(0.2);
        for (const GapState& gap : simulation.gaps())
            closed += gap.contact_force > 0;
    }
    EXPECT_GT(closed, 0);
    const RigidBody<2>& heavy = simulation.bodies()[0];
    EXPECT_NEAR(0.5 * heavy.twist.head<2>().squaredNorm() / (pull * (from - heavy.pose.position[1])), 1, 2e-3);
}

// Boxes that tumble onto each other: the bodies' own laws forecast what holds, sticks and slides.
TEST(ContactSet, TumblingBoxesTakeFewIterations)
{
    Scene scene = tank(2);
    scene.contact.friction = 0.3;
    for (int i = 0; i < 4; ++i) {
        scene.bodies.push_back(box("box" + std::to_string(i), {0.3, 0.2, 0}, {0.5 + 0.31 * i, 0.22 + 0.1 * (i % 2), 0}));
        scene.bodies.back().angle = 0.35 + 0.45 * i;
    }
    Simulation<2> simulation(scene, Communicator());
    int most = 0;
    double highest = 0;
    for (int i = 0; i < 60; ++i) {
        const StepReport report = simulation.step(scene.end);
        most = std::max(most, report.iterations);
        highest = std::max(highest, report.energy_fluid + report.energy_bodies);
        for (const GapState& gap : simulation.gaps())
            EXPECT_GT(gap.thickness, -2e-3 / 16);
    }
    EXPECT_LE(most, 80);
    EXPECT_LT(highest, 0.1);
}

// A bed of boxes and balls that share their weight in many ways and slide on each other: what the solves of a step tell of the bodies' response makes
// sets and friction settle in a few. (Without that this one takes 6.8 to 8.5 a step, 3.4 with it.)
TEST(ContactSet, ABedTakesFewSolves)
{
    const auto crowd = [](const std::string& keys) { return "[[crowd]]\ndensity = 2500\nnumber = 6\n" + keys + "\n"; };
    const Scene scene = parse_scene("gravity = [0, -9.81]\n[domain]\nsize = [0.012, 0.024]\ncells = [16, 32]\n"
                                    "[fluid]\ndensity = 1000\nviscosity = 1e-3\n[gap]\nroughness = 1e-5\n"
                                    "[contact]\nfriction = 0.3\n[time]\nend = 0.5\nmax_step = 2e-3\n" +
                                        crowd("name = \"box\"\nshape = \"box\"\nsize = [0.003, 0.0024]\nseed = 1") +
                                        crowd("name = \"ball\"\nshape = \"ball\"\nradius = 0.0015\nseed = 2"),
                                    "bed.toml", {}, Purpose::run);
    Simulation<2> simulation(scene, Communicator());
    int steps = 0, solves = 0;
    for (double time = 0; time < scene.end; ++steps) {
        const StepReport report = simulation.step(scene.end);
        solves += report.solves;
        time = report.time;
    }
    EXPECT_LT(solves, 5 * steps);
}

// A block of mass 2 on two points of a floor, by the laws alone: weight 1 a second over one second, pushed along the floor.
TEST(ContactLaw, BlockSticksOrSlides)
{
    const TwistMatrix<2> mobility = Eigen::Vector3d(0.5, 0.5, 4).asDiagonal();
    std::vector<Contact<2>> contacts(2);
    for (int i = 0; i < 2; ++i) {
        Contact<2>& c = contacts[i];
        c.point.a = 0;
        c.point.b = 1;
        const double arm = i == 0 ? -1 : 1, height = -0.25;
        c.normal = {Twist<2>(0, 1, arm), Twist<2>::Zero()};
        c.tangents[0] = {Twist<2>(1, 0, -height), Twist<2>::Zero()};
        c.friction = 0.5;
    }
    const std::vector<ContactImpulse<2>> none(2);
    for (double push : {0.2, 0.4}) { // against a bound of 0.5 over the weight of 1 and mass of 2: 0.25 of speed
        const std::vector<Twist<2>> free_motion{Twist<2>(push, -0.5, 0), Twist<2>::Zero()};
        const ContactForecast<2> forecast =
            forecast_contacts<2>(contacts, none, free_motion, {{mobility, TwistMatrix<2>::Zero()}, {}}, 1e-12);
        double normal = 0, tangential = 0;
        for (const ContactImpulse<2>& impulse : forecast.impulses) {
            EXPECT_GE(impulse.normal, 0);
            EXPECT_LE(std::abs(impulse.tangential[0]), 0.5 * impulse.normal * (1 + 1e-12));
            normal += impulse.normal;
            tangential += impulse.tangential[0];
        }
        EXPECT_NEAR(normal, 1.0, 1e-9);
        EXPECT_NEAR(tangential, -std::min(2 * push, 0.5), 1e-9);
        EXPECT_NEAR(forecast.twists[0][0], std::max(push - 0.25, 0.0), 1e-9);
        EXPECT_NEAR(forecast.twists[0][1], 0, 1e-9);
        EXPECT_NEAR(forecast.twists[0][2], 0, 1e-9);
    }
}

// The same block, held to the floor by an impulse that no contact may have, lets go as slowly as the film below lets it.
TEST(ContactLaw, FilmHoldsBackWhatLetsGo)
{
    NearInertia<2> inertia;
    inertia.mobility = {Eigen::Vector3d(0.5, 0.5, 4).asDiagonal(), TwistMatrix<2>::Zero()};
    Contact<2> contact;
    contact.point.a = 0;
    contact.point.b = 1;
    contact.normal = {Twist<2>(0, 1, 0), Twist<2>::Zero()};
    const std::vector<Contact<2>> contacts(1, contact);
    std::vector<ContactImpulse<2>> given(1);
    given[0].normal = -1;
    for (double film : {0.0, 18.0}) {
        inertia.films = {{0, 1, PairMatrix<2>::Zero()}};
        inertia.films[0].matrix(1, 1) = film;
        const ContactForecast<2> forecast =
            forecast_contacts<2>(contacts, given, std::vector<Twist<2>>(2, Twist<2>::Zero()), inertia, 1e-12);
        EXPECT_EQ(forecast.impulses[0].normal, 0);
        EXPECT_NEAR(forecast.twists[0][1], 1 / (2 + film), 1e-9);
    }
}

// A light block in the corner of a wall and a floor, on films that weigh a million times as much as it (random scene 257). Each film is set to the
// body's motion in turn, and contacts between the two must not take the other film's push for a speed to stop.
TEST(ContactLaw, BlockInACornerBetweenTwoFilms)
{
    NearInertia<2> inertia;
    inertia.mobility = {Eigen::Vector3d(35.7, 35.7, 19236).asDiagonal(), TwistMatrix<2>::Zero(), TwistMatrix<2>::Zero()};
    inertia.films = {{0, 1, PairMatrix<2>::Zero()}, {0, 2, PairMatrix<2>::Zero()}};
    inertia.films[0].matrix.topLeftCorner<3, 3>() << 17691.5, 13.1229, 280.068, 13.1229, 0.0172863, 0.277007, 280.068, 0.277007,
        7.06939;
    inertia.films[1].matrix.topLeftCorner<3, 3>() << 0.0108383, 5.15948, 0.0687193, 5.15948, 4348.67, 43.4734, 0.0687193,
        43.4734, 0.683689;
    std::vector<Contact<2>> contacts;
    for (int wall : {1, 2})
        for (double arm : {-1.0, 1.0}) {
            Contact<2> c;
            c.point.a = 0;
            c.point.b = wall;
            c.normal = {wall == 1 ? Twist<2>(-1, 0, 0.0632 * arm) : Twist<2>(0, 1, 0.0396 * arm), Twist<2>::Zero()};
            contacts.push_back(c);
        }
    const std::vector<Twist<2>> start{Twist<2>(5e-6, -5e-5, -3e-4), Twist<2>::Zero(), Twist<2>::Zero()};
    const std::vector<ContactImpulse<2>> none(contacts.size());
    const ContactForecast<2> found = forecast_contacts<2>(contacts, none, start, inertia, 1e-12);
    double most = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const double speed = contacts[i].normal.a.dot(found.twists[0]);
        EXPECT_GE(speed, -1e-9);
        EXPECT_NEAR(found.impulses[i].normal > 0 ? speed : 0, 0, 1e-9);
        most = std::max(most, found.impulses[i].normal);
    }
    EXPECT_LT(most, 1);
    EXPECT_GT(most, 1e-6);
}

// Between flat faces of length L, h apart, ideal flow weighs rho L^3 / (12 h) against squeezing and rho L^5 / (720 h) against turning.
// A light block under a heavy one, on films that resist a million times as much as either: the laws hold, and bodies and films answer.
TEST(ContactLaw, StackOnHeavyFilmsObeysTheLaws)
{
    constexpr int floor = 2;
    NearInertia<2> inertia;
    const Eigen::Vector3d mass[] = {{1, 1, 0.1}, {5000, 5000, 400}};
    for (const Eigen::Vector3d& m : mass)
        inertia.mobility.push_back(TwistMatrix<2>(m.cwiseInverse().asDiagonal()));
    inertia.mobility.push_back(TwistMatrix<2>::Zero());
    std::vector<Contact<2>> contacts;
    for (int lower : {floor, 0}) {
        const int upper = lower == floor ? 0 : 1;
        FilmInertia<2> film{std::min(upper, lower), std::max(upper, lower), PairMatrix<2>::Zero()};
        for (double arm : {-0.4, 0.1, 0.5}) {
            Eigen::Matrix<double, 6, 1> row;
            const Twist<2> of_upper(0.01, 1, arm), of_lower(-0.01, -1, 0.02 - arm);
            row << (upper < lower ? of_upper : of_lower), (upper < lower ? of_lower : of_upper);
            film.matrix += 1e6 * row * row.transpose();
        }
        inertia.films.push_back(film);
        for (double arm : {-0.5, 0.5}) {
            Contact<2> c;
            c.point.a = upper;
            c.point.b = lower;
            c.normal = {Twist<2>(0, 1, arm), lower == floor ? Twist<2>(Twist<2>::Zero()) : Twist<2>(0, -1, -arm)};
            c.tangents[0] = {Twist<2>(1, 0, 0.5), lower == floor ? Twist<2>(Twist<2>::Zero()) : Twist<2>(-1, 0, 0.5)};
            c.friction = 0.1;
            contacts.push_back(c);
        }
    }
    const std::vector<ContactImpulse<2>> none(contacts.size());
    const std::vector<Twist<2>> start{Twist<2>(1e-3, -1e-3, 2e-3), Twist<2>(2e-3, -1e-3, 1e-3), Twist<2>::Zero()};
    const ContactForecast<2> found = forecast_contacts<2>(contacts, none, start, inertia, 1e-15);

    std::vector<Twist<2>> left(3, Twist<2>::Zero()); // of every body's momentum balance
    for (int b : {0, 1})
        left[b] = mass[b].asDiagonal() * Twist<2>(found.twists[b] - start[b]);
    for (const FilmInertia<2>& film : inertia.films) {
        Eigen::Matrix<double, 6, 1> change;
        change << found.twists[film.a] - start[film.a], found.twists[film.b] - start[film.b];
        left[film.a] += (film.matrix * change).head<3>();
        left[film.b] += (film.matrix * change).tail<3>();
    }
    double largest = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact<2>& c = contacts[i];
        const ContactImpulse<2>& impulse = found.impulses[i];
        auto speed = [&](const RelativeRow<2>& row) {
            return row.a.dot(found.twists[c.point.a]) + row.b.dot(found.twists[c.point.b]);
        };
        EXPECT_GE(impulse.normal, 0);
        EXPECT_GE(speed(c.normal), -1e-11);
        EXPECT_NEAR(impulse.normal > 0 ? speed(c.normal) : 0, 0, 1e-11);
        EXPECT_LE(std::abs(impulse.tangential[0]), c.friction * impulse.normal * (1 + 1e-6));
        const bool sticks = std::abs(impulse.tangential[0]) < c.friction * impulse.normal * (1 - 1e-6);
        EXPECT_NEAR(sticks ? speed(c.tangents[0]) : 0, 0, 1e-11);
        largest = std::max(largest, impulse.normal);
        left[c.point.a] -= impulse.normal * c.normal.a + impulse.tangential[0] * c.tangents[0].a;
        left[c.point.b] -= impulse.normal * c.normal.b + impulse.tangential[0] * c.tangents[0].b;
    }
    EXPECT_GT(largest, 0);
    for (int b : {0, 1})
        EXPECT_LT(left[b].norm(), 1e-6 * largest) << b;
}

// A pyramid of bricks, each on two of the course below and each course twice as heavy as that: forces have many ways to go. It stands.
TEST(ContactCones, PyramidStands)
{
    constexpr int courses = 10;
    constexpr double width = 1, height = 0.5, speed = 0.01;
    const TwistMatrix<2> unit = Eigen::Vector3d(1, 1, 12 / (width * width + height * height)).asDiagonal();
    NearInertia<2> inertia;
    std::vector<Contact<2>> contacts;
    const auto touch = [&](int upper, int lower, double arm_upper,
                           double arm_lower) { // the upper one's lower side, from its centre
        Contact<2> c;
        c.point.a = upper;
        c.point.b = lower;
        const bool floor = lower == 0;
        c.normal = {Twist<2>(0, 1, arm_upper), floor ? Twist<2>(Twist<2>::Zero()) : Twist<2>(0, -1, -arm_lower)};
        c.tangents[0] = {Twist<2>(1, 0, height / 2), floor ? Twist<2>(Twist<2>::Zero()) : Twist<2>(-1, 0, height / 2)};
        c.friction = 0.3;
        contacts.push_back(c);
    };
    inertia.mobility.push_back(TwistMatrix<2>::Zero()); // the floor
    int first_below = 0;
    for (int course = 0; course < courses; ++course) {
        const int first = static_cast<int>(inertia.mobility.size());
        for (int i = 0; i < courses - course; ++i) {
            const int brick = first + i;
            inertia.mobility.push_back(unit / std::exp2(course));
            if (course == 0) {
                touch(brick, 0, -width / 2, 0);
                touch(brick, 0, width / 2, 0);
                continue;
            }
            for (double side : {-1.0, 1.0}) // each covers half of the brick below
                for (double end : {0.0, 1.0})
                    touch(brick, first_below + i + (side > 0), side * end * width / 2, side * (end - 1) * width / 2);
        }
        first_below = first;
    }
    const std::size_t bricks = inertia.mobility.size() - 1;
    std::vector<Twist<2>> falling(bricks + 1, Twist<2>(0, -speed, 0));
    falling[0].setZero();
    const std::vector<ContactImpulse<2>> none(contacts.size());
    const std::optional<ContactForecast<2>> solved = solve_cones<2>(contacts, none, falling, inertia, none, 1e-10 * speed);
    ASSERT_TRUE(solved);
    const ContactForecast<2>& found = *solved;
    for (std::size_t b = 0; b <= bricks; ++b)
        EXPECT_LT(found.twists[b].norm(), 1e-5 * speed) << b;
    double carried = 0, weight = 0;
    std::vector<Twist<2>> left(bricks + 1, Twist<2>::Zero()); // of every brick's momentum balance
    for (std::size_t b = 1; b <= bricks; ++b)
        left[b] = inertia.mobility[b].inverse() * Twist<2>(found.twists[b] - falling[b]);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact<2>& c = contacts[i];
        const ContactImpulse<2>& impulse = found.impulses[i];
        EXPECT_GE(impulse.normal, 0);
        EXPECT_LE(std::abs(impulse.tangential[0]), c.friction * impulse.normal * (1 + 1e-9));
        left[c.point.a] -= impulse.normal * c.normal.a + impulse.tangential[0] * c.tangents[0].a;
        left[c.point.b] -= impulse.normal * c.normal.b + impulse.tangential[0] * c.tangents[0].b;
        if (c.point.b == 0)
            carried += impulse.normal;
    }
    for (std::size_t b = 1; b <= bricks; ++b) {
        EXPECT_LT(left[b].norm(), 1e-6 * bricks * speed) << b;
        weight += speed / inertia.mobility[b](0, 0);
    }
    EXPECT_NEAR(carried, weight, 1e-5 * weight);
}

// A slope's block in fluid that ties it to another body: with pairs of the true inertia for all their motions the forecast is that of the true one.
TEST(ContactCones, SecantsReplaceTheInertia)
{
    const Twist<2> masses(2, 2, 0.25);
    std::vector<Contact<2>> contacts;
    for (double arm : {-0.4, 0.5}) {
        Contact<2> c;
        c.point.a = 1;
        c.point.b = 0;
        c.friction = 0.3;
        c.normal = {Twist<2>(0, 1, arm), Twist<2>::Zero()};
        c.tangents[0] = {Twist<2>(1, 0, 0.5), Twist<2>::Zero()};
        contacts.push_back(c);
    }
    NearInertia<2> true_one, own;
    for (NearInertia<2>* inertia : {&true_one, &own})
        inertia->mobility = {TwistMatrix<2>::Zero(), masses.cwiseInverse().asDiagonal(), masses.cwiseInverse().asDiagonal()};
    PairMatrix<2> film = PairMatrix<2>::Zero();
    const Eigen::Matrix<double, 6, 1> squeeze(0.6, 3, 0.2, -0.6, -3, 0.1);
    film = squeeze * squeeze.transpose();
    true_one.films = {{1, 2, film}};
    const std::vector<Twist<2>> moving = {Twist<2>::Zero(), Twist<2>(0.5, -1, 0.2), Twist<2>(0, 0.3, 0)};
    const std::vector<ContactImpulse<2>> none(contacts.size());
    ContactSecants secants{Eigen::MatrixXd::Zero(9, 6), Eigen::MatrixXd::Zero(9, 6)};
    secants.twists.bottomRows(6).setIdentity();
    secants.impulses.bottomRows(6) = film;
    for (int k = 0; k < 6; ++k)
        secants.impulses(3 + k, k) += masses[k % 3];
    const auto expected = solve_cones<2>(contacts, none, moving, true_one, none, 1e-10);
    const auto found = solve_cones<2>(contacts, none, moving, own, none, 1e-10, secants);
    const auto without = solve_cones<2>(contacts, none, moving, own, none, 1e-10);
    ASSERT_TRUE(expected && found && without);
    for (int b : {1, 2}) {
        EXPECT_LT((found->twists[b] - expected->twists[b]).norm(), 5e-4)
            << b; // films count as through a spring (contact_cones)
        EXPECT_GT((without->twists[b] - expected->twists[b]).norm(), 0.05) << b;
    }
}

} // namespace
} // namespace gapflow
