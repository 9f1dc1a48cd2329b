// How far a flow is from steady (method, "Steady flow"): the part of itself by which it will still change if its changes go on fading as they did
// over the last tenth of the time so far. With the relative rate of change in a step
//
//     s = max( |du/dt| / |u|,  max_b |dF_b/dt| / F,  max_b |dV_b/dt| / U ),      r = s T,
//
// s' the mean of s over about that tenth, ds'/dt = (s - s') / (t/10), and T the time in which a rate that fades as exp(-t/T) lags by that much,
//
//     T = (t/10) / (1 - s/s'),   but at most   tau = min( L / U, L^2 / nu ),   which holds where changes do not fade; at least dt.
//
// U is the root mean square of the fluid's velocity, L the domain's longest edge, F the largest force without buoyancy, not less than
// rho U^2 l^(D-1) of the largest body's size l. Where U has fallen below the tolerance times its largest value so far, that takes its
// place: the fluid counts as at rest. Where nothing moves fast enough to come further than the solver's tolerance, in cells, in the time of the
// whole run, r is 0.
#pragma once

#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

#include <vector>

namespace gapflow {

/// The flow before a step.
template <int D>
struct EarlierFlow {
    FaceField<D> velocity;
    std::vector<Twist<D>> wrenches, twists; ///< of bodies; of all solids

    EarlierFlow(const Model<D>& model, const State<D>& state)
        : velocity(state.velocity.grid), wrenches(state.wrenches), twists(model.twists(state.bodies))
    {
    }
};

/// r of the last step; 0 where nothing moves but by round-off. Updates state.steady. Collective.
template <int D>
double unsteadiness(const Model<D>& model, const Coupling<D>& here, const EarlierFlow<D>& before, State<D>& state);

/// Whether the flow has settled: r was below time.until_steady in ten steps in a row and for a twentieth of the time so far, and no table of inflow or
/// motion goes on.
bool has_settled(const Scene& scene, const SteadyWatch& watch, double time);

} // namespace gapflow
