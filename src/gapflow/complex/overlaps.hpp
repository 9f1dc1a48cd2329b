// Which solids overlap sharp ones: no cell beside both of them is divided at an edge, whose line the other solid may cover.
#pragma once

#include "gapflow/complex/placed.hpp"

#include <span>

namespace gapflow {

/// Whether the solid of `sharp`, a convex one with edges, and another one have common points; of a solid that is not convex its hull counts, of the
/// outside of a convex one whether a box around `sharp` reaches into it. Convex solids are apart where an axis separates them, of those along
/// which touching ones can: normals of faces, axes, their products, and the way between nearest points.
bool overlap(const PlacedSolid<3>& sharp, const PlacedSolid<3>& other);

/// Fills SharpSolid::overlapping.
void find_overlaps(std::span<PlacedSolid<3>> solids);

} // namespace gapflow
