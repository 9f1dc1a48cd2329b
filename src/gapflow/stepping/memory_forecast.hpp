// Forecast of the memory that a run needs.
#pragma once

#include "gapflow/scene/scene.hpp"

namespace gapflow {

/// Bytes that a run of the scene takes at its most on one rank: the grid's (expected_memory), what viscosity adds, and that of films
/// with so many nodes and mouths and their factor. Measured (docs/performance.md).
double forecast_memory(const Scene& scene, long film_nodes, long mouths);

} // namespace gapflow
