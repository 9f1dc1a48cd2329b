// Volume fluxes on parts: through the faces of the grid, and out of a gap. Exact: what passes the edges of the complex is what the bodies' motion displaces.
#pragma once

#include "gapflow/step/instant.hpp"
#include "gapflow/stepping/volume_flux.hpp"

namespace gapflow {

/// Through a side, a plane or out of a gap at an instant, as volume_flux(). Where the scene has no flux the complex is built once more. Collective.
template <int D>
VolumeFlux flux_on_parts(const Model<D>& model, const Instant<D>& instant, const State<D>& state, const FluxScene& through);

} // namespace gapflow
