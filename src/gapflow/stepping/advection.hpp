// Advection of face velocities on the MAC grid.
#pragma once

#include "gapflow/grid/field.hpp"
#include "gapflow/stepping/velocity_ghosts.hpp"

#include <cstdint>

namespace gapflow {

enum class AdvectionScheme { semi_lagrangian, maccormack };

/// result = `carried` after a time dt in the flow u, on owned faces; ghosts of result are left as they are.
///
/// u and carried need filled ghosts; they may be the same field, result must be another. Feet beyond walls are clamped
/// into the domain, and no foot lies further than ghost() - 1 cells outside the rank's block: traces are exact for
/// dt |u| <= (ghost() - 1) dx on every axis, and safe for any u.
///
/// first_order (optional): faces marked with nonzero take the semi-Lagrangian value. Collective with MacCormack.
/// change (optional; ghosts filled): half of this change of velocities in the step acts at the trace's foot: result += 1/2
/// (A(change) - change), A semi-Lagrangian.
/// grid_velocity: of a grid that moves during dt; the values at its places are velocities in the world before and after.
template <int D>
void advect(const Grid<D>& grid, FaceField<D>& result, const FaceField<D>& u, const FaceField<D>& carried, double dt,
            AdvectionScheme scheme, const BoundaryVelocity<D>& sides, const FaceField<D, std::int8_t>* first_order = nullptr,
            const FaceField<D>* change = nullptr, const Vec<D>& grid_velocity = Vec<D>::Zero());

/// The semi-Lagrangian result for u itself on the marked faces (nonzero); others are left as they are.
template <int D>
void advect_marked_faces(const Grid<D>& grid, FaceField<D>& result, const FaceField<D>& u,
                         const FaceField<D, std::int8_t>& marked, double dt, const Vec<D>& grid_velocity = Vec<D>::Zero());

} // namespace gapflow
