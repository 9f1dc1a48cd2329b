// The projection with its unilateral conditions (method, "The time step", stage 6): contact forces are compressive, film
// pressures have a lower bound. The rounds over their sets are in rounds.hpp, the system and its solves in projection.hpp.
#pragma once

#include "gapflow/core/timer.hpp"
#include "gapflow/stepping/transport.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// Result of a projection.
template <int D>
struct Projected {
    FluidVelocity<D> velocity;    ///< u* as used in the projection: the flux of mouths that voids shut is 0
    UnknownVector<D> impulse;     ///< p
    std::vector<Twist<D>> twists; ///< V of all solids at the step's end
    FilmAccount<D> account;       ///< of the films' transport, as used in the projection
    std::vector<char> was_empty;  ///< film elements without fluid before the step; empty: no voids
};

/// Solves (L + K M^-1 K^T) p = -(D u* + K V*), contacts among the bodies included. In the initial projection (step.dt = 0) there are neither
/// contacts nor voids. `there`: its system gets the contributions of this step alone: drag's speeds, held contacts, shut
/// mouths. `state`: its
/// contacts and voids become those of the step's end; its impulse is used as storage. Throws ComputationError where fluid has
/// no way
/// out, bodies are driven into each other, or the solve does not converge. Collective.
template <int D>
Projected<D> project(const Model<D>& model, Coupling<D>& there, Intermediate<D> star, const std::vector<TwistMatrix<D>>& mass,
                     const Step& step, State<D>& state, StepReport& report, StageTimers& timers);

} // namespace gapflow
