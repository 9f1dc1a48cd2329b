// The gauge of flow with circulation: what of its momentum is a gradient belongs to the potential.
#pragma once

#include "gapflow/step/potential_flow.hpp"

namespace gapflow {

/// The same flow with a remainder whose fluxes have no divergence but in parts beside others of their cell: its potential is then that of the solids' motion
/// alone. Collective.
template <int D>
void renew_gauge(const Placed<D>& at, PotentialFlow<D>& flow, const SolverOptions& options);

} // namespace gapflow
