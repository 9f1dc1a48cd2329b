// Normals, smooth patches, sharp edges and curvatures of a closed mesh.
#pragma once

#include "gapflow/geometry/facet_tree.hpp"
#include "gapflow/geometry/mesh_check.hpp"

#include <span>

namespace gapflow {

template <int D>
struct MeshFeatures {
    std::vector<Vec<D>> facet_normal;        ///< a facet without area has that of its neighbour across its longest edge
    std::vector<std::array<bool, D>> smooth; ///< ridge i of a facet: its two normals differ by at most 30 degrees
    std::vector<int> patch;                  ///< of each facet: parts connected over smooth ridges, numbered by first facet
    std::vector<double> patch_curvature;     ///< 0 if planar within 1e-6 of its size
    std::vector<Vec<D>> vertex_normal;       ///< angle-weighted pseudonormal (Baerentzen & Aanaes 2005)
    std::vector<Feature> vertex_feature;     ///< 3D: edge where a sharp edge passes or ends, corner where they meet or turn
    std::vector<bool> vertex_one_fan;        ///< false: parts touch here, the pseudonormal does not determine the side
    std::vector<int> fan_start, fan;         ///< facets at vertex v: fan[fan_start[v]] .. fan[fan_start[v + 1] - 1]

    std::span<const int> facets_at(int vertex) const
    {
        return {fan.data() + fan_start[vertex], fan.data() + fan_start[vertex + 1]};
    }
};

template <int D>
MeshFeatures<D> find_features(const ClosedSurface<D>& surface);

/// Angle of a facet at its local vertex i (2D: 1).
template <int D>
double facet_angle(const SurfaceMesh<D>& mesh, int facet, int i);

} // namespace gapflow
