// Check that bodies are thick enough to be resolved by the grid.
#pragma once

#include "gapflow/stepping/setup.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// A body that is thinner than two cells.
template <int D>
struct ThinBody {
    std::string name;
    double cells; ///< thickness (sheet_thickness), in cells; fixed bodies and walls that a fixed body touches count with it
    Vec<D> at;    ///< where
};

/// The thinnest first.
template <int D>
std::vector<ThinBody<D>> thin_bodies(const Scene& scene, const std::vector<RigidBody<D>>& bodies, const DomainWalls<D>& walls);

/// Notes for the user about them. Throws InputError if one is thinner than a cell and `thin` does not allow it. With gap.model = "parts", which
/// takes bodies of any thickness: notes about those that are short along their surface, with the error of the added mass to expect.
template <int D>
std::vector<std::string> thickness_warnings(const Scene& scene, const std::vector<RigidBody<D>>& bodies,
                                            const DomainWalls<D>& walls, Scene::Thin thin);

/// Throws the InputError that a run of the scene would.
void require_thickness(const Scene& scene);

} // namespace gapflow
