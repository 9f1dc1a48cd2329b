#include "gapflow/solver/weighted_lists.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

TEST(WeightedLists, TransposedKeepTheOrderOfTheLists)
{
    WeightedLists<long> lists;
    lists.add(30, 0.5);
    lists.add(10, 0.25);
    lists.end_list();
    lists.end_list(); // empty
    lists.add(10, 2);
    lists.add(30, -1);
    lists.add(30, 4); // twice
    lists.end_list();
    ASSERT_EQ(lists.size(), 3);
    EXPECT_TRUE(lists[1].empty());

    const WeightedLists<int> by_number = lists.transposed(4, [](long number) { return number / 10; });
    ASSERT_EQ(by_number.size(), 4);
    EXPECT_TRUE(by_number[0].empty() && by_number[2].empty());
    ASSERT_EQ(by_number[1].size(), 2u);
    EXPECT_EQ(by_number[1][0].number, 0);
    EXPECT_EQ(by_number[1][0].weight, 0.25);
    EXPECT_EQ(by_number[1][1].number, 2);
    EXPECT_EQ(by_number[1][1].weight, 2);
    ASSERT_EQ(by_number[3].size(), 3u);
    EXPECT_EQ(by_number[3][0].weight, 0.5);
    EXPECT_EQ(by_number[3][1].weight, -1);
    EXPECT_EQ(by_number[3][2].weight, 4);
}

} // namespace
} // namespace gapflow
