// domain.spacing, core, growth and largest.
#include "gapflow/core/error.hpp"
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

TEST(GradedDomain, SizesThatAreNoWholeNumberOfCellsAreTakenAsTheNearest)
{
    const Scene cad = scene_of("size = [39.199922, 39.199922, 24.79995]\nspacing = 0.8\n"); // in single precision
    EXPECT_EQ(cad.cells, (std::array<int, 3>{49, 49, 31}));
    EXPECT_EQ(cad.size, (Triple{49 * 0.8, 49 * 0.8, 31 * 0.8}));
    ASSERT_EQ(cad.warnings.size(), 3u);
    EXPECT_EQ(cad.warnings[2],
              "text:3:11: domain.spacing: the domain is 30.99994 cells long along z; it is taken as 31 cells, a domain.size of "
              "24.8 there");
    const Scene cells = scene_of("size = [39.199922, 39.199922, 24.79995]\ncells = [49, 49, 31]\n");
    EXPECT_EQ(cells.size[2], 31 * (39.199922 / 49));
    EXPECT_TRUE(cells.warnings.empty());
    EXPECT_THROW(scene_of("size = [1, 1.001]\ncells = [10, 10]\n"), InputError);
    EXPECT_EQ(scene_of("size = [0.01, 1]\nspacing = 0.1\n").cells[0], 1);
}

TEST(GradedDomain, CoresThatAreNoWholeNumberOfCellsAreTakenAsTheNearest)
{
    const auto core_of = [](const std::string& low, const std::string& high) {
        return scene_of("size = [4, 10]\nspacing = 0.3\ncore = { low = [1, " + low + "], high = [2.5, " + high + "] }\n");
    };
    const auto ends = [](const Scene& scene) { return std::array{scene.core->low[1], scene.core->high[1]}; };
    const auto expect_ends = [&](const Scene& scene, double low, double high, int warnings) {
        EXPECT_NEAR(ends(scene)[0], low, 1e-12);
        EXPECT_NEAR(ends(scene)[1], high, 1e-12);
        EXPECT_EQ(scene.warnings.size(), warnings);
        for (const auto& widths : {scene.core->below[1], scene.core->above[1]})
            EXPECT_TRUE(widths.empty() || *std::min_element(widths.begin(), widths.end()) >= 0.5);
    };
    expect_ends(core_of("1", "3"), 1, 3.1, 1);     // 6.67 cells
    expect_ends(core_of("0.1", "3"), 0, 3, 1);     // less than half a cell is left below it
    expect_ends(core_of("7.1", "10.1"), 7, 10, 2); // beyond the side by less than that
    expect_ends(core_of("1", "9.8"), 1, 9.7, 1);   // 29.33 cells; no further than half a cell from the side
    expect_ends(core_of("0", "9.8"), 0, 9.6, 1);
    EXPECT_EQ(core_of("1", "3").warnings[0],
              "text:4:31: domain.core.high: along y the core is 6.666667 cells long; it is taken as 7 cells, "
              "with this end at 3.1");
    const Scene whole = core_of("0", "10"); // 33.3 cells from side to side
    EXPECT_NEAR(whole.size[1], 9.9, 1e-12);
    EXPECT_TRUE(whole.core->below[1].empty() && whole.core->above[1].empty());
    EXPECT_EQ(whole.warnings.size(), 1u);
    EXPECT_THROW(core_of("1", "10.2"), InputError);
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
