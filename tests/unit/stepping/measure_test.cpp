// What a scene asks to be measured: values at points, volume fluxes, parts of forces.
#include "gapflow/step/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace gapflow {
namespace {

Scene tank()
{
    Scene scene;
    scene.dimension = 2;
    scene.size = {2, 1, 0};
    scene.cells = {64, 32, 1};
    scene.end = 1;
    scene.max_step = 0.01;
    return scene;
}

BodyScene ball(const std::string& name, double radius, Triple position)
{
    BodyScene body;
    body.name = name;
    body.shape = BodyScene::ShapeKind::ball;
    body.radius = radius;
    body.position = position;
    body.density = 1.0;
    return body;
}

BodyScene box(const std::string& name, Triple size, Triple position)
{
    BodyScene body;
    body.name = name;
    body.shape = BodyScene::ShapeKind::box;
    body.size = size;
    body.position = position;
    body.density = 1.0;
    return body;
}

FluxScene side(int number)
{
    FluxScene flux;
    flux.side = number;
    return flux;
}

FluxScene plane(Triple point, Triple normal)
{
    FluxScene flux;
    flux.kind = FluxScene::Kind::plane;
    flux.point = point;
    flux.normal = normal;
    return flux;
}

FluxScene gap(const std::string& a, const std::string& b)
{
    FluxScene flux;
    flux.kind = FluxScene::Kind::gap;
    flux.bodies = {a, b};
    return flux;
}

template <int D>
PointValues<D> at(const Simulation<D>& simulation, const Vec<D>& x)
{
    return simulation.sample(std::vector<Vec<D>>{x})[0];
}

TEST(Probes, FluidAtRestHasItsHydrostaticPressureOnSurfacesToo)
{
    Scene scene = tank();
    scene.gravity = {0, -10, 0};
    scene.density = 2;
    scene.sides[3].kind = SideScene::Kind::open;
    scene.reference_pressure = 7;
    scene.bodies = {ball("ball", 0.23, {1.01, 0.47, 0})};
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    Simulation<2> simulation(scene, Communicator());
    simulation.step(scene.end);
    for (const Vec<2>& x :
         {Vec<2>(0.1, 0.9), Vec<2>(0, 0), Vec<2>(2, 1), Vec<2>(1.01, 0.47 + 0.23), Vec<2>(1.01 - 0.23, 0.47)}) {
        const PointValues<2> values = at(simulation, x);
        EXPECT_EQ(values.kind, PointKind::bulk);
        EXPECT_NEAR(values.pressure, 7 + 20 * (1 - x[1]), 1e-9) << x.transpose();
        EXPECT_NEAR(values.velocity.norm(), 0, 1e-12);
        EXPECT_NEAR(values.vorticity[0], 0, 1e-10);
    }
    const PointValues<2> inside = at(simulation, Vec<2>(1.01, 0.5));
    EXPECT_EQ(inside.kind, PointKind::solid);
    EXPECT_TRUE(std::isnan(inside.pressure) && std::isnan(inside.velocity[0]) && std::isnan(inside.vorticity[0]));
}

// u = y between a wall and one that slides, up to the walls themselves; a pressure gradient along it is linear everywhere.
TEST(Probes, ShearFlowIsExactUpToTheWalls)
{
    Scene scene = tank();
    scene.sides[0].kind = scene.sides[1].kind = SideScene::Kind::periodic;
    scene.sides[3].velocity = {1, 0, 0};
    scene.viscosity = 1;
    scene.max_step = 0.1;
    Simulation<2> simulation(scene, Communicator());
    while (simulation.steps() < 80)
        simulation.step(1e9);
    for (const double y : {0.0, 0.013, 0.5, 0.77, 1.0})
        for (const double x : {0.0, 0.3, 1.99, 2.0}) {
            const PointValues<2> values = at(simulation, Vec<2>(x, y));
            EXPECT_NEAR(values.velocity[0], y, 1e-6);
            EXPECT_NEAR(values.velocity[1], 0, 1e-6);
            EXPECT_NEAR(values.vorticity[0], -1, 1e-5) << x << " " << y;
        }
}

TEST(Probes, VorticityOfAShearInSpace)
{
    Scene scene;
    scene.dimension = 3;
    scene.size = {0.5, 1, 0.5};
    scene.cells = {8, 16, 8};
    for (const int s : {0, 1, 4, 5})
        scene.sides[s].kind = SideScene::Kind::periodic;
    scene.sides[3].velocity = {1, 0, 2};
    scene.viscosity = 1;
    scene.end = 1;
    scene.max_step = 0.1;
    Simulation<3> simulation(scene, Communicator());
    while (simulation.steps() < 60)
        simulation.step(1e9);
    const PointValues<3> values = at(simulation, Vec<3>(0.21, 0.4, 0.13));
    EXPECT_NEAR((values.velocity - Vec<3>(0.4, 0, 0.8)).norm(), 0, 1e-5);
    EXPECT_NEAR((values.vorticity - Vec<3>(2, 0, -1)).norm(), 0, 1e-4); // curl of (y, 0, 2 y)
}

// Plates that part at the rate h': the fluid between them moves with u = -h' x / h from the middle, whatever the pressure.
TEST(Probes, FilmHasItsOwnPressureAndVelocity)
{
    Scene scene = tank();
    scene.size = {2, 2, 0};
    scene.cells = {64, 64, 1};
    scene.sides[3].kind = SideScene::Kind::open;
    const double h = 0.01;
    scene.bodies = {box("lower", {0.5, 0.25, 0}, {1.0, 0.875, 0}), box("upper", {0.5, 0.25, 0}, {1.0, 1.125 + h, 0})};
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    scene.bodies[1].motion = BodyScene::Motion::prescribed;
    scene.bodies[1].velocity = {0, 0.1, 0};
    Simulation<2> simulation(scene, Communicator());
    simulation.step(scene.end);
    const double rate = 0.1, now = simulation.bodies()[1].pose.position[1] - 1.125;
    const std::vector<GapState> gaps = simulation.gaps();
    ASSERT_EQ(gaps.size(), 1u);
    for (const double x : {-0.2, -0.05, 0.0, 0.13}) {
        const PointValues<2> values = at(simulation, Vec<2>(1 + x, 1 + 0.3 * now));
        EXPECT_EQ(values.kind, PointKind::film);
        EXPECT_NEAR(values.velocity[0], -rate * x / now, 0.05 * 0.25 * rate / now) << x;
        EXPECT_NEAR(values.velocity[1], 0.5 * rate, 1e-9);
        EXPECT_GE(values.pressure, gaps[0].pressure_min);
        EXPECT_LE(values.pressure, gaps[0].pressure_max);
        EXPECT_TRUE(std::isnan(values.vorticity[0]));
    }
    // u = -h' x / h decelerates as the gap opens: p(0) - p(x) = rho (h' x / h)^2.
    const double drop =
        at(simulation, Vec<2>(1.0, 1 + 0.5 * now)).pressure - at(simulation, Vec<2>(1.2, 1 + 0.5 * now)).pressure;
    EXPECT_NEAR(drop / std::pow(rate * 0.2 / now, 2), 1, 0.3);
    EXPECT_EQ(at(simulation, Vec<2>(1.0, 1 - 0.01)).kind, PointKind::solid);
    EXPECT_EQ(at(simulation, Vec<2>(1.4, 1.0)).kind, PointKind::bulk);
}

// What bodies displace leaves through the sides; a body that crosses one takes its own volume along.
template <int D>
void check_balance()
{
    Scene scene = tank();
    scene.dimension = D;
    scene.tolerance = 1e-10;
    if (D == 3) {
        scene.size = {2, 1, 1};
        scene.cells = {32, 16, 16};
    }
    const double z = D == 3 ? 0.47 : 0.0;
    scene.sides[0].kind = SideScene::Kind::inflow;
    scene.sides[0].velocity = {0.3, 0, 0};
    scene.sides[1].kind = scene.sides[3].kind = SideScene::Kind::open;
    scene.bodies = {ball("inside", 0.17, {0.61, 0.52, z}), ball("leaving", 0.21, {1.87, 0.43, z}),
                    ball("free", 0.13, {1.2, 0.7, z})};
    scene.bodies[0].motion = scene.bodies[1].motion = BodyScene::Motion::prescribed;
    scene.bodies[0].velocity = {0.5, 0.4, 0};
    scene.bodies[1].velocity = {1, 0.2, 0};
    Simulation<D> simulation(scene, Communicator());
    for (int i = 0; i < 4; ++i)
        simulation.step(scene.end);
    double fluid = 0, bodies = 0, size = 0;
    for (int s = 0; s < 2 * D; ++s) {
        const VolumeFlux flux = simulation.volume_flux(side(s));
        fluid += flux.flux;
        bodies += flux.bodies;
        size += std::abs(flux.flux);
        EXPECT_NEAR(flux.outflow - flux.inflow, flux.flux, 1e-14);
    }
    const double area = D == 2 ? 1.0 : 1.0;
    EXPECT_NEAR(simulation.volume_flux(side(0)).flux, -0.3 * area, 1e-9);
    EXPECT_GT(bodies, 0.1 * (D == 2 ? 1 : 0.3));
    EXPECT_NEAR(fluid + bodies, 0, 1e-8 * size);
    // Sections between the inflow and the first place where y_high takes part do not exist: use the sections' whole sum.
    const VolumeFlux out = simulation.volume_flux(side(1));
    const VolumeFlux last = simulation.volume_flux(plane({2, 0.5, 0.5}, {1, 0, 0}));
    EXPECT_NEAR(last.flux, out.flux, 1e-12);
    EXPECT_NEAR(last.bodies, out.bodies, 1e-12);
}

TEST(Fluxes, SidesBalanceWithMovingBodies2D)
{
    check_balance<2>();
}
TEST(Fluxes, SidesBalanceWithMovingBodies3D)
{
    check_balance<3>();
}

// Fluid and bodies together: the same through every section, at any place between the grid's planes and at any angle.
TEST(Fluxes, EverySectionOfAChannelHasTheSame)
{
    Scene scene = tank();
    scene.tolerance = 1e-10;
    scene.sides[0].kind = SideScene::Kind::inflow;
    scene.sides[0].velocity = {0.3, 0, 0};
    scene.sides[1].kind = SideScene::Kind::open;
    scene.bodies = {ball("moving", 0.22, {0.9, 0.5, 0}), box("step", {0.3, 0.2, 0}, {1.4, 0.1, 0})};
    scene.bodies[0].motion = BodyScene::Motion::prescribed;
    scene.bodies[0].velocity = {0.7, 0.1, 0};
    scene.bodies[1].motion = BodyScene::Motion::fixed;
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 3; ++i)
        simulation.step(scene.end);
    for (const double x : {0.0, 0.01, 0.4, 0.7, 0.811, 0.9, 1.0, 1.37, 1.99, 2.0}) {
        const VolumeFlux flux = simulation.volume_flux(plane({x, 0.5, 0}, {1, 0, 0}));
        EXPECT_NEAR(flux.flux + flux.bodies, 0.3, 1e-8) << x;
    }
    for (const double angle : {0.3, -0.5}) {
        const VolumeFlux flux = simulation.volume_flux(plane({1.0, 0.5, 0}, {std::cos(angle), std::sin(angle), 0}));
        EXPECT_NEAR(flux.flux + flux.bodies, 0.3, 1e-8) << angle;
        EXPECT_GT(flux.bodies, 0.1);
    }
    FluxScene part = plane({1.4, 0.5, 0}, {1, 0, 0}); // the free part of the section over the step
    part.low = {0, 0.2, 0};
    part.high = {2, 1, 0};
    EXPECT_NEAR(simulation.volume_flux(part).flux, simulation.volume_flux(plane({1.4, 0.5, 0}, {1, 0, 0})).flux, 1e-8);
    part.high = {2, 0.6, 0};
    EXPECT_LT(simulation.volume_flux(part).flux, 0.2);
}

