// Solves the viscous system by preconditioned conjugate gradients (multigrid for velocities, exact blocks for twists).
#pragma once

#include "gapflow/viscosity/viscous_system.hpp"

namespace gapflow {

struct ViscousReport {
    int iterations = 0;
    double residual = 0; ///< in the norm of the preconditioner, relative to the energy at the start
    bool converged = true;
};

template <int D>
struct ViscousSolution {
    std::vector<Twist<D>> twists;   ///< of all solids
    std::vector<Twist<D>> impulses; ///< of the fluid's viscous traction on every solid but walls, about its centre
    double energy = 0;              ///< twice what the step minimises, at its solution
    ViscousReport report;
};

/// u: u* on entry, the velocity after the viscous step on return, on this rank's open faces; other faces stay. `twists`: V* of
/// free bodies, of others as given. Collective.
template <int D>
ViscousSolution<D> solve_viscous_system(const ViscousSystem<D>& system, FaceField<D>& u, const ViscousBodies<D>& bodies,
                                        double tolerance);

} // namespace gapflow
