#include "gapflow/output/convergence.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace gapflow {

namespace {

constexpr double lowest_order = -5, highest_order = 20;

std::vector<std::string> cells_of(const std::string& line)
{
    std::vector<std::string> cells;
    for (const auto cell : split(line, ','))
        cells.emplace_back(cell);
    return cells;
}

double interpolated(const Series& series, double time)
{
    const auto after = std::upper_bound(series.time.begin(), series.time.end(), time);
    if (after == series.time.begin())
        return series.value.front();
    if (after == series.time.end())
        return series.value.back();
    const auto k = after - series.time.begin();
    const double s = (time - series.time[k - 1]) / (series.time[k] - series.time[k - 1]);
    return series.value[k - 1] + s * (series.value[k] - series.value[k - 1]);
}

// Slope of the least-squares line through (x, y).
double slope_of(const std::vector<double>& x, const std::vector<double>& y)
{
    const double n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    return xy / xx;
}

// log((h^p - r^p) / p), finite and increasing in h at p = 0 too.
double log_error_law(double h, double r, double p)
{
    if (r == 0)
        return p * std::log(h);
    const double a = std::log(h / r);
    return p * std::log(r) + std::log(std::abs(p * a) < 1e-8 ? a * (1 + 0.5 * p * a) : std::expm1(p * a) / p);
}

std::string order_text(const std::optional<double>& order)
{
    return order ? fmt::format("{:.2f}", *order) : "";
}

} // namespace

std::size_t CsvTable::column(const std::string& name) const
{
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    const std::string near = nearest_name(name, names);
    throw InputError(file + ": has no column '" + name + "'" + (near.empty() ? "" : ", did you mean '" + near + "'?") +
                     "; its columns are: " + joined(names));
}

CsvTable read_csv(const std::string& file)
{
    std::ifstream in(file);
    std::error_code error;
    if (!in || std::filesystem::is_directory(file, error))
        throw InputError(file + ": cannot be read; check that the file is there");
    CsvTable table;
    table.file = file;
    std::string line;
    for (long number = 1; std::getline(in, line); ++number) {
        if (number == 1 && line.starts_with("\xef\xbb\xbf"))
            line.erase(0, 3);
        const std::string_view content = trimmed(line);
        if (content.empty() || content.starts_with('#'))
            continue;
        std::vector<std::string> cells = cells_of(line);
        if (table.names.empty()) {
            if (parse_number(cells[0]))
                throw InputError(file + ":" + std::to_string(number) +
                                 ": the first line must name the columns, as time,upper.y; add such a line");
            table.names = std::move(cells);
            continue;
        }
        if (in.eof() && table.names[0] == "step")
            break; // an incomplete last line: the run was killed while it was written
        if (cells.size() != table.names.size())
            throw InputError(file + ":" + std::to_string(number) + ": has " + std::to_string(cells.size()) +
                             " columns, the first line names " + std::to_string(table.names.size()) + "; complete the line");
        table.rows.push_back(std::move(cells));
        table.lines.push_back(number);
    }
    if (table.rows.empty())
        throw InputError(file + ": has no rows; write a line of names and rows of numbers below it");
    return table;
}

Series read_series(const CsvTable& table, const std::string& time, const std::string& value,
                   const std::vector<std::pair<std::string, std::string>>& where)
{
    const std::size_t columns[2] = {table.column(time), table.column(value)};
    std::vector<std::pair<std::size_t, std::string>> wanted;
    for (const auto& [column, text] : where)
        wanted.emplace_back(table.column(column), text);
    Series series;
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const std::vector<std::string>& row = table.rows[r];
        if (!std::all_of(wanted.begin(), wanted.end(), [&](const auto& w) { return row[w.first] == w.second; }))
            continue;
        const std::string place = table.file + ":" + std::to_string(table.lines[r]) + ": ";
        double numbers[2];
        for (int k = 0; k < 2; ++k) {
            const auto number = parse_number(row[columns[k]]);
            if (!number || !std::isfinite(*number))
                throw InputError(place + table.names[columns[k]] + " = '" + row[columns[k]] + "' is not a finite number");
            numbers[k] = *number;
        }
        if (!series.time.empty() && numbers[0] <= series.time.back())
            throw InputError(place + table.names[columns[0]] + " = " + number_text(numbers[0]) + " does not come after " +
                             number_text(series.time.back()) + "; times must increase from row to row");
        series.time.push_back(numbers[0]);
        series.value.push_back(numbers[1]);
    }
    return series;
}

double range_of(const Series& series, const TimeWindow& window)
{
    double low = interpolated(series, window.from), high = low;
    auto take = [&](double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    };
    take(interpolated(series, window.to));
    for (std::size_t i = 0; i < series.time.size(); ++i)
        if (series.time[i] >= window.from && series.time[i] <= window.to)
            take(series.value[i]);
    return high - low;
}

