// What the remainder of viscous fluid has along edges of the complex beside that of the grid's faces: two pieces of one face, on both sides of a thin body, have velocities of their own.
#pragma once

#include "gapflow/step/remainder.hpp"

namespace gapflow {

/// The remainder's integrals along the edges less those of its faces. Empty without viscosity, where there are none.
template <int D>
std::vector<double> own_along_edges(const Placed<D>& at, const Remainder<D>& remainder);

/// The same at another place of the bodies: of the piece of the same face that lies nearest, and of the mouth of the same solids; 0 where there is none.
template <int D>
std::vector<double> carried_along_edges(const Placed<D>& from, const std::vector<double>& own, const Placed<D>& to);

/// sum += own, where there is any.
void add_own(std::vector<double>& sum, const std::vector<double>& own);

} // namespace gapflow
