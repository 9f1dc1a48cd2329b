// Connected parts of the fluid, as they are or with some film nodes shut.
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <vector>

namespace gapflow {

template <int D>
struct FluidParts {
    CellField<D, int> component; ///< of each cell, -1: no unknown; valid on owned cells and one layer of ghosts
    std::vector<int> node_component;
    std::vector<Component> components;
};

/// Parts connected by faces, film elements and links; elements and links with a shut node connect nothing. `shut`: one value for each film
/// node, the same on all ranks; empty: none is. Collective.
template <int D>
FluidParts<D> find_parts(const Coupling<D>& coupling, const std::vector<char>& shut);

/// Whether the contacts in the system keep the free bodies from giving way to enclosed fluid that without them they would give way to: the coupled system has
/// no solution then. Collective.
template <int D>
bool contacts_lock_fluid(const Coupling<D>& coupling);

} // namespace gapflow
