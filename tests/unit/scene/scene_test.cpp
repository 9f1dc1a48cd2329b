#include "temporary.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/scene/keys.hpp"
#include "gapflow/scene/parse_scene.hpp"
#include "gapflow/scene/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <set>

namespace gapflow {
namespace {

constexpr double pi = std::numbers::pi;
const std::string data = std::string(GAPFLOW_TEST_DATA) + "/bad_scenes/";

const std::string flat_scene = R"(
title = "all of 2D"
gravity = [0, -9.81]
[domain]
size = [4.0, 2]
cells = [64, 32]
origin = [-2, 0.5]
leaving = "remove"
[domain.sides]
x_low = { inflow = [1, 0.25] }
x_high = "open"
y_low = { wall = [0.5, 0] }
y_high = "wall"
[fluid]
density = 1000
viscosity = 0
reference_pressure = 1e5
vapour_pressure = "none"
velocity = [1, 0]
mean_velocity = [0, 0]
initial = "potential"
[grid]
fractions = "voxel"
advection = "semi-lagrangian"
thin = "allow"
[gap]
model = "film"
threshold = 1.5
contact = "wet"
roughness = 1e-6
entrance_loss = 0.5
exit = "jet"
[contact]
restitution = 0
friction = 0.0
thickness = 1e-4
[[pair]]
bodies = ["box", "wall:y_low"]
threshold = "auto"
roughness = 1e-5
[[pair]]
bodies = ["ball", "box"]
model = "none"
thickness = 0.25
[[body]]
name = "box"
shape = "box"
size = [1, 0.5]
position = [0, 1]
rotation = 30
density = 2000
velocity = [0.1, 0]
angular_velocity = 0.5
force = [0, 1]
torque = -2
[[body]]
name = "ball"
shape = "ball"
radius = 0.25
position = [1, 1]
mass = 3
inertia = 0.5
free = ["x", "rz"]
[body.spring]
anchor = [2, 3]
stiffness = 10
damping = 0.25
[[body]]
name = "arm"
shape = "capsule"
radius = 0.1
length = 0.5
motion = "prescribed"
file = "MOTION"
[[body]]
name = "foil"
shape = "sheet"
points = [[0.2, 0.2], [0.4, 0.2], [0.5, 0.3]]
scale = 0.5
thickness = 1e-3
motion = "fixed"
[[body]]
name = "ramp"
shape = "half-space"
normal = [1, 1]
motion = "prescribed"
velocity = [0, 0.1]
[time]
end = 1
max_step = 0.01
cfl = 0.5
gap_cfl = 0.125
until_steady = 0.25
[solver]
tolerance = 1e-10
backend = "petsc"
[output]
directory = "elsewhere"
every = 0.05
fields = ["pressure"]
checkpoint_every = 0.5
precision = "single"
format = "appended"
forces = true
bodies = "both"
)";

const std::string deep_scene = R"(
[domain]
size = [1, 1, 1]
cells = [8, 8, 8]
[domain.sides]
z_low = "periodic"
z_high = "periodic"
[fluid]
pressure_gradient = [0, 0, -0.5]
[[body]]
name = "post"
shape = "cylinder"
radius = 0.1
length = 0.5
rotation = { axis = [0, 3, 0], degrees = -90 }
mass = 2
inertia = [[1, 0.1, 0], [0.1, 2, 0], [0, 0, 3]]
angular_velocity = [0, 0, 1]
torque = [1, 2, 3]
[body.hinge]
point = [0, 0, 0.25]
axis = [0, 0, 2]
[[body]]
name = "shell"
shape = "mesh"
file = "MESH"
scale = 1e-3
inside_out = true
rotation = [2, 0, 0, 2]
motion = "prescribed"
motion_file = "MOTION3"
interpolation = "linear"
)";

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    return text.replace(text.find(what), what.size(), by);
}

Scene flat(const std::vector<std::pair<std::string, std::string>>& overrides = {})
{
    const test::TemporaryFile file("flat.toml", replaced(flat_scene, "MOTION", data + "motion.csv"));
    return read_scene(file.path(), overrides, Purpose::run);
}

