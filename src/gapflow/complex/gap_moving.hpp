// The two walls of a gap with one pair of twists, and with the derivatives by their places and angles: of a few numbers with every number on their way
// (dual.hpp); of what is a sum over many sections backwards, from the derivatives by each section to those by the places (add_rates). Places in cells.
#pragma once

#include "gapflow/complex/dual.hpp"
#include "gapflow/complex/gap_round.hpp"

namespace gapflow {

/// to += by . x, the derivatives alone.
template <int D, class Scalar>
void add_rates_along(const Vec<D>& by, const PlaceOf<D, Scalar>& x, Scalar& to)
{
    for (int k = 0; k < D; ++k)
        to.add_rates_of(x[k], by[k]);
}

/// A number with its derivatives by place and angle of the two solids one after the other, and by the centroid of the piece of a face.
template <int D>
using MovingNumber = Dual<2 * twist_size<D> + D + 1>;

/// Derivatives of a number by the place at which a section is taken, its normal, the motion of the frame in which the gap opens, and by place and
/// angle of the two solids, one after the other.
template <int D>
struct SectionRates {
    Vec<D> x = Vec<D>::Zero(), n = Vec<D>::Zero(), frame = Vec<D>::Zero();
    PairTwist<D> pose = PairTwist<D>::Zero();
};
/// Derivatives of a number by what a section has.
template <int D>
struct SectionLoads {
    double thickness = 0, opening = 0; ///< in the frame
    Vec<D> slope = Vec<D>::Zero(), middle = Vec<D>::Zero();
};

/// With one pair of twists.
template <int D>
class MovingWalls {
public:
    using Scalar = MovingNumber<D>;
    using Row = Scalar;
    using Square = Scalar;
    using Place = PlaceOf<D, Scalar>;
    using Frame = Place;

    /// Keeps a reference to `walls`.
    MovingWalls(const GapWalls<D>& walls, const PairTwist<D>& twist, const Standoff<D>& standoff)
        : walls_(walls), twist_(twist), standoff_(standoff.distance), standoff_rate_(standoff.rate)
    {
        for (int k = 0; k < 2 * twist_size<D>; ++k)
            standoff_.rate[k] = standoff.rate[k];
        for (int side = 0; side < 2; ++side)
            for (int axis = 0; axis < D; ++axis)
                reference_[side][axis] = Scalar::variable(walls.reference[side][axis], side * twist_size<D> + axis);
    }

