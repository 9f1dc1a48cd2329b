// Bodies that touch in viscous fluid, with no roughness that would keep their films from closing: the solver finds pressure and motion.
#include "gapflow/core/error.hpp"
#include "gapflow/step/simulation.hpp"
#include "temporary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace gapflow {
namespace {

Scene tank(int cells, double viscosity)
{
    Scene scene;
    scene.size = {1, 1, 0};
    scene.cells = {cells, cells, 1};
    scene.gravity = {0, -1, 0};
    scene.viscosity = viscosity;
    scene.end = 1;
    scene.max_step = 0.01;
    return scene;
}

BodyScene ball(const std::string& name, double radius, double x, double y, double density)
{
    BodyScene body;
    body.name = name;
    body.radius = radius;
    body.position = {x, y, 0};
    body.density = density;
    return body;
}

BodyScene box(const std::string& name, double width, double height, double x, double y, double density)
{
    BodyScene body = ball(name, 0, x, y, density);
    body.shape = BodyScene::ShapeKind::box;
    body.size = {width, height, 0};
    return body;
}

// Without films the cells between two disks that touch are pockets, whose fluid holds the disks against what pulls them apart. Where the contact holds them, too, it carries
// all of that force, and the pressure of the pockets has no effect: what round-off leaves of its energy must not be inverted.
TEST(Touching, DisksWithPocketsBetweenThemStay)
{
    Scene scene = tank(48, 0);
    scene.size = {8, 8, 0};
    scene.gravity = {0, 0, 0};
    scene.max_step = 0.02;
    scene.gap.film = false;
    scene.fractions = Scene::Fractions::voxel;
    scene.bodies = {ball("right", 1, 5, 4, 2), ball("left", 1, 3, 4, 2)};
    scene.bodies[0].force = {1, 0, 0};
    scene.bodies[1].force = {-1, 0, 0};
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 6; ++i)
        simulation.step(1e9);
    EXPECT_NEAR(simulation.bodies()[0].pose.position[0], 5, 1e-9);
    EXPECT_NEAR(simulation.bodies()[1].pose.position[0], 3, 1e-9);
}

// Two balls in the slots of a comb that stands in a closed tank: one lies on the bottom of its slot, a film leads around it from side to side. The tank's level is that
// of all of the fluid, and no body feels it: what the round-off of its extension into the films leaves of its energy must not be inverted. (With it a step takes up to 400
// iterations, or fails.)
TEST(Touching, BallsInTheSlotsOfAComb)
{
    const double dx = 2.5e-4, radius = 0.0006905983841524675;
    const test::TemporaryFile comb(
        "comb.txt", "-0.0028994484603977163 0\n0.0028994484603977163 0\n"
                    "0.0028994484603977163 0.002157066611219857\n0.0019396690762386298 0.002157066611219857\n"
                    "0.0019396690762386298 0.0008815465622869965\n0.00047988969207954325 0.0008815465622869965\n"
                    "0.00047988969207954325 0.002157066611219857\n-0.00047988969207954325 0.002157066611219857\n"
                    "-0.00047988969207954325 0.0008815465622869965\n-0.0019396690762386298 0.0008815465622869965\n"
                    "-0.0019396690762386298 0.002157066611219857\n-0.0028994484603977163 0.002157066611219857\n");
    Scene scene = tank(52, 0.0016338985505623123);
    scene.size = {52 * dx, 58 * dx, 0};
    scene.cells = {52, 58, 1};
    scene.max_step = 0.000820665205373266;
    scene.gap.roughness = 0.005 * dx;
    BodyScene b0;
    b0.name = "b0";
    b0.shape = BodyScene::ShapeKind::mesh;
    b0.mesh_file = comb.path();
    b0.position = {0.0065, 0.00228535583082132, 0};
    b0.motion = BodyScene::Motion::fixed;
    scene.bodies = {b0, ball("b1", radius, 0.005290220615840914, 0.0038575007772607838, 137.30327529601033),
                    ball("b2", radius, 0.007709779384159087, 0.0041075007772607836, 561.7322144932281)};
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 12; ++i)
        EXPECT_LT(simulation.step(1e9).iterations, 30) << "step " << i + 1;
}

// A film of 1e-9 cells under a box: 1e-27 of a cell's conductance.
TEST(Touching, BoxOnTheFloorRests)
{
    for (double density : {1.5, 1e3}) {
        Scene scene = tank(24, 1e-3);
        scene.bodies = {box("a", 0.2, 0.2, 0.5, 0.1, density)};
        Simulation<2> simulation(scene, Communicator());
        for (int i = 0; i < 4; ++i)
            EXPECT_LT(simulation.step(1e9).iterations, 100) << density;
        EXPECT_NEAR(simulation.bodies()[0].pose.position[1], 0.1, 1e-8) << density;
    }
}

