// The kinetic energy of the complex, T = 1/2 sum_f a_f (u_f - U)^2 + 1/2 V D V + ..., of a fluid at rest far away (theory, "The bulk").
//
// With a_f = A, the open areas, T is a quadrature of the relative velocity's square with an error that depends on where a wall crosses a cell and whose
// mean over places is not zero. A cut face therefore lends area to its neighbours: of its first moment m = A c about its own centre -3/4, 1 and -1/4 go
// to itself, to the next face towards c and to the one after it. Then the mean error vanishes for relative velocities that are quadratic beside the wall. The
// stencil stays that of the grid.
#pragma once

#include "gapflow/complex/mouth_arm.hpp"

#include <array>
#include <vector>

namespace gapflow {

/// Flux of a solid's twist out of a part or cell that the solid does not touch.
template <int D>
struct LentFlux {
    PartOrCell row;
    std::int32_t solid;
    Twist<D> flux; ///< in cells
};

/// What gaps add to the mass of two solids, by their twists one after the other, in cells.
template <int D>
struct PairInertia {
    std::int32_t a, b;  ///< a < b
    PairMass<D> mass;   ///< a sum of squares and `motion`
    PairMass<D> motion; ///< the terms that make uniform motion exact
};

/// One of each two solids.
template <int D>
void merge_pairs(std::vector<PairInertia<D>>& pairs);

/// Flux of a link between several rows: conductance times the sum of w p, of which w leaves each of them.
template <int D>
struct RowsLink {
    PartOrCell first; ///< whose rank has it
    double conductance;
    std::vector<std::pair<PartOrCell, double>> rows;
};

/// Flux of a solid's twist from the low side of a face to the high one (of a mouth, from the rows of positive weight), in cells: what K has of lent area and of
/// gaps, beside the walls' own. It is carried with the face's momentum.
template <int D>
struct FaceFlux {
    std::int8_t axis;
    std::int32_t face;       ///< number in Complex::index; of a mouth none
    std::int32_t piece = -1; ///< -1: all that joins the largest parts of two cells
    std::int32_t mouth = -1; ///< number in Inertia::mouths
    std::int32_t solid;
    Twist<D> flux;
};

template <int D>
struct Inertia {
    /// a_f of the grid's own faces, as Complex::main_area; conductance is a_f over the distance of the cells' centres.
    std::array<std::vector<double>, D> main_weight;
    std::vector<double> piece_weight;     ///< of each piece
    std::vector<double> link_conductance; ///< of each of Complex::links; 0 where `mouths` has it
    std::vector<RowsLink<D>> mouths;
    std::vector<Twist<D>> patch_flux;   ///< of each of Complex::patches, in cells: the walls' own and what is lent
    std::vector<LentFlux<D>> flux;      ///< of the rows beside; one may come more than once
    std::vector<PairInertia<D>> pairs;  ///< one of each two solids with a gap, of this rank's faces
    std::vector<FaceFlux<D>> face_flux; ///< where asked for

    long bytes() const;
};

/// `gaps`: of the faces whose energy is that of a gap. `mouths`: of these gaps. `face_flux`: whether it is wanted.
template <int D>
Inertia<D> find_inertia(const Grid<D>& grid, const Complex<D>& complex, std::span<const GapArm<D>> gaps = {},
                        std::span<const MouthArm<D>> mouths = {}, bool face_flux = false);

} // namespace gapflow
