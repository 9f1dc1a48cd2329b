// Where two resolved scenes (scene_as_json) differ.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace gapflow {

/// Dotted key of the first difference between two scenes and both values, "body.ball.density: was 2, is 3"; empty: none. The tables and keys
/// of tables ("domain.leaving") in `free` do not count, nor do folders of files that the scenes name.
std::string scene_difference(const std::string& then, const std::string& now, const std::vector<std::string>& free);

/// The values that differ between some of several scenes, by dotted key (bodies by name), a text for each scene: "-" where a scene has
/// none. Title, output and cost (solver) do not count.
std::map<std::string, std::vector<std::string>> differing_values(const std::vector<std::string>& scenes);

} // namespace gapflow
