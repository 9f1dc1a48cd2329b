#include "gapflow/output/table.hpp"

#include "temporary.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/types.hpp"

#include <gmock/gmock.h>

using namespace gapflow;
using testing::HasSubstr;

TEST(Table, WritesHeaderAndRows)
{
    const test::TemporaryFolder folder;
    Table table(folder / "bodies.csv", {"step", "time", "body", "x", "y"});
    EXPECT_EQ(test::content_of(folder / "bodies.csv"), "step,time,body,x,y\n");
    table.row(0, 0.0, "upper", Vec<2>(0.1, 1.0 / 3.0));
    table.row(0, 0.0, std::string("a,\"b\""), Vec<2>(1e-7, -2.0));
    EXPECT_EQ(test::content_of(folder / "bodies.csv"), "step,time,body,x,y\n") << "nothing before flush()";
    table.flush();
    EXPECT_EQ(test::content_of(folder / "bodies.csv"), "step,time,body,x,y\n"
                                                       "0,0,upper,0.1,0.3333333333333333\n"
                                                       "0,0,\"a,\"\"b\"\"\",1e-07,-2\n");
}

TEST(Table, ResumeCutsBackToAStep)
{
    const test::TemporaryFolder folder;
    const auto path = folder / "steps.csv";
    {
        Table table(path, {"step", "time"});
        for (long step = 0; step < 12; ++step)
            table.row(step, 0.5 * static_cast<double>(step));
        table.flush();
    }
    std::ofstream(path, std::ios::app) << "12,6."; // what a killed writer may leave
    {
        Table table = Table::resume(path, {"step", "time"}, 2);
        table.row(3, 1.25);
        table.flush();
    }
    EXPECT_EQ(test::content_of(path), "step,time\n0,0\n1,0.5\n2,1\n3,1.25\n");
}

TEST(Table, ResumeDropsAnIncompleteLineOfAKeptStep)
{
    const test::TemporaryFolder folder;
    std::ofstream(folder / "t.csv") << "step,time\n0,0\n1,0.";
    Table::resume(folder / "t.csv", {"step", "time"}, 5).flush();
    EXPECT_EQ(test::content_of(folder / "t.csv"), "step,time\n0,0\n");
}

TEST(Table, ResumeWithoutAFileStartsOne)
{
    const test::TemporaryFolder folder;
    Table::resume(folder / "t.csv", {"step", "time"}, 5).flush();
    EXPECT_EQ(test::content_of(folder / "t.csv"), "step,time\n");
}

TEST(Table, ResumeRefusesOtherColumns)
{
    const test::TemporaryFolder folder;
    std::ofstream(folder / "t.csv") << "step,time\n0,0\n";
    try {
        Table::resume(folder / "t.csv", {"step", "time", "dt"}, 5);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("other columns than this run writes (step,time,dt)"));
    }
    EXPECT_EQ(test::content_of(folder / "t.csv"), "step,time\n0,0\n");
}

TEST(Table, FullDiskIsAComputationError)
{
    try {
        Table table("/dev/full", {"step"});
        FAIL() << "no error";
    } catch (const ComputationError& error) {
        EXPECT_THAT(error.what(), HasSubstr("/dev/full: cannot write the table: No space left on device; free space"));
    }
}
