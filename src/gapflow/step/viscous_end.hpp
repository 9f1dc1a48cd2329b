// Viscosity in a step on parts: what acts with it, and the step's end.
#pragma once

#include "gapflow/step/viscosity.hpp"
#include "gapflow/stepping/step.hpp"

namespace gapflow {

/// Impulses that act on the bodies beside the fluid's: with viscosity they do so while it does. `forced`: twists with them; on return those of the momenta alone. `mass`: of
/// all solids; `there`: at the step's end.
template <int D>
std::vector<Twist<D>> take_loads(const Model<D>& model, const std::vector<RigidBody<D>>& bodies,
                                 const std::vector<TwistMatrix<D>>& mass, const Coupling<D>& there, const Step& step,
                                 std::vector<Twist<D>>& forced);

/// The step's end with viscosity, from that without it. `voids`: null: none. The state gets wrenches and the mean pressure gradient.
template <int D>
void with_viscosity(const Model<D>& model, const std::vector<TwistMatrix<D>>& mass, const std::vector<Twist<D>>& loads,
                    const Step& step, State<D>& state, StepReport& report, Instant<D>& now, ViscousVoids<D>* voids);

} // namespace gapflow
