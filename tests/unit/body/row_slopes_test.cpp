#include "gapflow/body/row_slopes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace gapflow {
namespace {

using Numbers = std::vector<double>;

Numbers values_of(const Numbers& time, const std::function<double(double)>& f)
{
    Numbers values;
    for (const double t : time)
        values.push_back(f(t));
    return values;
}

TEST(RowSlopes, AreExactForPolynomialsOfFourthDegree)
{
    const Numbers time{0, 0.3, 0.5, 1, 1.2, 1.7, 2};
    const Numbers values = values_of(time, [](double t) { return 2 + t - 0.2 * t * t * t + 0.1 * t * t * t * t; });
    for (std::size_t k = 0; k < time.size(); ++k) {
        const auto [first, count] = rows_about(k, time.size());
        EXPECT_EQ(count, 5u);
        EXPECT_TRUE(first <= k && k < first + 5 && first + 5 <= time.size());
        const double t = time[k];
        EXPECT_NEAR(polynomial_slope(std::span(time).subspan(first, 5), std::span(values).subspan(first, 5), k - first),
                    1 - 0.6 * t * t + 0.4 * t * t * t, 1e-12);
    }
    EXPECT_EQ(row_slopes(Numbers{1}, Numbers{3}), (Numbers{0}));
    EXPECT_EQ(row_slopes(Numbers{1, 3}, Numbers{3, 4}), (Numbers{0.5, 0.5}));
}

TEST(RowSlopes, OfAnOscillationHaveFourthOrderAtItsTopsToo)
{
    double before = 0;
    for (const int rows : {20, 40, 80}) {
        Numbers time;
        for (int k = 0; k <= rows; ++k)
            time.push_back((k + 0.3) * 2 * std::numbers::pi / rows);
        const Numbers slopes = row_slopes(time, values_of(time, [](double t) { return std::sin(t) + 0.2 * std::cos(2 * t); }));
        double error = 0;
        for (int k = 3; k <= rows - 3; ++k)
            error = std::max(error, std::abs(slopes[k] - std::cos(time[k]) + 0.4 * std::sin(2 * time[k])));
        if (before > 0) {
            EXPECT_GT(before / error, 14) << rows;
        }
        before = error;
    }
}

TEST(RowSlopes, AreNotLimitedAtAnInflexionWithoutSlope)
{
    Numbers time;
    for (int k = 0; k < 12; ++k)
        time.push_back(k - 5.1);
    const Numbers slopes = row_slopes(time, values_of(time, [](double t) { return t * t * t - 0.02 * t; }));
    for (int k = 2; k < 10; ++k)
        EXPECT_NEAR(slopes[k], 3 * time[k] * time[k] - 0.02, 1e-12);
}

TEST(RowSlopes, KeepPlateausAndMonotoneRows)
{
    const Numbers time{0, 1, 2, 3, 4, 5, 6};
    const Numbers held = row_slopes(time, Numbers{0, 1, 2, 2, 1, 0, 0}); // one of two rows, one at the end
    for (const int row : {2, 3, 5, 6})
        EXPECT_EQ(held[row], 0) << row;
    for (const Numbers& values :
         {Numbers{0, 0, 0, 1, 1, 1, 1}, Numbers{0, 0, 0.1, 5, 5.1, 5.1, 9}, Numbers{9, 1, 0.1, 0.01, 0, 0, 0}}) {
        const Numbers slopes = row_slopes(time, values);
        for (int k = 0; k < 6; ++k)
            for (const double slope : {slopes[k], slopes[k + 1]}) {
                const double secant = values[k + 1] - values[k];
                EXPECT_TRUE(secant == 0 ? slope == 0 : slope / secant >= 0 && slope / secant < 3 + 1e-12) << k;
            }
    }
}

} // namespace
} // namespace gapflow