Scene deep()
{
    const test::TemporaryFile motion("motion3.csv", "0,1,2,3,1,0,0,0\n1,1,2,4,0,0,0,1\n");
    const test::TemporaryFile mesh("mesh.obj", "v 0 0 0\n");
    const test::TemporaryFile file("deep.toml", replaced(replaced(deep_scene, "MESH", mesh.path()), "MOTION3", motion.path()));
    return read_scene(file.path(), {}, Purpose::added_mass);
}

Scene minimal()
{
    const test::TemporaryFile file("minimal.toml", "[domain]\nsize = [4, 2]\ncells = [2, 1]\n");
    return read_scene(file.path(), {}, Purpose::check);
}

TEST(Scene, EveryKeyIsReadHere)
{
    for (const KeyInfo& key : scene_keys()) {
        if (key.name.starts_with("crowd.") || key.name.starts_with("probe.") || key.name.starts_with("flux.") ||
            key.name == "domain.spacing" || key.name.starts_with("domain.core") || key.name == "domain.growth" ||
            key.name == "domain.largest" || key.name == "domain.follow" || key.name == "time.long_ways") // tests of their own
            continue;
        std::string line = "\n";
        line += last_part(key.name) + " = ";
        EXPECT_TRUE((flat_scene + deep_scene).find(line) != std::string::npos) << key.name;
    }
}

TEST(Scene, TableOfKeysIsComplete)
{
    std::set<std::string> names;
    for (const KeyInfo& key : scene_keys()) {
        EXPECT_TRUE(names.insert(key.name).second) << key.name << " twice";
        EXPECT_FALSE(key.meaning.empty()) << key.name;
        for (int dimension : {0, 2, 3})
            EXPECT_FALSE(allowed_values(key, dimension).empty()) << key.name;
    }
}

TEST(Scene, DomainFluidGrid)
{
    const Scene s = flat();
    EXPECT_EQ(s.title, "all of 2D");
    EXPECT_EQ(s.dimension, 2);
    EXPECT_EQ(s.gravity, (Triple{0, -9.81, 0}));
    EXPECT_EQ(s.size, (Triple{4, 2, 0}));
    EXPECT_EQ(s.cells, (std::array<int, 3>{64, 32, 1}));
    EXPECT_EQ(s.origin, (Triple{-2, 0.5, 0}));
    EXPECT_EQ(s.sides[0].kind, SideScene::Kind::inflow);
    EXPECT_EQ(s.sides[0].velocity, (Triple{1, 0.25, 0}));
    EXPECT_EQ(s.sides[1].kind, SideScene::Kind::open);
    EXPECT_EQ(s.sides[2].kind, SideScene::Kind::wall);
    EXPECT_EQ(s.sides[2].velocity, (Triple{0.5, 0, 0}));
    EXPECT_EQ(s.sides[3].kind, SideScene::Kind::wall);
    EXPECT_EQ(s.density, 1000);
    EXPECT_EQ(s.reference_pressure, 1e5);
    EXPECT_EQ(s.fluid_velocity, (Triple{1, 0, 0}));
    EXPECT_EQ(s.mean_velocity, (Triple{0, 0, 0}));
    EXPECT_FALSE(s.pressure_gradient);
    EXPECT_EQ(s.initial, Scene::Initial::potential);
    EXPECT_EQ(s.fractions, Scene::Fractions::voxel);
    EXPECT_EQ(s.advection, Scene::Advection::semi_lagrangian);
    EXPECT_EQ(s.thin, Scene::Thin::allow);
    EXPECT_EQ(s.tolerance, 1e-10);
    EXPECT_EQ(s.backend, Scene::Backend::petsc);
    EXPECT_EQ(s.end, 1);
    EXPECT_EQ(s.max_step, 0.01);
    EXPECT_EQ(s.cfl, 0.5);
    EXPECT_EQ(s.gap_cfl, 0.125);
    EXPECT_EQ(s.output_directory, "elsewhere");
    EXPECT_EQ(s.output_every, 0.05);
    EXPECT_EQ(s.fields, std::vector<std::string>{"pressure"});
    EXPECT_EQ(s.checkpoint_every, 0.5);
    EXPECT_EQ(s.leaving, Scene::Leaving::remove);
    EXPECT_EQ(s.until_steady, 0.25);
    EXPECT_EQ(s.precision, Scene::Precision::single);
    EXPECT_EQ(s.format, Scene::Format::appended);
    EXPECT_TRUE(s.forces);
    EXPECT_TRUE(s.warnings.empty());
}

