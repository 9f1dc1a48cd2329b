// The cells of the grid from which a mouth takes its pressure and to which its flux goes (method, "Mouths and joints").
#pragma once

#include "gapflow/film/cell_states.hpp"

#include <utility>
#include <vector>

namespace gapflow {

/// Multilinear weights over bulk and mixed cells around y, those connected to the heaviest one through open faces
/// nearby (within one cell of the stencil, so that nothing leaks through a thin wall). Grid::key, weight; sum 1. Empty
/// if there is no such cell.
template <int D>
std::vector<std::pair<long, double>> mouth_stencil(const CellStates<D>& states, const Vec<D>& y);

} // namespace gapflow
