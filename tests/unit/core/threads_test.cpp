// Loops cut into parts for threads: every index once, sums in one order, errors handed on.
#include "gapflow/core/threads.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

TEST(Threads, PartsMakeUpTheWhole)
{
    for (long n : {0L, 1L, 2L, 7L, 100L}) {
        std::vector<int> seen(n, 0);
        for_each_part_of(3, n, [&](long begin, long end) {
            for (long i = begin; i < end; ++i)
                ++seen[i];
        });
        EXPECT_EQ(seen, std::vector<int>(n, 1));
    }
    EXPECT_EQ(sum_over_planes(-2, 4, [](int k) { return k; }), 3);
}

} // namespace
} // namespace gapflow
