// The passes that find the forces of a step: each answers the forces with which a flow was found by those that follow from it.
#pragma once

#include "gapflow/body/rigid_body.hpp"

#include <Eigen/Dense>

#include <vector>

namespace gapflow {

/// Impulses of the fluid's forces on the fluid's own impulse over a step, of every solid: trapezium of dT/dx, and what is missing in their work.
template <int D>
struct StepForces {
    std::vector<Twist<D>> mean;    ///< dt times the mean of `force`
    std::vector<Twist<D>> missing; ///< correction
};

/// Combines the answers so far with the weights, summing to one, with which the last answers would have differed least from what they answer (Anderson):
/// a pass that overshoots, or falls short, in few directions then costs few passes more than there are of these. From the third answer on.
template <int D>
class ForcePasses {
public:
    /// Differences count as the energies of bodies with the fluid that they displace, `density`; those of free bodies alone.
    ForcePasses(const std::vector<RigidBody<D>>& bodies, double density);

    /// The forces for the next pass, after `answer` to `given`.
    StepForces<D> next(const StepForces<D>& given, StepForces<D> answer);

private:
    /// Impulses as numbers whose squares are energies.
    Eigen::VectorXd scaled(const StepForces<D>& forces) const;

    std::vector<TwistMatrix<D>> root_; ///< of each solid
    std::vector<StepForces<D>> answers_;
    std::vector<Eigen::VectorXd> errors_; ///< of each answer: how much it differs from what it answers
};

} // namespace gapflow
