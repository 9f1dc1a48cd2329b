// domain.spacing, core, growth and largest.
#include "gapflow/scene/parse_scene.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <string>

namespace gapflow {
namespace {

Scene scene_of(const std::string& domain)
{
    return parse_scene("[domain]\n" + domain, "text", {}, Purpose::check);
}

TEST(GradedDomain, SpacingAloneMakesAUniformGrid)
{
    const Scene scene = scene_of("size = [4.0, 2.0]\nspacing = 0.25\n");
    EXPECT_FALSE(scene.core);
    EXPECT_EQ(scene.cells, (std::array<int, 3>{16, 8, 1}));
    EXPECT_EQ(scene.spacing(), 0.25);
}

TEST(GradedDomain, CoreOfTheWholeDomainMakesAUniformGrid)
{
    EXPECT_FALSE(scene_of("size = [4.0, 2.0]\nspacing = 0.25\ncore = { low = [0, 0], high = [4, 2] }\n").core);
}

TEST(GradedDomain, CellsFillTheDomain)
{
    const Scene scene = scene_of("size = [40.0, 20.0]\norigin = [-20, 0]\nspacing = 0.1\ncore = { low = [-1, 0], high = [2, 3] "
                                 "}\ngrowth = 1.2\nlargest = 2\n");
    ASSERT_TRUE(scene.core);
    const CoreScene& core = *scene.core;
    const auto length = [](const std::vector<double>& widths) {
        return 0.1 * std::accumulate(widths.begin(), widths.end(), 0.0);
    };
    EXPECT_NEAR(length(core.below[0]), 19, 1e-10);
    EXPECT_NEAR(length(core.above[0]), 18, 1e-10);
    EXPECT_TRUE(core.below[1].empty());
    EXPECT_NEAR(length(core.above[1]), 17, 1e-10);
    EXPECT_EQ(scene.cells[0], 30 + static_cast<int>(core.below[0].size() + core.above[0].size()));
    EXPECT_EQ(scene.cells[1], 30 + static_cast<int>(core.above[1].size()));
    EXPECT_LE(*std::max_element(core.above[0].begin(), core.above[0].end()), 20 * (1 + 1e-9));
    EXPECT_EQ(scene.spacing(), 0.1);
}

TEST(GradedDomain, StandsInTheResolvedScene)
{
    const std::string given = "size = [4.0, 4.0]\nspacing = 0.1\ncore = { low = [1, 1], high = [3, 3] }\n";
    const auto json = nlohmann::json::parse(scene_as_json(scene_of(given)))["domain"];
    EXPECT_EQ(json["spacing"], 0.1);
    EXPECT_EQ(json["core"]["low"], (std::vector<double>{1, 1}));
    EXPECT_EQ(json["core"]["high"], (std::vector<double>{3, 3}));
    EXPECT_EQ(json["growth"], 1.1);
    EXPECT_FALSE(json.contains("cells"));
    EXPECT_FALSE(json.contains("largest"));
}

TEST(GradedDomain, FollowsABody)
{
    const std::string rest =
        "[domain.sides]\nx_low = \"open\"\nx_high = \"open\"\n[[body]]\nname = \"ball\"\nshape = \"ball\"\nradius = 0.5\n"
        "position = [2, 2]\nmotion = \"free\"\ndensity = 2\n";
    const Scene scene = scene_of("size = [4.0, 4.0]\ncells = [8, 8]\nfollow = { body = \"ball\", axes = [\"x\"] }\n" + rest);
    ASSERT_TRUE(scene.follow);
    EXPECT_EQ(scene.follow->body, "ball");
    EXPECT_EQ(scene.follow->axes, (std::array<bool, 3>{true, false, false}));
    const auto json = nlohmann::json::parse(scene_as_json(scene))["domain"]["follow"];
    EXPECT_EQ(json["body"], "ball");
    EXPECT_EQ(json["axes"], (std::vector<std::string>{"x"}));
}

} // namespace
} // namespace gapflow