// Between a wall and a ceiling as well, fitted in.
TEST(Touching, BoxFromFloorToCeilingStaysAndFluidBesideRests)
{
    Scene scene = tank(24, 1e-3);
    scene.bodies = {box("a", 0.5, 1, 0.5, 0.5, 2)};
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 3; ++i)
        simulation.step(1e9);
    EXPECT_NEAR(simulation.bodies()[0].pose.position[0], 0.5, 1e-8);
    EXPECT_LT(simulation.bodies()[0].twist.norm(), 1e-8);
}

// Between two balls in a row on the floor lies a pocket that only films drain.
TEST(Touching, DryBallsInARowArePulled)
{
    Scene scene = tank(64, 0.01);
    scene.gravity = {};
    scene.sides[3].kind = SideScene::Kind::open;
    scene.reference_pressure = 1;
    scene.gap.contact = GapScene::Contact::dry;
    scene.contact.thickness = 1e-3;
    scene.contact.friction = 0.3;
    const double pull[] = {0.195, 0.080, 0.360};
    for (int i = 0; i < 3; ++i) {
        scene.bodies.push_back(ball("b" + std::to_string(i), 0.1, 0.25 + 0.201 * i, 0.101, 2));
        scene.bodies.back().force = {0, pull[i], 0};
    }
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 3; ++i)
        simulation.step(1e9);
    for (const RigidBody<2>& body : simulation.bodies())
        EXPECT_LT(body.twist.norm(), 0.1) << body.name;
}

// In a closed tank as well: what its front displaces the other one's back leaves, and what the closing gap between them squeezes out.
TEST(Touching, APrescribedBoxPushesAFreeOne)
{
    Scene scene = tank(16, 0);
    scene.gravity = {};
    scene.gap.roughness = 0.005 / 16;
    scene.bodies = {box("pushing", 0.2, 0.1, 0.25, 0.6, 1), box("pushed", 0.1, 0.2, 0.4005, 0.6, 2)};
    scene.bodies[0].motion = BodyScene::Motion::prescribed;
    scene.bodies[0].velocity = {1, 0, 0};
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 6; ++i)
        simulation.step(1e9);
    EXPECT_NEAR(simulation.bodies()[1].twist[0], 1, 1e-3);
}

// Teeth that are about to meet do not shut what lies between them.
TEST(Touching, APrescribedGearDrivesAFreeOne)
{
    std::string teeth;
    for (int tooth = 0; tooth < 6; ++tooth)
        for (const auto& [degrees, radius] : {std::pair(0, 0.13), {6, 0.17}, {30, 0.17}, {36, 0.13}}) {
            const double angle = (60 * tooth + degrees) * std::numbers::pi / 180;
            teeth += std::to_string(radius * std::cos(angle)) + " " + std::to_string(radius * std::sin(angle)) + "\n";
        }
    const test::TemporaryFile file("gear.txt", teeth);
    Scene scene = tank(48, 0);
    scene.gravity = {};
    scene.max_step = 0.02;
    scene.gap.roughness = 0.005 / 48;
    for (const bool drives : {true, false}) {
        BodyScene gear = ball(drives ? "driving" : "driven", 0, drives ? 0.33 : 0.64, 0.5, 2);
        gear.shape = BodyScene::ShapeKind::mesh;
        gear.mesh_file = file.path();
        gear.angle = (drives ? 13.4 : 38.5) * std::numbers::pi / 180;
        if (drives) {
            gear.motion = BodyScene::Motion::prescribed;
            gear.angular_velocity = {1, 0, 0};
        } else {
            gear.hinge = HingeScene{{0.64, 0.5, 0}};
        }
        scene.bodies.push_back(gear);
    }
    Simulation<2> simulation(scene, Communicator());
    for (int i = 0; i < 8; ++i)
        simulation.step(1e9);
    EXPECT_NEAR(simulation.bodies()[1].twist[2], -1, 0.1);
}

// A ball closes the hole between two boxes against suction: it touches their corners, where no film is as thin as the roughness.
TEST(Touching, BallOnTheCornersOfItsSeatSealsTheInflow)
{
    Scene scene = tank(32, 0);
    scene.sides[2].kind = SideScene::Kind::inflow;
    scene.sides[2].velocity = {0, -0.05, 0};
    scene.sides[3].kind = SideScene::Kind::open;
    scene.gap.roughness = 0.005 / 32;
    for (double x : {0.18, 0.82}) {
        scene.bodies.push_back(box(x < 0.5 ? "left" : "right", 0.36, 0.2, x, 0.3, 1));
        scene.bodies.back().motion = BodyScene::Motion::fixed;
    }
    scene.bodies.push_back(ball("valve", 0.23, 0.5, 0.4 + std::sqrt(0.231 * 0.231 - 0.14 * 0.14), 1.1));
    Simulation<2> simulation(scene, Communicator());
    std::string message;
    try {
        for (int i = 0; i < 150; ++i)
            simulation.step(1e9);
    } catch (const ComputationError& error) {
        message = error.what();
    }
    EXPECT_NE(message.find("the inflow at y_low changes the volume of fluid sealed in"), std::string::npos) << message;
    EXPECT_NE(message.find("'valve' and 'left', 'valve' and 'right' touch"), std::string::npos) << message;
}

} // namespace
} // namespace gapflow
