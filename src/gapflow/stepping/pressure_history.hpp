// What the last step's pressure still does: taken up at a step's start, kept at its end (method, "The time step" and "Viscosity").
#pragma once

#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

#include <vector>

namespace gapflow {

/// The last step's pressure as far as it goes on.
template <int D>
struct LastPressure {
    PastPressure<D> bulk;
    std::vector<Twist<D>> force; ///< viscous: on every body
};

/// Takes it out of the state's history. `here`: of the step's start. None where bodies met: what stopped them does not go on. Without viscosity,
/// nor where a body crosses an open side: about the line where its surface leaves the fluid ideal flow is singular, and the pressure of
/// one step says nothing of the next. With viscosity only a share of what a much shorter step found goes on, as with bodies' accelerations.
template <int D>
LastPressure<D> recall_pressure(const Model<D>& model, const Coupling<D>& here, const Step& step, State<D>& state);

/// Acceleration of the elements of flat films by the pressure (curved ones would grow about points of contact), in 2D without viscosity;
/// `before`, `after`: the films' velocities without and with it. The step itself tells of its middle, and, where the flat films' meshes
/// stay, so did the step before.
template <int D>
void remember_film_pressure(const Coupling<D>& there, const std::vector<Vec<D>>& before, const std::vector<Vec<D>>& after,
                            const Step& step, PressureHistory<D>& history);

/// Viscous: the bulk's pressure and the projection's forces on bodies, from which the next viscous step starts. `V_star`: twists
/// before the projection, `V`: after it; `divergence`: of the cells after the viscous step. Collective.
template <int D>
void remember_viscous_pressure(const Model<D>& model, const Coupling<D>& there, const std::vector<TwistMatrix<D>>& mass,
                               const std::vector<Twist<D>>& V_star, const CellField<D>& divergence, const Step& step,
                               State<D>& state);

} // namespace gapflow
