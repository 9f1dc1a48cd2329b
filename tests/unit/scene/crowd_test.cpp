// Crowds: places without overlap, numbers, sizes, regions, arrangements; each checked against a formula or a search of its own.
#include "temporary.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/scene/body_shape.hpp"
#include "gapflow/scene/crowd_room.hpp"
#include "gapflow/scene/parse_scene.hpp"
#include "gapflow/scene/random_numbers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <set>

namespace gapflow {
namespace {

constexpr double pi = std::numbers::pi;
const std::string solid_domain = "[domain]\nsize = [1, 1, 2]\ncells = [16, 16, 32]\n";
const std::string flat_domain = "[domain]\nsize = [2, 1]\ncells = [32, 16]\n";
const std::string ball = "name = \"ball\"\nshape = \"ball\"\nradius = 0.05\ndensity = 2\n";

Scene scene_of(const std::string& text, const Overrides& overrides = {})
{
    return parse_scene(text, "crowd.toml", overrides, Purpose::check);
}

std::string refusal_of(const std::string& text)
{
    try {
        scene_of(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

std::string crowd(const std::string& keys)
{
    return "[[crowd]]\n" + keys;
}

// Smallest gap between balls, and between balls and the sides that are not periodic.
double smallest_gap(const Scene& scene)
{
    double least = 1e300;
    const int D = scene.dimension;
    for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
        const BodyScene& one = scene.bodies[a];
        for (std::size_t b = 0; b < a; ++b) {
            double square = 0;
            for (int i = 0; i < D; ++i) {
                double d = std::abs(one.position[i] - scene.bodies[b].position[i]);
                if (scene.sides[2 * i].kind == SideScene::Kind::periodic)
                    d = std::min(d, scene.size[i] - d);
                square += d * d;
            }
            least = std::min(least, std::sqrt(square) - one.radius - scene.bodies[b].radius);
        }
        for (int i = 0; i < D; ++i)
            if (scene.sides[2 * i].kind != SideScene::Kind::periodic)
                least = std::min({least, one.position[i] - scene.origin[i] - one.radius,
                                  scene.origin[i] + scene.size[i] - one.position[i] - one.radius});
    }
    return least;
}

const std::string periodic_3d = "[domain.sides]\nx_low = \"periodic\"\nx_high = \"periodic\"\ny_low = \"periodic\"\ny_high = "
                                "\"periodic\"\nz_low = \"periodic\"\nz_high = \"periodic\"\n";
const std::string periodic_2d =
    "[domain.sides]\nx_low = \"periodic\"\nx_high = \"periodic\"\ny_low = \"periodic\"\ny_high = \"periodic\"\n";

TEST(Crowd, BecomesNamedBodies)
{
    const Scene scene =
        scene_of(solid_domain +
                 "[[body]]\nname = \"block\"\nshape = \"box\"\nsize = [0.5, 0.5, 0.5]\nposition = "
                 "[0.5, 0.5, 0.25]\nmotion = \"fixed\"\n" +
                 crowd(ball + "number = 40\nvelocity = [0, 0, 1]\nfree = [\"x\", \"z\"]\n") +
                 crowd("name = \"rod\"\nshape = \"capsule\"\nradius = 0.02\nlength = 0.1\ndensity = 3\nnumber = 12\n"));
    ASSERT_EQ(scene.bodies.size(), 53u);
    ASSERT_EQ(scene.crowds.size(), 2u);
    EXPECT_EQ(scene.bodies[1].name, "ball_0001");
    EXPECT_EQ(scene.bodies[40].name, "ball_0040");
    EXPECT_EQ(scene.bodies[41].name, "rod_0001");
    EXPECT_EQ(scene.crowds[1].first, 41);
    EXPECT_EQ(scene.crowd_of(40), &scene.crowds[0]);
    EXPECT_EQ(scene.crowd_of(0), nullptr);
    EXPECT_EQ(scene.bodies[7].density, 2);
    EXPECT_EQ(scene.bodies[7].velocity, (Triple{0, 0, 1}));
    EXPECT_FALSE(scene.bodies[7].free[1]);
    EXPECT_NEAR(scene.crowds[0].volume_fraction, 40 * 4 * pi / 3 * 0.05 * 0.05 * 0.05 / 2, 1e-12);
    // No ball in or near the block, no rod in a ball: by the shapes' own distances.
    std::vector<std::unique_ptr<Shape<3>>> shapes;
    for (const BodyScene& body : scene.bodies)
        shapes.push_back(make_shape<3>(body));
    const PlacedShape<3> block(*shapes[0], scene_pose<3>(scene.bodies[0]));
    for (int i = 1; i <= 40; ++i)
        EXPECT_GE(block.distance(to_vec<3>(scene.bodies[i].position)) - 0.05, scene.crowds[0].spacing - 1e-12);
    std::set<double> turns;
    for (int i = 41; i < 53; ++i) {
        const PlacedShape<3> rod(*shapes[i], scene_pose<3>(scene.bodies[i]));
        turns.insert(scene.bodies[i].quaternion[0]);
        for (int j = 1; j <= 40; ++j)
            EXPECT_GE(rod.distance(to_vec<3>(scene.bodies[j].position)) - 0.05, scene.crowds[1].spacing - 1e-12);
        EXPECT_GT(block.distance(to_vec<3>(scene.bodies[i].position)), 0.02);
    }
    EXPECT_EQ(turns.size(), 12u) << "each rod has a rotation of its own";
}

TEST(Crowd, BallsKeepTheirSpacing)
{
    for (const std::string& sides : {std::string(), periodic_3d}) {
        const Scene scene = scene_of(solid_domain + sides + crowd(ball + "volume_fraction = 0.2\nspacing = 0.01\n"));
        EXPECT_EQ(scene.bodies.size(), static_cast<std::size_t>(std::lround(0.2 * 2 / (4 * pi / 3 * 1.25e-4))));
        EXPECT_GE(smallest_gap(scene), 0.01 - 1e-12);
        EXPECT_LT(smallest_gap(scene), 0.013) << "no more room than needed";
    }
}

TEST(Crowd, SeedsDecide)
{
    const std::string text = flat_domain + crowd(ball + "number = 20\n");
    const Scene one = scene_of(text), same = scene_of(text), other = scene_of(text, {{"crowd.ball.seed", "2"}});
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(one.bodies[i].position, same.bodies[i].position);
    EXPECT_NE(one.bodies[0].position, other.bodies[0].position);
    // The same on every machine.
    EXPECT_NEAR(one.bodies[0].position[0], 0.304365623623812, 1e-12);
}

TEST(Crowd, DenseBallsAndDisks)
{
    const Scene balls = scene_of(solid_domain + periodic_3d + crowd(ball + "volume_fraction = 0.5\n"));
    EXPECT_NEAR(balls.crowds[0].volume_fraction, 0.5, 1e-3);
    EXPECT_GE(smallest_gap(balls), balls.crowds[0].spacing - 1e-12);
    EXPECT_NEAR(balls.crowds[0].spacing, 0.001, 1e-15) << "a hundredth of the diameter";
    const Scene boxed = scene_of(solid_domain + crowd(ball + "volume_fraction = 0.45\n"));
    EXPECT_GE(smallest_gap(boxed), 0.001 - 1e-12);
    // Pushed against a plane of the region that no sum of doubles meets exactly.
    const Scene layer = scene_of(solid_domain + periodic_3d +
                                 crowd(ball + "number = 380\nregion = { low = [0, 0, 0.17], high = [1, 1, 0.77] }\n"));
    EXPECT_GE(smallest_gap(layer), 0.001 - 1e-12);
    const Scene disks = scene_of(flat_domain + periodic_2d + crowd(ball + "volume_fraction = 0.7\n"));
    EXPECT_GE(smallest_gap(disks), 0.001 - 1e-12);
    // Shuffled: the gaps of nearest neighbours are not all as small as allowed.
    int close = 0;
    for (std::size_t a = 0; a < balls.bodies.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const double gap = (to_vec<3>(balls.bodies[a].position) - to_vec<3>(balls.bodies[b].position)).norm() - 0.1;
            close += gap < 0.0012;
        }
    EXPECT_LT(close, 0.2 * static_cast<double>(balls.bodies.size()));
}

TEST(Crowd, AThousandBalls)
{
    const Scene scene = scene_of("[domain]\nsize = [1, 1, 1]\ncells = [32, 32, 32]\n" +
                                 crowd("name = \"b\"\nshape = \"ball\"\nradius = 0.04\ndensity = 2\nnumber = 1000\n"));
    EXPECT_EQ(scene.bodies.back().name, "b_1000");
    EXPECT_GT(smallest_gap(scene), 0);
}

TEST(Crowd, SizesFollowTheirDistribution)
{
    const std::string base = "[domain]\nsize = [10, 10]\ncells = [16, 16]\n" + crowd(ball + "number = 3000\n");
    const auto factors = [&](const std::string& sizes) {
        std::vector<double> list;
        for (const BodyScene& body : scene_of(base + sizes).bodies)
            list.push_back(body.radius / 0.05);
        return list;
    };
    const auto moments = [](const std::vector<double>& list) {
        double mean = 0, square = 0;
        for (const double f : list)
            mean += f / static_cast<double>(list.size());
        for (const double f : list)
            square += (f - mean) * (f - mean) / static_cast<double>(list.size());
        return std::pair(mean, std::sqrt(square));
    };
    auto [mean, deviation] = moments(factors("sizes = { distribution = \"normal\", mean = 1.0, deviation = 0.2 }\n"));
    EXPECT_NEAR(mean, 1.0, 0.012);
    EXPECT_NEAR(deviation, 0.2, 0.008);
    std::tie(mean, deviation) = moments(factors("sizes = { distribution = \"log-normal\", mean = 0.8, deviation = 0.3 }\n"));
    EXPECT_NEAR(mean, 0.8, 0.018);
    EXPECT_NEAR(deviation, 0.3, 0.025);
    const std::vector<double> uniform = factors("sizes = { distribution = \"uniform\", low = 0.5, high = 1.5 }\n");
    std::tie(mean, deviation) = moments(uniform);
    EXPECT_NEAR(mean, 1.0, 0.02);
    EXPECT_NEAR(deviation, 1 / std::sqrt(12.0), 0.01);
    EXPECT_GE(*std::min_element(uniform.begin(), uniform.end()), 0.5);
    const std::vector<double> cut =
        factors("sizes = { distribution = \"normal\", mean = 1.0, deviation = 0.5, low = 0.9, high = 1.2 }\n");
    EXPECT_GE(*std::min_element(cut.begin(), cut.end()), 0.9);
    EXPECT_LE(*std::max_element(cut.begin(), cut.end()), 1.2);
}

TEST(Crowd, MassScalesWithSize)
{
    const Scene scene =
        scene_of(flat_domain + crowd("name = \"s\"\nshape = \"ball\"\nradius = 0.02\nmass = 3\ninertia = 0.5\nnumber = "
                                     "5\nsizes = { mean = 2 }\n"));
    EXPECT_NEAR(scene.bodies[0].radius, 0.04, 1e-15);
    EXPECT_NEAR(*scene.bodies[0].mass, 12, 1e-12);
    EXPECT_NEAR(scene.bodies[0].inertia[0], 8, 1e-12);
}

TEST(Crowd, RegionsHoldWholeBodies)
{
    Scene scene = scene_of(solid_domain + crowd(ball + "number = 30\nregion = { low = [0, 0, 1.5], high = [0.5, 1, 2] }\n"));
    for (const BodyScene& body : scene.bodies) {
        EXPECT_GE(body.position[2], 1.55);
        EXPECT_LE(body.position[0], 0.45);
    }
    scene = scene_of(solid_domain + crowd(ball + "number = 30\nregion = { centre = [0.5, 0.5, 1], radius = 0.4 }\n"));
    for (const BodyScene& body : scene.bodies)
        EXPECT_LE((to_vec<3>(body.position) - Vec<3>(0.5, 0.5, 1)).norm(), 0.35);
    scene = scene_of(solid_domain +
                     crowd(ball + "number = 30\nregion = { from = [0.5, 0.5, 0.2], to = [0.5, 0.5, 1.2], radius = 0.3 }\n"));
    for (const BodyScene& body : scene.bodies) {
        EXPECT_LE(std::hypot(body.position[0] - 0.5, body.position[1] - 0.5), 0.25);
        EXPECT_GE(body.position[2], 0.25);
        EXPECT_LE(body.position[2], 1.15);
    }
}

TEST(Crowd, ContainersAndFunnelsStayFree)
{
    // Balls and boxes in a container of another shape, which is no region.
    const Scene scene =
        scene_of("[domain]\nsize = [2, 2, 2]\ncells = [16, 16, 16]\n[[body]]\nname = \"tank\"\nshape = \"ball\"\nradius "
                 "= 0.9\nposition = [1, 1, 1]\ninside_out = true\nmotion = \"fixed\"\n" +
                 crowd("name = \"box\"\nshape = \"box\"\nsize = [0.3, 0.1, 0.1]\ndensity = 2\nnumber = 40\n") +
                 crowd(ball + "number = 60\n"));
    const auto shape = make_shape<3>(scene.bodies[1]);
    for (int i = 1; i <= 40; ++i) {
        const PlacedShape<3> box(*shape, scene_pose<3>(scene.bodies[i]));
        for (const Vec<3>& corner : shape->surface_mesh().vertices)
            EXPECT_LE((box.to_world(corner) - Vec<3>::Ones()).norm(), 0.9);
    }
    for (int i = 41; i <= 100; ++i)
        EXPECT_LE((to_vec<3>(scene.bodies[i].position) - Vec<3>::Ones()).norm(), 0.85);
}

TEST(Crowd, Lattices)
{
    const std::string cube =
        "[domain]\nsize = [1, 1, 1]\ncells = [16, 16, 16]\n" + crowd(ball + "arrangement = \"lattice\"\nnumber = ");
    Scene scene = scene_of(cube + "343\n");
    ASSERT_EQ(scene.bodies.size(), 343u);
    EXPECT_NEAR(scene.bodies[0].position[0], 0.5 / 7, 1e-15);
    EXPECT_NEAR(smallest_gap(scene), 0.5 / 7 - 0.05, 1e-12) << "half a pitch to the walls";
    scene = scene_of(cube + "300\n"); // sites are left out
    EXPECT_EQ(scene.bodies.size(), 300u);
    EXPECT_GE(smallest_gap(scene), 0.5 / 7 - 0.05 - 1e-12);
    scene = scene_of(cube + "343\njitter = 0.2\nspacing = 0.005\n");
    EXPECT_GE(smallest_gap(scene), 0.005 - 1e-12);
    int moved = 0;
    for (const BodyScene& body : scene.bodies)
        moved += std::abs(std::remainder(body.position[0] - 0.5 / 7, 1.0 / 7)) > 1e-6;
    EXPECT_GT(moved, 330);
    // Boxes of a lattice are not turned, and lie closer than any way of turning them would let them.
    const Scene boxes =
        scene_of(flat_domain + crowd("name = \"b\"\nshape = \"box\"\nsize = [0.17, 0.17]\ndensity = 1\nnumber = 50\n"
                                     "arrangement = \"lattice\"\n"));
    EXPECT_EQ(boxes.bodies[3].angle, 0);
}

TEST(Crowd, BadOnesAreRefused)
{
    const std::string rods = "name = \"r\"\nshape = \"box\"\nsize = [0.2, 0.05]\ndensity = 1\n";
    const std::vector<std::pair<std::string, std::string>> cases{
        {ball, "crowd.toml:4:1: crowd.ball.number is missing: a crowd needs number or volume_fraction"},
        {ball + "number = 3\nvolume_fraction = 0.1\n",
         "crowd.toml:10:19: crowd.ball.volume_fraction = 0.1: given together with number"},
        {ball + "number = 2.5\n", "crowd.ball.number = 2.5: 2.5 is not a whole number"},
        {ball + "number = 0\n", "out of range"},
        {ball + "number = 3\nposition = [1, 1]\n", "crowd.toml:10:1: crowd.ball.position: unknown key"},
        {ball + "count = 3\n", "crowd.toml:9:1: crowd.ball.count: unknown key; did you mean 'crowd.ball.number'?"},
        {ball + "number = 500\n", "have 1.963 times the region's volume; use fewer"},
        {ball + "number = 230\n",
         "find room at random; use fewer bodies, a larger region or a smaller spacing (0.001, auto); balls"},
        {rods + "number = 150\n", "together, find room at random; use fewer"},
        {rods + "number = 150\n", "or arrangement = \"lattice\""},
        {rods + "number = 50\narrangement = \"lattice\"\nrotation = 45\nspacing = 0.05\n", "have room at their sites"},
        {ball + "number = 3\njitter = 0.1\n", "only a lattice has jitter"},
        {ball + "number = 3\nregion = { low = [1, 0], high = [0.5, 1] }\n", "no extent along x"},
        {ball + "number = 3\nregion = { low = [1, 0], high = [2.5, 1] }\n",
         "region.high = [2.5, 1]: the region reaches out of the domain"},
        {ball + "number = 3\nregion = { centre = [1, 0.5] }\n", "region.radius is missing: a ball needs it"},
        {ball + "number = 3\nregion = { centre = [1, 0.5], low = [0, 0] }\n",
         "region.low = [0, 0]: given together with region.centre"},
        {ball + "number = 3\nregion = { radius = 0.5 }\n", "given without region.centre"},
        {ball + "number = 3\nregion = { from = [0, 0], to = [1, 0], radius = 0.5 }\n", "a cylinder needs three dimensions"},
        {ball + "number = 3\nregion = { centre = [1, 0.5], radius = 0.5 }\narrangement = \"lattice\"\n",
         "a lattice fills a box"},
        {ball + "number = 3\nsizes = { deviation = 0.1 }\n", "a fixed distribution has none; add sizes.distribution"},
        {ball + "number = 3\nsizes = { distribution = \"normal\" }\n",
         "sizes.deviation is missing: a normal distribution needs it"},
        {ball + "number = 3\nsizes = { distribution = \"uniform\", low = 2, high = 1 }\n", "not below the largest"},
        {ball + "number = 3\nsizes = { distribution = \"normal\", deviation = 0.001, low = 2 }\n", "next to no factor"},
        {ball + "number = 3\nsizes = { distribution = \"gauss\" }\n", "unknown value \"gauss\""},
        {ball + "volume_fraction = 1e-5\n", "less than half a body"},
        {"name = \"d\"\nshape = \"ball\"\nradius = 1e-5\ndensity = 1\nvolume_fraction = 0.1\n", "allowed: up to 100000"},
        {ball + "number = 3\nregion = { low = [0, 0], high = [0.05, 1] }\n", "no body finds room in the region"},
        {"name = \"h\"\nshape = \"half-space\"\nnumber = 3\n", "crowd.h.shape = \"half-space\": unknown value"},
        {ball + "number = 3\nfile = \"path.csv\"\nmotion = \"prescribed\"\n", "a ball has no file"},
        {ball + "number = 3\n[[crowd]]\n" + ball + "number = 3\n", "an earlier [[crowd]] has this name"},
        {ball + "number = 3\n[[body]]\nname = \"ball_0002\"\nshape = \"ball\"\nradius = 0.1\ndensity = 1\n",
         "the body 'ball_0002' has"},
        {ball + "number = 3\n[[pair]]\nbodies = [\"ball\", \"wall:x_low\"]\n",
         "'ball' is a crowd, and a pair names single bodies; name one of "
         "ball_0001 ... ball_0003"},
        {ball + "number = 3\n[[pair]]\nbodies = [\"bell\", \"wall:x_low\"]\n", "allowed: ball_0001 ... ball_0003, wall:x_low"},
    };
    for (const auto& [keys, expected] : cases)
        EXPECT_THAT(refusal_of(flat_domain + crowd(keys)), testing::HasSubstr(expected)) << keys;
    EXPECT_EQ(refusal_of(flat_domain + crowd(ball + "number = 3\n[[pair]]\nbodies = [\"ball_0001\", \"wall:x_low\"]\n")),
              "accepted");
}

TEST(Crowd, JsonTellsWhatItBecame)
{
    const auto json = nlohmann::json::parse(scene_as_json(scene_of(flat_domain + crowd(ball + "number = 3\n"))));
    EXPECT_EQ(json["crowd"][0]["name"], "ball");
    EXPECT_EQ(json["crowd"][0]["number"], 3);
    EXPECT_EQ(json["body"].size(), 3u);
    EXPECT_FALSE(nlohmann::json::parse(scene_as_json(scene_of(flat_domain))).contains("crowd"));
}

TEST(Crowd, DistancesOfHulls)
{
    BodyScene box;
    box.shape = BodyScene::ShapeKind::box;
    box.size = {1, 1, 1};
    const auto shape = make_shape<3>(box);
    const Hull<3> hull = hull_of<3>(box, *shape).hull;
    // Two unit cubes, one turned by 45 degrees about z: corner to face along x, sqrt(1/2) + 1/2 apart.
    const Hull<3> turned = hull.turned(Eigen::AngleAxisd(pi / 4, Eigen::Vector3d::UnitZ()).matrix(), 1);
    const double touch = std::sqrt(0.5) + 0.5;
    EXPECT_TRUE(apart<3>(hull, turned, {touch + 0.12, 0, 0}, 0.1));
    EXPECT_FALSE(apart<3>(hull, turned, {touch + 0.09, 0, 0}, 0.1));
    EXPECT_FALSE(apart<3>(hull, turned, {touch - 0.01, 0, 0}, 0));
    EXPECT_TRUE(apart<3>(hull, hull, {0, 1.02, 0.3}, 0));
    EXPECT_FALSE(apart<3>(hull, hull, {0, 0.99, 0.3}, 0));
}

TEST(Crowd, PortableFunctions)
{
    for (const double x : {1e-300, 1e-3, 0.4, 0.7071, 0.9999999, 1.0, 1.5, 3.0, 1e10})
        EXPECT_NEAR(portable_log(x), std::log(x), 4e-16 * std::max(1.0, std::abs(std::log(x)))) << x;
    for (const double x : {-40.0, -1.0, -1e-9, 0.0, 0.3, 1.0, 20.0})
        EXPECT_NEAR(portable_exp(x) / std::exp(x), 1, 1e-14) << x;
    RandomNumbers random(7);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero(); // of a vector turned at random
    for (int i = 0; i < 4000; ++i) {
        const auto q = random.quaternion();
        EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-12);
        mean += Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * Eigen::Vector3d::UnitX() / 4000;
    }
    EXPECT_LT(mean.norm(), 0.04);
}

} // namespace
} // namespace gapflow
