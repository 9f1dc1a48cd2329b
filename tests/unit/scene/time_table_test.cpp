#include "temporary.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/scene/time_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gapflow {
namespace {

using Row = std::vector<double>;

TEST(TimeTable, ReadsHeaderCommentsBlanksAndSigns)
{
    const test::TemporaryFile file("table.csv",
                                   "\xef\xbb\xbf# from a rig\r\ntime, u, v\r\n\r\n0, +1, -2.5e-1\r\n# more\n 2 ,3,4\n");
    const TimeTable table = read_time_table(file.path(), {"time", "u", "v"});
    EXPECT_EQ(table.file, file.path());
    EXPECT_EQ(table.time, (Row{0, 2}));
    EXPECT_EQ(table.rows[0], (Row{1, -0.25}));
    EXPECT_EQ(table.rows[1], (Row{3, 4}));
}

TEST(TimeTable, RefusesNamesInTheMiddleAndNumbersThatAreNot)
{
    for (const char* line : {"time,u", "1,nan", "1,inf", "1,", "1,2x", "0,1"}) {
        const test::TemporaryFile file("wrong.csv", std::string("0,1\n") + line + "\n");
        try {
            read_time_table(file.path(), {"time", "u"});
            ADD_FAILURE() << line;
        } catch (const InputError& e) {
            EXPECT_THAT(e.what(), testing::HasSubstr("wrong.csv:2: "));
        }
    }
}

TEST(TimeTable, LinearBetweenRowsConstantBeyondThem)
{
    const TimeTable table{"", {1, 2, 4}, {{0, 1}, {2, 1}, {1, 5}}};
    EXPECT_EQ(value_at(table, 0), (Row{0, 1}));
    EXPECT_EQ(value_at(table, 1), (Row{0, 1}));
    EXPECT_EQ(value_at(table, 1.5), (Row{1, 1}));
    EXPECT_EQ(value_at(table, 2), (Row{2, 1}));
    EXPECT_EQ(value_at(table, 3), (Row{1.5, 3}));
    EXPECT_EQ(value_at(table, 4), (Row{1, 5}));
    EXPECT_EQ(value_at(table, 9), (Row{1, 5}));
    EXPECT_EQ(derivative_at(table, 0.5), (Row{0, 0}));
    EXPECT_EQ(derivative_at(table, 1), (Row{2, 0}));
    EXPECT_EQ(derivative_at(table, 2), (Row{-0.5, 2}));
    EXPECT_EQ(derivative_at(table, 4), (Row{0, 0}));
    const TimeTable constant{"", {3}, {{7}}};
    EXPECT_EQ(value_at(constant, 1), Row{7});
    EXPECT_EQ(value_at(constant, 5), Row{7});
    EXPECT_EQ(derivative_at(constant, 3), Row{0});
}

} // namespace
} // namespace gapflow
