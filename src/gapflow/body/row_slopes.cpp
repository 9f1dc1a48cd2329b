// A cubic with slopes in [0, 3 s] at both ends, s the secant, is monotone (C. de Boor, B. Swartz, J. Approx. Theory 21 (1977)). That alone
// makes the slope 0 at the extrema of the data, and the force on a body that oscillates has spikes there; so it holds only where the rows are
// not those of a smooth curve. Of second derivatives d by differences, a smooth curve with w (t_k+1 - t_k) << 1 leaves
//
//     | d_k - (mean of its neighbours) | = (w h)^2 / 2 |d|,     a corner |d|, the row beside one and the ends of a plateau |d| / 2,
//
// with d the largest of the three. The limit is half of the least of these: nine rows a period of an oscillation.
#include "gapflow/body/row_slopes.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gapflow {

RowRange rows_about(std::size_t row, std::size_t rows)
{
    const std::size_t count = std::min<std::size_t>(5, rows);
    return {std::min(row < 2 ? 0 : row - 2, rows - count), count};
}

double polynomial_slope(std::span<const double> time, std::span<const double> value, std::size_t at)
{
    assert(time.size() == value.size() && at < time.size());
    double slope = 0;
    for (std::size_t j = 0; j < time.size(); ++j) {
        if (j == at)
            continue;
        double weight = 1 / (time[j] - time[at]);
        for (std::size_t i = 0; i < time.size(); ++i)
            if (i != j && i != at)
                weight *= (time[at] - time[i]) / (time[j] - time[i]);
        slope += weight * (value[j] - value[at]);
    }
    return slope;
}

void limit_slopes(std::span<const double> time, std::span<const double> secant, std::span<double> slope)
{
    const std::size_t n = time.size();
    assert(n == slope.size() && secant.size() + 1 == n);
    std::vector<double> second(n, 0.0);
    for (std::size_t k = 1; k + 1 < n; ++k)
        second[k] = 2 * (secant[k] - secant[k - 1]) / (time[k + 1] - time[k - 1]);
    std::vector<bool> smooth(n, false);
    for (std::size_t k = 2; k + 2 < n; ++k) {
        const double w = (time[k] - time[k - 1]) / (time[k + 1] - time[k - 1]);
        const double mean = (1 - w) * second[k - 1] + w * second[k + 1];
        const double largest = std::max({std::abs(second[k - 1]), std::abs(second[k]), std::abs(second[k + 1])});
        smooth[k] = std::abs(second[k] - mean) <= 0.25 * largest;
    }
    for (std::size_t k = 0; k + 1 < n; ++k)
        for (const std::size_t row : {k, k + 1})
            if (!smooth[k] || !smooth[k + 1])
                slope[row] = std::clamp(slope[row], std::min(0.0, 3 * secant[k]), std::max(0.0, 3 * secant[k]));
}

std::vector<double> row_slopes(std::span<const double> time, std::span<const double> value)
{
    std::vector<double> slope(time.size(), 0.0), secant;
    for (std::size_t k = 0; k < time.size(); ++k) {
        const auto [first, count] = rows_about(k, time.size());
        slope[k] = polynomial_slope(time.subspan(first, count), value.subspan(first, count), k - first);
    }
    for (std::size_t k = 0; k + 1 < time.size(); ++k)
        secant.push_back((value[k + 1] - value[k]) / (time[k + 1] - time[k]));
    limit_slopes(time, secant, slope);
    return slope;
}

} // namespace gapflow