// A port that a plate on its two seats closes: all that flows in leaks through the two gaps.
Scene closed_valve()
{
    Scene scene = tank();
    scene.size = {1, 1, 0};
    scene.cells = {32, 32, 1};
    scene.viscosity = 0.1;
    scene.tolerance = 1e-10;
    scene.sides[2].kind = SideScene::Kind::inflow;
    scene.sides[2].velocity = {0, 1e-4, 0};
    scene.sides[3].kind = SideScene::Kind::open;
    scene.gap.roughness = 5e-3;
    scene.bodies = {box("left", {0.35, 0.2, 0}, {0.175, 0.4, 0}), box("right", {0.35, 0.2, 0}, {0.825, 0.4, 0}),
                    box("plate", {0.5, 0.16, 0}, {0.5, 0.585, 0})};
    for (BodyScene& body : scene.bodies)
        body.motion = BodyScene::Motion::fixed;
    PairScene pair;
    pair.bodies = {"plate", "left"};
    pair.gap = scene.gap;
    scene.pairs = {pair};
    pair.bodies = {"plate", "right"};
    scene.pairs.push_back(pair);
    return scene;
}

TEST(Fluxes, AClosedValveLeaksWhatFlowsIn)
{
    const Scene scene = closed_valve();
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 5; ++i)
        EXPECT_TRUE(simulation.step(scene.end).notes.empty());
    const VolumeFlux left = simulation.volume_flux(gap("left", "plate")), right = simulation.volume_flux(gap("plate", "right"));
    EXPECT_NEAR(left.flux + right.flux, 1e-4, 1e-10);
    EXPECT_NEAR(left.flux, right.flux, 1e-8);
    EXPECT_NEAR(left.inflow, left.outflow, 1e-10);
    EXPECT_NEAR(simulation.volume_flux(side(3)).flux, 1e-4, 1e-10);
    // The same through a section that cuts the film, and through one above the plate.
    const VolumeFlux cut = simulation.volume_flux(plane({0.3, 0.5, 0}, {1, 0, 0}));
    EXPECT_NEAR(cut.film, -left.flux, 1e-9);
    EXPECT_NEAR(simulation.volume_flux(plane({0.5, 0.9, 0}, {0, 1, 0})).flux, 1e-4, 1e-10);
    EXPECT_TRUE(std::isnan(simulation.volume_flux(gap("left", "right")).flux));
}

