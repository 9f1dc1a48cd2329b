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
std::vector<std::string> placement_warnings(const Scene& scene, const std::vector<RigidBody<D>>& bodies,
                                            const DomainWalls<D>& walls);

/// Moves free bodies out of what they overlap at the start, about as far as the overlaps ask for and whatever their masses. Returns what the
/// user should know: who was moved and how far, what still overlaps. Where bodies only touch, or none can give way, nothing moves. Throws
/// InputError if some could give way, but not to where nothing overlaps by more than a cell.
template <int D>
std::vector<std::string> take_out_overlaps(const Scene& scene, const Grid<D>& grid, std::vector<RigidBody<D>>& bodies,
                                           const DomainWalls<D>& walls);

} // namespace gapflow
