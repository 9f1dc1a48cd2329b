// Viscosity on parts: the energy law of its stage, what it leaves alone, exact flows, order in time.
#include "unit/step/parts_run.hpp"
#include "unit/step/scenes.hpp"

#include "gapflow/step/advance.hpp"
#include "gapflow/step/remainder.hpp"
#include "gapflow/step/start.hpp"
#include "gapflow/step/viscosity.hpp"
#include "gapflow/stepping/motion.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <numbers>
#include <random>

namespace gapflow {
namespace {

constexpr double pi = std::numbers::pi;

template <int D>
Vec<D> eddy(const Vec<D>& x)
{
    Vec<D> u = Vec<D>::Zero();
    u[0] = std::sin(pi * x[0]) * std::cos(pi * x[1]);
    u[1] = -std::cos(pi * x[0]) * std::sin(pi * x[1]);
    return u;
}

/// Bodies in a flow, before a viscous stage.
template <int D>
struct Moment {
    Model<D> model;
    std::vector<TwistMatrix<D>> mass;
    Instant<D> now;

    Moment(const Scene& scene, const std::vector<Twist<D>>& twists, const Velocity<D>& velocity)
        : model(scene, Communicator(), Task::motion), mass(model.masses(model.bodies, 0.0))
    {
        SolverOptions exact;
        exact.tolerance = 1e-13;
        now.placed = placed(model, model.bodies, mass, true);
        now.flow = flow_of_twists(*now.placed, twists, exact, remainder_of(*now.placed, on_faces<D>(model.grid, velocity)));
        find_forces(now);
    }
    double energy()
    {
        find_forces(now);
        double sum = now.energy;
        for (std::size_t b = 0; b < model.bodies.size(); ++b)
            if (model.bodies[b].motion == Motion::free)
                sum += 0.5 * now.flow.twists[b].dot(mass[b] * now.flow.twists[b]);
        return sum;
    }
    ViscousStep<D> stage(double viscosity, double dt)
    {
        return add_viscosity(*now.placed, mass, ViscousLoads<D>{}, viscosity, dt, 1e-11, now.flow);
    }
};

template <int D>
Scene viscous_box(int cells, SideScene::Kind sides = SideScene::Kind::wall)
{
    Scene scene = box_of_fluid(D, cells, sides);
    scene.viscosity = 1; // stages are given theirs
    return scene;
}

template <int D>
std::vector<Twist<D>> random_twists(const Model<D>& model, int seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<Twist<D>> V = model.twists(model.bodies);
    for (std::size_t b = 0; b < model.bodies.size(); ++b)
        for (int k = 0; k < twist_size<D>; ++k)
            V[b][k] = number(random);
    return V;
}

/// A stage takes from the energy what it dissipates and what its integrator loses, whatever the viscosity: rates of nu dt/dx^2.
template <int D>
void check_energy(const Scene& scene, const std::vector<double>& rates)
{
    double last = 0;
    for (const double rate : rates) {
        Moment<D> moment(scene, random_twists<D>(Model<D>(scene, Communicator(), Task::motion), 3), eddy<D>);
        const double before = moment.energy(), dx = scene.spacing();
        const ViscousStep<D> step = moment.stage(rate * dx * dx, 1);
        const double after = moment.energy();
        // Of the stiffest the round-off of the solve: 1.2e-9 in the plane.
        EXPECT_NEAR((after - before + step.dissipated + step.lost) / before, 0, rate < 1000 ? 1e-9 : 3e-9) << rate;
        EXPECT_GT(step.dissipated, last) << rate; // more, as it is larger
        EXPECT_LT(after, before) << rate;
        if (rate <= 1e-5) {
            EXPECT_LT(before - after, 100 * rate * before) << rate; // towards ideal fluid
        }
        last = rate < 0.1 ? step.dissipated : 0;
    }
}

TEST(Viscosity, TakesWhatItDissipates2D)
{
    Scene scene = viscous_box<2>(24);
    scene.bodies = {body("disk", BodyScene::ShapeKind::ball, {0.31, 0.43, 0}),
                    body("box", BodyScene::ShapeKind::box, {0.63, 0.5, 0}),
                    body("plate", BodyScene::ShapeKind::box, {0.45, 0.78, 0})};
    scene.bodies[0].radius = 0.13;
    scene.bodies[1].size = {0.3, 0.17, 0};
    scene.bodies[1].angle = 0.4;
    scene.bodies[1].density = 0.01;
    scene.bodies[2].size = {0.4, 0.012, 0}; // thinner than a cell
    scene.bodies[2].angle = 0.07;
    check_energy<2>(scene, {1e-7, 1e-5, 1e-3, 0.1, 1, 10, 1e3});
}

TEST(Viscosity, TakesWhatItDissipates3D)
{
    Scene scene = viscous_box<3>(8);
    scene.bodies = {body("ball", BodyScene::ShapeKind::ball, {0.47, 0.43, 0.52})};
    scene.bodies[0].radius = 0.23;
    check_energy<3>(scene, {1e-5, 1, 1e3});
}

// The impulse on the solids is what the bodies' momenta gain; a fixed one feels what it would.
// With the compact lattice between the ball's elements and the sides.
TEST(Viscosity, TakesWhatItDissipatesFarFromSolids3D)
{
    Scene scene = viscous_box<3>(16);
    scene.bodies = {body("ball", BodyScene::ShapeKind::ball, {0.37, 0.41, 0.46})};
    scene.bodies[0].radius = 0.09;
    check_energy<3>(scene, {1e-3, 1});
}

TEST(Viscosity, GivesTheImpulseToTheSolids)
{
    Scene scene = viscous_box<2>(24);
    scene.bodies = {body("disk", BodyScene::ShapeKind::ball, {0.31, 0.43, 0}),
                    body("fixed", BodyScene::ShapeKind::box, {0.63, 0.5, 0})};
    scene.bodies[0].radius = 0.13;
    scene.bodies[1].size = {0.3, 0.17, 0};
    scene.bodies[1].motion = BodyScene::Motion::fixed;
    std::vector<Twist<2>> V = random_twists<2>(Model<2>(scene, Communicator(), Task::motion), 5);
    V[1].setZero();
    Moment<2> moment(scene, V, eddy<2>);
    const ViscousStep<2> step = moment.stage(1e-3, 0.3);
    const Twist<2> gained = moment.mass[0] * (moment.now.flow.twists[0] - V[0]);
    EXPECT_LT((step.impulse[0] - gained).norm(), 1e-10 * gained.norm());
    EXPECT_GT(step.impulse[1].norm(), 1e-3 * gained.norm());
    EXPECT_EQ(moment.now.flow.twists[1], V[1]);
}

template <int D>
void check_uniform_motion()
{
    Scene scene = viscous_box<D>(D == 2 ? 16 : 6, SideScene::Kind::periodic);
    scene.bodies = {body("box", BodyScene::ShapeKind::box, {0.41, 0.33, 0.47})};
    scene.bodies[0].size = {0.4, 0.35, D == 3 ? 0.45 : 0.0};
    scene.bodies[0].angle = D == 2 ? 0.4 : 0;
    const Vec<D> U = Vec<D>::LinSpaced(0.7, -0.4);
    std::vector<Twist<D>> V(1, stream_twist<D>(U));
    Moment<D> moment(scene, V, [&](const Vec<D>&) { return U; });
    const double energy = moment.energy();
    const ViscousStep<D> step = moment.stage(1, 1);
    EXPECT_LT(step.dissipated, 1e-12 * energy);
    EXPECT_LT((moment.now.flow.twists[0] - V[0]).norm(), 1e-8);
    EXPECT_NEAR(moment.energy() / energy, 1, 1e-9);
}

TEST(Viscosity, UniformMotionDissipatesNothing2D)
{
    check_uniform_motion<2>();
}

TEST(Viscosity, UniformMotionDissipatesNothing3D)
{
    check_uniform_motion<3>();
}

// Between walls that slide the flow becomes linear shear, exactly.
template <int D>
void check_couette()
{
    Scene scene = box_of_fluid(D, D == 2 ? 6 : 4, SideScene::Kind::periodic);
    scene.tolerance = 1e-12;
    scene.viscosity = 1;
    scene.sides[2].kind = scene.sides[3].kind = SideScene::Kind::wall;
    scene.sides[2].velocity = {-0.3, 0, 0};
    scene.sides[3].velocity = {0.7, 0, 0};
    PartsRun<D> run(scene);
    for (int k = 0; k < 10; ++k)
        run.step(0.4);
    double worst = 0;
    for_each_index<D>(run.model.grid.low(), run.model.grid.high(), [&](const Index<D>& f) {
        const double y = run.model.grid.face_centre(0, f)[1];
        worst = std::max(worst, std::abs(run.state.velocity.grid(0, f) - (y - 0.3)));
    });
    EXPECT_LT(worst, 1e-8);
    EXPECT_NEAR(run.report.dissipation_grid, 1, 1e-8);
}

TEST(Viscosity, ShearBetweenSlidingWallsIsLinear2D)
{
    check_couette<2>();
}

TEST(Viscosity, ShearBetweenSlidingWallsIsLinear3D)
{
    check_couette<3>();
}

// On both sides of a plate thinner than a cell, of which a face of the grid may have a piece on either, the flow is sheared by itself.
TEST(Viscosity, ShearOnBothSidesOfAThinPlate)
{
    Scene scene = box_of_fluid(2, 6, SideScene::Kind::periodic);
    scene.tolerance = 1e-12;
    scene.viscosity = 1;
    scene.sides[2].kind = scene.sides[3].kind = SideScene::Kind::wall;
    scene.sides[2].velocity = {-0.3, 0, 0};
    scene.sides[3].velocity = {0.7, 0, 0};
    scene.bodies = {body("plate", BodyScene::ShapeKind::box, {0.5, 0.43, 0})};
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    scene.bodies[0].size = {3, 0.02, 0};
    PartsRun<2> run(scene);
    for (int k = 0; k < 14; ++k)
        run.step(0.1);
    EXPECT_NEAR(run.report.dissipation_grid, 0.3 * 0.3 / 0.42 + 0.7 * 0.7 / 0.56, 1e-6);
    EXPECT_NEAR(run.state.wrenches[0][0], 0.7 / 0.56 - 0.3 / 0.42, 1e-6);
}

// A mean pressure gradient, and the one that keeps a mean velocity: laminar flow between walls.
TEST(Viscosity, DrivenChannels)
{
    for (const bool kept : {false, true}) {
        Scene scene = box_of_fluid(2, 6, SideScene::Kind::periodic);
        scene.tolerance = 1e-12;
        scene.viscosity = 1;
        scene.sides[2].kind = scene.sides[3].kind = SideScene::Kind::wall;
        if (kept)
            scene.mean_velocity = Triple{1, 0, 0};
        else
            scene.pressure_gradient = Triple{-12, 0, 0};
        Simulation<2> run(scene, Communicator());
        StepReport last;
        while (run.time() < 3)
            last = run.step(3);
        EXPECT_NEAR(last.mean_velocity_x, 1, 1e-8);
        EXPECT_NEAR(last.pressure_gradient_x, -12, 1e-7);
    }
}

TEST(Viscosity, RunsGoOnFromTheirState)
{
    Scene scene = box_of_fluid(2, 16, SideScene::Kind::wall);
    scene.viscosity = 0.01;
    scene.gravity = {0, -1, 0};
    scene.bodies = {body("disk", BodyScene::ShapeKind::ball, {0.4, 0.43, 0}, {0.3, 0.2, 0}),
                    body("plate", BodyScene::ShapeKind::box, {0.6, 0.71, 0})};
    scene.bodies[0].density = 2;
    scene.bodies[1].size = {0.4, 0.02, 0};
    scene.bodies[1].angle = 0.2;
    expect_to_go_on<2>(scene);
}

// What flows into a chamber leaves it through two slots, a hundredth as wide as it is: 12 mu l q / h^3.
TEST(Viscosity, AChamberWithNarrowOutlets)
{
    Scene scene = box_of_fluid(2, 24, SideScene::Kind::wall);
    scene.sides[2].kind = SideScene::Kind::inflow;
    scene.sides[2].velocity = {0, 0.01, 0};
    scene.sides[3].kind = SideScene::Kind::open;
    scene.viscosity = 0.01;
    scene.bodies = {body("piston", BodyScene::ShapeKind::box, {0.5, 0.6, 0})};
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    scene.bodies[0].size = {0.98, 0.3, 0};
    PartsRun<2> run(scene);
    for (int k = 0; k < 3; ++k)
        run.step(0.5);
    const double over = run.state.wrenches[0][1] / (12 * 0.01 * 0.3 * 0.005 / 1e-6);
    EXPECT_GT(over, 0.99); // and what the slots' ends resist with
    EXPECT_LT(over, 1.15);
}

// A face that the disk leaves open over 4e-10 of a cell: its friction is 1e19 times its inertia.
TEST(Viscosity, SliversOfFacesKeepTheFlow)
{
    Scene scene = box_of_fluid(2, 32, SideScene::Kind::wall);
    scene.viscosity = 1;
    scene.gap.roughness = 0;
    scene.bodies = {body("disk", BodyScene::ShapeKind::ball, {0.5, 0.2500025, 0}, {0, -1e-11, 0})};
    scene.bodies[0].motion = BodyScene::Motion::prescribed;
    scene.bodies[0].radius = 0.25;
    PartsRun<2> run(scene);
    const double start = run.energy();
    for (int k = 0; k < 6; ++k)
        run.step(1.25e-3);
    EXPECT_LT(run.energy(), 2 * start);
}

// Two plates at a gap of 0.16 cells, whose ends have mouths: what flows in them is kept from step to step.
TEST(Viscosity, PlatesThatAreDrivenApartGoAsInIdealFluidWhereItIsSmall)
{
    const auto speed = [](double viscosity) {
        Scene scene = two_plates(16, 16, 0.16, 0);
        scene.viscosity = viscosity;
        for (BodyScene& plate : scene.bodies)
            plate.force = {0, plate.name == "upper" ? 1.0 : -1.0, 0};
        PartsRun<2> run(scene);
        for (int k = 0; k < 10; ++k)
            run.step(0.002);
        return run.now.flow.twists[1][1] - run.now.flow.twists[0][1];
    };
    const double ideal = speed(0);
    EXPECT_NEAR(speed(1e-12), ideal, 5e-3 * ideal);
}

// Vortices decay at the rate of their wave numbers, with an error in time of second order.
TEST(Viscosity, DecayIsOfSecondOrderInTime)
{
    const auto energy = [](int steps) {
        Scene scene = box_of_fluid(2, 16, SideScene::Kind::periodic);
        scene.size = {2 * pi, 2 * pi, 0};
        scene.tolerance = 1e-12;
        scene.viscosity = 0.25;
        PartsRun<2> run(
            scene, [](const Vec<2>& x) { return Vec<2>(std::sin(x[0]) * std::cos(x[1]), -std::cos(x[0]) * std::sin(x[1])); });
        const double start = run.energy();
        for (int k = 0; k < steps; ++k)
            run.step(2.0 / steps);
        return run.energy() / start;
    };
    const double coarse = energy(4), middle = energy(8), fine = energy(16);
    EXPECT_NEAR(std::log2((coarse - middle) / (middle - fine)), 2, 0.2);
    EXPECT_NEAR(fine / std::exp(-2.0), 1, 0.03);
}

// No step gains energy.
TEST(Viscosity, ADiskThatIsThrownLosesEnergyAtAnyViscosity)
{
    for (const double rate : {1e-7, 1e-3, 0.1, 10.0, 1e3}) {
        Scene scene = box_of_fluid(2, 24, SideScene::Kind::wall);
        const double dx = scene.spacing(), dt = 0.4 * dx;
        scene.viscosity = rate * dx * dx / dt;
        scene.bodies = {body("disk", BodyScene::ShapeKind::ball, {0.33, 0.41, 0}, {1, 0.3, 0})};
        scene.bodies[0].radius = 0.13;
        PartsRun<2> run(scene);
        double last = run.energy();
        for (int k = 0; k < 8; ++k) {
            run.step(dt);
            const double now = run.energy();
            EXPECT_LT(now, last * (1 + 2e-5)) << rate;
            last = now;
        }
        if (rate < 1e-6) {
            EXPECT_GT(last, 0.99 * 0.5 * 1.09 * pi * 0.13 * 0.13);
        }
    }
}

} // namespace
} // namespace gapflow
