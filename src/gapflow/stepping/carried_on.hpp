// What the last step found goes on in this one (method, "The time step", "The bulk").
#pragma once

#include <algorithm>

namespace gapflow {

/// The share of the last step's accelerations and pressures that goes on in a step of length `dt`: none is carried further than
/// two steps of the length that it was found in. What a much shorter step found may be an impulse. `last_dt`: 0 in the first
/// step, where nothing was found.
inline double carried_on(double last_dt, double dt)
{
    constexpr double longest = 2; // steps like the last one
    return last_dt > 0 ? std::min(1.0, longest * last_dt / dt) : 1.0;
}

} // namespace gapflow
