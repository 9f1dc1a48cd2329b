// The values that a sweep gives to keys of a scene, as the user writes them.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gapflow {

/// A dotted key and its values, each as --set takes it.
struct Variation {
    std::string key;
    std::vector<std::string> values;
};

/// Reads KEY=VALUES. VALUES: FROM:TO:COUNT, evenly spaced with both ends, numbers or vectors ([1,0.5]:[1,0.9]:5); with :log behind it
/// in equal ratios; or a list with commas between its values (film,none or [32,32],[64,64]). Throws InputError.
Variation read_variation(const std::string& text);

/// The values of each run, key and value: of every combination, the last key changing fastest; with `zip` the first values of all keys, the
/// second ones and so on. Throws InputError for a key given twice, for lists of different length to zip, and for more than 10 000 runs.
std::vector<std::vector<std::pair<std::string, std::string>>> combinations(const std::vector<Variation>& variations, bool zip);

} // namespace gapflow
