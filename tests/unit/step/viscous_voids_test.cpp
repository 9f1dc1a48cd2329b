// Voids in gaps of viscous fluid on parts: dry contact holds and lets go at the exact pull, cavitation bounds the pressure, and the energy is that of the work done.
#include "dry_block.hpp"
#include "parts_run.hpp"

#include "gapflow/step/remainder.hpp"
#include "gapflow/step/viscosity.hpp"
#include "gapflow/step/void_solve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace gapflow {
namespace {

Scene viscous_block(int dimension, double pull, double viscosity)
{
    Scene scene = dry_block(dimension, pull);
    if (dimension == 3)
        scene.cells = {12, 12, 6};
    scene.viscosity = viscosity;
    return scene;
}

template <int D>
void expect_to_hold_and_lift(double viscosity)
{
    for (const double share : {0.99, 1.01}) {
        Simulation<D> simulation(viscous_block(D, share * ambient, viscosity), Communicator());
        EXPECT_NEAR(gap_of(simulation.gaps()).void_volume, thickness, 1e-6 * thickness);
        for (int i = 0; i < 3; ++i) {
            EXPECT_LT(simulation.step(1).divergence_max, 1e-6);
            const GapState gap = gap_of(simulation.gaps());
            EXPECT_NEAR(gap.pressure_max, 0, 1e-12);
            if (share < 1) {
                EXPECT_NEAR(gap.contact_force, (1 - share) * ambient,
                            0.02 * (1 - share) * ambient); // (friction)
                EXPECT_NEAR(gap.void_volume, thickness, 1e-3 * thickness);
                EXPECT_LT(std::abs(simulation.bodies()[0].twist[D - 1]), 1e-9); // it may slide
            } else {
                EXPECT_EQ(gap.contact_force, 0);
                EXPECT_GT(simulation.bodies()[0].twist[D - 1], 1e-5);
            }
        }
    }
}

TEST(ViscousVoids, ADryBlockHoldsUntilAmbientPressureTimesArea2D)
{
    for (const double viscosity : {1e-3, 0.1})
        expect_to_hold_and_lift<2>(viscosity);
}

TEST(ViscousVoids, ADryBlockHoldsUntilAmbientPressureTimesArea3D)
{
    expect_to_hold_and_lift<3>(0.1);
}

// No fluid drags at it where there is none: mu V L/thickness would be 100.
TEST(ViscousVoids, NoFluidDragsWhereThereIsNone)
{
    Scene scene = viscous_block(2, 0, 0.1);
    scene.bodies[0].motion = BodyScene::Motion::prescribed;
    scene.bodies[0].force = {0, 0, 0};
    scene.bodies[0].velocity = {0.1, 0, 0};
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 10; ++i)
        simulation.step(1);
    EXPECT_NEAR(gap_of(simulation.gaps()).void_volume, thickness, 1e-3 * thickness);
    EXPECT_LT(std::abs(simulation.fluid_wrenches()[0][0]), 2);
}

Scene pulled_plates(double viscosity)
{
    Scene scene = box_of_fluid(2, 32, SideScene::Kind::wall);
    scene.size = {4, 4, 0};
    scene.sides[3].kind = SideScene::Kind::open;
    scene.reference_pressure = 1;
    scene.max_step = 2e-3;
    scene.viscosity = viscosity;
    for (const int side : {-1, 1}) {
        BodyScene plate = body(side < 0 ? "lower" : "upper", BodyScene::ShapeKind::box, {2.013, 2 + side * 0.255, 0});
        plate.size = {1, 0.5, 0};
        plate.force = {0, 4.0 * side, 0};
        scene.bodies.push_back(plate);
    }
    return scene;
}

