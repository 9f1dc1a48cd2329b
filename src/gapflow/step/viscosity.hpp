// Viscosity in the step on parts (theory, "Viscosity on parts"): after the ideal step, implicit, with the bodies and what acts on them.
#pragma once

#include "gapflow/step/instant.hpp"

#include <array>
#include <map>
#include <optional>

namespace gapflow {

/// What acts beside viscosity in its step.
template <int D>
struct ViscousLoads {
    std::vector<Twist<D>> impulse;    ///< on the free bodies; empty: none
    Vec<D> gradient = Vec<D>::Zero(); ///< mean pressure gradient
    std::array<std::optional<double>, D>
        mean_velocity{};               ///< of fluid and solids, along axes where it is kept: the gradient there follows
    std::array<double, 2 * D> sides{}; ///< given pressures beyond sides, times the time
};

template <int D>
struct ViscousStep {
    std::vector<Twist<D>> impulse; ///< of the fluid on every solid, and of the mean pressure gradient
    Friction<D> friction;          ///< impulses: the share in these of traction along the walls
    Vec<D> gradient = Vec<D>::Zero();
    double dissipated = 0; ///< energy
    double lost = 0;       ///< by the integrator besides
    double work = 0;       ///< of what acts, but for a gradient that follows
    int iterations = 0;    ///< of its solves
};

/// Voids in this: rows are numbers as in FluidRows.
template <int D>
struct ViscousVoids {
    std::map<long, double> given;   ///< what the potential gains in rows whose pressure is given instead of their outflow
    std::map<long, double> outflow; ///< of other rows: net outflow at the end
    std::vector<double> momentum;   ///< of each edge of Placed::voids; after the step that at its end
    double work = 0;                ///< of the given pressures, after the step
};

/// From the flow at a step's end without viscosity to that with it, twists included. The flow's gauge is kept.
/// `mass`: of all solids, their own. `voids`: null: none. Throws ComputationError where the solve does not converge.
template <int D>
ViscousStep<D> add_viscosity(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass, const ViscousLoads<D>& loads,
                             double viscosity, double dt, double tolerance, PotentialFlow<D>& flow,
                             ViscousVoids<D>* voids = nullptr);

/// Mean velocity of fluid and solids over the domain, of the flow's fluxes.
template <int D>
Vec<D> mean_flux(const Grid<D>& grid, const FaceField<D>& flux);

/// What solids cover of the remainder's faces takes the mean of that beside it, from face to face: what a body uncovers moves as the fluid around it.
template <int D>
void fill_covered(const Placed<D>& at, FaceField<D>& velocity);

} // namespace gapflow
