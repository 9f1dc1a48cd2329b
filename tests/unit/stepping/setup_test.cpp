// What is refused or told of before the first step.
#include "gapflow/core/error.hpp"
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/placement.hpp"
#include "gapflow/stepping/setup.hpp"

#include "temporary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gapflow {
namespace {

Scene scene_of(int cells)
{
    Scene scene;
    scene.file = "scene.toml";
    scene.size = {1, 1, 0};
    scene.cells = {cells, cells, 1};
    return scene;
}

TEST(Memory, IsRefusedWithTheNumberThatItWouldTake)
{
    const double mebibyte = 1048576;
    const Communicator comm;
    EXPECT_NO_THROW(require_memory(scene_of(100), comm, 100 * mebibyte));
    try {
        require_memory(scene_of(2000), comm, 100 * mebibyte); // 45 MB and 4e6 cells of 325 bytes
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("scene.toml: domain.cells: 4e+06 cells need about 1.25 GiB of memory"));
        EXPECT_THAT(error.what(), testing::HasSubstr("on a machine that has 0.0977 GiB; use fewer cells"));
    }
}

BodyScene ball(const std::string& name, double x, double radius, BodyScene::Motion motion)
{
    BodyScene body;
    body.name = name;
    body.radius = radius;
    body.position = {x, 0.5, 0};
    body.density = 1;
    body.motion = motion;
    return body;
}

std::vector<std::string> warnings_of(const Scene& scene)
{
    return placement_warnings<2>(scene, make_bodies<2>(scene), make_walls<2>(scene));
}

TEST(Placement, TellsOfOverlapsAndOfWhatIsOutside)
{
    using Motion = BodyScene::Motion;
    Scene scene = scene_of(50);
    scene.bodies = {ball("a", 0.4, 0.1, Motion::free), ball("b", 0.61, 0.1, Motion::fixed)};
    EXPECT_THAT(warnings_of(scene), testing::IsEmpty());
    scene.bodies[1].position[0] = 0.59; // half a cell deep
    EXPECT_THAT(warnings_of(scene), testing::IsEmpty());
    scene.bodies[1].position[0] = 0.5;
    EXPECT_THAT(warnings_of(scene),
                testing::ElementsAre(testing::StartsWith("'a' and 'b' overlap by 0.1 (5 cells) at the start; contact")));
    scene.bodies[0].motion = Motion::fixed;
    EXPECT_THAT(warnings_of(scene), testing::ElementsAre(testing::HasSubstr("they count as one solid")));
    scene.bodies[1].position[0] = 1.05; // through a wall: only of a free body
    EXPECT_THAT(warnings_of(scene), testing::IsEmpty());
    scene.bodies[1].motion = Motion::free;
    EXPECT_THAT(warnings_of(scene), testing::ElementsAre(testing::StartsWith("'b' and 'wall:x_high' overlap by 0.15")));
    scene.bodies[1].motion = Motion::fixed;
    scene.bodies[1].position[0] = 1.2;
    EXPECT_THAT(warnings_of(scene),
                testing::ElementsAre("body 'b' lies outside the domain, where there is no fluid; put it inside, or "
                                     "remove it"));
    scene.bodies[1].motion = Motion::prescribed;
    EXPECT_THAT(warnings_of(scene), testing::ElementsAre(testing::EndsWith("its motion should bring it in")));
    scene.sides[1].kind = SideScene::Kind::surface; // above water
    EXPECT_THAT(warnings_of(scene), testing::IsEmpty());
}

