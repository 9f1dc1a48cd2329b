// Damps vorticity of films around points where curved surfaces nearly touch (method, "The time step"). There the gap widens over less than
// a cell, the velocity of ideal flow is singular, and the error of the transport is vorticity, which grows from step to step until vortices
// around the point of contact are the fastest flow. Any element velocity splits, orthogonally in kinetic energy, into
//
//     u = grad phi + (A / S) rot psi,       psi linear on the elements, 0 on the rim,
//
// and the projection determines grad phi alone. Sweeps of Jacobi's method reduce psi where the gap is that narrow. The flux
// balance of no element changes, and energy only falls.
#pragma once

#include "gapflow/film/mouths.hpp"

#include <vector>

namespace gapflow {

/// `velocity`: tangential, one an element of the network. 2D: films are lines and have no vorticity.
template <int D>
void damp_vorticity(const FilmNetwork<D>& network, double dx, std::vector<Vec<D>>& velocity);

} // namespace gapflow
