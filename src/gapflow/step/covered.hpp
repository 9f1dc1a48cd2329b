// What solids cover of the grid's faces: with the fluid's flux that of their motion is the flux of all volume, which has no divergence in whole cells.
#pragma once

#include "gapflow/step/placed.hpp"

#include <vector>

namespace gapflow {

/// Twists as fluxes through what is covered take them: without the spin of a ball about its centre, which moves no wall.
template <int D>
Twist<D> moving_walls(const Solid<D>& solid, Twist<D> twist);

/// Flux of each solid's motion through what it covers of this rank's inner faces. `at`: with its clipper.
template <int D>
std::vector<CarriedFlux<D>> covered_fluxes(const Placed<D>& at);

} // namespace gapflow