TEST(Scene, GapsOfPairsStartFromTheDefaults)
{
    const Scene s = flat();
    EXPECT_TRUE(s.gap.film);
    EXPECT_EQ(s.gap.threshold, 1.5);
    EXPECT_EQ(s.gap.entrance_loss, 0.5);
    EXPECT_EQ(s.gap.exit, GapScene::Exit::jet);
    EXPECT_EQ(s.contact.thickness, 1e-4);
    const GapScene& floor = s.gap_of("wall:y_low", "box");
    EXPECT_FALSE(floor.threshold);
    EXPECT_EQ(floor.roughness, 1e-5);
    EXPECT_EQ(floor.exit, GapScene::Exit::jet);
    EXPECT_EQ(s.contact_of("box", "wall:y_low").thickness, 1e-4);
    EXPECT_FALSE(s.gap_of("box", "ball").film);
    EXPECT_EQ(s.contact_of("ball", "box").thickness, 0.25);
    EXPECT_EQ(&s.gap_of("ball", "ramp"), &s.gap);
    EXPECT_EQ(&s.contact_of("ball", "ramp"), &s.contact);
}

TEST(Scene, RoughnessIsAShareOfTheCellUnlessGiven)
{
    const std::string text = R"(
[domain]
size = [2.0, 1.0]
cells = [80, 40]
[contact]
thickness = THICKNESS
[[body]]
name = "a"
shape = "ball"
radius = 0.2
position = [1.0, 0.5]
density = 2.0
[[pair]]
bodies = ["a", "wall:y_low"]
roughness = 1e-6
[[pair]]
bodies = ["a", "wall:x_low"]
thickness = 1e-5
[time]
end = 1.0
max_step = 0.1
)";
    const auto read = [&](const std::string& thickness, Purpose purpose) {
        std::string scene = text;
        return parse_scene(scene.replace(scene.find("THICKNESS"), 9, thickness), "scene.toml", {}, purpose);
    };
    const Scene run = read("0.0", Purpose::run);
    EXPECT_DOUBLE_EQ(run.gap.roughness, 0.005 * 0.025);
    EXPECT_TRUE(run.gap.automatic_roughness);
    EXPECT_EQ(run.gap_of("a", "wall:y_low").roughness, 1e-6);
    EXPECT_EQ(run.gap_of("a", "wall:x_low").roughness, 1e-5); // never above a thickness that is asked for
    EXPECT_EQ(read("2e-5", Purpose::run).gap.roughness, 2e-5);
    EXPECT_DOUBLE_EQ(read("0.1", Purpose::run).gap.roughness, 0.005 * 0.025);
    EXPECT_EQ(read("0.0", Purpose::added_mass).gap.roughness, 0.0);
}

