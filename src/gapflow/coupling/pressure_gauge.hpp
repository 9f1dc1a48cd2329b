// Gauge of the pressure in which the mass of light bodies is positive (theory of the complex, "The system").
//
// With D = V_d - V the mass M = M_s + D of a body may be negative, while M + K^T L^-1 K is not. With p = p' - Y V and the fluid's rows, times
// Y^T, added to the bodies' the system keeps its form and V:
//
//     K' = K - L Y,    M' = M + Y^T K + K^T Y - Y^T L Y.
//
// Y = K / diag(L), one Jacobi step towards L Y = K, gives M' = M + Y^T (2 diag(L) - L) Y. That term is a sum of squares: an edge of conductance g
// between P and Q adds g (Y_P + Y_Q)^2. K' reaches one row further than K.
#pragma once

#include "gapflow/coupling/coupling.hpp"

namespace gapflow {

/// Limits coupling.seen_mass: of D + Y^T (2 diag(L) - L) Y the positive part counts, in the axes in which the fluid that the solid displaces has the mass one. Only
/// of a solid that is thinner than a cell there is a negative one. Then M' >= M_s, and the added mass is positive. Collective.
template <int D>
void limit_deficits(Coupling<D>& coupling);

/// To be called once, with the bodies' own masses in coupling.system: adds D, and changes the gauge of bodies that are lighter than twice what D
/// takes from them. Fills coupling.gauge_cells and gauge_nodes. Collective.
template <int D>
void add_seen_mass(Coupling<D>& coupling);

/// The pressure p = p' - Y V of the free bodies' twists, from that of the system.
template <int D>
void leave_gauge(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, UnknownVector<D>& p);

} // namespace gapflow