    static Row none() { return 0; }
    static Square no_square() { return 0; }
    static Square product(const Row& a, const Row& b) { return a * b; }
    static Row along(const Frame& frame, const Place& v) { return frame.dot(v); }
    Row row(int side, const Place& force, const SpinOf<D, Scalar>& torque) const
    {
        Row sum = 0;
        for (int k = 0; k < D; ++k)
            sum += twist_[side * twist_size<D> + k] * force[k];
        for (int k = 0; k < spin_size<D>; ++k)
            sum += twist_[side * twist_size<D> + D + k] * torque[k];
        return sum;
    }
    const Place& reference_of(int side) const { return reference_[side]; }
    const GapWall<D>& wall(int side) const { return walls_.wall(side); }
    const GapWalls<D>& still() const { return walls_; }
    const Scalar& standoff() const { return standoff_; }
    Scalar between_shapes(const Scalar& thickness) const { return std::max(Scalar(thickness - standoff_), Scalar(place_unit)); }
    /// Of a point at the end of a face, for places x near it: how far the point is from the end.
    Scalar off_edge(int side, const WallPoint<D, Scalar>& at, const Place& x) const
    {
        const Vec<D> n = values_of<D>(at.normal), foot = values_of<D>(at.x);
        Vec<D> out; // in the face, normal to its border
        if constexpr (D == 2)
            out = Vec<2>(-n[1], n[0]);
        else if (const auto round = wall(side).across_border(walls_.nearest(side, values_of<D>(x))))
            out = *round;
        else { // a little beyond, the direction from the border to a place is normal to it
            Vec<3> way;
            for (int k = 0; k < 3; ++k)
                way[k] = at.x[k].rate[Scalar::variables - 1];
            out = way;
            for (const double little : {parameters.tangent_share, -parameters.tangent_share})
                if (const WallPoint<3, double> beyond =
                        walls_.nearest(side, step_along<3>(values_of<3>(x), little / way.norm(), way));
                    !beyond.on_face)
                    out = beyond.normal - n.dot(beyond.normal) * n;
        }
        Scalar sum = 0;
        for (int variable = 0; variable < Scalar::variables; ++variable) {
            Vec<D> moved = Vec<D>::Zero();
            if (const int own = variable - side * twist_size<D>; own >= 0 && own < D)
                moved[own] = 1;
            else if (own >= D && own < twist_size<D>)
                moved = turned(own - D, foot - walls_.reference[side]);
            for (int k = 0; k < D; ++k)
                sum.rate[variable] += out[k] * (at.x[k].rate[variable] - moved[k]);
        }
        return sum;
    }
    WallPoint<D, Scalar> nearest(int side, const Place& x, int face = -1) const
    {
        const Vec<D> at = values_of<D>(x);
        const WallPoint<D, double> point = walls_.nearest(side, at, face);
        WallPoint<D, Scalar> result{{}, {}, point.distance, point.on_face, point.face};
        for (int k = 0; k < D; ++k) {
            result.x[k] = point.x[k];
            result.normal[k] = point.normal[k];
        }
        for (int variable = 0; variable < Scalar::variables; ++variable) {
            Vec<D> way, turn = Vec<D>::Zero(); // of x relative to the moved solid; of the normal by the solid's turn
            for (int k = 0; k < D; ++k)
                way[k] = x[k].rate[variable];
            const Vec<D> moved = way;
            if (const int own = variable - side * twist_size<D>; own >= 0 && own < D)
                way[own] -= 1;
            else if (own >= D && own < twist_size<D>) {
                way -= turned(own - D, at - walls_.reference[side]);
                turn = turned(own - D, point.normal);
            }
            const double by_distance = point.normal.dot(way);
            const Vec<D> by_normal = turn + walls_.wall(side).normal_rate(point, way);
            result.distance.rate[variable] = by_distance;
            for (int k = 0; k < D; ++k) {
                result.normal[k].rate[variable] = by_normal[k];
                result.x[k].rate[variable] = moved[k] - point.normal[k] * by_distance - point.distance * by_normal[k];
            }
        }
        return result;
    }