// Fluid and bodies together pass every section alike while walls of films that it cuts move, too.
TEST(Fluxes, SectionsThroughFilmsOfMovingWalls)
{
    Scene valve = closed_valve();
    valve.bodies[2].motion = BodyScene::Motion::prescribed;
    valve.bodies[2].velocity = {0.003, 0.01, 0};
    Simulation<2> simulation(valve, Communicator());
    for (int i = 0; i < 3; ++i)
        simulation.step(valve.end);
    ASSERT_EQ(simulation.gaps().size(), 2u);
    for (const double y : {0.1, 0.35, 0.49, 0.5, 0.502, 0.51, 0.53, 0.6, 0.7, 0.99})
        for (const double slope : {0.0, 0.2, -0.4}) {
            const VolumeFlux flux = simulation.volume_flux(plane({0.4, y, 0}, {-std::sin(slope), std::cos(slope), 0}));
            if (std::abs(y - 0.5) + 0.6 * std::tan(std::abs(slope)) < 0.45 || slope == 0) { // between the sides
                EXPECT_NEAR(flux.flux + flux.bodies, 1e-4, 1e-9) << y << " " << slope;
            }
        }
}

// Around an edge the gap goes on in a second film, with cells between them: what the first passes on to the second counts once.
TEST(Fluxes, AGapRoundAnEdgeCountsItsFlowOnce)
{
    Scene scene = tank();
    scene.size = {1, 1, 0};
    scene.cells = {32, 32, 1};
    scene.viscosity = 0.1;
    scene.tolerance = 1e-11;
    scene.sides[2].kind = SideScene::Kind::inflow;
    scene.sides[2].velocity = {0, 1e-4, 0};
    scene.sides[1].kind = SideScene::Kind::open;
    const double away = std::sqrt(0.5) * (0.15 + 0.75 / 32);
    scene.bodies = {box("seat", {0.5, 0.5, 0}, {0.75, 0.25, 0}), box("poppet", {1.6, 0.3, 0}, {0.5 - away, 0.5 + away, 0})};
    scene.bodies[1].angle = 0.25 * M_PI;
    for (BodyScene& body : scene.bodies)
        body.motion = BodyScene::Motion::fixed;
    Simulation<2> simulation(scene, Communicator());
    StepReport report;
    for (int i = 0; i < 5; ++i)
        report = simulation.step(scene.end);
    ASSERT_EQ(report.notes.size(), 1u);
    EXPECT_THAT(report.notes[0], testing::HasSubstr("' goes through a film that is shorter than three of its thicknesses"));
    const double through = -simulation.volume_flux(side(2)).flux;
    EXPECT_GT(through, 0.4e-4);
    FluxScene leak = gap("poppet", "seat");
    EXPECT_NEAR(simulation.volume_flux(leak).flux, through, 1e-8 * through);
    for (const auto& [along, sign] :
         {std::pair(Triple{0, 1, 0}, 1), std::pair(Triple{1, 0, 0}, 1), std::pair(Triple{-0.6, -0.8, 0}, -1)}) {
        leak.along = along;
        EXPECT_NEAR(simulation.volume_flux(leak).flux, sign * through, 1e-8 * through);
    }
    for (const double y : {0.1, 0.3, 0.44, 0.47, 0.49})
        EXPECT_NEAR(simulation.volume_flux(plane({0.2, y, 0}, {0, 1, 0})).flux, through, 1e-8 * through) << y;
    for (const double x : {0.5, 0.51, 0.55, 0.6, 0.9}) // cuts films, and cells between them
        EXPECT_NEAR(simulation.volume_flux(plane({x, 0.5, 0}, {1, 0, 0})).flux, through, 1e-8 * through) << x;
}

