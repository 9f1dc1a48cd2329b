// The table of scene keys as text for users: a page, a man page, a list.
#pragma once

#include "gapflow/scene/keys.hpp"

namespace gapflow {

/// For a terminal: the keys whose dotted name is `within` or starts with it and a dot; all if empty. Empty if there are none.
std::string key_list(const std::string& within = "");

/// Names alone, one per line, as --set takes them (bodies' keys with "body.NAME.", pairs' keys left out).
std::string key_names();

/// The reference page in Markdown.
std::string key_page();

/// The manual page gapflow-scene(5).
std::string key_manual(const std::string& version);

} // namespace gapflow
