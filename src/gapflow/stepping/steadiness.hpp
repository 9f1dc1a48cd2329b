// How far a flow is from steady (method, "Steady flow"): the rates at which the bulk's velocity, the fluid's forces and the bodies' motion change
// in a step, over their own size and per time tau of the flow,
//
//     r = tau max( |du/dt| / |u|,  max_b |dF_b/dt| / F,  max_b |dV_b/dt| / U ),      tau = max( min( L / U, L^2 / nu ), dt ),
//
// U the root mean square of the fluid's velocity, L the domain's longest edge, F the largest force without buoyancy, not less than
// rho U^2 l^(D-1) of the largest body's size l. Where U has fallen below the tolerance times its largest value so far, that takes its
// place: the fluid counts as at rest. Where nothing moves by more than the solver's tolerance, in cells, until the end, r is 0. A change that would take the time tau to double the flow has r = 1, whatever the step.
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

/// Whether the flow has settled: r was below time.until_steady in ten steps in a row, and no table of inflow or motion goes on.
bool has_settled(const Scene& scene, const SteadyWatch& watch, double time);

} // namespace gapflow
