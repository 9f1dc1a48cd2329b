// Checks of the bodies' positions at the start.
#pragma once

#include "gapflow/stepping/setup.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// Notes for the user about initial positions: meshes far wider than the domain (in millimetres, perhaps), bodies wholly outside the domain (fixed ones,
/// and those that may come in), and pairs that overlap by more than a cell (fixed and prescribed bodies may reach out through walls). Overlaps are looked
/// for at the bodies' centres and the vertices of their surfaces. Throws InputError for a free body wholly outside the domain that nothing moves in, and
/// where it and another one are in one place, or one lies wholly inside the other's solid.
template <int D>
std::vector<std::string> placement_warnings(const Scene& scene, const std::vector<RigidBody<D>>& bodies,
                                            const DomainWalls<D>& walls);

/// Separates free bodies that overlap at the start, with displacements about as large as the overlaps and independent of
/// masses. Returns notes for the user: which bodies were moved and how far, which still overlap. Where bodies only touch, or
/// none can give way, nothing moves. Throws InputError if overlaps of more than a cell remain between bodies that could give
/// way.
template <int D>
std::vector<std::string> take_out_overlaps(const Scene& scene, const Grid<D>& grid, std::vector<RigidBody<D>>& bodies,
                                           const DomainWalls<D>& walls);

} // namespace gapflow
