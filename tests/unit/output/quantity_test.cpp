// Quantities of a stored run: statistics by hand, the choice of what a sweep's table holds; scenes that differ.
#include "gapflow/output/quantity.hpp"

#include "gapflow/output/scene_difference.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace gapflow {
namespace {

using testing::ElementsAre;

// Steps of lengths 1, 2, 3; a ball that moves, a fixed post, a gap that opens at step 2.
StoredRun hand_made()
{
    StoredRun run;
    run.scene = std::make_shared<nlohmann::ordered_json>(nlohmann::ordered_json::parse(R"({
        "body": [{"name": "ball", "motion": "free"}, {"name": "post", "motion": "fixed"}, {"name": "sand_0001", "motion": "free"}],
        "crowd": [{"name": "sand"}]})"));
    run.steps = {4, {{"step", {0, 1, 2, 3}}, {"time", {0, 1, 3, 6}}, {"dt", {0, 1, 2, 3}}}, {}};
    run.bodies = {8,
                  {{"step", {0, 0, 1, 1, 2, 2, 3, 3}},
                   {"time", {0, 0, 1, 1, 3, 3, 6, 6}},
                   {"y", {10, 0, 11, 0, 9, 0, 12, 0}},
                   {"fx", {0, 0, 0, 4, 0, 1, 0, -1}}},
                  {{"body", {"ball", "post", "ball", "post", "ball", "post", "ball", "post"}}}};
    run.gaps = {3,
                {{"step", {1, 2, 2}}, {"time", {1, 3, 3}}, {"thickness", {0.5, 0.25, 0.1}}},
                {{"body_a", {"post", "post", "sand_0001"}}, {"body_b", {"ball", "ball", "ball"}}}};
    return run;
}

TEST(Quantity, StatisticsAreThoseOfTheWindow)
{
    const StoredRun run = hand_made();
    const auto y = statistics_of(run, {"ball.y", "y", "ball", ""}, {0, 6});
    ASSERT_TRUE(y);
    EXPECT_DOUBLE_EQ(y->last, 12);
    EXPECT_DOUBLE_EQ(y->mean, (11 * 1 + 9 * 2 + 12 * 3) / 6.0);
    EXPECT_DOUBLE_EQ(y->low, 9);
    EXPECT_DOUBLE_EQ(y->high, 12);
    const auto part = statistics_of(run, {"ball.y", "y", "ball", ""}, {0, 3});
    EXPECT_DOUBLE_EQ(part->last, 9);
    EXPECT_DOUBLE_EQ(part->high, 11);
    EXPECT_DOUBLE_EQ(statistics_of(run, {"ball.y", "y", "ball", ""}, {0, 0.5})->mean, 10);             // the start alone
    const auto gap = statistics_of(run, {"ball-post.thickness", "thickness", "ball", "post"}, {0, 6}); // either order
    EXPECT_DOUBLE_EQ(gap->mean, (0.5 * 1 + 0.25 * 2) / 3);
    EXPECT_FALSE(statistics_of(run, {"ball.y", "y", "ball", ""}, {7, 8}));
    EXPECT_FALSE(statistics_of(run, {"ball.z", "z", "ball", ""}, {0, 6}));
}

TEST(Quantity, KeyQuantitiesAreThoseOfNamedBodiesAndTheirGaps)
{
    std::vector<std::string> names;
    for (const Quantity& quantity : key_quantities(hand_made()))
        names.push_back(quantity.name);
    EXPECT_THAT(names, ElementsAre("ball.x", "ball.y", "ball.angle", "ball.vx", "ball.vy", "ball.omega", "ball.fx", "ball.fy",
                                   "ball.torque", "post.fx", "post.fy", "post.torque", "post-ball.thickness", "post-ball.force",
                                   "post-ball.contact_force"));
}

TEST(SceneDifference, NamesKeyAndValues)
{
    const std::string one = R"({"title": "a", "body": [{"name": "ball", "density": 2, "file": "/x/a.stl"}],
                                "domain": {"sides": {}}, "time": {"end": 1}})";
    const std::string two = R"({"title": "b", "body": [{"name": "ball", "density": 3, "file": "/y/a.stl"}],
                                "domain": {"sides": {}}, "time": {"end": 2}})";
    EXPECT_EQ(scene_difference(one, two, {"title", "time"}), "body.ball.density: was 2, is 3");
    EXPECT_EQ(scene_difference(one, one, {}), "");
    const auto values = differing_values({one, two, one});
    ASSERT_EQ(values.size(), 2u);
    EXPECT_THAT(values.at("body.ball.density"), ElementsAre("2", "3", "2"));
    EXPECT_THAT(values.at("time.end"), ElementsAre("1", "2", "1"));
}

} // namespace
} // namespace gapflow
