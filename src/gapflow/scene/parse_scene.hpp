// A scene from a text in memory.
#pragma once

#include "gapflow/scene/scene.hpp"

#include <string_view>

namespace gapflow {

/// Dotted keys and TOML values, as given to --set.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// As read_scene(), of a text. `file` stands for it in messages; files that the scene names are looked for in the folder of
/// `file`.
Scene parse_scene(std::string_view text, const std::string& file, const Overrides& overrides, Purpose purpose);

} // namespace gapflow
