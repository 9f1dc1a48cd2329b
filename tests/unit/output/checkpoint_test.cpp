#include "gapflow/output/checkpoint.hpp"

#include "gapflow/core/error.hpp"
#include "temporary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>

namespace gapflow {
namespace {

using testing::HasSubstr;

Scene scene()
{
    Scene scene;
    scene.title = "a";
    scene.size = {2, 1, 0};
    scene.cells = {20, 10, 1};
    BodyScene ball;
    ball.name = "ball";
    ball.radius = 0.2;
    scene.bodies = {ball};
    return scene;
}

Checkpoint checkpoint()
{
    Checkpoint c;
    c.version = "0.1.0";
    c.scene = scene_as_json(scene());
    c.position = {12, 3, std::numeric_limits<double>::infinity()};
    c.state.numbers["time"] = {0.1};
    c.state.numbers["bodies/twist"] = {-0.0, std::nextafter(1.0, 2.0), std::numeric_limits<double>::denorm_min(), 1e300};
    c.state.numbers["contacts/impulse"] = {};
    c.state.integers["step"] = {12};
    c.state.integers["contacts.size"] = {std::numeric_limits<std::int64_t>::min(), 0};
    c.state.fields["velocity_x"].assign(5000, 0.3);
    return c;
}

std::string refusal(const std::filesystem::path& path)
{
    try {
        read_checkpoint(path, Communicator());
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Checkpoint, HoldsEveryBit)
{
    const test::TemporaryFolder folder;
    const auto path = folder / "checkpoint.h5";
    const Checkpoint before = checkpoint();
    write_checkpoint(path, before, Communicator());
    const Checkpoint after = read_checkpoint(path, Communicator());
    EXPECT_EQ(after.version, before.version);
    EXPECT_EQ(after.scene, before.scene);
    EXPECT_EQ(after.position.step, 12);
    EXPECT_EQ(after.position.frames, 3);
    EXPECT_TRUE(std::isinf(after.position.smallest_gap));
    EXPECT_EQ(after.state.integers, before.state.integers);
    EXPECT_EQ(after.state.fields, before.state.fields);
    EXPECT_EQ(after.state.numbers, before.state.numbers);
    EXPECT_TRUE(std::signbit(after.state.numbers.at("bodies/twist")[0]));
}

TEST(Checkpoint, TheSameStateIsTheSameFile)
{
    const test::TemporaryFolder folder;
    write_checkpoint(folder / "a.h5", checkpoint(), Communicator());
    write_checkpoint(folder / "b.h5", checkpoint(), Communicator());
    EXPECT_EQ(test::content_of(folder / "a.h5"), test::content_of(folder / "b.h5"));
}

TEST(Checkpoint, DamageIsFound)
{
    const test::TemporaryFolder folder;
    const auto path = folder / "checkpoint.h5";
    write_checkpoint(path, checkpoint(), Communicator());
    const std::string good = test::content_of(path);
    const double value = 0.3;
    std::string pattern(sizeof value, ' ');
    std::memcpy(pattern.data(), &value, sizeof value);
    const auto place = good.find(pattern + pattern);
    ASSERT_NE(place, std::string::npos);
    std::string bad = good;
    bad[place + 8 * 2500] ^= 1;
    std::ofstream(path, std::ios::binary) << bad;
    EXPECT_THAT(refusal(path), HasSubstr("checkpoint.h5: not a checkpoint, or damaged (its checksum is wrong); take another"));
    std::ofstream(path, std::ios::binary) << good.substr(0, good.size() / 2);
    EXPECT_THAT(refusal(path), HasSubstr("damaged"));
    std::ofstream(path, std::ios::binary) << "";
    EXPECT_THAT(refusal(path), HasSubstr("not a checkpoint, or damaged"));
    EXPECT_THAT(refusal(folder / "none.h5"), HasSubstr("none.h5: no such file"));
    std::ofstream(path, std::ios::binary) << good;
    EXPECT_EQ(refusal(path), "accepted");
}

TEST(Checkpoint, FullDiskKeepsTheOldOne)
{
    const test::TemporaryFolder folder;
    const auto path = folder / "checkpoint.h5";
    write_checkpoint(path, checkpoint(), Communicator());
    const std::string good = test::content_of(path);
    std::filesystem::create_symlink("/dev/full", folder / "checkpoint.h5.partial");
    try {
        write_checkpoint(path, checkpoint(), Communicator());
        FAIL() << "no error";
    } catch (const ComputationError& error) {
        EXPECT_THAT(error.what(), HasSubstr("checkpoint.h5: cannot write the file: No space left on device; free space"));
    }
    EXPECT_EQ(test::content_of(path), good);
}

TEST(Checkpoint, OnlyTheSameSceneGoesOn)
{
    const Checkpoint stored = checkpoint();
    auto refusal = [&](const std::function<void(Scene&)>& change) {
        Scene changed = scene();
        change(changed);
        try {
            require_same_scene("c.h5", stored, changed);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_EQ(refusal([](Scene& s) {
                  s.title = "b";
                  s.end = 9;
                  s.max_step = 0.5;
                  s.tolerance = 1e-4;
                  s.output_directory = "elsewhere";
                  s.checkpoint_every = 3;
              }),
              "accepted");
    EXPECT_THAT(refusal([](Scene& s) { s.cells[1] = 11; }),
                HasSubstr("c.h5: a checkpoint of another scene: domain.cells: was [20,10], is [20,11]"));
    EXPECT_THAT(refusal([](Scene& s) { s.bodies[0].radius = 0.25; }), HasSubstr("body.ball.radius: was 0.2, is 0.25"));
    EXPECT_THAT(refusal([](Scene& s) { s.bodies.push_back(s.bodies[0]); }), HasSubstr("number of [[body]]: was 1, is 2"));
    EXPECT_THAT(refusal([](Scene& s) { s.bodies[0].density = 2; }), HasSubstr("body.ball.density: was not given, is 2.0"));
    EXPECT_THAT(refusal([](Scene& s) { s.sides[3].kind = SideScene::Kind::open; }),
                HasSubstr(R"(domain.sides.y_high: was "wall", is "open")"));
}

} // namespace
} // namespace gapflow
