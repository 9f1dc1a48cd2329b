// Dissipation of the fluid in gaps that are narrower than a cell, in the form of their kinetic energy (theory, "Drag of gaps").
//
// Between walls at the distance t the flux W along the gap relative to the walls' mean velocity u, and their difference v, dissipate
// 12 W^2/t^3 + v^2/t of each area. A face of the grid has the component along its axis of both, over the same area as its kinetic energy, so that each
// bit of a gap is counted once, whatever its direction:
//
//     E = 1/2 Delta sum_l b_l int [12 (w_l + D_l V)^2/t^3 + (e v)^2/t] ds = 1/2 (R q^2 + 2 q c V + V B V),      q = sum_l b_l w_l
//     D_l = - sigma int_0^s dt/dt ds - t e u
//
// in the frame of the walls' mean rigid motion. q is the flux in it, and w_l the share of the line l: that with the least dissipation.
//
// Around a point or a line of contact the pressure has a peak that may be narrower than a cell. Its part p = (alpha + beta x) (1/t^2 - 1/t_a^2 + 2 (t - t_a)/t_a^3),
// t < t_a, with the flux P = -t^3/12 grad p, is taken out of D_l and its dissipation added in closed form: p ends at t_a, so that
// int P W/t^3 is the integral of p times the source of W, whatever W is. The factors alpha and beta are those with which p without its end is exact in a
// gap of quadratic thickness. Along a line p ends before the walls do.
#pragma once

#include "gapflow/complex/gap_arm.hpp"

namespace gapflow {

/// E = 1/2 (R q^2 + 2 q c V + V B V).
template <int D>
struct DragForm {
    double resistance = 0;
    PairTwist<D> flux = PairTwist<D>::Zero(); ///< c
    PairMass<D> mass = PairMass<D>::Zero();   ///< B
};

/// Of a piece of a face, per unit of viscosity, in cells. Of the twists of two solids, one after the other.
template <int D>
struct GapDrag {
    std::int32_t piece;
    std::array<std::int32_t, 2> solid;
    double share; ///< of the gap's dissipation, as of its energy
    double resistance;
    PairTwist<D> flux; ///< c
    PairTwist<D>
        motion;       ///< the walls' mean velocity along the face's axis at the piece's centroid: q is the flux relative to it
    PairMass<D> mass; ///< B
    double thickness; ///< at the piece
    std::array<DragForm<D>, 2>
        half; ///< on the way to the low node and to the high one; their sum, times the share, is the whole
};

/// Of the peak of the pressure at a contact of two solids.
template <int D>
struct PeakDrag {
    std::array<std::int32_t, 2> solid;
    Vec<D> at; ///< in cells
    PairMass<D> mass;
};

template <int D>
struct GapDrags {
    /// A face of a gap whose drag others have, 2D: those that cross the gap straighter.
    struct Joined {
        std::int32_t piece;
        double share, thickness; ///< as GapDrag's
    };
    std::vector<GapDrag<D>> faces;
    std::vector<PeakDrag<D>> peaks;
    std::vector<Joined> joined;
};

template <int D>
GapDrags<D> find_gap_drag(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                          const Standoffs<D>& standoffs = {});

} // namespace gapflow
