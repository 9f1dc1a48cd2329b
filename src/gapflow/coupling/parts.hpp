// The complex of fluid parts and the bodies joined into the coupled system (theory, "The system"). The largest part of a cell is the grid's
// unknown, every other part takes a node; face pieces between two largest parts are the grid's conductance, all others are sparse.
#pragma once

#include "gapflow/complex/energy_derivative.hpp"
#include "gapflow/complex/inertia.hpp"
#include "gapflow/coupling/coupling.hpp"

namespace gapflow {

/// Number of the node of each part, -1: none. Fills the nodes of the system. Collective.
template <int D>
std::vector<int> nodes_of_parts(const Grid<D>& grid, const Complex<D>& complex, CoupledSystem<D>& system);

/// As couple(), without films. `mass` holds the generalised mass of each solid (used for free ones): the system has the bodies' own mass until
/// add_seen_mass() completes it. Collective.
template <int D>
Coupling<D> couple_parts(const Grid<D>& grid, std::vector<Solid<D>> solids, const std::vector<TwistMatrix<D>>& mass,
                         double density, const Complex<D>& complex, const Inertia<D>& inertia);

/// dT of the fluid at fixed twists by each solid's place, and by its rotation about its reference point (energy_derivative.hpp). p: the impulse
/// that sets the fluid at rest moving with these twists, L p = -K V. `gaps` and `pairs`: of the gaps of `coupling`, null: it has none, and Inertia::pairs. `wanted`: the solids
/// whose derivatives are, empty: all; those of others are not complete. Collective.
template <int D>
std::vector<Twist<D>> energy_derivative(const Coupling<D>& coupling, const Complex<D>& complex,
                                        const FaceDerivatives<D>& derivatives, const UnknownVector<D>& p,
                                        const std::vector<Twist<D>>& twists, const GapDerivatives<D>* gaps = nullptr,
                                        std::span<const PairInertia<D>> pairs = {}, const std::vector<char>& wanted = {},
                                        const Circulation<D>* circulation = nullptr);

} // namespace gapflow
