// The projection with its one-sided conditions (method, "The time step", stage 6): contacts that only push, film pressures that do not
// fall below their least. The rounds over their sets are in rounds.hpp, the system and its solves in projection.hpp.
#pragma once

#include "gapflow/core/timer.hpp"
#include "gapflow/stepping/transport.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// What a projection makes.
template <int D>
struct Projected {
    FluidVelocity<D> velocity;    ///< u* as the projection saw it: without what mouths had that voids shut
    UnknownVector<D> impulse;     ///< p
    std::vector<Twist<D>> twists; ///< V of all solids at the step's end
    std::vector<char> was_empty;  ///< film elements without fluid before the step; empty: no voids
};

/// Solves (L + K M^-1 K^T) p = -(D u* + K V*), contacts among the bodies included. In the initial projection (step.dt = 0) there are neither
/// contacts nor voids. `there`: gets what the step alone adds to its system: drag's speeds, held contacts, shut mouths. `state`: its
/// contacts and voids become those of the step's end; its impulse is taken as storage. Throws ComputationError where fluid has no way
/// out, bodies are driven into each other, or the solve does not converge. Collective.
template <int D>
Projected<D> project(const Model<D>& model, Coupling<D>& there, Intermediate<D> star, const std::vector<TwistMatrix<D>>& mass,
                     const Step& step, State<D>& state, StepReport& report, StageTimers& timers);

} // namespace gapflow
