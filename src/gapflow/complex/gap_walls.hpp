// The two walls of a gap and the thickness between them, in two kinds: at rest, with rows of their twists; and with one pair of twists, and with
// the derivatives by their places and angles. Shared by what integrates along a gap (gap_way.hpp). Places in cells.
#pragma once

#include "gapflow/complex/dual.hpp"
#include "gapflow/complex/facet_cut.hpp"
#include "gapflow/complex/gap_arm.hpp"
#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/placed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace gapflow {

/// n . v of a solid's twist at x.
template <int D>
Twist<D> speed_along(const Vec<D>& n, const Vec<D>& x, const Vec<D>& reference)
{
    return lever<D>(n, x - reference);
}

template <int D, class S>
using PlaceOf = Eigen::Matrix<S, D, 1>;
template <int D, class S>
using SpinOf = Eigen::Matrix<S, spin_size<D>, 1>;

/// moment() of core/types.hpp, for all kinds of numbers.
template <int D, class S>
SpinOf<D, S> moment_of(const PlaceOf<D, S>& a, const PlaceOf<D, S>& b)
{
    if constexpr (D == 2)
        return SpinOf<2, S>(a[0] * b[1] - a[1] * b[0]);
    else
        return a.cross(b);
}

/// x + s way. By components: Eigen leaves copies of its loop, which other folders compile with contracted products (tools/check-copies).
template <int D, class S>
PlaceOf<D, S> step_along(const PlaceOf<D, S>& x, const S& s, const PlaceOf<D, S>& way)
{
    PlaceOf<D, S> result;
    for (int k = 0; k < D; ++k)
        result[k] = x[k] + s * way[k];
    return result;
}

/// Nearest point of a wall.
template <int D, class S>
struct WallPoint {
    PlaceOf<D, S> x, normal;
    S distance;
    bool on_face; ///< else on a sharp edge or a corner
    int face;     ///< number of the patch within sharp edges
};

/// A solid that is one wall of a gap.
template <int D>
class GapWall {
public:
    GapWall(const PlacedShape<D>& shape, const GridPlanes<D>& grid) : shape_(shape), anchor_(grid.anchor), dx_(grid.dx)
    {
        if (const auto radius = shape.shape().sphere_radius()) {
            radius_ = *radius / dx_;
            sign_ = shape.shape().inside_out() ? -1 : 1;
            centre_ = in_cells(shape.to_world(Vec<D>::Zero()));
        } else if (const auto planes = shape.shape().planes();
                   planes.size() == 1 && !shape.shape().complement() && !shape.shape().inside_out()) {
            flat_ = true;
            normal_ = shape.rotation() * planes[0].normal;
            centre_ = in_cells(shape.to_world(planes[0].offset * planes[0].normal));
        }
    }

    const PlacedShape<D>& shape() const { return shape_; }
    /// `face`: of this one, or where it would go on beyond its border; -1: of the solid.
    [[gnu::always_inline]] WallPoint<D, double> nearest(const Vec<D>& x, int face = -1) const
    {
        if (radius_ > 0)
            if (const double length = (x - centre_).norm(); length > 0) {
                const Vec<D> way = (1 / length) * (x - centre_);
                return {step_along<D>(centre_, radius_, way), Vec<D>(sign_ * way), sign_ * (length - radius_), true, 0};
            }
        if (flat_) {
            const double distance = normal_.dot(x - centre_);
            return {step_along<D>(x, -distance, normal_), normal_, distance, true, 0};
        }
        return nearest_of_shape(x, face);
    }
    /// Derivative of the normal at a wall's point by the place to which it is the nearest: that of the surface through the place at one distance
    /// from the wall.
    Mat<D> normal_rate(const WallPoint<D, double>& at) const
    {
        const Shape<D>& shape = shape_.shape();
        const double sign = shape.inside_out() ? -1 : 1;
        const Mat<D> across = Mat<D>::Identity() - at.normal * at.normal.transpose();
        if (radius_ > 0)
            return sign / (radius_ + sign * at.distance) * across;
        if (const auto bar = shape.round_bar()) {
            const double radius = bar->radius / dx_;
            const Vec<D> axis = shape_.rotation().col(0), from = at.x - in_cells(shape_.to_world(Vec<D>::Zero()));
            const bool side = bar->flat ? at.face >= 2 : std::abs(axis.dot(from)) < bar->half / dx_;
            if (side ? D == 2 : bar->flat)
                return Mat<D>::Zero();
            return sign / (radius + sign * at.distance) * (side ? Mat<D>(across - axis * axis.transpose()) : across);
        }
        return Mat<D>::Zero();
    }
    /// At a point on the round border of a face: the direction normal to the border, in the face; of either sign. Nothing where borders are straight.
    std::optional<Vec<D>> across_border(const WallPoint<D, double>& at) const
    {
        const auto bar = shape_.shape().round_bar();
        if (D == 2 || !bar || !bar->flat)
            return {};
        const Vec<D> axis = shape_.rotation().col(0), from = at.x - in_cells(shape_.to_world(Vec<D>::Zero()));
        return at.face >= 2 ? axis : Vec<D>(from - axis.dot(from) * axis).normalized();
    }

private:
    [[gnu::noinline]] WallPoint<D, double> nearest_of_shape(const Vec<D>& x, int face) const
    {
        const Vec<D> world = step_along<D>(anchor_, dx_, x);
        const SurfacePoint<D> at = shape_.closest(world);
        if (const int own = face_of(at.patch); face < 0 || (at.feature == Feature::face && own == face))
            return {in_cells(at.x), at.normal, at.distance / dx_, at.feature == Feature::face, own};
        const Vec<D> foot = shape_.onto(world, face), normal = shape_.patch_normal(foot, face);
        return {in_cells(foot), normal, normal.dot(world - foot) / dx_, true, face};
    }
    /// A capsule's patches meet without an edge.
    int face_of(int patch) const
    {
        const auto bar = shape_.shape().round_bar();
        return bar && !bar->flat ? 0 : patch;
    }

