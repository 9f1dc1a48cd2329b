// Fluid on parts that is enclosed where surfaces touch: what leaks through the distance of their roughness is none that a motion may count on.
#pragma once

#include "gapflow/step/placed.hpp"
#include "gapflow/stepping/sealing.hpp"

namespace gapflow {

/// squeezed_pocket() of the complex without the faces of gaps that touch and do not part: the message, empty where no volume of enclosed fluid is driven to change.
/// Collective.
template <int D>
std::string squeezed_on_parts(const Model<D>& model, const Placed<D>& at, const std::vector<Contact<D>>& contacts,
                              const std::vector<Twist<D>>& twists, const FluidVelocity<D>& u, GivesWay gives_way);

} // namespace gapflow
