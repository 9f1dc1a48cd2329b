// Type and range of one value.
#pragma once

#include "gapflow/scene/document.hpp"
#include "gapflow/scene/keys.hpp"

#include <string>

namespace gapflow {

/// Throws InputError if the value is not of the key's type or not in its range; `shown` is the key's name in messages.
void check_value(const Node& value, const KeyInfo& key, const std::string& shown, int dimension);

} // namespace gapflow
