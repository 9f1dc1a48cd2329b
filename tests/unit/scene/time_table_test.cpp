#include "temporary.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/scene/time_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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

std::string error_of(const std::string& text, const std::vector<std::string>& columns,
                     const std::vector<std::string>& optional = {})
{
    const test::TemporaryFile file("named.csv", text);
    try {
        read_time_table(file.path(), columns, optional);
    } catch (const InputError& e) {
        const std::string message = e.what();
        return message.substr(message.find("named.csv"));
    }
    return "";
}

TEST(TimeTable, NamesTellTheOrder)
{
    for (const char* names : {"v,time,u\n", "# v,time,u\n"}) {
        const test::TemporaryFile file("table.csv", std::string(names) + "1,0,2\n3,1,4\n");
        const TimeTable table = read_time_table(file.path(), {"time", "u", "v"});
        EXPECT_EQ(table.time, (Row{0, 1}));
        EXPECT_EQ(table.rows[0], (Row{2, 1}));
        EXPECT_EQ(table.rows[1], (Row{4, 3}));
    }
    const test::TemporaryFile file("table.csv", "# time, u\ntime,angle_deg,x,y,vy\n0,90,1,2,3\n");
    const TimeTable table = read_time_table(file.path(), {"time", "x", "y", "angle"}, {"vx", "vy", "omega"});
    ASSERT_EQ(table.rows[0].size(), 6u);
    EXPECT_NEAR(table.rows[0][2], 1.5707963267948966, 1e-15);
    EXPECT_EQ(table.rows[0][4], 3);
    EXPECT_TRUE(std::isnan(table.rows[0][3]) && std::isnan(table.rows[0][5]));
}

TEST(TimeTable, OtherNamesAreRefused)
{
    const std::vector<std::string> columns{"time", "u", "v"};
    EXPECT_EQ(error_of("time,u,v [mm/s]\n0,1,2\n", columns),
              "named.csv:1: the column 'v [mm/s]' is not one of those wanted: time,u,v");
    EXPECT_EQ(error_of("time,u,u\n0,1,2\n", columns), "named.csv:1: the column 'u' is there twice");
    EXPECT_EQ(error_of("\ntime,u\n0,1\n", columns), "named.csv:2: there is no column 'v'; wanted are time,u,v");
    EXPECT_EQ(error_of("v,u,time\n0,1\n", columns), "named.csv:2: has 2 columns; 3 have names");
    EXPECT_EQ(error_of("0,1,2,3\n", columns), "named.csv:1: has 4 columns; 3 are needed: time,u,v");
    EXPECT_EQ(error_of("v,u,time\n0,1,one\n", columns), "named.csv:2: time = 'one' is not a finite number");
    EXPECT_EQ(
        error_of("t,x,y,angle\n0,1,2,3\n", {"time", "x", "y", "angle"}, {"vx", "vy", "omega"}),
        "named.csv:1: the column 't' is not one of those wanted: time,x,y,angle (or angle_deg) and, if known, vx,vy,omega");
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
