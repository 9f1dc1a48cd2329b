// From facets of a file to a closed, oriented surface.
#pragma once

#include "gapflow/geometry/shape.hpp"

#include <array>
#include <string>
#include <vector>

namespace gapflow {

/// For each facet the facet across each ridge (3D: edge, 2D: vertex); ridge i is the one without the facet's vertex i. In 2D
/// ridge i is thus the vertex 1 - i.
template <int D>
using Neighbours = std::vector<std::array<int, D>>;

/// Closed surface with outward orientation.
template <int D>
struct ClosedSurface {
    SurfaceMesh<D> mesh; ///< `patch` empty
    Neighbours<D> neighbours;
};

/// Welds vertices where the facets need it (first identical ones, then those within 1e-6 of the size), drops facets that
/// collapse, checks that every ridge has two facets of consistent orientation, and that the surface does not cut itself by more
/// than 1e-6 of the size, and turns it over if its volume is negative. Then every connected part must be outward, or inward where
/// it is a cavity inside another part. Throws InputError that starts with `name` and names the first bad ridge, or the first pair
/// of facets that cross: by the `lines` of the file on which they are (one for each facet, or empty), else by their numbers from 0.
template <int D>
ClosedSurface<D> closed_surface(SurfaceMesh<D> mesh, const std::string& name, const std::vector<int>& lines = {});

/// Diagonal of the box around a mesh that has vertices.
template <int D>
double extent(const SurfaceMesh<D>& mesh);

/// Merges vertices no further apart than `tolerance` (each with the first such vertex), drops unused vertices and facets
/// with fewer than D different vertices, also from `source`.
template <int D>
SurfaceMesh<D> welded(const SurfaceMesh<D>& mesh, double tolerance, std::vector<int>& source);

/// Generalised winding number of the surface around x: 1 inside a simple outward surface, 0 outside
/// (Jacobson et al. 2013; solid angles by Van Oosterom & Strackee 1983).
template <int D>
double winding_number(const SurfaceMesh<D>& mesh, const Vec<D>& x);

} // namespace gapflow
