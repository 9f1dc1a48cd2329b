// Bodies so light against the fluid in their place that round-off hides their motion.
#pragma once

#include "gapflow/body/rigid_body.hpp"
#include "gapflow/scene/scene.hpp"

#include <vector>

namespace gapflow {

/// Throws InputError, with the scene's file, the key, the body and a remedy, where a free body has less than 1e-8 of the inertia of the fluid that it
/// displaces: of the mass, of a body that only turns of the moment of inertia.
template <int D>
void require_weight(const Scene& scene, const std::vector<RigidBody<D>>& bodies);

} // namespace gapflow
