// Steps in which viscosity goes so far that the forces on bodies lag behind their motion (method, "What to keep in mind").
#pragma once

#include "gapflow/stepping/state.hpp"

#include <string>

namespace gapflow {

/// Longest step whose forces the pressure follows whatever the bodies do; infinite without viscosity.
template <int D>
double followed_step(const Model<D>& model);

/// After a step: whether it was too long for bodies that changed their velocities as they did.
template <int D>
bool lags(const Model<D>& model, const State<D>& state);

/// After a step, once one was too long: the longest next one. At the bodies' accelerations it changes no velocity by more than what counts as steady, and it is at
/// most twice as long as the last; or it is followed_step().
template <int D>
double longest_viscous_step(const Model<D>& model, const State<D>& state);

/// For the user.
template <int D>
std::string viscous_lag_note(const Model<D>& model);

} // namespace gapflow
