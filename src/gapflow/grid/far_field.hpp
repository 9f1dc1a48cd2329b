// Sides beyond which the fluid goes on without end (method, "Sides of the domain").
//
// A disturbance of fluid at rest fades with the distance r from its centre like r^-m: m = d - 1 for the pressure around moving bodies (a
// dipole), d the number of axes along which the fluid goes on. Its derivative along a side's normal n then is
//
//     dp/dn = -m (n . x) / r^2 p,      x from the centre to the side's point.
#pragma once

#include "gapflow/grid/side_faces.hpp"

#include <array>
#include <cmath>

namespace gapflow {

template <int D>
struct FarField {
    std::array<bool, D> endless;    ///< axes that are neither periodic nor between walls
    Vec<D> centre = Vec<D>::Zero(); ///< that disturbances fade away from

    /// d: the number of endless axes.
    int dimensions() const
    {
        int count = 0;
        for (const bool without_end : endless)
            count += without_end;
        return count;
    }
    /// (n . x) / r^2 at the point x of a side normal to `axis`, n out of the domain; 1/length.
    double fading(int axis, const Vec<D>& x) const
    {
        Vec<D> way = x - centre;
        for (int k = 0; k < D; ++k)
            way[k] *= endless[k];
        return std::abs(way[axis]) / way.squaredNorm();
    }
    /// Length over which the pressure beyond a far side would fall to 0 if it fell linearly, at the side's point x.
    double pressure_length(int axis, const Vec<D>& x) const { return 1 / ((dimensions() - 1) * fading(axis, x)); }
};

/// The far field of a grid. Disturbances fade away from the middle of the grid's core (of the domain, if its spacing is uniform), along an axis with a wall opposite a far side from the wall:
/// the body's mirror image lies beyond it.
template <int D>
FarField<D> far_field(const Grid<D>& grid)
{
    FarField<D> far;
    for (int axis = 0; axis < D; ++axis) {
        const bool low = grid.side(axis, 0) == SideKind::wall, high = grid.side(axis, 1) == SideKind::wall;
        far.endless[axis] = !grid.periodic(axis) && !(low && high);
        const bool mirrored = grid.side(axis, low ? 1 : 0) == SideKind::far && (low || high);
        if (grid.graded() && !mirrored)
            far.centre[axis] = grid.anchor()[axis] + 0.5 * grid.dx() * (grid.core_low()[axis] + grid.core_high()[axis]);
        else
            far.centre[axis] = grid.origin()[axis] + (mirrored ? (low ? 0.0 : 1.0) : 0.5) * grid.size()[axis];
    }
    return far;
}

/// Calls f(face, end) for this rank's faces on far sides normal to `axis`; end 0: the low side.
template <int D, class F>
void for_each_far_face(const Grid<D>& grid, int axis, F&& f)
{
    for (int end = 0; end < 2; ++end)
        if (grid.side(axis, end) == SideKind::far)
            for_each_face_of_side<D>(grid, axis, end, [&](const Index<D>& face) { f(face, end); });
}

/// Distance over which the pressure falls from the cell beside a face of a far side to 0 at infinity, in half cells: an open side's is 1.
template <int D>
double far_distance(const Grid<D>& grid, const FarField<D>& far, int axis, const Index<D>& face)
{
    return 1 + 2 * far.pressure_length(axis, grid.face_centre(axis, face)) / (grid.dx() * grid.spread(axis, face[axis]));
}

} // namespace gapflow
