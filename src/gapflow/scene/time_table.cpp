#include "gapflow/scene/time_table.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace gapflow {

TimeTable read_time_table(const std::string& file, const std::vector<std::string>& columns)
{
    std::error_code error; // a device or pipe may never end
    std::ifstream in(std::filesystem::is_regular_file(file, error) ? file : "");
    if (!in)
        throw InputError(file + ": cannot be read; paths are relative to the scene's folder");
    const std::string wanted = joined(columns, ",");
    TimeTable table;
    table.file = file;
    bool first = true;
    std::string line;
    for (long number = 1; std::getline(in, line); ++number) {
        const std::string place = file + ":" + std::to_string(number);
        if (number == 1 && line.starts_with("\xef\xbb\xbf"))
            line.erase(0, 3);
        const std::string_view content = trimmed(line);
        if (content.empty() || content.starts_with('#'))
            continue;
        const auto cells = split(content, ',');
        if (cells.size() != columns.size())
            throw InputError(place + ": has " + std::to_string(cells.size()) + " columns; " + std::to_string(columns.size()) +
                             " are needed: " + wanted);
        const bool names = first && !parse_number(cells[0]);
        first = false;
        if (names)
            continue;
        std::vector<double> row;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto value = parse_number(cells[i]);
            if (!value || !std::isfinite(*value))
                throw InputError(place + ": " + columns[i] + " = '" + std::string(cells[i]) + "' is not a finite number");
            row.push_back(*value);
        }
        if (!table.time.empty() && row[0] <= table.time.back())
            throw InputError(place + ": time " + number_text(row[0]) + " does not come after " +
                             number_text(table.time.back()) + "; times must increase from row to row");
        table.time.push_back(row[0]);
        table.rows.emplace_back(row.begin() + 1, row.end());
    }
    if (table.time.empty())
        throw InputError(file + ": has no rows; write rows of " + wanted);
    return table;
}

namespace {

/// Row whose segment holds the time: time[k] <= t < time[k + 1]; -1 before the first, the last row after it.
std::ptrdiff_t segment(const TimeTable& table, double time)
{
    return std::upper_bound(table.time.begin(), table.time.end(), time) - table.time.begin() - 1;
}

} // namespace

std::vector<double> value_at(const TimeTable& table, double time)
{
    const std::ptrdiff_t k = segment(table, time), last = std::ssize(table.time) - 1;
    if (k < 0 || k == last)
        return table.rows.at(std::max<std::ptrdiff_t>(k, 0));
    const double s = (time - table.time[k]) / (table.time[k + 1] - table.time[k]);
    std::vector<double> value = table.rows[k];
    for (std::size_t i = 0; i < value.size(); ++i)
        value[i] += s * (table.rows[k + 1][i] - value[i]);
    return value;
}

std::vector<double> derivative_at(const TimeTable& table, double time)
{
    const std::ptrdiff_t k = segment(table, time), last = std::ssize(table.time) - 1;
    std::vector<double> slope(table.rows.at(0).size());
    if (k < 0 || k == last)
        return slope;
    for (std::size_t i = 0; i < slope.size(); ++i)
        slope[i] = (table.rows[k + 1][i] - table.rows[k][i]) / (table.time[k + 1] - table.time[k]);
    return slope;
}

} // namespace gapflow
