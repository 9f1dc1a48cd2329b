// Energy of the flow through mouths (gap-energy, "Mouths in 2D"): along the gap from its last node to the mouth, and out of it.
//
//     T = 1/2 sum_sides [ gap int (q + D(s) V)^2 / t(s) ds + (1 - gap) R q^2 ] + q d V
//
// q is the flux through the mouth relative to the line that divides the fluid, t and D as in gap_arm.hpp, R the resistance of the outlet. d V is the difference of the
// potentials of uniform motion between the places from which and to which the mouth leads: a node, or all that lies in the sector into which the flow
// spreads.
#pragma once

#include "gapflow/complex/gap_arm.hpp"

#include <span>
#include <utility>
#include <vector>

namespace gapflow {

/// Lengths in cells, density 1. Of the twists of two solids, one after the other.
template <int D>
struct MouthArm {
    std::int32_t link, piece; ///< of the complex, whose energy it replaces; one of them -1
    std::array<std::int32_t, 2> solid;
    double resistance;
    PairTwist<D> flux;  ///< c and d
    PairMass<D> mass;   ///< B
    PairMass<D> motion; ///< the terms of the mass that are not squares
    /// Flux of the line's motion: of a piece, through it along its axis; of a link, from its first part to the second, what it has not as a part of the corner's solid.
    PairTwist<D> carried;
    std::vector<std::pair<PartOrCell, double>>
        rows; ///< w: the flux leaves w of the row; positive before the mouth (2D: at its left)
};

template <int D>
std::vector<MouthArm<D>> find_mouth_arms(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                                         const Standoffs<D>& standoffs = {});

/// Nodes of parts behind mouths lie at the centroid of what the mouth leaves of them where their cell's centre is nearer to it. By part: from the cell's
/// centre; sorted.
template <int D>
std::vector<std::pair<std::int32_t, Vec<D>>> moved_nodes(const Grid<D>& grid, const Complex<D>& complex);

} // namespace gapflow
