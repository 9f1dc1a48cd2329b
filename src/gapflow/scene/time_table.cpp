#include "gapflow/scene/time_table.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <utility>

namespace gapflow {

namespace {

/// Which of the wanted columns those of a file are, and what their numbers are multiplied by.
struct Layout {
    std::vector<std::size_t> place;
    std::vector<double> factor;
};

class TableReader {
public:
    TableReader(const std::vector<std::string>& columns, const std::vector<std::string>& optional)
        : columns_(columns), optional_(optional)
    {
        for (std::size_t i = 0; i < columns.size(); ++i)
            take(layout_, i, 1);
    }

    /// A line with neither blanks at its ends nor nothing in it.
    void read(const std::string& place, std::string_view content)
    {
        if (content.starts_with('#')) {
            const auto cells = split(content.substr(1), ',');
            if (first_ && cells.size() > 1 && std::all_of(cells.begin(), cells.end(), [&](auto c) { return find(c).first; }))
                read_names(place, cells);
            return;
        }
        const auto cells = split(content, ',');
        const bool names = first_ && !parse_number(cells[0]);
        first_ = false;
        if (names)
            read_names(place, cells);
        else
            read_row(place, cells);
    }

    TimeTable table;

    /// "time,x,y,angle (or angle_deg); vx,vy,omega if known".
    std::string wanted() const
    {
        std::string text = joined(columns_, ",");
        if (columns_.back() == "angle")
            text += " (or angle_deg)";
        return text + (optional_.empty() ? "" : " and, if known, " + joined(optional_, ","));
    }

private:
    static void take(Layout& layout, std::size_t place, double factor)
    {
        layout.place.push_back(place);
        layout.factor.push_back(factor);
    }

    const std::string& name_of(std::size_t place) const
    {
        return place < columns_.size() ? columns_[place] : optional_[place - columns_.size()];
    }

    /// Whether a column of this name is wanted, its place and factor.
    std::pair<bool, std::pair<std::size_t, double>> find(std::string_view name) const
    {
        const bool degrees = name == "angle_deg";
        for (std::size_t i = 0; i < columns_.size() + optional_.size(); ++i)
            if (name_of(i) == (degrees ? "angle" : name))
                return {true, {i, degrees ? std::numbers::pi / 180 : 1.0}};
        return {false, {}};
    }

    void read_names(const std::string& place, const std::vector<std::string_view>& cells)
    {
        Layout layout;
        std::vector<bool> there(columns_.size() + optional_.size());
        for (const std::string_view name : cells) {
            const auto [wanted_one, column] = find(name);
            if (!wanted_one)
                throw InputError(place + ": the column '" + std::string(name) + "' is not one of those wanted: " + wanted());
            if (there[column.first])
                throw InputError(place + ": the column '" + name_of(column.first) + "' is there twice");
            there[column.first] = true;
            take(layout, column.first, column.second);
        }
        for (std::size_t i = 0; i < columns_.size(); ++i)
            if (!there[i])
                throw InputError(place + ": there is no column '" + columns_[i] + "'; wanted are " + wanted());
        layout_ = layout;
        width_ =
            std::any_of(there.begin() + static_cast<std::ptrdiff_t>(columns_.size()), there.end(), [](bool t) { return t; })
                ? there.size()
                : columns_.size();
        named_ = true;
    }

    void read_row(const std::string& place, const std::vector<std::string_view>& cells)
    {
        if (cells.size() != layout_.place.size())
            throw InputError(place + ": has " + std::to_string(cells.size()) + " columns; " +
                             std::to_string(layout_.place.size()) +
                             (named_ ? " have names" : " are needed: " + joined(columns_, ",")));
        std::vector<double> row(width_, std::numeric_limits<double>::quiet_NaN());
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto value = parse_number(cells[i]);
            if (!value || !std::isfinite(*value))
                throw InputError(place + ": " + name_of(layout_.place[i]) + " = '" + std::string(cells[i]) +
                                 "' is not a finite number");
            row[layout_.place[i]] = layout_.factor[i] * *value;
        }
        if (!table.time.empty() && row[0] <= table.time.back())
            throw InputError(place + ": time " + number_text(row[0]) + " does not come after " +
                             number_text(table.time.back()) + "; times must increase from row to row");
        table.time.push_back(row[0]);
        table.rows.emplace_back(row.begin() + 1, row.end());
    }

    const std::vector<std::string>&columns_, &optional_;
    Layout layout_;
    std::size_t width_ = columns_.size(); ///< of the rows, the time included
    bool first_ = true, named_ = false;
};

} // namespace

TimeTable read_time_table(const std::string& file, const std::vector<std::string>& columns,
                          const std::vector<std::string>& optional)
{
    std::error_code error; // a device or pipe may never end
    std::ifstream in(std::filesystem::is_regular_file(file, error) ? file : "");
    if (!in)
        throw InputError(file + ": cannot be read; paths are relative to the scene's folder");
    TableReader reader(columns, optional);
    reader.table.file = file;
    std::string line;
    for (long number = 1; std::getline(in, line); ++number) {
        if (number == 1 && line.starts_with("\xef\xbb\xbf"))
            line.erase(0, 3);
        if (const std::string_view content = trimmed(line); !content.empty())
            reader.read(file + ":" + std::to_string(number), content);
    }
    if (reader.table.time.empty())
        throw InputError(file + ": has no rows; write rows of " + reader.wanted());
    return reader.table;
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

std::vector<double> integral_to(const TimeTable& table, double time)
{
    std::vector<double> sum(table.rows.at(0).size(), 0.0);
    double from = 0;
    const auto go_on_to = [&](double to) { // no row in between
        const std::vector<double> low = value_at(table, from), high = value_at(table, to);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += 0.5 * (to - from) * (low[i] + high[i]);
        from = to;
    };
    for (const double row : table.time)
        if (row > 0 && row < time)
            go_on_to(row);
    go_on_to(time);
    return sum;
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
