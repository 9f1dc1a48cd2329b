// Slopes of a smooth curve through the rows of a table: those of polynomials through five rows, which leave a cubic between two rows with
// an error of fourth order and jumps of its second derivative of third order; bounded where the rows are not smooth.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gapflow {

/// First of the rows, five or all, whose polynomial gives the slope at a row; and their number.
struct RowRange {
    std::size_t first, count;
};
RowRange rows_about(std::size_t row, std::size_t rows);

/// Slope at row `at` of the polynomial through all rows. Times differ from each other.
double polynomial_slope(std::span<const double> time, std::span<const double> value, std::size_t at);

/// Brings slopes at rows to where the cubic between two rows lies between their values, but where these two, and the two before and behind them, are
/// rows of a smooth curve: there it goes beyond them, as it must at the top of an oscillation. `secant`: mean slope between a row and the next one.
/// So a plateau stays one, also one of two rows, and the tops of a smooth curve are not cut off.
void limit_slopes(std::span<const double> time, std::span<const double> secant, std::span<double> slope);

/// Both: limited slopes of the curve through values.
std::vector<double> row_slopes(std::span<const double> time, std::span<const double> value);

} // namespace gapflow
