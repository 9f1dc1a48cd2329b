// Round walls (gap_round.hpp) with the derivatives by their places in every number: their sections are in closed form, and depend on few variables. Places
// in cells.
#pragma once

#include "gapflow/complex/gap_moving.hpp"

namespace gapflow {

/// A number with its derivatives by the places of the two walls one after the other, by the centroid of the piece of a face in the face, and along a line.
template <int D>
using RoundNumber = Dual<3 * D>;

template <int D>
class MovingRoundWalls {
public:
    using Scalar = RoundNumber<D>;
    using Row = Scalar;
    using Place = PlaceOf<D, Scalar>;
    using Frame = Place;

    /// Keeps a reference to `walls`.
    MovingRoundWalls(const GapWalls<D>& walls, const Standoff<D>& standoff) : walls_(walls), standoff_(standoff.distance)
    {
        for (int side = 0; side < 2; ++side)
            for (int axis = 0; axis < D; ++axis) {
                const int variable = side * D + axis;
                standoff_.rate[variable] = standoff.rate[side * twist_size<D> + axis];
                point_[side][axis] = Scalar::variable(walls.wall(side).point()[axis], variable);
            }
    }
    /// In a face normal to an axis.
    static Place centroid(const Vec<D>& x, int face_axis)
    {
        Place result;
        for (int axis = 0, variable = 2 * D; axis < D; ++axis)
            result[axis] = axis == face_axis ? Scalar(x[axis]) : Scalar::variable(x[axis], variable++);
        return result;
    }

    const GapWall<D>& wall(int side) const { return walls_.wall(side); }
    const GapWalls<D>& still() const { return walls_; }
    /// Centre of a ball, or a point of a plane.
    const Place& point(int side) const { return point_[side]; }
    const Scalar& standoff() const { return standoff_; }
    Scalar between_shapes(const Scalar& thickness) const { return std::max(Scalar(thickness - standoff_), Scalar(place_unit)); }
    WallPoint<D, Scalar> nearest(int side, const Place& x, int = -1) const
    {
        const GapWall<D>& of = wall(side);
        const Place from = x - point_[side];
        if (of.radius() > 0) {
            const Scalar length = sqrt(from.squaredNorm());
            const Place way = (1.0 / length) * from;
            return {step_along<D, Scalar>(point_[side], Scalar(of.radius()), way), of.sign() * way,
                    of.sign() * (length - of.radius()), true, 0};
        }
        const Place normal = of.normal().template cast<Scalar>();
        const Scalar distance = normal.dot(from);
        return {step_along<D, Scalar>(x, -distance, normal), normal, distance, true, 0};
    }
    /// Nothing of round walls ends at an edge.
    static Scalar off_edge(int, const WallPoint<D, Scalar>&, const Place&) { return 0; }

private:
    const GapWalls<D>& walls_;
    Scalar standoff_;
    std::array<Place, 2> point_;
};

/// A section through x along n. Its numbers depend on the place through two of each ball, the height over its centre and the square of the distance from it,
/// and two of a plane, the distance and the cosine: rates are made of those of these.
template <int D>
class RoundSection {
public:
    using S = RoundNumber<D>;
    using Place = PlaceOf<D, S>;

    /// Keeps references to its arguments. `known`: to be a place at which the walls face each other, or the last such place. Else it may be none.
    RoundSection(const FacingWalls<D, MovingRoundWalls<D>>& walls, const Place& x, const Place& n, bool known) : n_(n)
    {
        faces_ = find_first(walls, x, known) && find_second(walls, known);
    }
    /// Whether the walls face each other.
    explicit operator bool() const { return faces_; }
    const S& thickness() const { return thickness_; }
    /// Of the middle over x along n.
    const S& rise() const { return rise_; }

    /// How the thickness grows along a way in the plane of the gap.
    S growth(const Place& way) const
    {
        S sum = 0;
        double along = 0;
        for (int k = 0; k < D; ++k)
            along += n_[k].value * way[k].value;
        for (const Side& side : side_) {
            double square = 0;
            for (int k = 0; k < D; ++k)
                square += side.from[k].value * way[k].value;
            const double own = side.ball ? square - side.z.value * along : square, inverse = side.inverse.value;
            sum.value += own * inverse;
            for (int k = 0; k < D; ++k)
                if (side.ball) {
                    sum.add_rates_of(side.from[k], way[k].value * inverse);
                    sum.add_rates_of(way[k], (side.from[k].value - side.z.value * n_[k].value) * inverse);
                    sum.add_rates_of(n_[k], -side.z.value * way[k].value * inverse);
                } else
                    sum.add_rates_of(way[k], side.from[k].value * inverse);
            if (side.ball)
                sum.add_rates_of(side.z, -along * inverse);
            sum.add_rates_of(side.inverse, own);
        }
        return sum;
    }

private:
    struct Side {
        bool ball;
        double sign, facing, radius;
        Place from;         ///< from a ball's centre to x; of a plane its normal
        S z, square, first; ///< z: of a plane the cosine
        S inverse;          ///< sign over the height of the middle, or over the cosine
    };

