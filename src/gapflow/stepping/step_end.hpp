// The end of a step: velocities, bodies, wrenches and the pressure's history from the result of the projection (method, "The
// time step", stage 6).
#pragma once

#include "gapflow/stepping/diffusion.hpp"
#include "gapflow/stepping/unilateral.hpp"

namespace gapflow {

/// Updates the state with the result of the projection. `twists`: V* before the projection; `past`: its storage is used
/// again; `diffusion`: viscous only. Collective.
template <int D>
void take_up(const Model<D>& model, const Coupling<D>& there, Projected<D> end, const std::vector<TwistMatrix<D>>& mass,
             const std::vector<Twist<D>>& twists, LastPressure<D> past, const Diffusion<D>& diffusion, const Step& step,
             State<D>& state);

} // namespace gapflow
