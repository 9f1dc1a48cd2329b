// Notes for the user about bodies that leave the domain.
#pragma once

#include "gapflow/stepping/setup.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// Position of a body relative to the domain.
struct Whereabouts {
    bool outside = false;     ///< wholly beyond a side that is not periodic
    std::vector<int> crossed; ///< open and inflow sides beyond which a part of it lies: 2 * axis + end
};

/// Of every body; fixed ones, containers and bodies without bounds count as inside.
template <int D>
std::vector<Whereabouts> whereabouts(const Scene& scene, const std::vector<RigidBody<D>>& bodies);

/// Notes about bodies that were at `before` when a step began: one that moves out through an open or inflow side is on its way
/// out
/// once it reaches through; one that is wholly outside and was not has left. `first`: of the first step, when bodies that reach
/// through already count.
template <int D>
std::vector<std::string> leaving_notes(const Scene& scene, const std::vector<RigidBody<D>>& bodies,
                                       const std::vector<Whereabouts>& before, bool first);

} // namespace gapflow