// A disk above a port between two sharp seats: each gap has a film along the seat's bore and one along its top, which meet at the corner, where the gap is thinnest. Tied
// to both ends of the other, each would lead around it, and the flow would be 80 times of what it is.
TEST(Fluxes, ThroughTwoFilmsThatMeetAtACorner)
{
    Scene scene = tank();
    scene.size = {1, 1, 0};
    scene.cells = {24, 24, 1};
    scene.viscosity = 1;
    scene.gap.roughness = 1e-5;
    scene.sides[2].kind = scene.sides[3].kind = SideScene::Kind::pressure;
    scene.sides[2].table = {"", {0}, {{1}}};
    scene.sides[3].table = {"", {0}, {{0}}};
    scene.bodies = {box("left", {0.35, 0.15, 0}, {0.175, 0.425, 0}), box("right", {0.35, 0.15, 0}, {0.825, 0.425, 0}),
                    ball("disk", 0.2, {0.5, 0, 0})};
    for (BodyScene& body : scene.bodies)
        body.motion = BodyScene::Motion::fixed;
    for (const double height : {0.6424626810735107, 0.6495512256733454}) {
        scene.bodies[2].position[1] = height;
        Simulation<2> simulation(scene, Communicator());
        StepReport report;
        for (int i = 0; i < 3; ++i)
            report = simulation.step(scene.end);
        // Where a circle's gap is thinnest by h: 12 mu q = h^2 dp, for the length h that it has to either side of the corner.
        const double h = std::hypot(0.15, height - 0.5) - 0.2, slit = 2 * h * h / 12;
        EXPECT_GT(simulation.volume_flux(side(3)).flux, 0.4 * slit) << height;
        EXPECT_LT(simulation.volume_flux(side(3)).flux, 1.5 * slit) << height;
        ASSERT_EQ(report.notes.size(), 2u) << height;
        EXPECT_THAT(report.notes[0], testing::HasSubstr("between 'left' and 'disk' goes through a film that is shorter"));
        EXPECT_THAT(report.notes[1], testing::HasSubstr("between 'right' and 'disk' goes through a film that is shorter"));
    }
}

