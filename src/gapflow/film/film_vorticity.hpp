// Vorticity of films about points where curved surfaces nearly touch (method, "The time step"). There the gap widens over less than a
// cell, the velocity of ideal flow is singular, and what transport errs by is vorticity: left alone it gains step by step until
// whirls about the point of contact outrun everything else. Any element velocity splits, orthogonally in kinetic energy, into
//
//     u = grad phi + (A / S) rot psi,       psi linear on the elements, 0 on the rim,
//
// and the projection answers for grad phi alone. Sweeps of Jacobi's method take psi out where the gap is that narrow: fluxes
// through no element's sides change their balance, and energy only falls.
#pragma once

#include "gapflow/film/conduits.hpp"

#include <vector>

namespace gapflow {

/// `velocity`: tangential, one an element of the network. 2D: films are lines and have no vorticity.
template <int D>
void damp_vorticity(const FilmNetwork<D>& network, double dx, std::vector<Vec<D>>& velocity);

} // namespace gapflow