    bool find_first(const FacingWalls<D, MovingRoundWalls<D>>& walls, const Place& x, bool known)
    {
        for (int i = 0; i < 2; ++i) {
            const GapWall<D>& wall = walls.wall(i);
            Side& side = side_[i];
            side.sign = i == 0 ? 1 : -1;
            side.ball = wall.radius() > 0;
            side.radius = wall.radius();
            side.facing = side.ball ? wall.sign() * side.sign : 1;
            if (!(side.ball ? find_ball(walls.point(i), x, known, side)
                            : find_plane(wall.normal(), walls.point(i), x, known, side)))
                return false;
        }
        return true;
    }
    bool find_ball(const Place& centre, const Place& x, bool known, Side& side) const
    {
        for (int k = 0; k < D; ++k) {
            side.from[k] = x[k] - centre[k];
            const double from = side.from[k].value;
            side.z.value += n_[k].value * from;
            side.square.value += from * from;
            side.z.add_rates_of(side.from[k], n_[k].value);
            side.z.add_rates_of(n_[k], from);
            side.square.add_rates_of(side.from[k], 2 * from);
        }
        const double z = side.z.value, length = std::sqrt(side.square.value);
        if (!known && side.facing * z < parameters.least_facing * length)
            return false;
        const double by_length = (2 * length - side.radius) * (side.sign / z);
        side.first.value = (length - side.radius) * length * (side.sign / z);
        side.first.add_rates_of(side.square, 0.5 * by_length / length);
        side.first.add_rates_of(side.z, -side.first.value / z);
        return true;
    }
    bool find_plane(const Vec<D>& normal, const Place& point, const Place& x, bool known, Side& side) const
    {
        S distance = 0;
        for (int k = 0; k < D; ++k) {
            side.from[k] = normal[k];
            side.z += side.sign * normal[k] * n_[k];
            distance += normal[k] * (x[k] - point[k]);
        }
        if (!known && side.z < parameters.least_facing)
            return false;
        side.inverse = 1.0 / side.z;
        side.first = distance * side.inverse;
        return true;
    }
    bool find_second(const FacingWalls<D, MovingRoundWalls<D>>& walls, bool known)
    {
        const S up = 0.5 * (side_[1].first - side_[0].first);
        thickness_ = walls.standoff();
        rise_ = up;
        for (Side& side : side_) {
            S second;
            if (side.ball) {
                const double height = side.z.value + up.value,
                             length = std::sqrt(side.square.value + up.value * (side.z.value + height));
                if (!known && side.facing * height < parameters.least_facing * length)
                    return false;
                const double inverse = side.sign / height, by_length = (2 * length - side.radius) * inverse / length;
                second.value = (length - side.radius) * length * inverse;
                const double by_height = by_length * height - second.value / height; // the height changes with z and `up`
                second.add_rates_of(side.square, 0.5 * by_length);
                second.add_rates_of(side.z, by_height - by_length * side.z.value);
                second.add_rates_of(up, by_height);
                side.inverse.value = inverse;
                side.inverse.add_rates_of(side.z, -inverse / height);
                side.inverse.add_rates_of(up, -inverse / height);
            } else
                second = side.first + side.sign * up;
            thickness_ += second;
            rise_ += -0.5 * side.sign * second;
        }
        if (!known && !(thickness_ > 0))
            return false;
        thickness_ = std::max(thickness_, S(place_unit));
        return true;
    }

    const Place& n_;
    std::array<Side, 2> side_;
    S thickness_, rise_;
    bool faces_;
};

template <int D>
std::optional<RoundNumber<D>> thickness_at(const FacingWalls<D, MovingRoundWalls<D>>& walls,
                                           const PlaceOf<D, RoundNumber<D>>& x, const PlaceOf<D, RoundNumber<D>>& n)
{
    if (const RoundSection<D> at(walls, x, n, false); at)
        return at.thickness();
    return {};
}
/// The thickness alone.
template <int D>
std::optional<GapProfile<D, MovingRoundWalls<D>>> profile_at(const FacingWalls<D, MovingRoundWalls<D>>& walls,
                                                             const PlaceOf<D, RoundNumber<D>>& x,
                                                             const PlaceOf<D, RoundNumber<D>>& n)
{
    const auto thickness = thickness_at<D>(walls, x, n);
    if (!thickness)
        return {};
    GapProfile<D, MovingRoundWalls<D>> profile;
    profile.thickness = *thickness;
    return profile;
}
template <int D>
std::optional<RoundNumber<D>> beyond_face(const FacingWalls<D, MovingRoundWalls<D>>& walls, const PlaceOf<D, RoundNumber<D>>& x,
                                          const PlaceOf<D, RoundNumber<D>>& n, int axis, double centre)
{
    const RoundSection<D> at(walls, x, n, true);
    return abs(x[axis] + at.rise() * n[axis] - centre) - 0.5 * (1.0 + at.thickness() * abs(n[axis]));
}
template <int D>
std::optional<Growth<RoundNumber<D>>> growth_at(const FacingWalls<D, MovingRoundWalls<D>>& walls,
                                                const PlaceOf<D, RoundNumber<D>>& x, const PlaceOf<D, RoundNumber<D>>& n,
                                                const PlaceOf<D, RoundNumber<D>>& way)
{
    const RoundSection<D> at(walls, x, n, true);
    return Growth<RoundNumber<D>>{at.thickness(), at.growth(way)};
}
template <int D>
PlaceOf<2, RoundNumber<D>> slope_along(const FacingWalls<D, MovingRoundWalls<D>>& walls, const PlaceOf<D, RoundNumber<D>>& x,
                                       const PlaceOf<D, RoundNumber<D>>& n, const GapProfile<D, MovingRoundWalls<D>>&,
                                       const PlaceOf<D, RoundNumber<D>>& u, const PlaceOf<D, RoundNumber<D>>& v)
{
    const RoundSection<D> at(walls, x, n, true);
    return {-at.growth(u), -at.growth(v)};
}

} // namespace gapflow
