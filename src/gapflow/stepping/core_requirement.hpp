// What a scene must keep to on a graded grid at its start (method, "Graded spacing").
#pragma once

#include "gapflow/body/rigid_body.hpp"
#include "gapflow/coupling/coupling.hpp"
#include "gapflow/stepping/model.hpp"

#include <vector>

namespace gapflow {

/// Throws InputError, with the scene's file, key and a remedy, where a body that moves, or a film, reaches out of the core (see outside_core).
template <int D>
void require_core(const Model<D>& model, const Coupling<D>& here, const std::vector<RigidBody<D>>& bodies);

} // namespace gapflow
