// The step's limit by gaps that close or open (of runs on parts): the energy of a gap between flat walls goes as 1/h, and a step resolves
// its change.
#pragma once

#include "gapflow/complex/gap_arm.hpp"
#include "gapflow/stepping/state.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// The step size dt, or a smaller one in which no gap changes by more than the part time.gap_cfl of its thickness, at velocities V and accelerations A of
/// all solids. `arms`: of the complex there, of this rank's faces. Collective.
template <int D>
double limit_of_closing(const Model<D>& model, const State<D>& state, const std::vector<Solid<D>>& solids,
                        const std::vector<Twist<D>>& V, const std::vector<Twist<D>>& A, std::span<const GapArm<D>> arms,
                        double dt);

} // namespace gapflow
