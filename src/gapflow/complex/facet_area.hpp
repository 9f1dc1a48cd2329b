// Facets of closed surfaces: segments (2D) and triangles (3D) whose vertices run so that the solid is behind their normal.
#pragma once

#include "gapflow/core/types.hpp"

#include <array>
#include <vector>

namespace gapflow {

/// The normal of a facet out of what the surface encloses, as long as the segment or twice the triangle's area.
template <int D>
Vec<D> facet_area(const std::vector<Vec<D>>& vertices, const std::array<int, D>& facet)
{
    const Vec<D> way = vertices[facet[1]] - vertices[facet[0]];
    if constexpr (D == 2)
        return Vec<2>(way[1], -way[0]);
    else
        return way.cross(vertices[facet[2]] - vertices[facet[0]]);
}

} // namespace gapflow
