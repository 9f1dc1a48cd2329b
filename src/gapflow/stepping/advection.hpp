// Advection of face velocities on the MAC grid, and the velocities beyond the domain's sides that its traces read.
#pragma once

#include "gapflow/grid/face_fractions.hpp"
#include "gapflow/grid/field.hpp"

#include <array>
#include <cstdint>

namespace gapflow {

enum class AdvectionScheme { semi_lagrangian, maccormack };

/// Velocity of the domain's sides, at 2 * axis + end: of walls (the normal component is 0 unless the wall moves; the others count
/// only where fluid sticks to walls) and of inflow. Unused on open and periodic sides.
template <int D>
struct BoundaryVelocity {
    std::array<Vec<D>, 2 * D> velocity;
    bool no_slip = false; ///< fluid sticks to walls

    BoundaryVelocity() { velocity.fill(Vec<D>::Zero()); }
};

/// Sets the normal velocity on walls and inflow sides and fills all ghosts:
///   wall              normal component odd about the wall's velocity, tangential components even (no slip: odd too);
///   inflow            the given velocity;
///   open              constant;
///   other ranks and periodic sides: exchanged. Collective.
template <int D>
void fill_velocity_ghosts(const Grid<D>& grid, FaceField<D>& u, const BoundaryVelocity<D>& sides);

/// result = `carried` after a time dt in the flow u, on owned faces; ghosts of result are left as they are.
///
/// u and carried need filled ghosts; they may be the same field, result must be another. Feet beyond walls are clamped
/// into the domain, and no foot lies further than ghost() - 1 cells outside the rank's block: traces are exact for
/// dt |u| <= (ghost() - 1) dx on every axis, and safe for any u.
///
/// fractions (optional): velocities of cut faces arrive at the centroid of the face's open part instead of its centre.
/// plain (optional): faces marked with nonzero take the semi-Lagrangian value. Collective with MacCormack.
/// change (optional, not with fractions; ghosts filled): of what this adds to velocities in the step, half acts where the fluid comes
/// from: result += 1/2 (A(change) - change), A semi-Lagrangian.
template <int D>
void advect(const Grid<D>& grid, FaceField<D>& result, const FaceField<D>& u, const FaceField<D>& carried, double dt,
            AdvectionScheme scheme, const BoundaryVelocity<D>& sides, const FaceFractions<D>* fractions = nullptr,
            const FaceField<D, std::int8_t>* plain = nullptr, const FaceField<D>* change = nullptr);

/// The semi-Lagrangian result for u itself on the marked faces (nonzero); others are left as they are.
template <int D>
void advect_marked_faces(const Grid<D>& grid, FaceField<D>& result, const FaceField<D>& u, const FaceField<D, std::int8_t>& marked,
                         double dt);

} // namespace gapflow
