// The gauge of flow with circulation: what of its momentum is a gradient belongs to the potential.
#pragma once

#include "gapflow/step/potential_flow.hpp"

namespace gapflow {

/// The same flow with a remainder whose fluxes have no divergence but in parts beside others of their cell: its potential is then that of the solids' motion
/// alone. Collective.
template <int D>
void renew_gauge(const Placed<D>& at, PotentialFlow<D>& flow, const SolverOptions& options);

/// Takes the potential into the remainder, which is then the fluid's velocity: in slivers friction is large, and cancels the pressure's gradient. Faces of the grid
/// without an own edge have the mean of their sparse ones. On one rank.
template <int D>
void take_gauge_of_velocity(const Placed<D>& at, PotentialFlow<D>& flow);

} // namespace gapflow
