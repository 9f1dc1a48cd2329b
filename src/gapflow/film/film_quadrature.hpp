// Quadrature points of a film's elements. Private to film/.
#pragma once

#include "gapflow/film/gap_test.hpp"

namespace gapflow {

/// Area vector of a simplex: with the master's order of nodes it points out of the master. 2D: length vector.
template <int D>
Vec<D> area_vector(const std::array<Vec<D>, D>& corners);

/// Appends the points of element `e` of `film`, which has its nodes, measure and normal, and sets its volume and inverse.
/// `other_patch`: of the other over this element; `flat`: x, y and h are linear on it.
template <int D>
void add_points(const GapTest<D>& test, int master_patch, int other_patch, bool flat, int e, FilmMesh<D>& film);

} // namespace gapflow