// Fluid that parting plates draw in from both sides has no direction; that of plates that slide over each other has.
TEST(Fluxes, AlongAGapWhatGoesThrough)
{
    Scene scene = tank();
    scene.size = {2, 2, 0};
    scene.cells = {64, 64, 1};
    scene.viscosity = 1;
    scene.sides[3].kind = SideScene::Kind::open;
    scene.bodies = {box("lower", {0.5, 0.25, 0}, {1.0, 0.875, 0}), box("upper", {0.5, 0.25, 0}, {1.0, 1.135, 0})};
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    scene.bodies[1].motion = BodyScene::Motion::prescribed;
    scene.bodies[1].velocity = {0, 0.1, 0};
    FluxScene through = gap("lower", "upper");
    through.along = Triple{1, 0, 0};
    Simulation<2> parting(scene, Communicator());
    parting.step(scene.end);
    EXPECT_NEAR(parting.volume_flux(gap("lower", "upper")).flux, 0.5 * 0.1 * 0.5, 1e-4);
    EXPECT_NEAR(parting.volume_flux(through).flux, 0, 1e-6);
    scene.bodies[1].velocity = {0.1, 0, 0};
    Simulation<2> sliding(scene, Communicator());
    sliding.step(scene.end);
    EXPECT_NEAR(sliding.volume_flux(through).flux, 0.5 * 0.1 * 0.01, 0.05e-3);
    through.along = Triple{-1, 0, 0};
    EXPECT_NEAR(sliding.volume_flux(through).flux, -0.5 * 0.1 * 0.01, 0.05e-3);
}

