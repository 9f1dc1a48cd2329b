// Pressure of unsteady potential flow, from the potentials at both ends of a step.
#pragma once

#include "gapflow/step/instant.hpp"

namespace gapflow {

/// dt times the reduced pressure -rho (d phi/dt + 1/2 u^2), mean of the step. Cells and nodes that were not there before it take the mean of those
/// beside them; so where they have nothing beside them that was: 0. `grid_velocity`: with which their places moved. Collective.
template <int D>
UnknownVector<D> pressure_impulse(const Instant<D>& before, const FaceField<D>& velocity_before, const Instant<D>& after,
                                  const FaceField<D>& velocity_after, const Vec<D>& grid_velocity, double dt);

} // namespace gapflow
