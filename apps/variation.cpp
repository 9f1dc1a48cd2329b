#include "variation.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gapflow {

namespace {

constexpr std::size_t most_runs = 10'000;

// Parts between separators outside of brackets and quotes, trimmed.
std::vector<std::string> split_outside(const std::string& text, char separator)
{
    std::vector<std::string> parts(1);
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '[' || c == '{')
            ++depth;
        else if (c == ']' || c == '}')
            --depth;
        if (c == separator && depth == 0 && !quote)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    for (std::string& part : parts)
        part = std::string(trimmed(part));
    return parts;
}

// A number, or numbers in brackets.
std::optional<std::vector<double>> numbers_of(const std::string& text)
{
    std::string_view inside = text;
    if (inside.starts_with('[') && inside.ends_with(']'))
        inside = inside.substr(1, inside.size() - 2);
    std::vector<double> numbers;
    for (const std::string_view part : split(inside, ',')) {
        const auto number = parse_number(part);
        if (!number || !std::isfinite(*number))
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

// As typed: 0.3, not 0.30000000000000004.
std::string text_of(const std::vector<double>& numbers, bool vector)
{
    std::vector<std::string> parts;
    for (const double number : numbers)
        parts.push_back(fmt::format("{:.15g}", number));
    return vector ? "[" + joined(parts, ",") + "]" : parts[0];
}

std::vector<std::string> range_of(const std::string& where, const std::vector<std::string>& parts)
{
    const auto from = numbers_of(parts[0]), to = numbers_of(parts[1]), count = numbers_of(parts[2]);
    const bool log = parts.size() == 4;
    if (!from || !to || from->size() != to->size() || !count || count->size() != 1 || (*count)[0] != std::floor((*count)[0]) ||
        (log && parts[3] != "log"))
        throw InputError(where +
                         ": not FROM:TO:COUNT or FROM:TO:COUNT:log; write for example 1:10:5 for 1, 3.25, 5.5, 7.75, 10, or "
                         "a list, 1,2,5; text with a colon needs quotes");
    const auto n = (*count)[0];
    if (n < 2 || n > static_cast<double>(most_runs))
        throw InputError(where + ": COUNT = " + parts[2] + " is out of range; allowed: 2 to " + std::to_string(most_runs) +
                         " values, the ends counted");
    std::vector<std::string> values;
    for (int i = 0; i < static_cast<int>(n); ++i) {
        const double s = i / (n - 1);
        std::vector<double> numbers;
        for (std::size_t k = 0; k < from->size(); ++k) {
            const double a = (*from)[k], b = (*to)[k];
            if (log && a != b && !(a * b > 0))
                throw InputError(where +
                                 ": equal ratios take two ends of the same sign, not 0; write them so, or leave :log away");
            numbers.push_back(!log || a == b ? a + s * (b - a) : a * std::pow(b / a, s));
        }
        values.push_back(i == 0 ? parts[0] : i + 1 == n ? parts[1] : text_of(numbers, parts[0].starts_with('[')));
    }
    return values;
}

} // namespace

Variation read_variation(const std::string& text)
{
    const std::string where = "--vary " + text;
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw InputError(where +
                         ": not key=VALUES; write for example --vary body.ball.density=1:10:5 or --vary gap.model=film,none");
    Variation variation{text.substr(0, equals), split_outside(text.substr(equals + 1), ',')};
    if (variation.values.size() == 1) {
        const std::vector<std::string> parts = split_outside(variation.values[0], ':');
        if (parts.size() == 3 || parts.size() == 4)
            variation.values = range_of(where, parts);
        else if (parts.size() != 1)
            throw InputError(where +
                             ": not FROM:TO:COUNT or FROM:TO:COUNT:log; write for example 1:10:5, or a list, 1,2,5; text "
                             "with a colon needs quotes");
    }
    for (auto value = variation.values.begin(); value != variation.values.end(); ++value) {
        if (value->empty())
            throw InputError(where + ": a value of the list is empty; write for example 1,2,5");
        if (std::find(variation.values.begin(), value, *value) != value)
            throw InputError(where + ": the value " + *value + " is there twice; leave one away");
    }
    return variation;
}

std::vector<std::vector<std::pair<std::string, std::string>>> combinations(const std::vector<Variation>& variations, bool zip)
{
    std::size_t count = zip ? variations.at(0).values.size() : 1;
    for (auto v = variations.begin(); v != variations.end(); ++v) {
        if (std::any_of(variations.begin(), v, [&](const Variation& other) { return other.key == v->key; }))
            throw InputError("--vary " + v->key + ": is there twice; put all its values into one list");
        if (zip && v->values.size() != count)
            throw InputError("--zip: " + v->key + " has " + std::to_string(v->values.size()) + " values, " + variations[0].key +
                             " has " + std::to_string(count) + "; give all keys the same number, or leave --zip away");
        if (!zip)
            count *= v->values.size();
        if (count > most_runs)
            throw InputError("--vary: more than " + std::to_string(most_runs) + " runs; vary fewer values");
    }
    std::vector<std::vector<std::pair<std::string, std::string>>> runs(count);
    for (std::size_t run = 0; run < count; ++run) {
        std::size_t rest = run;
        for (auto v = variations.rbegin(); v != variations.rend(); ++v) {
            runs[run].emplace_back(v->key, v->values[zip ? run : rest % v->values.size()]);
            rest /= v->values.size();
        }
        std::reverse(runs[run].begin(), runs[run].end());
    }
    return runs;
}

} // namespace gapflow
