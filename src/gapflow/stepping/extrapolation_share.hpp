// Extrapolation of the last step's accelerations and pressures (method, "The time step", "The bulk").
#pragma once

#include <algorithm>

namespace gapflow {

/// The share of the last step's accelerations and pressures that is used in a step of length `dt`: none is extrapolated over
/// more than twice the length of the step in which it was found, because in a much shorter step it may be an impulse.
/// `last_dt`: 0 in the first step.
inline double extrapolation_share(double last_dt, double dt)
{
    constexpr double longest = 2; // steps like the last one
    return last_dt > 0 ? std::min(1.0, longest * last_dt / dt) : 1.0;
}

} // namespace gapflow
