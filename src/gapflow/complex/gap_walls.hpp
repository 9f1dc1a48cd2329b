// The two walls of a gap and the thickness between them, at rest, with rows of their twists; with one pair of twists and derivatives in gap_moving.hpp.
// Shared by what integrates along a gap (gap_way.hpp). Places in cells.
#pragma once

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
    /// Of a ball, else 0.
    double radius() const { return radius_; }
    /// -1: fluid inside the ball.
    double sign() const { return sign_; }
    bool flat() const { return flat_; }
    /// Centre of a ball, or a point of a plane.
    const Vec<D>& point() const { return centre_; }
    /// Of a plane.
    const Vec<D>& normal() const { return normal_; }
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
    /// Rate of the normal at a wall's point where the place to which it is the nearest moves by `way`: that of the surface through the place at one
    /// distance from the wall. Symmetric: `way` times the rate for another way is that way times the rate for `way`.
    Vec<D> normal_rate(const WallPoint<D, double>& at, const Vec<D>& way) const
    {
        const Vec<D> across = way - at.normal.dot(way) * at.normal;
        if (radius_ > 0)
            return sign_ / (radius_ + sign_ * at.distance) * across;
        if (flat_)
            return Vec<D>::Zero();
        const Shape<D>& shape = shape_.shape();
        const auto bar = shape.round_bar();
        if (!bar)
            return Vec<D>::Zero();
        const double sign = shape.inside_out() ? -1 : 1, radius = bar->radius / dx_;
        const Vec<D> axis = shape_.rotation().col(0), from = at.x - in_cells(shape_.to_world(Vec<D>::Zero()));
        const bool side = bar->flat ? at.face >= 2 : std::abs(axis.dot(from)) < bar->half / dx_;
        if (side ? D == 2 : bar->flat)
            return Vec<D>::Zero();
        return sign / (radius + sign * at.distance) * (side ? Vec<D>(across - axis.dot(way) * axis) : across);
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
    /// Whether both are balls that turn about their centres, or one of them and a flat wall that stands still (gap_round.hpp).
    bool round() const { return round_; }
    void set_round(bool round) { round_ = round; }
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
    bool round_ = false;
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

/// How a section was found: in both passes the place, and the walls' points nearest to it.
template <int D>
struct SectionTrace {
    std::array<Vec<D>, 2> place;
    std::array<std::array<WallPoint<D, double>, 2>, 2> wall;
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
    std::optional<Profile> profile(const Place& x, const Place& n, GapStop* stop = nullptr,
                                   SectionTrace<D>* trace = nullptr) const
    {
        Profile profile;
        std::array<Place, 2> foot;
        std::array<S, 2> cosine;
        if (!find(x, n, profile, foot, cosine, stop, trace))
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
    bool find(Place x, const Place& n, Profile& at, std::array<Place, 2>& foot, std::array<S, 2>& cosine, GapStop* stop,
              SectionTrace<D>* trace = nullptr) const
    {
        const auto stopped = [&](int pass, int side, bool edge) {
            if (stop)
                *stop = {pass, side, edge};
            return false;
        };
        for (int pass = 0; pass < 2; ++pass) { // the second one from the middle
            std::array<S, 2> way;
            if constexpr (std::is_same_v<S, double>)
                if (trace)
                    trace->place[pass] = x;
            for (int side = 0; side < 2; ++side) {
                const WallPoint<D, S> point = this->nearest(side, x, pass == 0 || extended_ ? face_[side] : -1);
                if constexpr (std::is_same_v<S, double>)
                    if (trace)
                        trace->wall[pass][side] = point;
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

} // namespace gapflow
