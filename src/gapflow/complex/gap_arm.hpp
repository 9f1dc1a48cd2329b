// Energy of the fluid in gaps that are narrower than a cell (gap-energy, "Arms").
//
// A piece of a face from which two walls that face each other are less than a cell apart is an arm of a gap. Along the way s from node to
// node, in the plane of the gap, the flux changes by what the walls' closing takes. The velocity is taken as uniform across the gap and
// across the piece:
//
//     T = 1/2 (A/t_0) Delta int [q t_0/A + D(s) V]^2 / t(s) ds = 1/2 (R q^2 + 2 q c V + V B V),
//     D(s) V = - sigma int_0^s dt/dt ds,     sigma = e Sigma nu
//
// In 3D on several lines side by side in the piece, and on each D counts from where the gap is thinnest along the way, less what all
// together carry through the face.
//
// q is the flux relative to the mean motion of the walls, t the thickness along the mean normal n, e and nu the face's normal and the way
// between the nodes without their parts along n. Sigma is the share of the closing that flows in each direction. In a gap whose thickness
// is quadratic the flux is w grad t / tr Hess t, with the closing speed w, none along the way where the gap is thinnest on it: Sigma
// follows from the Hessian; where t is constant or linear from its gradient, or it is the same in all directions.
#pragma once

#include "gapflow/complex/complex.hpp"

#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace gapflow {

template <int D>
using PairTwist = Eigen::Matrix<double, 2 * twist_size<D>, 1>;
template <int D>
using PairMass = Eigen::Matrix<double, 2 * twist_size<D>, 2 * twist_size<D>>;

/// How much farther apart than their shapes the surfaces of two solids stand, in cells, and its derivative by their places and angles, one after the
/// other (gap-energy, "Roughness").
template <int D>
struct Standoff {
    double distance = 0;
    PairTwist<D> rate = PairTwist<D>::Zero();
};

/// Of pairs of solids; of all others 0.
template <int D>
class Standoffs {
public:
    /// Of a pair that has one already, as in a periodic domain, the larger.
    void add(int a, int b, const Standoff<D>& standoff);
    Standoff<D> of(int a, int b) const;

private:
    std::map<std::pair<int, int>, Standoff<D>> of_; ///< a < b
};

/// Lengths in cells, density 1. Of the twists of two solids, one after the other.
template <int D>
struct GapArm {
    std::int32_t piece;
    std::array<std::int32_t, 2> solid;
    double share; ///< of the gap's energy in that of the face, 0 .. 1; the rest is that of a plain face
    double resistance;
    PairTwist<D> flux;   ///< c
    PairTwist<D> motion; ///< the walls' mean velocity along the face's axis
    PairMass<D> mass;    ///< B
    Standoff<D> standoff;
    double thickness;     ///< at the piece
    PairTwist<D> opening; ///< its rate
};

/// Of all pieces of the complex that lie in gaps, in their order.
template <int D>
std::vector<GapArm<D>> find_gap_arms(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                                     const Standoffs<D>& standoffs = {});

/// Derivatives of a number by what an arm is of one pair of twists: share and resistance, c V, the mean motion, V B V.
struct GapLoads {
    double share = 0, resistance = 0, flux = 0, motion = 0, mass = 0;
};
/// Derivatives of a number by the places and angles of an arm's two solids, one after the other, and by area and centroid of its piece.
template <int D>
struct GapRates {
    PairTwist<D> pose = PairTwist<D>::Zero();
    double area = 0;
    Vec<D> centroid = Vec<D>::Zero();

    GapRates& operator+=(const GapRates& other)
    {
        pose += other.pose;
        area += other.area;
        centroid += other.centroid;
        return *this;
    }
};

template <int D>
class GapFinder;

template <int D>
struct RoundArmRates;

/// Of complexes without mouths.
template <int D>
class GapDerivatives {
public:
    /// Of find_gap_arms. Keeps references to its arguments.
    GapDerivatives(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                   std::span<const GapArm<D>> arms);
    ~GapDerivatives();
    std::span<const GapArm<D>> arms() const { return arms_; }
    /// Of what has the derivatives `by` by the terms of an arm and a pair of twists. One thread at a time may ask for one arm.
    GapRates<D> of(int arm, const PairTwist<D>& twist, const GapLoads& by) const;

private:
    std::unique_ptr<const GapFinder<D>> finder_;
    std::span<const GapArm<D>> arms_;
    mutable std::vector<std::unique_ptr<const RoundArmRates<D>>> round_; ///< of each arm between round walls that was asked for
};

} // namespace gapflow
