// Open sides of viscous fluid (theory, "Viscosity on parts", Sides): what leaves keeps its vorticity and loses its head, what comes in has the head of the fluid beyond and no vorticity.
#pragma once

#include "gapflow/grid/field.hpp"

namespace gapflow {

/// Adds dt (v x omega) of the edges of the grid in open sides where fluid leaves, omega that of its velocity across the side. `flux`: over the grid, whose
/// velocity is `grid_velocity`: a far side that it leaves behind is open. It does no work.
template <int D>
void turn_in_exits(const Grid<D>& grid, const FaceField<D>& flux, const Vec<D>& grid_velocity, double dt,
                   FaceField<D>& impulse);

/// Adds to the velocities in sides that are open or far what a head there takes from them in dt: that of the fluid beyond, whose velocity is `beyond`, and where
/// fluid leaves through an open side that of its own velocity across the side in place of the one beyond. All velocities are over the grid.
template <int D>
void add_heads(const Grid<D>& grid, const FaceField<D>& flux, const Vec<D>& beyond, const Vec<D>& grid_velocity, double dt,
               FaceField<D>& impulse);

} // namespace gapflow
