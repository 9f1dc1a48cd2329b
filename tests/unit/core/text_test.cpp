// Small text helpers: distances between names, numbers that read back, parts of lists.
#include "gapflow/core/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gapflow {
namespace {

TEST(Text, DistancesAndNames)
{
    EXPECT_EQ(edit_distance("", "abc"), 3);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
    EXPECT_EQ(edit_distance("gpa", "gap"), 1); // a swap
    EXPECT_EQ(nearest_name("cels", {"size", "cells", "sides"}), "cells");
    EXPECT_EQ(nearest_name("xyzzy", {"size", "cells"}), "");
}

TEST(Text, Numbers)
{
    EXPECT_EQ(number_text(100000), "100000");
    EXPECT_EQ(number_text(0.1), "0.1");
    EXPECT_EQ(number_text(1e-8), "1e-08");
    EXPECT_EQ(parse_number(" +2.5 "), 2.5);
    EXPECT_FALSE(parse_number("2.5 m"));
    EXPECT_FALSE(parse_number(""));
}

TEST(Text, NumbersReadBackToTheBit)
{
    for (double value : {1.0 / 3, -2e-308, 6.02214076e23, std::nextafter(1.0, 2.0), std::numeric_limits<double>::max()})
        EXPECT_EQ(parse_number(number_text(value)), value);
}

TEST(Text, PartsAreTrimmed)
{
    EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
    EXPECT_EQ(trimmed(" \t"), "");
    EXPECT_EQ(split(" a, b c ,,d", ','), (std::vector<std::string_view>{"a", "b c", "", "d"}));
    EXPECT_EQ(split("", ','), std::vector<std::string_view>{""});
    EXPECT_EQ(joined({"a", "b", "c"}), "a, b, c");
    EXPECT_EQ(joined({}, "-"), "");
}

} // namespace
} // namespace gapflow