TEST(Scene, Bodies2D)
{
    const Scene s = flat();
    ASSERT_EQ(s.bodies.size(), 5u);
    const BodyScene &box = s.bodies[0], &ball = s.bodies[1], &arm = s.bodies[2], &foil = s.bodies[3], &ramp = s.bodies[4];
    EXPECT_EQ(foil.shape, BodyScene::ShapeKind::sheet);
    EXPECT_EQ(foil.points.size(), 3u);
    EXPECT_EQ(foil.points[2], (Triple{0.5, 0.3, 0}));
    EXPECT_EQ(foil.mesh_scale, 0.5);
    EXPECT_EQ(foil.thickness, 1e-3);
    EXPECT_EQ(box.shape, BodyScene::ShapeKind::box);
    EXPECT_EQ(box.size, (Triple{1, 0.5, 0}));
    EXPECT_NEAR(box.angle, pi / 6, 1e-15);
    EXPECT_EQ(box.density, 2000);
    EXPECT_EQ(box.motion, BodyScene::Motion::free);
    EXPECT_EQ(box.angular_velocity, (Triple{0.5, 0, 0}));
    EXPECT_EQ(box.force, (Triple{0, 1, 0}));
    EXPECT_EQ(box.torque, (Triple{-2, 0, 0}));
    EXPECT_EQ(ball.mass, 3);
    EXPECT_EQ(ball.inertia, std::vector<double>{0.5});
    EXPECT_FALSE(ball.density);
    EXPECT_EQ(ball.free, (std::array<bool, 6>{true, false, false, false, false, true}));
    ASSERT_TRUE(ball.spring);
    EXPECT_EQ(ball.spring->anchor, (Triple{2, 3, 0}));
    EXPECT_EQ(ball.spring->stiffness, 10);
    EXPECT_EQ(ball.spring->damping, 0.25);
    EXPECT_FALSE(ball.hinge);
    EXPECT_FALSE(box.spring);
    EXPECT_TRUE(box.free[5]);
    EXPECT_EQ(arm.motion, BodyScene::Motion::prescribed);
    EXPECT_EQ(arm.motion_table.time, (std::vector<double>{0, 1}));
    EXPECT_EQ(arm.motion_table.rows[1], (std::vector<double>{2, 3, 0.5}));
    EXPECT_EQ(ramp.shape, BodyScene::ShapeKind::half_space);
    EXPECT_EQ(ramp.normal, (Triple{1, 1, 0}));
    EXPECT_EQ(ramp.velocity, (Triple{0, 0.1, 0}));
}

