// Volume flux through the gap of a pair of bodies (method, "What is measured").
#pragma once

#include "gapflow/stepping/volume_flux.hpp"

namespace gapflow {

/// Half of what enters and leaves the films of the scene's pair; with a direction, what flows through their middle along it. NaN for a gap without
/// a film. The same on every rank.
template <int D>
VolumeFlux flux_through_gap(const Coupling<D>& here, const State<D>& state, const FluxScene& through);

/// Impulse of the pressure at a joint's nodes times its conductance: the volume flux out of the nodes of positive weight.
template <int D>
double flux_of_joint(const State<D>& state, const Link& link);

} // namespace gapflow