TEST(ViscousVoids, APulledWetGapCavitates)
{
    for (const double viscosity : {1e-3, 0.1}) {
        Scene scene = pulled_plates(viscosity);
        scene.vapour_pressure = -1e6;
        Simulation<2> without(scene, Communicator());
        scene.vapour_pressure = 0.2;
        Simulation<2> with(scene, Communicator());
        for (int i = 0; i < 6; ++i) {
            without.step(1);
            with.step(1);
            const GapState gap = gap_of(with.gaps());
            EXPECT_NEAR(gap.pressure_min, 0.2, 1e-3);
            EXPECT_GT(gap.void_volume, 0);
            EXPECT_LT(gap_of(without.gaps()).pressure_min, -1);
        }
        EXPECT_GT(with.bodies()[1].pose.position[1], without.bodies()[1].pose.position[1]);
    }
}

/// A pulled plate beside a void, before a viscous stage.
template <int D>
struct MomentWithVoids {
    Model<D> model;
    std::vector<TwistMatrix<D>> mass;
    Instant<D> now;
    ViscousVoids<D> voids;

    explicit MomentWithVoids(const Scene& scene)
        : model(scene, Communicator(), Task::motion), mass(model.masses(model.bodies, 0.0))
    {
        SolverOptions exact;
        exact.tolerance = 1e-13;
        now.placed = placed(model, model.bodies, mass, true);
        std::vector<double> volume(count_sites(now.placed->complex), 0.0);
        for (const VoidPart<D>& part : now.placed->voids.parts)
            if (part.place[0] < 2)
                volume[part.part] = 0.4 * part.room;
        put_voids(model, model.bodies, mass, std::move(volume), *now.placed);
        std::vector<VoidEdge<D>>& edges = now.placed->voids.edges;
        std::vector<Link>& links = now.placed->voids.all->system.links; // the edges are its last ones
        for (std::size_t e = 0; e < edges.size(); ++e) {
            edges[e].fluid = e % 2 ? 0.6 : 1.0;
            links[links.size() - edges.size() + e].conductance = edges[e].open();
        }
        std::vector<Twist<D>> twists = model.twists(model.bodies);
        twists[0].setConstant(0.3);
        now.flow = flow_beside_voids(
            *now.placed, twists, exact, remainder_of(*now.placed, on_faces<D>(model.grid, [](const Vec<D>& x) {
                Vec<D> u = Vec<D>::Zero();
                u[0] = std::sin(0.25 * std::numbers::pi * x[0]) * std::cos(0.5 * std::numbers::pi * x[1]);
                u[1] = -0.5 * std::cos(0.25 * std::numbers::pi * x[0]) * std::sin(0.5 * std::numbers::pi * x[1]);
                return u;
            })));
        for (const VoidEdge<D>& edge : now.placed->voids.edges) {
            voids.momentum.push_back(0);
            for (const auto& [row, weight] : edge.rows)
                voids.momentum.back() += weight * value(row);
        }
    }
    double value(long row) const
    {
        const long cells = model.grid.cells().template cast<long>().prod();
        return row < cells ? now.flow.p.cells(model.grid.cell_of_key(row)) : now.flow.p.nodes[row - cells];
    }
    double energy()
    {
        find_forces(now);
        double sum = now.energy;
        for (std::size_t b = 0; b < model.bodies.size(); ++b)
            sum += 0.5 * now.flow.twists[b].dot(mass[b] * now.flow.twists[b]);
        for (std::size_t e = 0; e < voids.momentum.size(); ++e)
            sum += 0.5 * now.placed->voids.edges[e].open() * voids.momentum[e] * voids.momentum[e];
        return sum;
    }
};

