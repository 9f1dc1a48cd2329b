// Reader of functions of time in CSV files.
#pragma once

#include "gapflow/scene/scene.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// Rows of numbers under increasing times. `columns` are the names that the file must have values for, time first. A first line of names
/// tells their order, and may have those of `optional` too: the rows then have a place for each of these, NaN for one that is not there.
/// A column angle may be called angle_deg, of degrees. Without names the columns are as in `columns`. Empty lines and lines that start with #
/// are left out, but one of nothing but names. Throws InputError with file, line and column.
TimeTable read_time_table(const std::string& file, const std::vector<std::string>& columns,
                          const std::vector<std::string>& optional = {});

/// Integral of a table's columns from time 0.
std::vector<double> integral_to(const TimeTable& table, double time);

} // namespace gapflow
