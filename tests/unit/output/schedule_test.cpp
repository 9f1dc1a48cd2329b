// Output times and checkpoints: when they are due, from the start and from a checkpoint on; how far a work is.
#include "gapflow/output/progress.hpp"
#include "gapflow/output/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gapflow {
namespace {

Scene scene_with(double end, double every, double checkpoint_every = 0)
{
    Scene scene;
    scene.end = end;
    scene.output_every = every;
    scene.checkpoint_every = checkpoint_every;
    return scene;
}

TEST(Schedule, OutputsAreTheMultiplesAndTheEnd)
{
    Schedule schedule(scene_with(0.35, 0.1), 0);
    for (const double time : {1 * 0.1, 2 * 0.1, 3 * 0.1, 0.35}) {
        EXPECT_EQ(schedule.next_output(), time); // to the bit
        EXPECT_FALSE(schedule.output_due(std::nextafter(time, 0.0)));
        EXPECT_TRUE(schedule.output_due(time));
        EXPECT_FALSE(schedule.output_due(time));
    }
    EXPECT_EQ(schedule.next_output(), std::numeric_limits<double>::infinity());
}

TEST(Schedule, TheEndTakesInAMultipleNextToIt)
{
    const double end = 0.3; // 3 * 0.1 is 0.30000000000000004
    Schedule schedule(scene_with(end, 0.1), 0.2);
    EXPECT_EQ(schedule.next_output(), end);
    EXPECT_TRUE(schedule.output_due(end));
    EXPECT_EQ(Schedule(scene_with(2, 0), 0).next_output(), 2);
}

TEST(Schedule, GoesOnAfterACheckpoint)
{
    EXPECT_EQ(Schedule(scene_with(1, 0.1), 2 * 0.1).next_output(), 3 * 0.1);
    EXPECT_EQ(Schedule(scene_with(1, 0.1), 0.25).next_output(), 3 * 0.1);
}

TEST(Schedule, CheckpointsFollowTheStepsThatReachThem)
{
    Schedule schedule(scene_with(1, 0, 0.25), 0);
    EXPECT_FALSE(schedule.checkpoint_due(0.24));
    EXPECT_TRUE(schedule.checkpoint_due(0.6)); // passes two of them
    EXPECT_FALSE(schedule.checkpoint_due(0.74));
    EXPECT_TRUE(schedule.checkpoint_due(0.75));
    EXPECT_TRUE(schedule.checkpoint_due(1));
    Schedule only_at_the_end(scene_with(1, 0.1), 0);
    EXPECT_FALSE(only_at_the_end.checkpoint_due(0.9));
    EXPECT_TRUE(only_at_the_end.checkpoint_due(1));
}

std::string printed(ProgressStyle style)
{
    std::FILE* file = std::tmpfile();
    {
        CountProgress progress(style, "frames", file);
        const auto start = std::chrono::steady_clock::now();
        while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(250))
            progress(3, 20);
    }
    std::rewind(file);
    std::string text;
    for (int c; (c = std::fgetc(file)) != EOF;)
        text += static_cast<char>(c);
    std::fclose(file);
    return text;
}

TEST(CountProgress, RepaintsATerminalAndLeavesNothingThere)
{
    const std::string text = printed(ProgressStyle::terminal), line = "\rframes: 3 of 20\033[K";
    EXPECT_TRUE(text.starts_with(line)) << text;
    EXPECT_TRUE(text.ends_with(line + "\r\033[K")) << text;
}

TEST(CountProgress, ShortWorkLeavesNoLineInALogAndNoneWhenSilent)
{
    EXPECT_EQ(printed(ProgressStyle::log), "");
    EXPECT_EQ(printed(ProgressStyle::silent), "");
}

} // namespace
} // namespace gapflow