std::string refusal_of(const Scene& scene)
{
    try {
        warnings_of(scene);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Placement, RefusesFreeBodiesOutsideTheDomainAndInOnePlaceWithOthers)
{
    using Motion = BodyScene::Motion;
    Scene scene = scene_of(50);
    scene.bodies = {ball("a", -0.2, 0.1, Motion::free)};
    EXPECT_EQ(refusal_of(scene),
              "scene.toml: body 'a' lies outside the domain, where there is no fluid; put it inside, or remove it");
    scene.bodies[0].velocity[0] = 0.1;
    EXPECT_NE(refusal_of(scene), ""); // the wall keeps it out
    scene.sides[0].kind = SideScene::Kind::open;
    EXPECT_THAT(warnings_of(scene), testing::ElementsAre(testing::EndsWith("its motion should bring it in")));
    scene.bodies[0].velocity[0] = 0;
    EXPECT_NE(refusal_of(scene), "");
    scene.gravity[0] = 9.81;
    EXPECT_NE(refusal_of(scene), ""); // as heavy as the fluid
    scene.bodies[0].density = 2;
    EXPECT_EQ(refusal_of(scene), "");
    scene.gravity[0] = 0;
    scene.sides[0].kind = scene.sides[1].kind = SideScene::Kind::periodic;
    EXPECT_EQ(refusal_of(scene), "");
    for (const Motion other : {Motion::free, Motion::fixed, Motion::prescribed}) {
        scene.bodies = {ball("a", 0.5, 0.1, Motion::free), ball("b", 0.5, 0.1, other)};
        EXPECT_EQ(refusal_of(scene), "scene.toml: 'a' and 'b' are in one place; move one of them, or remove it");
        scene.bodies[1].radius = 0.3;
        EXPECT_EQ(refusal_of(scene), "scene.toml: 'a' lies wholly inside 'b'; move one of them, or remove it");
        std::swap(scene.bodies[0], scene.bodies[1]);
        EXPECT_EQ(refusal_of(scene), "scene.toml: 'a' lies wholly inside 'b'; move one of them, or remove it");
    }
    scene.bodies[0].inside_out = true; // a container, with room
    scene.bodies[0].motion = Motion::fixed;
    EXPECT_EQ(refusal_of(scene), "");
    scene.bodies[1].position[0] = 0.1; // in its wall
    EXPECT_EQ(refusal_of(scene), "scene.toml: 'a' lies wholly inside 'b'; move one of them, or remove it");
    scene.bodies[0].inside_out = false; // solids that stand still are one
    scene.bodies[1] = ball("a", 0.5, 0.1, Motion::fixed);
    EXPECT_EQ(refusal_of(scene), "");
}

// A part of 0.4 m whose file is in millimetres.
TEST(Placement, AsksForTheUnitOfAMeshFarWiderThanTheDomain)
{
    const test::TemporaryFile square("square.txt", "-200 -200\n200 -200\n200 200\n-200 200\n");
    Scene scene = scene_of(50);
    scene.bodies = {ball("part", 0.5, 0, BodyScene::Motion::free)};
    scene.bodies[0].shape = BodyScene::ShapeKind::mesh;
    scene.bodies[0].mesh_file = square.path();
    const auto question =
        testing::EndsWith("body 'part' is 400 times as wide as the domain: is its file in millimetres? then scale = 0.001");
    EXPECT_THAT(warnings_of(scene), testing::Contains(question));
    std::vector<RigidBody<2>> bodies = make_bodies<2>(scene);
    try {
        take_out_overlaps<2>(scene, make_grid<2>(scene, Communicator()), bodies, make_walls<2>(scene));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("cannot be pushed apart; move them; body 'part'"));
        EXPECT_THAT(error.what(), question);
    }
    scene.sides[0].kind = scene.sides[1].kind = SideScene::Kind::periodic;
    try {
        make_bodies<2>(scene);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("body 'part' is 400 times as wide as the domain along x, which is periodic"));
        EXPECT_THAT(error.what(), testing::EndsWith("with scale = 0.001 if its file is in millimetres"));
    }
    scene.sides[0].kind = scene.sides[1].kind = SideScene::Kind::wall;
    scene.bodies[0].mesh_scale = 0.001;
    EXPECT_THAT(warnings_of(scene), testing::IsEmpty());
    scene.bodies[0].motion = BodyScene::Motion::fixed;
    scene.bodies[0].mesh_scale = 0.02; // a bed under a small domain
    EXPECT_THAT(warnings_of(scene), testing::IsEmpty());
}

