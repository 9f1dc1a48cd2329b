// Reader of functions of time in CSV files.
#pragma once

#include "gapflow/scene/scene.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// Rows of numbers under increasing times. `columns` are the names that the file must have values for, time first; a first
/// line of names, empty lines and lines that start with # are left out. Throws InputError with file and line.
TimeTable read_time_table(const std::string& file, const std::vector<std::string>& columns);

} // namespace gapflow
