// The last pressure around bodies that move through the grid (method, "The time step", on the pressure that goes with the bodies): what surrounds a body is, but for
// slow changes, where the body has gone. With W the velocity of the body nearby, a field f of the step's start becomes f(x - dt W).
#pragma once

#include "gapflow/coupling/coupling.hpp"
#include "gapflow/stepping/past_pressure.hpp"

#include <array>
#include <optional>
#include <vector>

namespace gapflow {

/// W at cells, relative to the grid, ghosts one layer deep filled: the translation of the bodies whose surfaces cut a cell's faces, and around them the
/// mean of the cells nearer to them.
template <int D>
struct CarryingVelocity {
    std::array<CellField<D>, D> components;

    CellField<D>& operator[](int axis) { return components[axis]; }
    const CellField<D>& operator[](int axis) const { return components[axis]; }
};

/// `motion`: mean of the step, of all solids, of which the first `bodies` count. None: no body moves through the grid. Collective.
template <int D>
std::optional<CarryingVelocity<D>> carrying_velocity(const Coupling<D>& there, const std::vector<Twist<D>>& motion,
                                                     std::size_t bodies, const Vec<D>& grid_velocity);

/// f(x + dt W) - f(x) of velocities at faces; ghosts of f must be filled, those of the result that other ranks own are. Collective.
template <int D>
FaceField<D> change_along(const Grid<D>& grid, const CarryingVelocity<D>& W, double dt, const FaceField<D>& f);

/// The pressure of the step's start where it is at the end. Ghosts are filled. Collective.
template <int D>
void carry(const Grid<D>& grid, const CarryingVelocity<D>& W, double dt, PastPressure<D>& past);

} // namespace gapflow