TEST(Scene, Bodies3D)
{
    const Scene s = deep();
    EXPECT_EQ(s.dimension, 3);
    EXPECT_EQ(s.sides[4].kind, SideScene::Kind::periodic);
    EXPECT_EQ(s.pressure_gradient, (Triple{0, 0, -0.5}));
    EXPECT_FALSE(s.mean_velocity);
    const BodyScene &post = s.bodies.at(0), &shell = s.bodies.at(1);
    EXPECT_EQ(post.inertia, (std::vector<double>{1, 0.1, 0, 0.1, 2, 0, 0, 0, 3}));
    EXPECT_NEAR(post.quaternion[0], std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(post.quaternion[2], -std::sqrt(0.5), 1e-15);
    EXPECT_EQ(post.torque, (Triple{1, 2, 3}));
    ASSERT_TRUE(post.hinge);
    EXPECT_EQ(post.hinge->point, (Triple{0, 0, 0.25}));
    EXPECT_EQ(post.hinge->axis, (Triple{0, 0, 1}));
    EXPECT_TRUE(shell.inside_out);
    EXPECT_EQ(shell.mesh_scale, 1e-3);
    EXPECT_THAT(shell.mesh_file, testing::EndsWith("mesh.obj"));
    EXPECT_NEAR(shell.quaternion[3], std::sqrt(0.5), 1e-15);
    EXPECT_EQ(shell.motion_table.rows.size(), 2u);
}

TEST(Scene, BodyThatIsFreeInNothingIsFixed)
{
    const Scene s = flat({{"body.ball.free", "[]"}});
    EXPECT_EQ(s.bodies[1].motion, BodyScene::Motion::fixed);
}

TEST(Scene, ConstraintsOfBodiesThatAreNotFreeAreIgnored)
{
    const Scene s = flat({{"body.ball.motion", "fixed"}});
    EXPECT_FALSE(s.bodies[1].spring);
    EXPECT_TRUE(s.bodies[1].free[1]);
    ASSERT_EQ(s.warnings.size(), 2u); // free, spring
    EXPECT_THAT(s.warnings[0], testing::HasSubstr("body.ball.free is ignored: the body's motion is \"fixed\""));
}

TEST(Scene, DefaultsOfTheTableAreThoseOfTheStruct)
{
    Scene expected;
    expected.size = {4, 2, 0};
    expected.cells = {2, 1, 1};
    expected.gap.automatic_roughness = true; // its length is the reader's, from the cells
    EXPECT_EQ(scene_as_json(minimal()), scene_as_json(expected));
}

TEST(Scene, Overrides)
{
    const Scene s = flat({{"domain.cells", "[128,64]"},
                          {"gap.model", "none"},
                          {"gap.model", "film"},
                          {"title", "2"},
                          {"output.directory", "runs/a b"},
                          {"body.ball.position", "[0.5, 1]"},
                          {"body.box.motion", "\"fixed\""},
                          {"domain.sides.y_high", "{ wall = [1, 0] }"},
                          {"solver.tolerance", "1e-6"}});
    EXPECT_EQ(s.cells[0], 128);
    EXPECT_TRUE(s.gap.film);
    EXPECT_EQ(s.title, "2");
    EXPECT_EQ(s.output_directory, "runs/a b");
    EXPECT_EQ(s.bodies[1].position, (Triple{0.5, 1, 0}));
    EXPECT_EQ(s.bodies[0].motion, BodyScene::Motion::fixed);
    EXPECT_EQ(s.bodies[0].velocity, Triple{});
    EXPECT_EQ(s.sides[3].velocity, (Triple{1, 0, 0}));
    EXPECT_EQ(s.tolerance, 1e-6);
    EXPECT_EQ(s.warnings.size(), 4u); // velocity, angular velocity, force and torque of a fixed body
}

Scene with_body(const std::string& body, const std::string& sides = "")
{
    return parse_scene("[domain]\nsize = [4, 2]\ncells = [32, 16]\n" + sides +
                           "[[body]]\nname = \"a\"\nshape = \"ball\"\nradius = 0.1\nposition = [0.5, 1]\ndensity = 2\n" + body,
                       "text", {}, Purpose::check);
}

TEST(Scene, WhatAMotionTableOverridesIsTold)
{
    const test::TemporaryFile table("path.csv", "time,x,y,angle_deg\n0,0.5,1,90\n1,1,1,90\n2,1,1,90\n");
    const std::string moves = "motion = \"prescribed\"\nmotion_file = \"" + table.path() + "\"\n";
    EXPECT_THAT(with_body(moves + "rotation = 90\n").warnings, testing::IsEmpty()); // as the table has it
    EXPECT_THAT(with_body(moves + "rotation = 30\n").warnings,
                testing::ElementsAre(
                    testing::StartsWith("text:12:12: body.a.rotation is ignored: the body moves as in " + table.path())));
    const test::TemporaryFile elsewhere("elsewhere.csv", "0,1,1,0\n");
    EXPECT_THAT(with_body("motion = \"prescribed\"\nmotion_file = \"" + elsewhere.path() + "\"\n").warnings,
                testing::ElementsAre(testing::HasSubstr("body.a.position is ignored")));
    EXPECT_THAT(with_body(moves + "interpolation = \"linear\"\n").warnings,
                testing::ElementsAre(testing::HasSubstr("body.a.interpolation: the velocity jumps at every row")));
    EXPECT_THAT(with_body("interpolation = \"linear\"\n").warnings,
                testing::ElementsAre(testing::HasSubstr("body.a.interpolation is ignored")));
    const test::TemporaryFile solid("solid.csv", "qw,qx,qy,qz,x,y,z,time\n2,0,0,2,1,1,1,0\n");
    const auto turned = [&](const std::string& rotation) {
        return parse_scene("[domain]\nsize = [2, 2, 2]\ncells = [8, 8, 8]\n[[body]]\nname = \"a\"\nshape = \"ball\"\nradius = "
                           "0.5\nposition = [1, 1, 1]\nmotion = \"prescribed\"\nfile = \"" +
                               solid.path() + "\"\nrotation = " + rotation + "\n",
                           "text", {}, Purpose::check)
            .warnings;
    };
    EXPECT_THAT(turned("[-1, 0, 0, -1]"), testing::IsEmpty());
    EXPECT_THAT(turned("[1, 0, 0, 0]"), testing::ElementsAre(testing::HasSubstr("body.a.rotation is ignored")));
}

TEST(Scene, HingesAndAnchorsAreTheImagesNearestToTheBody)
{
    const std::string periodic = "sides.x_low = \"periodic\"\nsides.x_high = \"periodic\"\n";
    const std::string body = "hinge = { point = [4.6, 1.5] }\nspring = { anchor = [-11.4, 3.5], stiffness = 1 }\n";
    const Scene scene = with_body(body, periodic);
    EXPECT_NEAR(scene.bodies[0].hinge->point[0], 0.6, 1e-15);
    EXPECT_EQ(scene.bodies[0].hinge->point[1], 1.5);
    EXPECT_NEAR(scene.bodies[0].spring->anchor[0], 0.6, 1e-14);
    EXPECT_EQ(scene.bodies[0].spring->anchor[1], 3.5); // no images along y
    EXPECT_THAT(scene.warnings, testing::ElementsAre(testing::HasSubstr("body.a.hinge.point is taken as ["),
                                                     testing::HasSubstr("body.a.spring.anchor is taken as [")));
    const Scene walls = with_body(body);
    EXPECT_EQ(walls.bodies[0].hinge->point[0], 4.6);
    EXPECT_THAT(walls.warnings, testing::IsEmpty());
}

TEST(Scene, FilesAreFoundBesideTheScene)
{
    const test::TemporaryFolder folder;
    std::ofstream(folder / "inflow.csv") << "0,1,0\n";
    std::ofstream(folder / "beside.toml")
        << "[domain]\nsize = [1, 1]\ncells = [4, 4]\nsides.x_low = { inflow = \"inflow.csv\" }\n";
    const Scene scene = read_scene((folder / "beside.toml").string(), {}, Purpose::check);
    EXPECT_EQ(scene.sides[0].table.file, (folder / "inflow.csv").string());
}

TEST(Scene, Json)
{
    const auto json = nlohmann::json::parse(scene_as_json(flat()));
    EXPECT_EQ(json["domain"]["cells"], (std::vector<int>{64, 32}));
    EXPECT_EQ(json["domain"]["sides"]["x_low"]["inflow"], (std::vector<double>{1, 0.25}));
    EXPECT_EQ(json["domain"]["sides"]["y_high"], "wall");
    EXPECT_EQ(json["gap"]["threshold"], 1.5);
    EXPECT_EQ(json["pair"][0]["threshold"], "auto");
    EXPECT_EQ(json["body"][0]["name"], "box");
    EXPECT_EQ(json["body"][2]["motion_file"], data + "motion.csv");
    EXPECT_EQ(json["body"][2]["interpolation"], "cubic");
    EXPECT_EQ(json["body"][1]["free"], (std::vector<std::string>{"x", "rz"}));
    EXPECT_EQ(json["body"][1]["spring"]["damping"], 0.25);
    EXPECT_FALSE(json["body"][0].contains("free"));
    EXPECT_EQ(json["time"]["max_step"], 0.01);
    const auto solid = nlohmann::json::parse(scene_as_json(deep()));
    EXPECT_EQ(solid["body"][0]["inertia"][1], (std::vector<double>{0.1, 2, 0}));
    EXPECT_EQ(solid["body"][0]["torque"], (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(solid["body"][0]["hinge"]["axis"], (std::vector<double>{0, 0, 1}));
    // Every name in it is a key or a table of the scene, but whether a roughness is the automatic one.
    std::set<std::string> names{"gap.automatic_roughness"};
    for (const KeyInfo& key : scene_keys())
        names.insert(key.name);
    for (const std::string table : {"fluid", "grid", "gap", "contact", "time", "solver", "output"})
        for (const auto& item : json[table].items())
            EXPECT_TRUE(names.count(table + "." + item.key())) << table << "." << item.key();
    for (const auto& item : json["body"][0].items())
        EXPECT_TRUE(names.count("body." + item.key())) << item.key();
}

TEST(Scene, ATextIsReadLikeAFile)
{
    const std::string text = "[domain]\nsize = [1, 1]\ncells = [8, 8]\n[domain.sides]\nx_low = { inflow = \"columns.csv\" }\n";
    try {
        parse_scene(text, data + "text", {{"domain.cells", "[4, -4]"}}, Purpose::check);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "--set domain.cells = [4, -4]: -4 is out of range; allowed: a list of 2 whole numbers, each >= 1 "
                     "and <= 1000000");
    }
    try { // the folder of the name is where files are looked for
        parse_scene(text, data + "text", {}, Purpose::check);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(data + "columns.csv"));
    }
    EXPECT_EQ(parse_scene("[domain]\nsize = [1, 1]\ncells = [8, 8]\n", "text", {}, Purpose::check).cells[0], 8);
}

} // namespace
} // namespace gapflow
