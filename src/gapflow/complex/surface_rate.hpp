// How points move that solids' borders define: where two borders meet in a plane, as the solids move.
#pragma once

#include "gapflow/complex/cut_faces.hpp"
#include "gapflow/complex/lever.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace gapflow {

/// Adds factor times the one to the other.
template <int D>
void add_rates(PointRates<D>& to, const PointRates<D>& rates, double factor)
{
    for (const PointRate<D>& r : rates) {
        auto known = std::find_if(to.begin(), to.end(), [&](const PointRate<D>& k) { return k.solid == r.solid; });
        if (known == to.end())
            to.push_back({r.solid, factor * r.rate});
        else
            known->rate += factor * r.rate;
    }
}

template <int D>
void scale_rates(PointRates<D>& rates, double factor)
{
    for (PointRate<D>& r : rates)
        r.rate *= factor;
}

/// Velocity of a point x that moves with a solid, by its twist.
template <int D>
Eigen::Matrix<double, D, twist_size<D>> rigid_rate(const Vec<D>& x, const Vec<D>& reference)
{
    Eigen::Matrix<double, D, twist_size<D>> rate;
    for (int k = 0; k < D; ++k)
        rate.row(k) = lever<D>(unit<D>(k), x - reference).transpose();
    return rate;
}

/// Normal of a facet, out of the solid.
template <int D>
Vec<D> facet_normal(const FacetKind<D>& kind, int facet);

/// Plane at which the rates of a disk's border in the plane x[d] = at are taken. Where it passes a plane the chord there is the root of the depth: it grows without
/// bound, over a way in which nothing moves. So up to 0.6 of a way of 0.05 cells of depth the rates are those at a depth whose slope is the mean one over
/// this way to both sides, as of forces from displaced energies (step/displaced).
double plane_of_rates(const BallKind<2>& disk, int d, double at);

/// Place and normal of the border by which the end x of a solid's stretch along `axis` moves; `last`: the one with the higher coordinate.
template <class Kind>
std::pair<Vec<2>, Vec<2>> end_of_rates(const Kind& kind, int axis, Vec<2> x, bool last)
{
    if constexpr (std::is_same_v<Kind, BallKind<2>>) {
        x[1 - axis] = plane_of_rates(kind, 1 - axis, x[1 - axis]);
        if (const Stretch stretch = kind.line(axis, x); !stretch.empty())
            x[axis] = last ? stretch.to : stretch.from;
    }
    return {x, kind.normal_at(x)};
}

/// Slope of a placed solid's surface along a segment in the plane x[d] = at; its normal out of what is solid.
Slope slope_of(const PlacedSolid<3>& solid, int d, double at, const ArcSegment& segment);

/// A line in a plane that moves: normal . (speed of a point of it) = speed . twist of a solid.
template <int D>
struct MovingLine {
    Vec<2> normal;
    Twist<D> speed = Twist<D>::Zero();
    int image = -1; ///< -1: fixed
};

/// Velocity over the solid's twist of both ends of a segment of a rim's chord in a face, normal to it, to its left; 0: it is none of its chords. The
/// rectangle of the face: low .. high.
struct RimSpeeds {
    Twist<3> from = Twist<3>::Zero(), to = Twist<3>::Zero();
};
RimSpeeds rim_speeds(const SharpRim& rim, const Vec<3>& reference, int d, double at, const Vec<2>& low, const Vec<2>& high,
                     const ArcSegment& segment);

/// The tangent of a solid's border at an end of a segment. `surface` of the segment as FaceArcs has it.
template <int D>
MovingLine<D> moving_line(const std::vector<PlacedSolid<D>>& solids, int image, int d, double at, const ArcSegment& segment,
                          bool end);

/// Rates of the point in which two lines meet; none where they are parallel. In 3D in the plane normal to d.
template <int D>
PointRates<D> meeting_rates(int d, const MovingLine<D>& a, const MovingLine<D>& b);

} // namespace gapflow