    Vec<D> in_cells(const Vec<D>& x) const { return (x - anchor_) / dx_; }

    PlacedShape<D> shape_;
    Vec<D> anchor_;
    double dx_;
    // In closed form: balls, and half-spaces.
    double radius_ = 0; ///< 0: no ball
    double sign_ = 1;   ///< -1: fluid inside the ball
    bool flat_ = false;
    Vec<D> centre_ = Vec<D>::Zero(); ///< of a ball; a point of the plane
    Vec<D> normal_ = Vec<D>::Zero(); ///< of the plane
};

/// Why there is no section of a gap at a place: of one pass and one side, or of both (2), where the walls meet.
struct GapStop {
    int pass = 1, side = 2;
    bool edge = false; ///< the face ends; else it turns away

    bool meet() const { return side == 2; }
};

template <int D>
class StillWalls {
public:
    using Scalar = double;
    using Row = PairTwist<D>;
    using Square = PairMass<D>;
    using Frame = Eigen::Matrix<double, D, 2 * twist_size<D>>;

    std::array<Vec<D>, 2> reference;

    StillWalls(const std::array<GapWall<D>, 2>& wall, const std::array<Vec<D>, 2>& reference_, double standoff = 0)
        : reference(reference_), wall_(wall), standoff_(standoff)
    {
    }

    const GapWall<D>& wall(int side) const { return wall_[side]; }
    void swap()
    {
        std::swap(reference[0], reference[1]);
        std::swap(wall_[0], wall_[1]);
    }
    static Row none() { return Row::Zero(); }
    static Square no_square() { return Square::Zero(); }
    static Square product(const Row& a, const Row& b) { return a * b.transpose(); }
    /// Component of a frame's motion.
    static Row along(const Frame& frame, const Vec<D>& v) { return frame.transpose() * v; }
    static Row row(int side, const Vec<D>& force, const Spin<D>& torque)
    {
        Row result = Row::Zero();
        result.template segment<twist_size<D>>(side * twist_size<D>) << force, torque;
        return result;
    }
    const Vec<D>& reference_of(int side) const { return reference[side]; }
    [[gnu::always_inline]] WallPoint<D, double> nearest(int side, const Vec<D>& x, int face = -1) const
    {
        return wall_[side].nearest(x, face);
    }
    /// What the thickness is larger than the distance between the shapes.
    double standoff() const { return standoff_; }
    /// Of the thickness what lies between the shapes.
    double between_shapes(double thickness) const { return std::max(thickness - standoff_, place_unit); }

private:
    std::array<GapWall<D>, 2> wall_;
    double standoff_;
};

/// A gap along the line through x along n.
template <int D, class Walls>
struct GapProfile {
    typename Walls::Scalar thickness;
    PlaceOf<D, typename Walls::Scalar> middle;
    std::array<PlaceOf<D, typename Walls::Scalar>, 2> normal; ///< out of the walls
    /// Rate of the thickness where both walls move with the velocity U: slope . U; minus its gradient.
    PlaceOf<D, typename Walls::Scalar> slope;
};
template <int D, class Walls>
struct SectionOf : GapProfile<D, Walls> {
    typename Walls::Row opening; ///< rate of the thickness
};

/// Two walls that face each other.
template <int D, class Walls>
class FacingWalls : public Walls {
public:
    using S = typename Walls::Scalar;
    using Place = PlaceOf<D, S>;
    using Section = SectionOf<D, Walls>;
    using Profile = GapProfile<D, Walls>;
    using Walls::Walls;

    explicit FacingWalls(Walls walls) : Walls(std::move(walls)) {}

