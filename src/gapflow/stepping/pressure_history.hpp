// The last step's pressure: read at a step's start, stored at its end (method, "The time step", "Viscosity").
#pragma once

#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

#include <vector>

namespace gapflow {

/// The part of the last step's pressure that is extrapolated.
template <int D>
struct LastPressure {
    PastPressure<D> bulk;
    std::vector<Twist<D>> force; ///< viscous: on every body
};

/// Takes it from the state's history. `here`: of the step's start. After an impact that of the last step without one, because the impulse that
/// stopped a body must not be extrapolated. Without viscosity none where a body crosses an open side: around the line where its
/// surface leaves the fluid ideal flow is singular, and the pressure of one step is no estimate for the next. With viscosity
/// only a share of the pressure of a much shorter step is used, as with bodies' accelerations.
template <int D>
LastPressure<D> recall_pressure(const Model<D>& model, const Coupling<D>& here, const Step& step, State<D>& state);

/// That of the bulk from the last projection's impulse, in the configuration `here` of that step's end; no ghosts.
template <int D>
PastPressure<D> bulk_pressure(const Coupling<D>& here, const State<D>& state);

/// Acceleration of the elements of flat films by the pressure (in curved ones it would be unstable near points of contact), in
/// 2D without viscosity;
/// `before`, `after`: the films' velocities without and with it. The step gives the value at its middle; where the flat films'
/// meshes stay the same, the value is extrapolated from the middles of two steps.
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