SeriesError error_of(const Series& run, const Series& reference, const TimeWindow& window)
{
    SeriesError error;
    double squares = 0, duration = 0, time_before = 0, before = 0;
    bool first = true;
    for (std::size_t i = 0; i < run.time.size(); ++i) {
        const double t = run.time[i];
        if (t < window.from || t > window.to)
            continue;
        const double e = run.value[i] - interpolated(reference, t);
        error.max = std::max(error.max, std::abs(e));
        if (!first) {
            squares += 0.5 * (t - time_before) * (e * e + before * before);
            duration += t - time_before;
        }
        time_before = t;
        before = e;
        first = false;
    }
    error.l2 = duration > 0 ? std::sqrt(squares / duration) : error.max;
    return error;
}

std::optional<double> observed_order(const std::vector<double>& h, const std::vector<double>& error, double reference_h)
{
    std::vector<double> spacing, y;
    for (std::size_t i = 0; i < h.size(); ++i)
        if (error[i] > 0 && h[i] > reference_h * (1 + 1e-12)) {
            spacing.push_back(h[i]);
            y.push_back(std::log(error[i]));
        }
    if (y.size() < 2)
        return std::nullopt;
    if (reference_h == 0) {
        std::vector<double> x;
        for (double s : spacing)
            x.push_back(std::log(s));
        return slope_of(x, y);
    }
    // At the order sought the residual of log(error) has no slope against log(h); the slope falls with p: bisection.
    auto remaining_slope = [&](double p) {
        std::vector<double> x, rest;
        for (std::size_t i = 0; i < y.size(); ++i) {
            x.push_back(std::log(spacing[i]));
            rest.push_back(y[i] - log_error_law(spacing[i], reference_h, p));
        }
        return slope_of(x, rest);
    };
    double low = lowest_order, high = highest_order;
    if (remaining_slope(low) < 0 || remaining_slope(high) > 0)
        return std::nullopt;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (remaining_slope(middle) > 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

void find_orders(ConvergenceOf& convergence, double reference_spacing)
{
    std::vector<double> h, max, l2;
    for (ConvergenceRow& row : convergence.rows) {
        h.push_back(row.spacing);
        max.push_back(row.error.max);
        l2.push_back(row.error.l2);
        if (const std::size_t n = h.size(); n > 1) {
            const std::vector<double> pair{h[n - 2], h[n - 1]};
            row.order_max = observed_order(pair, {max[n - 2], max[n - 1]}, reference_spacing);
            row.order_l2 = observed_order(pair, {l2[n - 2], l2[n - 1]}, reference_spacing);
        }
    }
    convergence.slope_max = observed_order(h, max, reference_spacing);
    convergence.slope_l2 = observed_order(h, l2, reference_spacing);
}

Limit limit_of(const std::vector<double>& spacings, const std::vector<double>& values, double least)
{
    Limit limit;
    limit.values = values;
    const std::size_t n = values.size();
    if (n < 3) {
        limit.reason = "takes three grids";
        return limit;
    }
    const double h1 = spacings[n - 3], h2 = spacings[n - 2], h3 = spacings[n - 1];
    const double before = values[n - 3] - values[n - 2], last = values[n - 2] - values[n - 1];
    if (std::abs(before) <= least || std::abs(last) <= least) {
        limit.reason = "changes no more than by round-off";
        return limit;
    }
    if (before * last < 0) {
        limit.reason = "not monotone";
        return limit;
    }
    // log of (h1^p - h2^p) / (h2^p - h3^p), which increases with p, less that of the changes
    const auto rest = [&](double p) {
        return log_error_law(h1 / h2, 1, p) - (log_error_law(1, h3 / h2, p)) - std::log(before / last);
    };
    double low = 0, high = highest_order;
    if (rest(low) >= 0 || rest(high) < 0) {
        limit.reason = rest(low) >= 0 ? "its changes do not fall" : "no order below 20";
        return limit;
    }
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (rest(middle) < 0 ? low : high) = middle;
    }
    limit.order = 0.5 * (low + high);
    limit.value = values[n - 1] - last / std::expm1(*limit.order * std::log(h2 / h3));
    return limit;
}

std::vector<std::pair<std::string, double>> numbers_of(const Series& series, const TimeWindow& window)
{
    Series inside;
    const auto add = [&](double time, double value) {
        inside.time.push_back(time);
        inside.value.push_back(value);
    };
    add(window.from, interpolated(series, window.from));
    for (std::size_t i = 0; i < series.time.size(); ++i)
        if (series.time[i] > window.from && series.time[i] < window.to)
            add(series.time[i], series.value[i]);
    add(window.to, interpolated(series, window.to));
    double sum = 0;
    for (std::size_t i = 1; i < inside.time.size(); ++i)
        sum += 0.5 * (inside.time[i] - inside.time[i - 1]) * (inside.value[i] + inside.value[i - 1]);
    const auto [smallest, largest] = std::minmax_element(inside.value.begin(), inside.value.end());
    return {{"end", inside.value.back()},
            {"mean", sum / (window.to - window.from)},
            {"smallest", *smallest},
            {"largest", *largest}};
}

std::string convergence_text(const std::vector<ConvergenceOf>& all)
{
    std::string text;
    for (const ConvergenceOf& c : all) {
        text += fmt::format("{} against {}, times {:.6g} to {:.6g}, errors over its range {:.6g}\n", c.quantity, c.reference,
                            c.window.from, c.window.to, c.range);
        text += fmt::format("{:>8} {:>12} {:>8} {:>12} {:>7} {:>12} {:>7}\n", "cells", "spacing", "steps", "max error", "order",
                            "L2 error", "order");
        for (const ConvergenceRow& row : c.rows)
            text += fmt::format("{:>8} {:>12.5g} {:>8} {:>12.4e} {:>7} {:>12.4e} {:>7}\n", row.cells, row.spacing, row.steps,
                                row.error.max, order_text(row.order_max), row.error.l2, order_text(row.order_l2));
        text += fmt::format("{:>8} {:>12} {:>8} {:>12} {:>7} {:>12} {:>7}\n", "slope", "", "", "", order_text(c.slope_max), "",
                            order_text(c.slope_l2));
        if (!c.limits.empty()) {
            text += fmt::format("{:>8}", "limits");
            for (const int cells : c.grids)
                text += fmt::format(" {:>12}", cells);
            text += fmt::format(" {:>7} {:>12} {:>12}\n", "order", "limit", "finest off");
        }
        for (const Limit& limit : c.limits) {
            text += fmt::format("{:>8}", limit.of);
            for (const double value : limit.values)
                text += fmt::format(" {:>12.6g}", value);
            text += limit.value ? fmt::format(" {:>7} {:>12.6g} {:>12.2e}\n", order_text(limit.order), *limit.value,
                                              limit.values.back() - *limit.value)
                                : "    " + limit.reason + "\n";
        }
        text += "\n";
    }
    return text;
}

std::string convergence_csv(const std::vector<ConvergenceOf>& all)
{
    const auto text = [](const std::optional<double>& order) { return order ? number_text(*order) : std::string(); };
    std::string csv = "quantity,cells,spacing,steps,error_max,order_max,error_l2,order_l2\n";
    for (const ConvergenceOf& c : all)
        for (const ConvergenceRow& row : c.rows)
            csv += fmt::format("{},{},{},{},{},{},{},{}\n", c.quantity, row.cells, number_text(row.spacing), row.steps,
                               number_text(row.error.max), text(row.order_max), number_text(row.error.l2), text(row.order_l2));
    return csv;
}

std::string limits_csv(const std::vector<ConvergenceOf>& all)
{
    const auto text = [](const std::optional<double>& number) { return number ? number_text(*number) : std::string(); };
    std::string csv;
    for (const ConvergenceOf& c : all) {
        if (csv.empty()) {
            csv = "quantity,of";
            for (const int cells : c.grids)
                csv += fmt::format(",cells_{}", cells);
            csv += ",order,limit,reason\n";
        }
        for (const Limit& limit : c.limits) {
            csv += c.quantity + "," + limit.of;
            for (const double value : limit.values)
                csv += "," + number_text(value);
            csv += "," + text(limit.order) + "," + text(limit.value) + "," + limit.reason + "\n";
        }
    }
    return csv;
}

std::string convergence_json(const std::vector<ConvergenceOf>& all)
{
    using Json = nlohmann::ordered_json;
    const auto number = [](const std::optional<double>& order) { return order ? Json(*order) : Json(nullptr); };
    Json list = Json::array();
    for (const ConvergenceOf& c : all) {
        Json entry = {{"quantity", c.quantity}, {"reference", c.reference},         {"window", {c.window.from, c.window.to}},
                      {"range", c.range},       {"slope_max", number(c.slope_max)}, {"slope_l2", number(c.slope_l2)},
                      {"rows", Json::array()}};
        for (const ConvergenceRow& row : c.rows)
            entry["rows"].push_back({{"cells", row.cells},
                                     {"spacing", row.spacing},
                                     {"steps", row.steps},
                                     {"error_max", row.error.max},
                                     {"order_max", number(row.order_max)},
                                     {"error_l2", row.error.l2},
                                     {"order_l2", number(row.order_l2)}});
        entry["limits"] = Json::array();
        for (const Limit& limit : c.limits) {
            Json of = {
                {"of", limit.of}, {"values", limit.values}, {"order", number(limit.order)}, {"limit", number(limit.value)}};
            if (!limit.reason.empty())
                of["reason"] = limit.reason;
            entry["limits"].push_back(of);
        }
        list.push_back(entry);
    }
    return Json{{"convergence", list}}.dump(2) + "\n";
}

} // namespace gapflow