/// h_c in cells of a pair of a scene's solids.
template <int D>
double threshold_of(const Scene& scene, int a, int b, bool moving = true)
{
    const auto bodies = make_bodies<D>(scene);
    const auto walls = make_walls<D>(scene);
    return gap_settings<D>(scene, make_solids<D>(bodies, walls), moving)(a, b).threshold / scene.spacing();
}

TEST(GapSettings, FilmsOfCurvedBodiesReachByTheRadiusOfThePair)
{
    using Motion = BodyScene::Motion;
    Scene scene = scene_of(50);
    const int wall = 3;
    BodyScene box = ball("box", 0.5, 0, Motion::free), flap = ball("flap", 0.7, 0.01, Motion::free);
    box.shape = BodyScene::ShapeKind::box;
    box.size = {0.1, 0.1, 0};
    flap.shape = BodyScene::ShapeKind::capsule;
    flap.length = 0.5;
    scene.bodies = {ball("a", 0.2, 0.1, Motion::free), box, flap}; // five cells a radius
    const double ideal = 1 - std::sqrt(0.75), viscous = 1 - std::sqrt(0.5);
    EXPECT_NEAR(threshold_of<2>(scene, 0, wall), 5 * ideal, 1e-12);
    EXPECT_NEAR(threshold_of<2>(scene, 0, 0), 2.5 * ideal, 1e-12); // its own image
    EXPECT_NEAR(threshold_of<2>(scene, 0, 1), 5 * ideal, 1e-12);
    EXPECT_NEAR(threshold_of<2>(scene, 1, wall), 2.25, 1e-12); // flat
    EXPECT_NEAR(threshold_of<2>(scene, 2, wall), 1.5, 1e-12);  // a thin plate with round ends is as flat as it is long
    scene.viscosity = 1;
    EXPECT_NEAR(threshold_of<2>(scene, 0, wall), 5 * viscous, 1e-12);
    EXPECT_NEAR(threshold_of<2>(scene, 0, wall, false), 5 * ideal, 1e-12); // added mass does not depend on viscosity
    scene.bodies[0].radius = 0.2;
    EXPECT_NEAR(threshold_of<2>(scene, 0, wall), 1.5, 1e-12);
    scene.viscosity = 0;
    scene.bodies[2] = ball("container", 0.2, 0.205, Motion::fixed);
    scene.bodies[2].inside_out = true;
    EXPECT_NEAR(threshold_of<2>(scene, 0, 2), 1.5, 1e-12); // surfaces that nest stay together for long
    scene.gap.threshold = 0.3;
    EXPECT_NEAR(threshold_of<2>(scene, 0, 2), 0.3, 1e-12);

    Scene rods; // in 3D capsules are round
    rods.dimension = 3;
    rods.size = {1, 1, 1};
    rods.cells = {50, 50, 50};
    rods.bodies = {flap};
    EXPECT_NEAR(threshold_of<3>(rods, 0, 1), 0.5 * ideal, 1e-12);
}

/// How much faster two balls of four cells radius start across their line with default films than without any, less one.
double gain_across()
{
    double speed[2];
    for (const bool film : {false, true}) {
        Scene scene;
        scene.dimension = 3;
        scene.size = {24, 24, 24};
        scene.cells = {24, 24, 24};
        scene.gap.film = film;
        scene.end = 1;
        scene.max_step = 0.01;
        for (const double side : {-1.0, 1.0}) {
            BodyScene body = ball(side < 0 ? "low" : "high", 12.2, 4, BodyScene::Motion::free);
            body.position = {12.2, 12.4, 12.1 + side * 4.04};
            body.force = {1, 0, 0};
            scene.bodies.push_back(body);
        }
        Simulation<3> simulation(scene, Communicator());
        simulation.step(1);
        speed[film] = simulation.bodies()[0].twist[0];
    }
    return speed[1] / speed[0] - 1;
}

TEST(GapSettings, FilmsDoNotSlowBodiesThatMoveTogether)
{
    EXPECT_NEAR(gain_across(), 0, 3e-3); // -0.03 where films reach to gaps of 1.5 cells
}

} // namespace
} // namespace gapflow
