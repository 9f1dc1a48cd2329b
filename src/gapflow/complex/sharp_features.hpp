// Sharp corners (2D) and edges (3D) of placed solids, at which their surroundings are divided (theory of the complex, "Corners").
#pragma once

#include "gapflow/complex/placed.hpp"

#include <array>
#include <span>
#include <vector>

namespace gapflow {

/// Of a convex polygon: a section's corners.
std::vector<SharpCorner> corners_of(const Section& polygon);

/// Of a closed polygon, solid at the left of its segments: convex corners that turn by more than parameters.sharp_turn. `links`: facet_links.
std::vector<SharpCorner> corners_of(std::span<const Vec<2>> vertices, std::span<const std::array<int, 2>> segments,
                                    std::span<const std::array<int, 2>> links);

/// Facets and edges of a bounded polytope.
SharpSolid sharp_solid(const PlanesKind<3>& kind, const GridPlanes<3>& planes);

/// Of a mesh: convex edges that turn by more than parameters.sharp_turn. Facets that lie in one plane and are joined are one, and edges on one line
/// between the same two that follow each other are one.
SharpSolid sharp_solid(const FacetKind<3>& kind, const GridPlanes<3>& planes);

/// Rims of a cylinder, their pieces in the cells of the domain and of a layer around it. Rim 0: of the end at low s.
SharpSolid sharp_solid(const RoundKind<3>& kind, const GridPlanes<3>& planes);

} // namespace gapflow
