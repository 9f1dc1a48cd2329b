// Small text helpers for messages, tables and files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gapflow {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn a into b.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to a misspelt name; empty if none is near enough to be the intended one.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// Shortest decimal text that reads back as the same number.
std::string number_text(double value);

/// The whole text as a number ("nan" and "inf" included); empty if it is not one.
std::optional<double> parse_number(std::string_view text);

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// Parts between separators, trimmed; always at least one.
std::vector<std::string_view> split(std::string_view text, char separator);

/// "a, b, c".
std::string joined(const std::vector<std::string>& parts, std::string_view separator = ", ");

} // namespace gapflow
