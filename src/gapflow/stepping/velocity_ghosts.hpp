// Velocities on the domain's sides and in the ghosts beyond them, for traces.
#pragma once

#include "gapflow/grid/field.hpp"

#include <array>

namespace gapflow {

/// Velocity of the domain's sides, at 2 * axis + end: of walls (the normal component is 0 unless the wall moves; the others count
/// only where fluid sticks to walls) and of inflow. Unused on open and periodic sides.
template <int D>
struct BoundaryVelocity {
    std::array<Vec<D>, 2 * D> velocity;
    bool no_slip = false;         ///< fluid sticks to walls
    Vec<D> grid = Vec<D>::Zero(); ///< of the grid: fluid comes in through far sides where it moves in relative to them

    BoundaryVelocity() { velocity.fill(Vec<D>::Zero()); }
};

/// Sets the normal velocity on walls and inflow sides and fills all ghosts:
///   wall              normal component odd about the wall's velocity, tangential components even (no slip: odd too);
///   inflow            the given velocity;
///   open              constant;
///   far               constant; where fluid comes in, tangential components such that it has no vorticity;
///   other ranks and periodic sides: exchanged. Collective.
template <int D>
void fill_velocity_ghosts(const Grid<D>& grid, FaceField<D>& u, const BoundaryVelocity<D>& sides);

/// The same for the component normal to `axis` alone; far sides as open ones.
template <int D>
void fill_velocity_ghosts(const Grid<D>& grid, int axis, CellField<D>& u, const BoundaryVelocity<D>& sides);

} // namespace gapflow
