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

#include "gapflow/complex/energy_derivative.hpp"
#include "gapflow/coupling/coupling.hpp"

namespace gapflow {

/// Y^T (2 diag(L) - L) Y of every solid: diag(L) of its rows, and the conductance between every two of them. Collective.
template <int D>
std::vector<TwistMatrix<D>> layer_inertias(const Coupling<D>& coupling);

/// Limits coupling.seen_mass: of D + Y^T (2 diag(L) - L) Y the positive part counts, in the axes in which the fluid that the solid displaces has the mass one. Only
/// of a solid that is thinner than a cell there is a negative one. Then M' >= M_s, and the added mass is positive. Collective.
template <int D>
void limit_deficits(Coupling<D>& coupling);

/// Derivative of 1/2 V . D' V at a fixed twist V, D' = (D + W)_+ - W the limited D of a solid and W = Y^T (2 diag(L) - L) Y: the sums of
/// weight/2 z . dD z and of weight/2 z . dW z, and by its rotation, with which the axes of the positive part turn.
template <int D>
struct LimitRate {
    std::vector<WeightedTwist<D>> seen, layer;
    Spin<D> turn = Spin<D>::Zero();
};
/// `seen`: D as it is without its limit; `layer`: W.
template <int D>
LimitRate<D> limit_rate(const Solid<D>& solid, double density, const TwistMatrix<D>& seen, const TwistMatrix<D>& layer,
                        const Twist<D>& V);

/// y = Y z of one solid and its next Jacobi step y' = (K z - L y)/diag(L). Collective.
template <int D>
struct JacobiSteps {
    UnknownVector<D> first, next;
};
template <int D>
JacobiSteps<D> jacobi_steps(const Coupling<D>& coupling, int solid, const Twist<D>& z);

/// To be called once, with the bodies' own masses in coupling.system: adds D, and changes the gauge of all bodies if one is lighter than twice what D
/// takes from it. Fills coupling.gauge_cells and gauge_nodes. Collective.
template <int D>
void add_seen_mass(Coupling<D>& coupling);

/// Outflow with the fluxes of the free bodies in the gauge of the system: += (K' - K) V. Collective.
template <int D>
void enter_gauge(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, UnknownVector<D>& outflow);

/// The pressure p = p' - Y V of the free bodies' twists, from that of the system. Collective.
template <int D>
void leave_gauge(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, UnknownVector<D>& p);

} // namespace gapflow
