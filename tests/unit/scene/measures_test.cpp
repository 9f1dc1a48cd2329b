// [[probe]] and [[flux]]: what the reader makes of them.
#include "gapflow/scene/parse_scene.hpp"
#include "gapflow/scene/scene.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace gapflow {
namespace {

using testing::ElementsAre;

const std::string box = R"(
[domain]
size = [2, 1, 1]
cells = [16, 8, 8]
[domain.sides]
x_high = "open"
[[body]]
name = "ball"
shape = "ball"
radius = 0.2
position = [0.5, 0.5, 0.5]
density = 2
[time]
end = 1
max_step = 0.1
)";

Scene scene_with(const std::string& more, const Overrides& sets = {})
{
    return parse_scene(box + more, "scene.toml", sets, Purpose::run);
}

TEST(Measures, PointsLinesAndPlanes)
{
    const Scene scene = scene_with(R"(
[[probe]]
name = "one"
point = [0.1, 0.2, 0.3]
[[probe]]
name = "some"
points = [[0, 0, 0], [2, 1, 1]]
fields = ["vorticity"]
every = 0.5
[[probe]]
name = "line"
line = { from = [0, 0, 0.5], to = [2, 1, 0.5], count = 3 }
[[probe]]
name = "plane"
plane = { origin = [1, 0, 0], u = [0, 1, 0], v = [0, 0, 0.5], counts = [2, 3] }
)");
    ASSERT_EQ(scene.probes.size(), 4u);
    EXPECT_THAT(scene.probes[0].places(), ElementsAre(Triple{0.1, 0.2, 0.3}));
    EXPECT_TRUE(scene.probes[0].pressure && scene.probes[0].velocity && !scene.probes[0].vorticity);
    EXPECT_THAT(scene.probes[1].places(), ElementsAre(Triple{0, 0, 0}, Triple{2, 1, 1}));
    EXPECT_TRUE(!scene.probes[1].pressure && !scene.probes[1].velocity && scene.probes[1].vorticity);
    EXPECT_EQ(scene.probes[1].every, 0.5);
    EXPECT_THAT(scene.probes[2].places(), ElementsAre(Triple{0, 0, 0.5}, Triple{1, 0.5, 0.5}, Triple{2, 1, 0.5}));
    EXPECT_THAT(scene.probes[3].places(), ElementsAre(Triple{1, 0, 0}, Triple{1, 1, 0}, Triple{1, 0, 0.25}, Triple{1, 1, 0.25},
                                                      Triple{1, 0, 0.5}, Triple{1, 1, 0.5}));
}

TEST(Measures, SidesPlanesAndGaps)
{
    const Scene scene = scene_with(R"(
[[flux]]
name = "out"
side = "x_high"
[[flux]]
name = "slanted"
plane = { point = [1, 0.5, 0.5], normal = [0, 3, 4] }
[[flux]]
name = "part"
plane = { point = [1, 0.5, 0.5], normal = "z", low = [0, 0, 0], high = [1, 1, 0] }
every = 0.25
[[flux]]
name = "leak"
gap = ["ball", "wall:y_low"]
[[flux]]
name = "through"
gap = ["ball", "wall:y_low"]
along = [3, 0, -4]
)",
                                   {{"flux.part.every", "0.5"}});
    ASSERT_EQ(scene.fluxes.size(), 5u);
    EXPECT_EQ(scene.fluxes[0].side, 1);
    EXPECT_EQ(scene.fluxes[1].normal, (Triple{0, 0.6, 0.8}));
    EXPECT_EQ(scene.fluxes[2].normal, (Triple{0, 0, 1}));
    EXPECT_EQ(scene.fluxes[2].high, (Triple{1, 1, 0}));
    EXPECT_EQ(scene.fluxes[2].every, 0.5);
    EXPECT_THAT(scene.fluxes[3].bodies, ElementsAre("ball", "wall:y_low"));
    EXPECT_FALSE(scene.fluxes[3].along);
    EXPECT_EQ(scene.fluxes[4].along, (Triple{0.6, 0, -0.8}));
}

// The resolved scene has the keys of the file, and none of a scene that measures nothing.
TEST(Measures, StandInTheResolvedScene)
{
    const auto json = nlohmann::json::parse(scene_as_json(scene_with(R"(
[[probe]]
name = "line"
line = { from = [0, 0, 0.5], to = [2, 1, 0.5], count = 3 }
[[flux]]
name = "leak"
gap = ["ball", "wall:y_low"]
along = "y"
)")));
    EXPECT_EQ(json["probe"][0]["line"]["count"], 3);
    EXPECT_EQ(json["flux"][0]["gap"][1], "wall:y_low");
    EXPECT_EQ(json["flux"][0]["along"], nlohmann::json({0.0, 1.0, 0.0}));
    EXPECT_FALSE(nlohmann::json::parse(scene_as_json(scene_with(""))).contains("probe"));
}

} // namespace
} // namespace gapflow
