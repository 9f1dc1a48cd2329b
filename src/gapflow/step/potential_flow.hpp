// Potential flow around moving bodies: L p + K V = 0 for the fluid, P = M V - K^T p for the bodies, P = dT/dV their impulse with that of
// the fluid. With circulation it is what the remainder of the fluid's momentum leaves (remainder.hpp).
#pragma once

#include "gapflow/solver/solver.hpp"
#include "gapflow/step/placed.hpp"
#include "gapflow/stepping/state.hpp"

#include <array>
#include <vector>

namespace gapflow {

/// What is given at the sides of the domain at an instant.
template <int D>
struct GivenSides {
    std::array<double, 2 * D> speed{}; ///< of inflow along the side's axis, relative to the stream
    std::array<double, 2 * D>
        impulse{}; ///< time integral of the reduced pressure beyond a pressure side since the start: p there

    bool any() const { return speed != GivenSides().speed || impulse != GivenSides().impulse; }
};

template <int D>
struct PotentialFlow {
    std::vector<Twist<D>> twists; ///< of all solids
    UnknownVector<D> p; ///< density times the potential, negative; velocities are those of the remainder - grad p / density
    int iterations = 0;
    Remainder<D> remainder;
    GivenSides<D> sides{};
};

/// sum += v. An empty sum is 0.
template <int D>
void add_to(UnknownVector<D>& sum, const UnknownVector<D>& v)
{
    if (sum.cells.size() == 0) {
        sum = v;
        return;
    }
    for (long i = 0; i < v.cells.size(); ++i)
        sum.cells.data()[i] += v.cells.data()[i];
    sum.nodes += v.nodes;
}

/// Of a scene. Its keys "solver".
SolverOptions solver_options(const Scene& scene);

/// That of given twists, and of what the remainder and the sides ask for. Collective.
template <int D>
PotentialFlow<D> flow_of_twists(const Placed<D>& at, std::vector<Twist<D>> twists, const SolverOptions& options,
                                Remainder<D> remainder = {}, const GivenSides<D>& sides = {});

/// K V of all solids, in this rank's cells and in all nodes. Collective.
template <int D>
UnknownVector<D> flux_of_twists(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists);

/// What the motion of the solids that are not free adds to the free bodies' impulses in their rows of the system: by the masses of gaps between both, and
/// in another gauge by the fluid's rows. 0 for the others. Collective.
template <int D>
std::vector<Twist<D>> impulses_of_given(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists);

/// The same of an outflow that the fluid has without pressure, in all rows. Collective.
template <int D>
std::vector<Twist<D>> impulses_of_outflow(const Coupling<D>& coupling, const UnknownVector<D>& outflow);

/// Potentials of rows with small conductances, slivers between walls and planes of the grid, from their own equations: the solver's tolerance is that of all rows
/// together, and leaves them undetermined, but what walls displace there is the square of their gradients. The same on any number of ranks. Collective.
template <int D>
void settle_weak_rows(const Placed<D>& at, PotentialFlow<D>& flow);
/// The same of another system of these rows, with a given outflow. On one rank.
template <int D>
void settle_weak_rows(const Complex<D>& complex, const Coupling<D>& coupling, const UnknownVector<D>& outflow,
                      PotentialFlow<D>& flow);

/// dT/dV of the fluid's energy alone, of all solids. Collective.
template <int D>
std::vector<Twist<D>> fluid_impulse(const Placed<D>& at, const PotentialFlow<D>& flow);

} // namespace gapflow
