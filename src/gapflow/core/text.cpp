#include "gapflow/core/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gapflow {

// Optimal string alignment (Damerau-Levenshtein without repeated edits), row by row.
int edit_distance(std::string_view a, std::string_view b)
{
    const std::size_t n = b.size();
    std::vector<int> before(n + 1), last(n + 1), row(n + 1);
    for (std::size_t j = 0; j <= n; ++j)
        last[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= n; ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(last);
        last.swap(row);
    }
    return last[n];
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates)
{
    std::string best;
    int best_distance = std::max(2, static_cast<int>(name.size()) / 3) + 1;
    for (const std::string& candidate : candidates) {
        const int distance = edit_distance(name, candidate);
        if (distance < best_distance && distance < static_cast<int>(std::max(name.size(), candidate.size()))) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string number_text(double value)
{
    char buffer[32];
    const bool whole = std::abs(value) < 1e9 && value == std::trunc(value); // 100000, not 1e+05
    const auto end = whole ? std::to_chars(buffer, buffer + sizeof buffer, static_cast<long>(value))
                           : std::to_chars(buffer, buffer + sizeof buffer, value);
    return std::string(buffer, end.ptr);
}

std::optional<double> parse_number(std::string_view text)
{
    text = trimmed(text);
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    double value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || end.ec != std::errc() || end.ptr != text.data() + text.size())
        return std::nullopt;
    return value;
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blank = " \t\r\n";
    const auto first = text.find_first_not_of(blank);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (;;) {
        const auto end = text.find(separator);
        parts.push_back(trimmed(text.substr(0, end)));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

std::string joined(const std::vector<std::string>& parts, std::string_view separator)
{
    std::string text;
    for (const std::string& part : parts) {
        if (&part != &parts.front())
            text += separator;
        text += part;
    }
    return text;
}

} // namespace gapflow
