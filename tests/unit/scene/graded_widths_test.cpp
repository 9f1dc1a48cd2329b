#include "gapflow/scene/graded_widths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace gapflow {
namespace {

double sum(const std::vector<double>& widths)
{
    return std::accumulate(widths.begin(), widths.end(), 0.0);
}

TEST(GradedWidths, FitAndGrowNoFasterThanAsked)
{
    for (const double length : {0.5, 0.7, 1.0, 1.3, 2.0, 7.77, 35.0, 1234.5})
        for (const double growth : {1.0, 1.05, 1.1, 1.2, 1.5}) {
            const std::vector<double> widths = graded_widths(length, growth, 1e9);
            EXPECT_NEAR(sum(widths), length, 1e-12 * length);
            double before = 1;
            for (const double width : widths) {
                EXPECT_LE(width, before * growth * (1 + 1e-9));
                EXPECT_GE(width, 0.5 * before);
                before = width;
            }
        }
}

TEST(GradedWidths, AreAsFewAsPossible)
{
    // 1.1 + 1.21 + 1.331 = 3.641: three cells reach no further.
    EXPECT_EQ(graded_widths(3.641, 1.1, 1e9).size(), 3U);
    EXPECT_EQ(graded_widths(3.642, 1.1, 1e9).size(), 4U);
    EXPECT_TRUE(graded_widths(0, 1.1, 1e9).empty());
}

TEST(GradedWidths, StopAtTheLargest)
{
    const std::vector<double> widths = graded_widths(100, 1.2, 3);
    EXPECT_LE(*std::max_element(widths.begin(), widths.end()), 3 * (1 + 1e-9));
    EXPECT_NEAR(widths.back(), widths[widths.size() - 2], 0.2);
    EXPECT_NEAR(sum(widths), 100, 1e-10);
}

} // namespace
} // namespace gapflow
