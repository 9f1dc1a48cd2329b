// The command line described from its one definition: man page, Markdown, completions of shells.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace gapflow {

/// Kinds of text that describe() makes.
inline constexpr const char* description_kinds[] = {"man", "markdown", "bash", "zsh", "fish", "scene-man", "scene-markdown"};

std::string describe(const CLI::App& app, const std::string& kind, const std::string& version);

} // namespace gapflow
