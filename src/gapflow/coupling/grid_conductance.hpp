// Conductance of the grid's faces from their open areas.
#pragma once

#include "gapflow/coupling/coupling.hpp"

namespace gapflow {

/// What a side of the domain does to the conductance of its face f: closed 0, open 2 (half a cell to the pressure beyond), far less. `end` 0: the
/// low side.
template <int D>
double side_factor(const Grid<D>& grid, int axis, const Index<D>& f, int end);

/// coupling.system.conductance = a |f| / (rho dx) from coupling.open; cells that a film fills have none to the sides of the domain.
template <int D>
void fill_conductance(Coupling<D>& coupling);

/// Mass of the free bodies and the blocks of coupling.normal_inertia and drag_inertia. Collective.
template <int D>
void fill_mass(Coupling<D>& coupling, const std::vector<TwistMatrix<D>>& mass);

} // namespace gapflow
