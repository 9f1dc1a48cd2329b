// Red-black Gauss-Seidel.
#pragma once

#include "gapflow/solver/level.hpp"

namespace gapflow {

/// Relaxes the cells of one plane normal to the last axis (2D: row) whose indices' sum has the parity `colour`:
/// x_c = (b_c + sum a_f x_n) / diagonal.
template <int D>
void relax_plane(Level<D>& level, int colour, int plane);

/// The same where x = 0, whatever it holds.
template <int D>
void relax_plane_from_zero(Level<D>& level, int colour, int plane);

} // namespace gapflow
