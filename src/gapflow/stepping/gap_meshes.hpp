// Meshes half-way between the surfaces of gaps, with what is drawn of the fluid there. Reads the state, never changes it.
#pragma once

#include "gapflow/stepping/state.hpp"

#include <array>
#include <utility>
#include <vector>

namespace gapflow {

/// Of all gaps of the domain: nodes and elements (2D: segments, 3D: triangles).
template <int D>
struct GapMeshes {
    std::vector<std::pair<int, int>> solids; ///< of each gap
    std::vector<Vec<D>> nodes;
    std::vector<int> node_gap;                           ///< number in `solids`
    std::vector<double> thickness, pressure, void_depth; ///< of each node; pressure: full
    std::vector<std::array<int, D>> elements;
    std::vector<int> element_gap;
    std::vector<Vec<D>> velocity; ///< of each element, along it, mean over the thickness
    std::vector<Vec<D>> normal;   ///< unit, from the first solid to the second
    std::vector<double> area;     ///< 2D: length
};

/// Those of films.
template <int D>
GapMeshes<D> film_meshes(const Model<D>& model, const Coupling<D>& here, const State<D>& state);

} // namespace gapflow
