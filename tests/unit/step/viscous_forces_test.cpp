// Parts of the forces on bodies in viscous fluid on parts.
#include "unit/step/scenes.hpp"

#include "gapflow/body/rigid_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gapflow {
namespace {

// All parts and the weight are what the momentum of each body gains, with impacts and contacts that hold.
TEST(ViscousForces, AddUpToTheChangeOfMomentum)
{
    Scene scene = box_of_fluid(2, 20, SideScene::Kind::wall);
    scene.viscosity = 0.005;
    scene.contact.thickness = 0.006;
    scene.gravity = {0.3, -4, 0};
    scene.contact.friction = 0.3;
    scene.max_step = 0.02;
    scene.forces = true;
    scene.tolerance = 1e-11;
    BodyScene rests = body("rests", BodyScene::ShapeKind::box, {0.3, 0.0813, 0}),
              falls = body("falls", BodyScene::ShapeKind::ball, {0.63, 0.13, 0}, {0.1, -1, 0});
    rests.size = {0.2, 0.15, 0};
    rests.density = 3;
    falls.density = 4;
    falls.radius = 0.11;
    scene.bodies = {rests, falls};
    Simulation<2> run(scene, Communicator());
    double touched = 0, rubbed = 0;
    for (int k = 0; k < 12; ++k) {
        const std::vector<RigidBody<2>> before = run.bodies();
        const double dt = run.step(100).dt;
        for (std::size_t b = 0; b < before.size(); ++b) {
            const ForceParts<2>& parts = run.force_parts()[b];
            const RigidBody<2>& body = run.bodies()[b];
            const Twist<2> gained = mass_matrix(body) * (body.twist - before[b].twist) / dt;
            Twist<2> all = parts.fluid() + parts.contact;
            all[0] += body.mass * scene.gravity[0];
            all[1] += body.mass * scene.gravity[1];
            const double scale = std::max(gained.norm(), body.mass * 4);
            EXPECT_LT((all - gained).norm(), 1e-7 * scale) << k << " " << b;
            EXPECT_LT((parts.fluid() - run.fluid_wrenches()[b]).norm(), 1e-12 * scale);
            touched = std::max(touched, parts.contact[1] / (body.mass * 4));
            rubbed = std::max(rubbed, std::abs(parts.shear[0]) / (body.mass * 4));
        }
    }
    EXPECT_GT(touched, 0.3);
    EXPECT_GT(rubbed, 1e-4);
}

/// A plate of 0.2 at a height of 0.06, a third of a cell, that goes along a wall.
std::unique_ptr<Simulation<2>> sheared_plate(double floor, double plate)
{
    Scene scene = box_of_fluid(2, 6, SideScene::Kind::periodic);
    scene.tolerance = 1e-12;
    scene.viscosity = 1;
    scene.sides[2].kind = scene.sides[3].kind = SideScene::Kind::wall;
    scene.sides[2].velocity = {floor, 0, 0};
    scene.sides[3].velocity = {0.7, 0, 0};
    scene.forces = true;
    scene.max_step = 0.1;
    scene.bodies = {body("plate", BodyScene::ShapeKind::box, {0.5, 0.16, 0}, {plate, 0, 0})};
    scene.bodies[0].motion = plate == 0 ? BodyScene::Motion::fixed : BodyScene::Motion::prescribed;
    scene.bodies[0].size = {3, 0.2, 0};
    auto run = std::make_unique<Simulation<2>>(scene, Communicator());
    while (run->time() < 1.2)
        run->step(1.2);
    return run;
}

// Friction of a gap in closed form is told as that of a gap, else as that of all fluid.
TEST(ViscousForces, ShearIsToldByWhereItIs)
{
    const auto moving = sheared_plate(0, 0.3), sliding = sheared_plate(-0.3, 0);
    EXPECT_NEAR(moving->force_parts()[0].film[0], -0.3 / 0.06, 1e-5);
    EXPECT_NEAR(moving->force_parts()[0].shear[0], 0.4 / 0.74, 1e-5);
    EXPECT_NEAR(sliding->force_parts()[0].film[0], -0.3 / 0.06, 0.02); // a wall that slides is one of the gap's; 0.007
    EXPECT_NEAR(sliding->force_parts()[0].shear[0], 0.7 / 0.74, 1e-5);
}

// In slow flow a cylinder far from others bears half of its drag by pressure and half by friction.
TEST(ViscousForces, HalfOfASlowCylindersDragIsFriction)
{
    Scene scene = box_of_fluid(2, 32, SideScene::Kind::periodic);
    scene.tolerance = 1e-10;
    scene.viscosity = 1;
    scene.mean_velocity = Triple{1e-3, 0, 0};
    scene.forces = true;
    scene.max_step = 0.1;
    scene.bodies = {body("cylinder", BodyScene::ShapeKind::ball, {0.513, 0.487, 0})};
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    scene.bodies[0].radius = 0.08;
    Simulation<2> run(scene, Communicator());
    while (run.time() < 0.6)
        run.step(0.6);
    const ForceParts<2>& parts = run.force_parts()[0];
    EXPECT_NEAR(parts.shear[0] / run.fluid_wrenches()[0][0], 0.5, 0.02);
}

} // namespace
} // namespace gapflow
