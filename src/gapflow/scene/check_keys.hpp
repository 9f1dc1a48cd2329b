// Checks that follow from the table of keys alone: names, types, ranges, required keys.
#pragma once

#include "gapflow/scene/document.hpp"
#include "gapflow/scene/keys.hpp"

#include <string>
#include <utility>
#include <vector>

namespace gapflow {

/// Puts the values given to --set into the document. Throws InputError for unknown keys and bodies.
void apply_overrides(Node& document, const std::vector<std::pair<std::string, std::string>>& overrides,
                     const std::vector<KeyInfo>& keys);

/// Throws InputError for keys and tables that do not exist.
void check_names(const Node& document, const std::vector<KeyInfo>& keys);

/// 2 or 3, from domain.size. Throws InputError.
int dimension_of(const Node& document, const std::vector<KeyInfo>& keys);

/// Throws InputError for missing keys, wrong types and values out of range.
void check_values(const Node& document, const std::vector<KeyInfo>& keys, int dimension);

/// A table under its name in messages: "body.upper." or, without a name, "body[1]." (counted from 1); "pair[2].".
std::string shown_prefix(const Node& element, const std::string& table, int number);

const KeyInfo* find_key(const std::vector<KeyInfo>& keys, const std::string& name);
/// Whether keys start with this name and a dot.
bool is_table(const std::vector<KeyInfo>& keys, const std::string& name);
/// Throws InputError with the nearest known key and the keys of the table it stands in.
[[noreturn]] void refuse_unknown(const std::string& where, const std::string& name, const std::string& shown,
                                 const std::vector<KeyInfo>& keys);

} // namespace gapflow