    /// Whether a thickness is that of the walls, not the least one.
    static bool free_thickness(double thickness) { return thickness > place_unit; }
    /// Rate of the thickness in a frame that moves with `frame`.
    double opening(const SectionTrace<D>& at, const Vec<D>& n, const Vec<D>& frame) const
    {
        double sum = 0;
        for (int side = 0; side < 2; ++side) {
            const WallPoint<D, double>& wall = at.wall[1][side];
            sum -= wall.normal.dot(velocity(side, wall.x) - frame) / ((side == 0 ? 1 : -1) * n.dot(wall.normal));
        }
        return sum;
    }
    /// Adds to `sum` the derivatives of a number that depends on a section along n, found as `at` tells, in a frame that moves with `frame`.
    void add_rates(const SectionTrace<D>& at, const Vec<D>& n, const Vec<D>& frame, const SectionLoads<D>& by,
                   SectionRates<D>& sum) const
    {
        constexpr int T = twist_size<D>;
        // From the middle, the second pass.
        Vec<D> by_middle = by.middle;
        double ahead = 0;
        for (int side = 0; side < 2; ++side) {
            const WallPoint<D, double>& wall = at.wall[1][side];
            const double sign = side == 0 ? 1 : -1, cosine = sign * n.dot(wall.normal),
                         by_way = by.thickness - 0.5 * sign * n.dot(by.middle);
            ahead -= sign * wall.distance / cosine;
            const Vec<D> force = -wall.normal / cosine;
            Vec<D> by_force = by.slope, by_foot = Vec<D>::Zero();
            if (by.opening != 0) {
                const Spin<D> spin = twist_.template segment<spin_size<D>>(side * T + D);
                by_force += by.opening * (velocity(side, wall.x) - frame);
                by_foot = -by.opening * turned_by(spin, force);
                sum.frame -= by.opening * force;
                sum.pose.template segment<D>(side * T) -= by_foot; // the reference point
            }
            const double by_cosine = -(by_force.dot(force) + by_way * wall.distance / cosine) / cosine,
                         by_distance = by_way / cosine - by_foot.dot(wall.normal);
            const Vec<D> by_normal = -by_force / cosine + sign * by_cosine * n - wall.distance * by_foot;
            sum.n += sign * by_cosine * wall.normal;
            by_middle += by_foot + by_place(side, at.place[1], wall, by_distance, by_normal, sum);
        }
        sum.pose += by.thickness * standoff_rate_;
        sum.n += 0.5 * ahead * by.middle;
        // To the middle.
        sum.x += by_middle;
        const double by_way = 0.5 * n.dot(by_middle);
        ahead = 0;
        for (int side = 0; side < 2; ++side) {
            const WallPoint<D, double>& wall = at.wall[0][side];
            const double sign = side == 0 ? 1 : -1, cosine = sign * n.dot(wall.normal), by_own = -sign * by_way,
                         by_cosine = -by_own * wall.distance / (cosine * cosine);
            ahead -= sign * wall.distance / cosine;
            sum.n += sign * by_cosine * wall.normal;
            sum.x += by_place(side, at.place[0], wall, by_own / cosine, sign * by_cosine * n, sum);
        }
        sum.n += 0.5 * ahead * by_middle;
    }
    /// With this value, and derivatives by x and n and by the solids' places.
    Scalar number(double value, const SectionRates<D>& rates, const Place& x, const Place& n) const
    {
        Scalar result(value);
        for (int k = 0; k < 2 * twist_size<D>; ++k)
            result.rate[k] = rates.pose[k];
        add_rates_along<D>(rates.x, x, result);
        add_rates_along<D>(rates.n, n, result);
        return result;
    }

private:
    /// Derivatives by the place from those by distance and normal of the wall's point nearest to it.
    Vec<D> by_place(int side, const Vec<D>& x, const WallPoint<D, double>& wall, double by_distance, const Vec<D>& by_normal,
                    SectionRates<D>& sum) const
    {
        constexpr int T = twist_size<D>;
        const Vec<D> by_x = by_distance * wall.normal + walls_.wall(side).normal_rate(wall, by_normal);
        sum.pose.template segment<D>(side * T) -= by_x;
        sum.pose.template segment<spin_size<D>>(side * T + D) +=
            moment<D>(wall.normal, by_normal) - moment<D>(Vec<D>(x - walls_.reference[side]), by_x);
        return by_x;
    }
    Vec<D> velocity(int side, const Vec<D>& x) const
    {
        constexpr int first = twist_size<D>;
        const Spin<D> spin = twist_.template segment<spin_size<D>>(side * first + D);
        return twist_.template segment<D>(side * first) + turned_by(spin, x - walls_.reference[side]);
    }
    /// spin_velocity() of core/types.hpp, of which this folder leaves no copies.
    [[gnu::always_inline]] static Vec<D> turned_by(const Spin<D>& spin, const Vec<D>& r)
    {
        if constexpr (D == 2)
            return Vec<2>(-spin[0] * r[1], spin[0] * r[0]);
        else
            return spin.cross(r);
    }
    static Vec<D> turned(int k, const Vec<D>& r)
    {
        if constexpr (D == 2)
            return Vec<2>(-r[1], r[0]);
        else
            return Vec<3>::Unit(k).cross(r);
    }

