// The known peak of the pressure around a contact of two walls in viscous fluid (gap_drag.hpp), per unit of viscosity, and what gaps and peaks share.
#pragma once

#include "gapflow/complex/gap_drag.hpp"
#include "gapflow/complex/gap_place.hpp"

#include <algorithm>

namespace gapflow {

template <int D>
using PairVectors = Eigen::Matrix<double, D, 2 * twist_size<D>>;

/// Of the two solids' twists those relative to the mean of their motions.
template <int D>
PairMass<D> relative_twists(const GapWalls<D>& walls)
{
    constexpr int T = twist_size<D>;
    PairMass<D> result = 0.5 * PairMass<D>::Identity();
    for (int side = 0; side < 2; ++side) {
        auto other = result.template block<T, T>(side * T, (1 - side) * T);
        other.template bottomRightCorner<spin_size<D>, spin_size<D>>() =
            -0.5 * Eigen::Matrix<double, spin_size<D>, spin_size<D>>::Identity();
        for (int k = 0; k < D; ++k)
            other.row(k) = -0.5 * speed_along<D>(unit<D>(k), walls.reference[side], walls.reference[1 - side]).transpose();
    }
    return result;
}

template <int D>
PairMass<D> in_relative(const PairMass<D>& relative, const PairMass<D>& mass)
{
    const PairMass<D> half = mass.lazyProduct(relative);
    return relative.transpose().lazyProduct(half);
}

/// Velocity along e of both walls: their mean, and of the first less that of the second.
template <int D>
struct WallSpeeds {
    PairTwist<D> mean, difference;

    WallSpeeds(const GapWalls<D>& walls, const GapSection<D>& at, const Vec<D>& n, const Vec<D>& e)
    {
        constexpr int T = twist_size<D>;
        const Vec<D> half = 0.5 * at.thickness * n;
        difference << speed_along<D>(e, at.middle - half, walls.reference[0]),
            -speed_along<D>(e, at.middle + half, walls.reference[1]);
        mean << 0.5 * difference.template head<T>(), -0.5 * difference.template tail<T>();
    }
};

/// The part of the pressure around a point contact that is known.
struct Peak {
    Vec<3> at, n;
    double end; ///< thickness at which it ends
    PairTwist<3> height;
    PairVectors<3> slope;
    Mat<3> hessian; ///< of the thickness
    // Along a line of contact it ends before the walls do.
    Vec<3> line = Vec<3>::Zero(); ///< zero: none
    double from = -1, to = 1, fade = 1;

    double place(const Vec<3>& x) const { return line.dot(x - at); }
    double within(const Vec<3>& x) const
    {
        const double y = place(x);
        return std::clamp(std::min(y - from, to - y) / fade, 0.0, 1.0);
    }
    double within_slope(const Vec<3>& x) const
    {
        const double y = place(x), least = std::min(y - from, to - y);
        return least <= 0 || least >= fade ? 0 : (y - from < to - y ? 1 : -1) / fade;
    }

    PairTwist<3> amount(const Vec<3>& x) const
    {
        const Vec<3> r = x - at;
        return height + slope.transpose() * (r - n.dot(r) * n);
    }
    PairTwist<3> pressure(const GapSection<3>& section) const
    {
        const double t = section.thickness;
        if (t >= end)
            return PairTwist<3>::Zero();
        return within(section.middle) * (1 / (t * t) - 1 / (end * end) + 2 * (t - end) / (end * end * end)) *
               amount(section.middle);
    }
    /// Its share of the friction 1/t of sliding walls; the rest is (2 - t/t_a)/t_a.
    double friction(const GapSection<3>& section) const
    {
        const double t = section.thickness;
        return t < end && within(section.middle) > 0 ? (1 - t / end) * (1 - t / end) / t : 0;
    }
    PairTwist<3> flux(const GapSection<3>& section, const Vec<3>& e) const
    {
        const double t = section.thickness, x = t / end;
        if (x >= 1)
            return PairTwist<3>::Zero();
        const double height_flux = -t / 12 * (1 - 3 * x * x + 2 * x * x * x), y = within(section.middle);
        return height_flux *
                   (y * (slope.transpose() * e) + within_slope(section.middle) * line.dot(e) * amount(section.middle)) -
               y * (1 - x * x * x) / 6 * section.slope.dot(e) * amount(section.middle);
    }
};

struct FoundPeak {
    Peak peak;
    PairMass<3> mass; ///< of the twists relative to the mean motion
};
/// Of the walls of a gap, searched from a place of it.
std::optional<FoundPeak> find_peak(const GapSite<3>& site);

} // namespace gapflow
