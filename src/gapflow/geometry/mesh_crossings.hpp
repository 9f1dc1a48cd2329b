// Pairs of facets through which a surface cuts itself.
#pragma once

#include "gapflow/geometry/shape.hpp"

#include <vector>

namespace gapflow {

template <int D>
struct Crossing {
    int first, second; ///< facets; first < second
    Vec<D> place;      ///< a point that both have, to the tolerance
};

/// What is wrong with a surface's facets; the crossings sorted by their facets.
template <int D>
struct Crossings {
    std::vector<Crossing<D>> through; ///< one passes through the other
    std::vector<Crossing<D>> flat;    ///< both lie in one plane (on one line), one over the other
    bool more = false; ///< there are more than those listed: `largest_count` were found before all pairs were seen
    static constexpr int largest_count = 10000;
};

/// Pairs of facets that have more in common than the vertices they share. Depth of a crossing is the shortest shift that parts the
/// two (for facets of one plane the shortest within it); one of no more than `tolerance` is touching, and no crossing.
template <int D>
Crossings<D> find_crossings(const SurfaceMesh<D>& mesh, double tolerance);

/// Pairs of touching facets at which closed parts of the outward surface lie within each other nevertheless, as where all that they
/// have in common runs along edges of both: on the facet's sides the winding numbers are not 0 and 1.
template <int D>
std::vector<Crossing<D>> find_crossings_along_ridges(const SurfaceMesh<D>& mesh, double tolerance);

} // namespace gapflow