    /// Sections are between the two faces that are nearest to x from now on; so far between any.
    void keep_faces(const Vec<D>& x)
    {
        for (int side = 0; side < 2; ++side)
            face_[side] = this->wall(side).nearest(x).face;
    }
    const std::array<int, 2>& faces() const { return face_; }
    void keep_faces(const std::array<int, 2>& face) { face_ = face; }
    /// Whether faces that are kept go on beyond their borders.
    void extend(bool faces) { extended_ = faces; }

    void swap()
    {
        Walls::swap();
        std::swap(face_[0], face_[1]);
    }

    /// Nothing where a wall ends, or where the walls overlap; `stop`: why. They are at least as far apart as places are told from each other.
    std::optional<Section> across(const Place& x, const Place& n, GapStop* stop = nullptr) const
    {
        Section section;
        std::array<Place, 2> foot;
        std::array<S, 2> cosine;
        if (!find(x, n, section, foot, cosine, stop))
            return {};
        section.opening = Walls::none();
        for (int side = 0; side < 2; ++side) {
            const Place force = -section.normal[side] / cosine[side];
            section.opening += this->row(side, force, moment_of<D, S>(foot[side] - this->reference_of(side), force));
        }
        return section;
    }
    /// The same without the opening.
    std::optional<Profile> profile(const Place& x, const Place& n, GapStop* stop = nullptr) const
    {
        Profile profile;
        std::array<Place, 2> foot;
        std::array<S, 2> cosine;
        if (!find(x, n, profile, foot, cosine, stop))
            return {};
        return profile;
    }

    /// How far x is from such a stop beyond it: 0 there.
    S margin(Place x, const Place& n, const GapStop& stop) const
    {
        std::array<S, 2> way;
        for (int pass = 0;; ++pass) {
            for (int side = 0; side < 2; ++side) {
                const WallPoint<D, S> at = this->nearest(side, x, pass == 0 ? face_[side] : -1);
                const S cosine = (side == 0 ? 1.0 : -1.0) * n.dot(at.normal);
                if (pass == stop.pass && side == stop.side)
                    return stop.edge ? this->off_edge(side, at, x) : S(cosine - parameters.least_facing);
                way[side] = at.distance / cosine;
            }
            if (pass == stop.pass)
                return way[0] + way[1] + this->standoff();
            x += 0.5 * (way[1] - way[0]) * n;
        }
    }

private:
    bool find(Place x, const Place& n, Profile& at, std::array<Place, 2>& foot, std::array<S, 2>& cosine, GapStop* stop) const
    {
        const auto stopped = [&](int pass, int side, bool edge) {
            if (stop)
                *stop = {pass, side, edge};
            return false;
        };
        for (int pass = 0; pass < 2; ++pass) { // the second one from the middle
            std::array<S, 2> way;
            for (int side = 0; side < 2; ++side) {
                const WallPoint<D, S> point = this->nearest(side, x, pass == 0 || extended_ ? face_[side] : -1);
                cosine[side] = (side == 0 ? 1.0 : -1.0) * n.dot(point.normal);
                const bool edge = !point.on_face || (face_[side] >= 0 && point.face != face_[side]);
                if (edge || cosine[side] < parameters.least_facing)
                    return stopped(pass, side, edge);
                way[side] = point.distance / cosine[side];
                if (pass == 1) {
                    at.normal[side] = point.normal;
                    foot[side] = point.x;
                }
            }
            if (const S thickness = way[0] + way[1] + this->standoff(); pass == 1) {
                if (!(thickness > 0))
                    return stopped(pass, 2, false);
                at.thickness = std::max(thickness, S(place_unit));
            }
            x += 0.5 * (way[1] - way[0]) * n;
        }
        at.slope = -at.normal[0] / cosine[0] - at.normal[1] / cosine[1];
        at.middle = x;
        return true;
    }

    std::array<int, 2> face_{-1, -1};
    bool extended_ = false;
};

template <int D>
using GapWalls = FacingWalls<D, StillWalls<D>>;
template <int D>
using GapSection = SectionOf<D, StillWalls<D>>;

/// Variables: place and angle of the two solids one after the other, area and centroid of the piece of a face.
template <int D>
class MovingWalls {
public:
    using Scalar = typename GapTerms<D>::Number;
    using Row = Scalar;
    using Square = Scalar;
    using Place = PlaceOf<D, Scalar>;
    using Frame = Place;

    /// Keeps a reference to `walls`.
    MovingWalls(const GapWalls<D>& walls, const PairTwist<D>& twist, const Standoff<D>& standoff)
        : walls_(walls), twist_(twist), standoff_(standoff.distance)
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
        const Mat<D> bend = walls_.wall(side).normal_rate(point);
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
            const Vec<D> by_normal = turn + bend * way;
            result.distance.rate[variable] = by_distance;
            for (int k = 0; k < D; ++k) {
                result.normal[k].rate[variable] = by_normal[k];
                result.x[k].rate[variable] = moved[k] - point.normal[k] * by_distance - point.distance * by_normal[k];
            }
        }
        return result;
    }

private:
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
    std::array<Place, 2> reference_;
};

} // namespace gapflow
