// Disjoint sets: the smallest member is the root, whatever the order in which sets are joined.
#include "gapflow/core/disjoint_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace gapflow {
namespace {

TEST(DisjointSets, DoNotDependOnTheOrderOfUnions)
{
    std::vector<std::pair<int, int>> unions{{5, 3}, {3, 1}, {4, 2}, {6, 5}};
    do {
        DisjointSets sets(8);
        for (const auto& [a, b] : unions)
            sets.join(a, b);
        for (int member : {1, 3, 5, 6})
            EXPECT_EQ(sets.find(member), 1);
        int count = 0;
        EXPECT_EQ(sets.numbers(count), (std::vector<int>{0, 1, 2, 1, 2, 1, 1, 3}));
        EXPECT_EQ(count, 4);
    } while (std::next_permutation(unions.begin(), unions.end()));
}

TEST(DisjointSets, Grow)
{
    DisjointSets sets(2);
    EXPECT_EQ(sets.add(), 2);
    EXPECT_EQ(sets.size(), 3);
    EXPECT_EQ(sets.find(2), 2);
    sets.join(2, 1);
    sets.join(1, 1);
    EXPECT_EQ(sets.find(2), 1);
    EXPECT_EQ(sets.find(0), 0);
}

} // namespace
} // namespace gapflow
