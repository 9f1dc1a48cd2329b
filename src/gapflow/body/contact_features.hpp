// Parts of a shape that can touch another body first: round cores, sharp vertices, convex edges. At flat and hollow parts the
// other body's parts touch first.
#pragma once

#include "gapflow/geometry/shape.hpp"

#include <vector>

namespace gapflow {

/// A convex edge between two patches, in the shape's frame. 3D only.
struct ContactEdge {
    Vec<3> from, to;
    Vec<3> normal_a, normal_b; ///< of the patches, in the middle of the edge
    int patch_a, patch_b;
    bool straight; ///< between two flat patches; else a chord of a curved rim
};

template <int D>
struct ContactFeatures {
    std::vector<Core<D>> cores;
    std::vector<Vec<D>> vertices;
    std::vector<std::vector<Vec<D>>> beside; ///< of each vertex: unit vectors to the surface's vertices beside it
    std::vector<ContactEdge> edges;
    int patches = 0;
};

template <int D>
ContactFeatures<D> contact_features(const Shape<D>& shape);

} // namespace gapflow
