// Whether bodies are where a computation can begin.
#pragma once

#include "gapflow/stepping/setup.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// What the user should know of where bodies begin: those wholly outside the domain (prescribed ones may come in), and pairs that
/// overlap by more than a cell (fixed and prescribed bodies may reach out through walls). Overlaps are looked for at the bodies'
/// centres and the vertices of their surfaces.
template <int D>
std::vector<std::string> placement_warnings(const Scene& scene, const std::vector<RigidBody<D>>& bodies, const DomainWalls<D>& walls);

} // namespace gapflow
