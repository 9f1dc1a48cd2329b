// Wrong scenes: each file's first line is "# expect: " and what its message says after the file's name, up to the remedy.
#include "temporary.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/scene/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace gapflow {
namespace {

const std::string folder = std::string(GAPFLOW_TEST_DATA) + "/bad_scenes/";

std::string message_of(const std::string& file, const std::vector<std::pair<std::string, std::string>>& overrides = {},
                       Purpose purpose = Purpose::run)
{
    try {
        read_scene(file, overrides, purpose);
    } catch (const InputError& e) {
        std::string text = e.what();
        for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
            text.erase(at, folder.size());
        return text;
    }
    return "accepted";
}

std::vector<std::string> bad_scenes()
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".toml")
            names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

TEST(BadScenes, AreRefusedWithPlaceKeyValueAndRemedy)
{
    const auto names = bad_scenes();
    EXPECT_GE(names.size(), 60u);
    for (const std::string& name : names) {
        std::ifstream in(folder + name + ".toml");
        std::string first;
        std::getline(in, first);
        const std::string mark = "# expect: ";
        ASSERT_TRUE(first.starts_with(mark)) << name;
        const std::string message = message_of(folder + name + ".toml");
        EXPECT_THAT(message, testing::StartsWith(name + ".toml" + first.substr(mark.size()))) << name;
        EXPECT_THAT(message, testing::AnyOf(testing::HasSubstr("; "), testing::HasSubstr("did you mean"))) << name;
        EXPECT_EQ(message.find('\n'), std::string::npos) << name;
    }
}

const std::string good = "gravity = [0, -1]\n[domain]\nsize = [4, 4]\ncells = [64, 64]\n[[body]]\nname = \"upper.left\"\n"
                         "shape = \"ball\"\nradius = 0.5\ndensity = 2\n[[pair]]\nbodies = [\"upper.left\", \"wall:y_low\"]\n"
                         "[time]\nend = 1\nmax_step = 0.1\n";

struct BadOverride {
    std::string key, value, expected;
};

TEST(BadScenes, OverridesAreRefused)
{
    const test::TemporaryFile scene("good.toml", good);
    ASSERT_EQ(message_of(scene.path()), "accepted");
    const std::vector<BadOverride> cases{
        {"domain.cells", "[64,63]", "--set domain.cells = [64, 63]: the spacing"},
        {"domain.cells", "[64,64", "--set domain.cells = [64,64: not a TOML value"},
        {"body.upper.left.angle", "30", "--set body.upper.left.angle: unknown key; did you mean 'body.upper.left.rotation'?"},
        {"domain.cels", "[64,64]", "--set domain.cels: unknown key; did you mean 'domain.cells'?"},
        {"gap", "none", "--set gap: is a table"},
        {"body", "none", "--set body: is a table"},
        {"gap.model", "nonne", "--set gap.model = \"nonne\": unknown value \"nonne\", did you mean \"none\"?"},
        {"gap.model", "", "--set gap.model: has no value"},
        {"gap.threshold", "0", "--set gap.threshold = 0: out of range"},
        {"time.end", "1\nmax_step = 2", "--set time.end = 1 max_step = 2: not a TOML value"},
        {"time.end", "soon", "--set time.end = \"soon\": \"soon\" is not a number"},
        {"time.end", "inf", "--set time.end = inf: not a finite number"},
        {"fluid.viscosity", "-0.1", "--set fluid.viscosity = -0.1: out of range"},
        {"body.uper.left.density", "1", "--set body.uper.left.density: no body is named 'uper'"},
        {"body.upper.left.densty", "1", "--set body.upper.left.densty: unknown key; did you mean 'body.upper.left.density'?"},
        {"body.upper.left.density", "-1", "--set body.upper.left.density = -1: out of range"},
        {"body.upper.left", "1", "--set body.upper.left: no body is named 'upper'"},
        {"body.upper.left.mass", "1", "--set body.upper.left.mass = 1: given together with density"},
        {"body.upper.left.spring.anchor", "[1,1]", "body.upper.left.spring.stiffness is missing: a spring needs it"},
        {"body.upper.left.hinge.axis", "[0,0,1]", "--set body.upper.left.hinge.axis = [0, 0, 1]: an axis in a 2D scene"},
        {"pair.contact", "wet", "--set pair.contact: pairs have no names"},
        {"", "1", "--set : unknown key"},
        {"domain.sides.y_low", "open", ":11:10: pair[1].bodies = [\"upper.left\", \"wall:y_low\"]: 'wall:y_low': this side"},
    };
    for (const auto& [key, value, expected] : cases)
        EXPECT_THAT(message_of(scene.path(), {{key, value}}), testing::HasSubstr(expected)) << key << "=" << value;
}

TEST(BadScenes, CheckRefusesWhatARunOnPartsWould)
{
    const std::string file = folder + "parts_entrance_loss.toml";
    EXPECT_EQ(message_of(file, {}, Purpose::check), message_of(file));
    EXPECT_EQ(message_of(file, {}, Purpose::added_mass), "accepted");
}

TEST(BadScenes, WhatIsNeededDependsOnThePurpose)
{
    const test::TemporaryFile still("still.toml",
                                    "[domain]\nsize = [4, 4]\ncells = [64, 64]\n[[body]]\nname = \"a\"\nshape = \"ball\"\n"
                                    "radius = 0.5\n");
    for (Purpose purpose : {Purpose::added_mass, Purpose::check})
        EXPECT_EQ(message_of(still.path(), {}, purpose), "accepted");
    EXPECT_THAT(message_of(still.path(), {}, Purpose::run), testing::HasSubstr("time.end is missing"));
    EXPECT_THAT(message_of(still.path(), {{"time.end", "1"}}, Purpose::check), testing::HasSubstr("a free body needs density"));
    EXPECT_THAT(message_of(still.path(), {{"body.a.motion", "fixed"}}, Purpose::added_mass),
                testing::HasSubstr("no body moves"));
}

TEST(BadScenes, FilesThatCannotBeRead)
{
    EXPECT_THAT(message_of(folder + "none.scene"), testing::StartsWith("none.scene: cannot be read"));
    EXPECT_THAT(message_of(GAPFLOW_TEST_DATA), testing::HasSubstr("is a folder, not a scene"));
    const test::TemporaryFile binary("binary.toml", std::string("\x7f\x45\x4c\x46\0\xff", 6));
    EXPECT_THAT(message_of(binary.path()), testing::HasSubstr(":1:5: not valid TOML"));
}

} // namespace
} // namespace gapflow
