// What the motion of each body changes in the kinetic energy over a step, as a form of the velocities before and after it (theory of the step,
// "Work").
//
// With the added masses N, N' of the two places, and L p = -K V, L' p' = -K' V', the form
//
//     B(x) = -1/2 [ p . L p' + p . K V' + p' . K V - V . D V' ]
//
// is stationary in p' before the step and in p after it: B(x') - B(x) = 1/2 V (N' - N) V' with both fields fixed. It is therefore a sum over the
// places where L, K or D change, and each of these belongs to the bodies beside it.
#pragma once

#include "gapflow/step/potential_flow.hpp"

#include <vector>

namespace gapflow {

/// 1/2 V (N' - N) V' of the fluid, as a sum over groups of solids: what changes beside several of them belongs to all of these.
struct EnergyChange {
    std::vector<double> work; ///< of each group
    std::vector<int> group;   ///< of each solid; -1: a wall, or one that does not move
};

/// `stream`: to which the flows' twists are relative. Collective.
template <int D>
EnergyChange energy_change(const Placed<D>& before, const PotentialFlow<D>& flow_before, const Placed<D>& after,
                           const PotentialFlow<D>& flow_after, const Twist<D>& stream = Twist<D>::Zero());

} // namespace gapflow