// What a stage takes from the energy is what it dissipates and what its integrator loses, less the work of the given pressures.
TEST(ViscousVoids, TheirPressuresDoTheWorkThatIsDone)
{
    for (const double rate : {1e-5, 1e-2, 1.0, 100.0}) {
        Scene scene = viscous_block(2, 0, 1);
        scene.bodies[0].position[1] += 0.02;
        MomentWithVoids<2> moment(scene);
        const double before = moment.energy(), dx = scene.spacing();
        int count = 0;
        for (const VoidPart<2>& part : moment.now.placed->voids.parts)
            if (moment.now.placed->voids.is_void(part.part) || count++ % 2)
                moment.voids.given[part.row] = -0.03;
        ViscousLoads<2> loads;
        loads.impulse.assign(moment.now.flow.twists.size(), Twist<2>::Zero());
        loads.impulse[0] = Twist<2>(0.02, 0.05, 0.01);
        const ViscousStep<2> step =
            add_viscosity(*moment.now.placed, moment.mass, loads, rate * dx * dx, 1, 1e-11, moment.now.flow, &moment.voids);
        const double after = moment.energy();
        EXPECT_NE(moment.voids.work, 0);
        EXPECT_NEAR((after - before + step.dissipated + step.lost - step.work - moment.voids.work) / before, 0, 1e-8) << rate;
    }
}

// A shaft of radius 0.97 turns in a bearing of radius 1 that is open above, 0.015 under its middle. Reynolds' equation with p >= 0 where the film ends (2000 nodes):
// load 1805 along x and 2413 upward; without cavitation 3082 and 19.
TEST(ViscousVoids, ABearingCavitates)
{
    Scene scene = box_of_fluid(2, 1, SideScene::Kind::wall);
    scene.size = {2.125, 1.25, 0};
    scene.cells = {17, 10, 1};
    scene.sides[3].kind = SideScene::Kind::open;
    scene.density = 1e-3;
    scene.viscosity = 1;
    scene.reference_pressure = 10;
    scene.vapour_pressure = 0;
    scene.max_step = 5e-3;
    BodyScene shaft = body("shaft", BodyScene::ShapeKind::ball, {1.063, 1.053 - 0.015, 0}),
              bush = body("bush", BodyScene::ShapeKind::ball, {1.063, 1.053, 0});
    shaft.radius = 0.97;
    shaft.motion = BodyScene::Motion::prescribed;
    shaft.angular_velocity = {1, 0, 0};
    bush.radius = 1;
    bush.inside_out = true;
    bush.motion = BodyScene::Motion::fixed;
    scene.bodies = {shaft, bush};
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 30; ++i) {
        simulation.step(1e9);
        const GapState gap = gap_of(simulation.gaps());
        EXPECT_GE(gap.pressure_min, -1e-6 * gap.pressure_max);
        EXPECT_LT(gap.void_volume, 0.04);
    }
    EXPECT_GT(gap_of(simulation.gaps()).void_volume, 0);
    const double load = std::hypot(simulation.fluid_wrenches()[0][0], simulation.fluid_wrenches()[0][1]);
    EXPECT_NEAR(load, std::hypot(1805.0, 2413.0), 0.03 * load);
    EXPECT_NEAR(std::atan2(simulation.fluid_wrenches()[0][1], simulation.fluid_wrenches()[0][0]), std::atan2(2413.0, 1805.0),
                0.05);
}

// Rows that an edge of 1e7 times the conductance of a face joins: the solve of viscosity converges.
TEST(ViscousVoids, PlatesNearlyAlongALineOfTheGrid)
{
    Scene scene = pulled_plates(1e-3);
    for (BodyScene& plate : scene.bodies) {
        plate.position[0] = 2;
        plate.angle = (plate.position[1] < 2 ? 1 : -1) * 1e-8;
    }
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 3; ++i)
        EXPECT_NO_THROW(simulation.step(1));
}

// Kinetic energy, less the work of the pull and of the ambient pressure on the voids.
TEST(ViscousVoids, GainNoEnergy)
{
    for (const double viscosity : {1e-4, 1e-2, 1.0}) {
        Scene scene = viscous_block(2, 1.05 * ambient, viscosity);
        scene.bodies[0].free = {false, true, false, false, false, false};
        EXPECT_LT(largest_gain(scene, 0.1), 0.02) << viscosity;
    }
}

TEST(ViscousVoids, GoOnFromAStoredState)
{
    expect_to_go_on<2>(viscous_block(2, 1.05 * ambient, 0.01));
}

} // namespace
} // namespace gapflow
