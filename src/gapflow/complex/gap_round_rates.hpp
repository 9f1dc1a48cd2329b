// Derivatives of what an arm between round walls is (gap_arm.hpp), once for all twists: between such walls it depends on few places and on the difference
// of two velocities.
#pragma once

#include "gapflow/complex/gap_finder.hpp"
#include "gapflow/complex/gap_round_way.hpp"

namespace gapflow {

/// By the places of the two walls one after the other and by the centroid of the piece, in the order of the face's two axes.
template <int D>
struct RoundArmRates {
    std::array<bool, 2> still; ///< sides of the domain
    RoundRates<D> share = RoundRates<D>::Zero(), resistance = RoundRates<D>::Zero();
    Eigen::Array<double, 3 * D - 1, D> flux = Eigen::Array<double, 3 * D - 1, D>::Zero();
    Eigen::Array<double, 3 * D - 1, D*(D + 1) / 2> mass =
        Eigen::Array<double, 3 * D - 1, D*(D + 1) / 2>::Zero(); ///< B_kl, k <= l, row by row

    /// Of what has the derivatives `by`, but those by its shape's own terms.
    GapRates<D> of(const GapArm<D>& arm, const FacePiece<D>& piece, const PairTwist<D>& twist, const GapLoads& by) const;
};

/// Of one of find_gap_arms at `site`, whose walls are round.
template <int D>
RoundArmRates<D> round_arm_rates(const GapFinder<D>& finder, const GapSite<D>& site);

} // namespace gapflow
