// The derivative of the kinetic energy T of potential flow by the places and angles of the solids, in closed form (theory, "Derivatives").
//
// With potentials p and twists V, E = p . K V - 1/2 p . L p + 1/2 V . D V is stationary in p where L p = K V, and E = T there. At fixed twists dT/dx is
// therefore the change of E at fixed p: of L by the areas a, of K by the walls' area vectors and moments and by what is lent, of the links, and of D. Each
// is linear in the derivatives of the pieces' areas and first moments. The walls' follow by closure:
//
//     dS = -sum dA o,   dTheta = -sum (dm + dA (x_f - r)) x o - dr x S,
//
// over the faces of a part, r the solid's reference point; where walls meet, from the motion of the curve in which they do (PatchRate).
// One pass over the pieces collects dE by the areas and moments, a second one multiplies by their derivatives. At fixed impulses
// P = dT/dV the derivative of T is that at fixed twists with the opposite sign.
//
// Where D is limited (coupling/pressure_gauge), 1/2 V . D' V is a function of D and of the layer's inertia W = Y^T (2 diag L - L) Y, Y = K/diag L. In the
// same way, with y = Y z and its next Jacobi step y' = (K z - L y)/diag L,
//
//     1/2 d(z . W z) = (y + y') . dK z - 1/2 y . dL y - y' . d(diag L) y.
//
// The energy of a face in a gap is, with c, B and U of the twists and d = p_low - p_high,
//
//     E_f = -(d + c + Delta U)^2 / 2R + A U d + 1/2 B + 1/2 A Delta U^2.
//
// R, c, .. are functions of the two walls' places and of the piece's area and centroid (GapDerivatives).
//
// Where an edge or a rim begins or ends to divide a cell, or
// another area bears what is lent, T may jump; the derivative is that of one side.
#pragma once

#include "gapflow/complex/area_derivative.hpp"
#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/gap_arm.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// p in cells^2 a unit of time, velocities are grad p: L p = K V. Parts and cells without an unknown: 0.
template <int D>
struct Potentials {
    std::vector<double> part; ///< of each
    std::vector<double> cell; ///< of each number in Complex::index; used where the cell is whole

    double of(const PartOrCell& side) const
    {
        return side.is_part() ? part[side.number()] : side.is_cell() ? cell[side.number()] : 0.0;
    }
};

/// What the fluid's momentum has beside the gradient of a potential (step theory, "Circulation"): on faces velocities along their axes, in cells a unit of
/// time, on links its integral from their first part to the second.
template <int D>
struct Circulation {
    std::array<std::vector<double>, D> face; ///< by the numbers of Complex::index
    std::vector<double> piece, link;         ///< of each
    std::vector<Twist<D>> covered;           ///< twists by which each solid moves what it covers of faces
};

/// 1/2 sum_k weight_k z_k . D z_k.
template <int D>
struct WeightedTwist {
    double weight;
    Twist<D> z;
};

/// 1/2 sum_ij weight_ij Q_ij, Q the terms of two solids' gaps that make uniform motion exact (PairInertia::motion), by their twists one after the other.
template <int D>
struct WeightedMotion {
    std::int32_t a, b;  ///< a < b
    PairMass<D> weight; ///< symmetric
};

/// What a layer's inertia has in an arm: A U y - ((c + Delta U) y + loss)/R - plain share, linear in the arm's terms but A and R.
template <int D>
struct LayerLoad {
    PairTwist<D> twist = PairTwist<D>::Zero(); ///< y
    double loss = 0, plain = 0;
};

/// The gaps of the energy that is derived.
template <int D>
struct DerivedGaps {
    const GapDerivatives<D>* derivatives = nullptr; ///< null: none
    std::vector<WeightedMotion<D>> motion;          ///< added to the energy; in the order of their pairs
    std::vector<LayerLoad<D>> loads;                ///< of each arm, added to the energy; empty: none
    std::vector<char> wanted;                       ///< solids whose derivatives are; empty: all

    std::span<const GapArm<D>> arms() const { return derivatives ? derivatives->arms() : std::span<const GapArm<D>>{}; }
};

/// dT by each solid's place (cells) and by its rotation (radians) about its reference point, at fixed twists (cells and radians a unit of time); T over the
/// fluid's density, in cells^(D + 2) a unit of time squared. Without the solids' own masses. `seen`: of each solid, what of D counts; with its
/// whole D its twist with the weight 1. With circulation it is the derivative of -1/2 m . g m - p . K V - w . W V + 1/2 V . D V at fixed potentials and circulation w, whose
/// sum is the momentum m, W V the flux of the solids through what they cover of faces, but for the motion of its arms' reference points. This rank's share, of its own faces, walls and gaps: all ranks' sum up to it. Potentials are those of all of the complex. Collective.
template <int D>
std::vector<Twist<D>> energy_derivative(const Grid<D>& grid, const Complex<D>& complex, const FaceDerivatives<D>& derivatives,
                                        const Potentials<D>& potentials, std::span<const Twist<D>> twists,
                                        std::span<const std::vector<WeightedTwist<D>>> seen, const DerivedGaps<D>& gaps,
                                        const Circulation<D>* circulation = nullptr);

/// weight/2 d(z . W z) of one solid's twist z, by each solid's place; y and y' in `step` and `next`. Without what its gaps have in it: that is added to
/// `gaps.loads`. This rank's share.
template <int D>
std::vector<Twist<D>> layer_derivative(const Grid<D>& grid, const Complex<D>& complex, const FaceDerivatives<D>& derivatives,
                                       const Potentials<D>& step, const Potentials<D>& next, int solid,
                                       const WeightedTwist<D>& of, DerivedGaps<D>& gaps);

} // namespace gapflow
