// Terms of one row.
#pragma once

#include "gapflow/viscous/squares.hpp"

#include <vector>

namespace gapflow {

/// Columns ascending, each once.
void merge(std::vector<Term>& terms);

} // namespace gapflow