// The pressure that drives the leak is that of Poiseuille flow through the gap.
TEST(Fluxes, LeakIsThatOfPoiseuilleFlow)
{
    const Scene scene = closed_valve();
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 20; ++i)
        simulation.step(scene.end);
    const double h = 5e-3, length = 0.1,
                 drop = at(simulation, Vec<2>(0.5, 0.2)).pressure - at(simulation, Vec<2>(0.5, 0.9)).pressure;
    EXPECT_NEAR(simulation.volume_flux(gap("left", "plate")).flux, h * h * h * drop / (12 * scene.viscosity * length),
                0.05 * 0.5e-4);
}

// A box that rests on the floor in flowing viscous fluid, one that a spring holds in it, and a wall that slides.
TEST(ForceParts, AddUpToTheFluidsForceAndContactCarriesTheRest)
{
    Scene scene = tank();
    scene.gravity = {0, -1, 0};
    scene.viscosity = 0.01;
    scene.forces = true;
    scene.sides[0].kind = SideScene::Kind::inflow;
    scene.sides[0].velocity = {0.2, 0, 0};
    scene.sides[1].kind = SideScene::Kind::open;
    scene.contact.friction = 2;
    scene.gap.roughness = 1e-4;
    scene.bodies = {box("block", {0.3, 0.2, 0}, {0.8, 0.1 + 1e-4, 0}), ball("ball", 0.1, {1.3, 0.6, 0})};
    scene.bodies[0].density = 3;
    scene.bodies[1].motion = BodyScene::Motion::fixed;
    Simulation<2> simulation(scene, Communicator());
    for (const ForceParts<2>& part : simulation.force_parts())
        EXPECT_GT(part.fluid()[1], 0); // buoyancy alone, at the start
    for (int i = 0; i < 10; ++i) {
        simulation.step(scene.end);
        for (int b = 0; b < 2; ++b) {
            const ForceParts<2>& parts = simulation.force_parts()[b];
            const Twist<2>& whole = simulation.fluid_wrenches()[b];
            const double size = parts.pressure.norm() + parts.shear.norm() + parts.film.norm() + parts.buoyancy.norm();
            EXPECT_NEAR((parts.fluid() - whole).norm(), 0, 1e-13 * size) << b;
        }
    }
    const ForceParts<2>&block = simulation.force_parts()[0], &held = simulation.force_parts()[1];
    EXPECT_NEAR(block.buoyancy[1], 0.06, 1e-15);
    EXPECT_NEAR(held.buoyancy[1], M_PI * 0.01, 1e-12);
    EXPECT_GT(held.shear[0], 0);
    EXPECT_GT(held.pressure[0], 0);
    EXPECT_TRUE(held.film.isZero(0) && held.contact.isZero(0));
    // The block rests: what the fluid does not carry of its weight the floor does, and friction holds it against the stream.
    ASSERT_LT(simulation.bodies()[0].twist.norm(), 1e-6);
    const Vec<2> weight(0, -3 * 0.06);
    EXPECT_NEAR((block.fluid() + block.contact).head<2>().dot(Vec<2>::UnitY()), -weight[1], 0.01 * 0.18);
    EXPECT_NEAR(block.fluid()[0] + block.contact[0], 0, 0.01 * 0.18);
    double normal = 0;
    for (const GapState& state : simulation.gaps())
        normal += state.contact_force;
    EXPECT_NEAR(std::abs(block.contact[1]), normal, 1e-12 * (1 + normal));
}

} // namespace
} // namespace gapflow