    const GapWalls<D>& walls_;
    PairTwist<D> twist_;
    Scalar standoff_;
    PairTwist<D> standoff_rate_;
    std::array<Place, 2> reference_;
};

/// Thickness of a gap along the line through x along n. Nothing where a wall ends.
template <int D>
std::optional<double> thickness_at(const GapWalls<D>& walls, const Vec<D>& x, const Vec<D>& n)
{
    if (walls.round()) {
        if (const auto found = RoundLine<D>(walls, x, Vec<D>::Zero(), n).at(0))
            return found->thickness;
    } else if (const auto found = walls.profile(x, n))
        return found->thickness;
    return {};
}
template <int D>
std::optional<MovingNumber<D>> thickness_at(const FacingWalls<D, MovingWalls<D>>& walls, const PlaceOf<D, MovingNumber<D>>& x,
                                            const PlaceOf<D, MovingNumber<D>>& n)
{
    SectionTrace<D> trace;
    const Vec<D> normal = values_of<D>(n);
    const auto found = walls.still().profile(values_of<D>(x), normal, nullptr, &trace);
    if (!found)
        return {};
    SectionRates<D> rates;
    if (walls.free_thickness(found->thickness))
        walls.add_rates(trace, normal, Vec<D>::Zero(), {1, 0, Vec<D>::Zero()}, rates);
    return walls.number(found->thickness, rates, x, n);
}

/// A gap at the place of a piece.
template <int D>
std::optional<GapProfile<D, StillWalls<D>>> profile_at(const GapWalls<D>& walls, const Vec<D>& x, const Vec<D>& n)
{
    return walls.profile(x, n);
}
template <int D>
std::optional<GapProfile<D, MovingWalls<D>>> profile_at(const FacingWalls<D, MovingWalls<D>>& walls,
                                                        const PlaceOf<D, MovingNumber<D>>& x,
                                                        const PlaceOf<D, MovingNumber<D>>& n)
{
    return walls.profile(x, n);
}

/// How far a section's middle lies from `centre` along an axis, less half of what the gap and a cell are wide along it.
template <int D>
double beyond_face(const GapProfile<D, StillWalls<D>>& section, const Vec<D>& n, int axis, double centre)
{
    return std::abs(section.middle[axis] - centre) - 0.5 * (1.0 + section.thickness * std::abs(n[axis]));
}
template <int D>
std::optional<MovingNumber<D>> beyond_face(const FacingWalls<D, MovingWalls<D>>& walls, const PlaceOf<D, MovingNumber<D>>& x,
                                           const PlaceOf<D, MovingNumber<D>>& n, int axis, double centre)
{
    SectionTrace<D> trace;
    const Vec<D> normal = values_of<D>(n);
    const auto found = walls.still().profile(values_of<D>(x), normal, nullptr, &trace);
    if (!found)
        return {};
    SectionRates<D> rates;
    SectionLoads<D> by;
    by.middle[axis] = found->middle[axis] < centre ? -1 : 1;
    by.thickness = walls.free_thickness(found->thickness) ? -0.5 * std::abs(normal[axis]) : 0.0;
    walls.add_rates(trace, normal, Vec<D>::Zero(), by, rates);
    rates.n[axis] -= (normal[axis] < 0 ? -0.5 : 0.5) * found->thickness;
    return walls.number(beyond_face<D>(*found, normal, axis, centre), rates, x, n);
}

/// The thickness, and how it grows along a way.
template <class S>
struct Growth {
    S thickness, growth;
};
template <int D>
std::optional<Growth<double>> growth_at(const GapWalls<D>& walls, const Vec<D>& x, const Vec<D>& n, const Vec<D>& way)
{
    if (const auto found = walls.profile(x, n))
        return Growth<double>{found->thickness, -found->slope.dot(way)};
    return {};
}
template <int D>
std::optional<Growth<MovingNumber<D>>> growth_at(const FacingWalls<D, MovingWalls<D>>& walls,
                                                 const PlaceOf<D, MovingNumber<D>>& x, const PlaceOf<D, MovingNumber<D>>& n,
                                                 const PlaceOf<D, MovingNumber<D>>& way)
{
    SectionTrace<D> trace;
    const Vec<D> normal = values_of<D>(n), along = values_of<D>(way), none = Vec<D>::Zero();
    const auto found = walls.still().profile(values_of<D>(x), normal, nullptr, &trace);
    if (!found)
        return {};
    SectionRates<D> by_thickness, by_growth;
    if (walls.free_thickness(found->thickness))
        walls.add_rates(trace, normal, none, {1, 0, none}, by_thickness);
    walls.add_rates(trace, normal, none, {0, 0, Vec<D>(-along)}, by_growth);
    MovingNumber<D> growth = walls.number(-found->slope.dot(along), by_growth, x, n);
    add_rates_along<D>(Vec<D>(-found->slope), way, growth);
    return Growth<MovingNumber<D>>{walls.number(found->thickness, by_thickness, x, n), growth};
}

/// Minus the gradient of the thickness, along two directions across n.
template <int D>
PlaceOf<2, double> slope_along(const GapWalls<D>&, const Vec<D>&, const Vec<D>&, const GapProfile<D, StillWalls<D>>& here,
                               const Vec<D>& u, const Vec<D>& v)
{
    return {here.slope.dot(u), here.slope.dot(v)};
}
template <int D>
PlaceOf<2, MovingNumber<D>> slope_along(const FacingWalls<D, MovingWalls<D>>&, const PlaceOf<D, MovingNumber<D>>&,
                                        const PlaceOf<D, MovingNumber<D>>&, const GapProfile<D, MovingWalls<D>>& here,
                                        const PlaceOf<D, MovingNumber<D>>& u, const PlaceOf<D, MovingNumber<D>>& v)
{
    return {here.slope.dot(u), here.slope.dot(v)};
}

} // namespace gapflow
