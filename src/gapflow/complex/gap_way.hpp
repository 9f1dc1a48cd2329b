// Gaps as the faces of the grid cut them: the way along a gap from node to node, and the integrals along it.
#pragma once

#include "gapflow/complex/gap_walls.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace gapflow {

inline Vec<2> left_of(const Vec<2>& x)
{
    return {-x[1], x[0]};
}

/// 1 up to `start`, 0 from `end` on.
template <class S>
S share_up_to(const S& thickness, double start, double end)
{
    const S x = std::clamp(S((end - thickness) / (end - start)), S(0.0), S(1.0));
    return x * x * (3 - 2 * x);
}

/// Images of the solids that come within `margin` of a complex's block.
template <int D>
std::vector<Image<D>> images_at(const Grid<D>& grid, const GridPlanes<D>& planes, const DenseIndex<D>& index,
                                std::span<const Solid<D>> solids, double margin)
{
    Vec<D> period = Vec<D>::Zero(), low, high;
    for (int axis = 0; axis < D; ++axis) {
        if (grid.periodic(axis))
            period[axis] = grid.size()[axis];
        low[axis] = planes.place[axis][index.low[axis]];
        high[axis] = planes.place[axis][index.high()[axis]];
    }
    return images(solids, planes.in_world(low), planes.in_world(high), period, margin);
}

/// Mean motion of the walls at x, by their twists: their translation, and what of their rotation moves them along their normals.
template <int D>
Eigen::Matrix<double, D, 2 * twist_size<D>> mean_motion(const GapWalls<D>& walls, const std::array<Vec<D>, 2>& normal,
                                                        const Vec<D>& x)
{
    Eigen::Matrix<double, D, 2 * twist_size<D>> frame;
    for (int side = 0; side < 2; ++side) {
        const Vec<D>& m = normal[side];
        const Twist<D> turning = speed_along<D>(m, x, walls.reference[side]);
        auto columns = frame.template middleCols<twist_size<D>>(side * twist_size<D>);
        columns.template leftCols<D>() = 0.5 * Mat<D>::Identity();
        columns.template rightCols<spin_size<D>>() = 0.5 * m * turning.template tail<spin_size<D>>().transpose();
    }
    return frame;
}
template <int D>
typename MovingWalls<D>::Frame mean_motion(const FacingWalls<D, MovingWalls<D>>& walls,
                                           const std::array<typename MovingWalls<D>::Place, 2>& normal,
                                           const typename MovingWalls<D>::Place& x)
{
    using S = typename MovingWalls<D>::Scalar;
    typename MovingWalls<D>::Frame frame = MovingWalls<D>::Frame::Constant(S(0));
    for (int side = 0; side < 2; ++side) {
        const auto turning = moment_of<D, S>(x - walls.reference_of(side), normal[side]);
        for (int k = 0; k < D; ++k)
            frame[k] += walls.row(side, 0.5 * PlaceOf<D, S>(unit<D>(k).template cast<S>()), 0.5 * normal[side][k] * turning);
    }
    return frame;
}

/// In the plane of a gap.
template <int D, class S = double>
struct GapShape {
    Eigen::Matrix<S, D, D> curvature; ///< the Hessian of the thickness, without its negative part
    Eigen::Matrix<S, D, D> shares;    ///< of the closing that flow in each direction, of trace 1
};

/// A symmetric matrix without its negative part.
template <class S>
Eigen::Matrix<S, 2, 2> positive_part(const Eigen::Matrix<S, 2, 2>& A)
{
    using std::hypot;
    const S mean = 0.5 * A.trace(), radius = hypot(S(0.5 * (A(0, 0) - A(1, 1))), A(0, 1));
    if (mean >= radius)
        return A;
    if (mean <= -radius)
        return Eigen::Matrix<S, 2, 2>::Zero();
    return (mean + radius) / (2 * radius) * (A - (mean - radius) * Eigen::Matrix<S, 2, 2>::Identity());
}

/// `here`: the gap at x.
template <int D, class Walls>
GapShape<D, typename Walls::Scalar> shape_of_gap(const FacingWalls<D, Walls>& walls,
                                                 const PlaceOf<D, typename Walls::Scalar>& x,
                                                 const PlaceOf<D, typename Walls::Scalar>& n, const SectionOf<D, Walls>& here)
{
    using S = typename Walls::Scalar;
    using Place = PlaceOf<D, S>;
    if constexpr (D == 2)
        return {Eigen::Matrix<S, 2, 2>::Zero(), Eigen::Matrix<S, 2, 2>::Identity() - n * n.transpose()};
    else {
        const Place u = n.unitOrthogonal(), v = n.cross(u);
        const S t = here.thickness;
        const double h = 0.5;
        // Second derivative along d; where a wall ends on one side of x from the slope there.
        const auto second = [&](const Place& d) {
            S sum = 0;
            int found = 0;
            for (const double s : {-h, h})
                if (const auto at = walls.profile(step_along<D, S>(x, S(s), d), n)) {
                    sum += at->thickness - t + s * here.slope.dot(d);
                    ++found;
                }
            return found ? S(2.0 / (found * h * h) * sum) : S(0.0);
        };
        const double r = std::sqrt(0.5);
        Eigen::Matrix<S, 2, 2> hess;
        hess(0, 0) = second(u);
        hess(1, 1) = second(v);
        hess(0, 1) = hess(1, 0) = 0.5 * (second(r * (u + v)) - second(r * (u - v)));
        const PlaceOf<2, S> gradient(here.slope.dot(u), here.slope.dot(v));
        const double e = parameters.faint_curvature;
        const Eigen::Matrix<S, 2, 2> curvature = positive_part<S>(hess);
        Eigen::Matrix<S, 2, 2> shares = curvature;
        shares += e / t * gradient * gradient.transpose() + e * e * t * Eigen::Matrix<S, 2, 2>::Identity();
        shares /= shares.trace();
        Eigen::Matrix<S, 3, 2> plane;
        plane << u, v;
        return {plane * curvature * plane.transpose(), plane * shares * plane.transpose()};
    }
}

/// Gauss's points of 0 .. 1, and the weights of integrals from 0 to each of them.
struct ThreePoints {
    static constexpr double root = 3.872983346207417; // of 15
    static constexpr std::array<double, 3> node{0.5 - root / 10, 0.5, 0.5 + root / 10}, weight{5.0 / 18, 4.0 / 9, 5.0 / 18};
    static constexpr std::array<std::array<double, 3>, 3> collocation{{{5.0 / 36, 2.0 / 9 - root / 15, 5.0 / 36 - root / 30},
                                                                       {5.0 / 36 + root / 24, 2.0 / 9, 5.0 / 36 - root / 24},
                                                                       {5.0 / 36 + root / 30, 2.0 / 9 + root / 15, 5.0 / 36}}};
};
struct FivePoints {
    static constexpr int points = 5;
    std::array<double, points> node{0.046910077030668, 0.23076534494715845, 0.5, 0.7692346550528415, 0.953089922969332},
        weight{0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324, 0.11846344252809454};
    std::array<std::array<double, points>, points> up_to{};

    constexpr FivePoints()
    {
        for (int h = 0; h < points; ++h) {
            std::array<double, points> factors{1}; // of Lagrange's polynomial, by powers
            for (int other = 0, degree = 0; other < points; ++other)
                if (other != h) {
                    ++degree;
                    for (int power = degree; power >= 0; --power)
                        factors[power] =
                            ((power > 0 ? factors[power - 1] : 0.0) - node[other] * factors[power]) / (node[h] - node[other]);
                }
            for (int g = 0; g < points; ++g) {
                double sum = 0;
                for (int power = points - 1; power >= 0; --power)
                    sum = (sum + factors[power] / (power + 1)) * node[g];
                up_to[g][h] = sum;
            }
        }
    }
};

/// Rows and thickness along a gap, and their integrals over pieces of it. Beyond the end of a wall the gap goes on as it is at the face, at rest.
template <int D, class Walls = StillWalls<D>>
class GapWay {
public:
    using S = typename Walls::Scalar;
    using Row = typename Walls::Row;
    using Place = PlaceOf<D, S>;

    struct Point {
        S weight, thickness;
        Row flux; ///< D
    };

    /// Keeps references to its arguments, but the thickness, which is that at `start`.
    GapWay(const FacingWalls<D, Walls>& walls, const Place& start, const Place& way, const Place& n, const S& thickness,
           const typename Walls::Frame& frame)
        : walls_(walls), start_(start), way_(way), n_(n), thickness_(thickness), frame_(frame)
    {
    }

    /// Quadrature of the stretch from .. to of the way. D is 0 where the gap is thinnest along the way: of a quadratic thickness there is no flux
    /// across the line on which it does not change along the way. `bend`: second derivative of the thickness along the way. `from_start`: D is 0 at
    /// the face, as in 2D.
    std::vector<Point> points(const S& from, const S& to, const S& sigma, const S& bend, bool from_start = D == 2)
    {
        constexpr int n = FivePoints::points;
        const End low = end_towards(std::min(from, S(0.0))), high = end_towards(std::max(to, S(0.0)));
        meets_ = low.meet || high.meet;
        const Thinnest thinnest = find_thinnest(low, high, bend);
        set_breaks({from, low.at, S(0.0), high.at, to}, low.at, high.at, thinnest);
        std::vector<Point> result;
        result.reserve(n * breaks_.size());
        Row here = Walls::none(), zero = here;
        const auto pass = [&](const S& s) {
            if (s == 0.0)
                at_face_ = here;
            if (!from_start && s == thinnest.at) {
                zero = here;
                if (thinnest.beyond != 0.0)
                    zero -= sigma * thinnest.beyond * at(s).first;
            }
        };
        for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
            const S length = breaks_[k + 1] - breaks_[k];
            std::array<Row, n> rate;
            std::array<S, n> t;
            if (breaks_[k] < low.at || breaks_[k + 1] > high.at) {
                rate.fill(Walls::none());
                t.fill(thickness_);
            } else {
                for (int g = 0; g < n; ++g)
                    std::tie(rate[g], t[g]) = at(breaks_[k] + rule.node[g] * length);
                const auto [least, most] = std::minmax_element(t.begin(), t.end());
                if (*most > parameters.way_widening * *least && breaks_.size() < parameters.most_intervals &&
                    length > parameters.least_stretch) {
                    breaks_.insert(breaks_.begin() + static_cast<long>(k) + 1, S(breaks_[k] + 0.5 * length));
                    --k;
                    continue;
                }
            }
            pass(breaks_[k]);
            if (breaks_[k] >= from && breaks_[k] < to)
                for (int g = 0; g < n; ++g) {
                    Point point{rule.weight[g] * length, t[g], here};
                    for (int h = 0; h < n; ++h)
                        point.flux -= sigma * length * rule.up_to[g][h] * rate[h];
                    result.push_back(point);
                }
            for (int h = 0; h < n; ++h)
                here -= sigma * length * rule.weight[h] * rate[h];
        }
        pass(breaks_.back());
        if (from_start)
            zero = at_face_;
        for (Point& point : result)
            point.flux -= zero;
        at_face_ -= zero;
        return result;
    }
    /// D at the face, after points().
    const Row& at_face() const { return at_face_; }
    /// Whether the walls meet on the way, after points(): it leads nowhere.
    bool meets() const { return meets_; }

private:
    static constexpr FivePoints rule{};
    static constexpr int most_steps = 30; ///< of a root's search

    const GapWalls<D>& still() const
    {
        if constexpr (std::is_same_v<S, double>)
            return walls_;
        else
            return walls_.still();
    }
    /// The still walls' way.
    std::optional<GapProfile<D, StillWalls<D>>> still_at(double s, GapStop* stop = nullptr) const
    {
        return still().profile(step_along<D>(values_of<D>(start_), s, values_of<D>(way_)), values_of<D>(n_), stop);
    }

    /// Of the stretch on which the walls face each other.
    struct End {
        S at, growth, thickness; ///< there
        bool meet = false;
    };
    /// `limit`, or where a wall ends before it, or where the walls meet.
    End end_towards(const S& limit) const
    {
        GapStop stop;
        const auto found = still_at(value_of(limit), &stop);
        if constexpr (std::is_same_v<S, double>)
            if (found)
                return end_at(limit, found);
        if (found)
            return end_at(limit, walls_.profile(step_along<D, S>(start_, limit, way_), n_));
        double in = 0, out = value_of(limit);
        for (double middle = 0.5 * out; middle != in && middle != out; middle = 0.5 * (in + out))
            (still_at(middle, &stop) ? in : out) = middle;
        S at = S(in);
        if constexpr (!std::is_same_v<S, double>)
            at = S::root(in, walls_.margin(step_along<D, S>(start_, S::along(in), way_), n_, stop));
        End end = end_at(at, walls_.profile(step_along<D, S>(start_, at, way_), n_));
        end.meet = stop.meet();
        return end;
    }
    End end_at(const S& at, const std::optional<GapProfile<D, Walls>>& there) const
    {
        if (!there)
            return {at, S(0.0), thickness_};
        return {at, S(-there->slope.dot(way_)), there->thickness};
    }

    struct Thinnest {
        S at;     ///< the place between the ends
        S beyond; ///< and how far beyond it the gap is thinnest
        S length; ///< from `at` to where the thickness of a quadratic gap is zero, at complex places too
    };
    Thinnest find_thinnest(const End& low, const End& high, const S& bend) const
    {
        using std::abs;
        const S curvature = high.at > low.at ? std::max(S(0.0), S((high.growth - low.growth) / (high.at - low.at))) : S(0.0);
        for (const End* end : {&low, &high})
            if (const S& g = end->growth; end == &low ? g >= 0.0 : g <= 0.0) {
                Thinnest result{end->at, S(0.0), length_of(end->thickness, g, curvature)};
                if (g != 0.0)
                    result.beyond = -g / std::max({bend, S(0.5 * g * g / end->thickness), S(abs(g))});
                return result;
            }
        const auto [at, thickness] = root_of_growth(low, high);
        return {at, S(0.0), length_of(thickness, S(0.0), curvature)};
    }
    /// Place and thickness: a false position that lets neither end stand.
    std::pair<S, S> root_of_growth(const End& low, const End& high) const
    {
        const Vec<D> way = values_of<D>(way_);
        double end[2] = {value_of(low.at), value_of(high.at)}, weight[2] = {value_of(low.growth), value_of(high.growth)},
               place = end[0], thickness = value_of(thickness_);
        for (int k = 0, last = -1; k < most_steps; ++k) {
            const double before = std::exchange(place, end[0] + weight[0] / (weight[0] - weight[1]) * (end[1] - end[0]));
            const auto found = still_at(place);
            if (!found)
                break;
            thickness = found->thickness;
            const double here = -found->slope.dot(way);
            if (here == 0 || std::abs(place - before) < 16 * std::numeric_limits<double>::epsilon())
                break;
            const int side = here < 0 ? 0 : 1;
            end[side] = place;
            weight[side] = here;
            if (side == last)
                weight[1 - side] *= 0.5;
            last = side;
        }
        if constexpr (!std::is_same_v<S, double>)
            if (const auto found = walls_.profile(step_along<D, S>(start_, S::along(place), way_), n_)) {
                const S at = S::root(place, found->slope.dot(way_));
                const auto there = walls_.profile(step_along<D, S>(start_, at, way_), n_);
                return {at, there ? there->thickness : thickness_};
            }
        return {S(place), S(thickness)};
    }
    static S length_of(const S& t, const S& growth, const S& curvature)
    {
        using std::abs;
        using std::sqrt;
        const S square = growth * growth - 2.0 * curvature * t;
        return square > 0.0      ? S(2.0 * t / (abs(growth) + sqrt(square)))
               : curvature > 0.0 ? S(sqrt(S(2.0 * t / curvature)))
                                 : S(std::numeric_limits<double>::infinity());
    }

    /// At all ends, and between low and high at lengths from the thinnest place that double: as far from where the thickness is zero as the
    /// intervals are long.
    void set_breaks(std::array<S, 5> ends, const S& low, const S& high, const Thinnest& thinnest)
    {
        std::sort(ends.begin(), ends.end());
        breaks_.assign(1, ends[0]);
        for (const S& end : ends)
            if (end > breaks_.back())
                breaks_.push_back(end);
        const auto add = [&](const S& s) {
            const auto after = std::lower_bound(breaks_.begin(), breaks_.end(), s);
            if (after == breaks_.end() || *after != s)
                breaks_.insert(after, s);
        };
        add(thinnest.at);
        if (!(thinnest.length > parameters.least_stretch))
            return;
        for (const double side : {-1.0, 1.0})
            for (S from = thinnest.length;; from = 2.0 * from + thinnest.length) {
                const S s = thinnest.at + side * from;
                if (!(side < 0 ? s > low : s < high))
                    break;
                add(s);
            }
    }

    /// Opening in the frame of the walls' mean motion, and thickness.
    std::pair<Row, S> at(const S& s) const
    {
        const auto found = walls_.across(step_along<D, S>(start_, s, way_), n_);
        if (!found)
            return {Walls::none(), thickness_};
        return {found->opening - Walls::along(frame_, found->slope), found->thickness};
    }

    const FacingWalls<D, Walls>& walls_;
    const Place &start_, &way_, &n_;
    S thickness_;
    const typename Walls::Frame& frame_;
    std::vector<S> breaks_;
    Row at_face_ = Walls::none();
    bool meets_ = false;
};

/// Place of a piece of a face in a gap.
template <int D, class Walls>
struct GapPlace {
    using S = typename Walls::Scalar;
    using Place = PlaceOf<D, S>;

    FacingWalls<D, Walls> walls;
    Place n;                  ///< from the first wall to the second one
    SectionOf<D, Walls> here; ///< at the piece's centroid
    S facing;                 ///< cosine of the angle between the walls there
    // The way from node to node is centroid + s way, middle - 1/2 <= s <= middle + 1/2.
    double delta = 1; ///< distance of the nodes along the face's axis
    Place e = Place::Constant(S(0.0)), way = Place::Constant(S(0.0));
    S middle = S(0.0);
    Place nodes = Place::Constant(S(0.0)); ///< the middle between the two
    std::array<S, 2> moved{};              ///< of its two ends: nodes that mouths move
    // 3D: the piece lies around centroid + s line, from <= s <= to or the other way round.
    Place line = Place::Constant(S(0.0));
    S from = S(0.0), to = S(0.0);

    bool along_face() const { return !(value_of(S(way.squaredNorm())) > parameters.parallel * parameters.parallel); }
};

/// A piece of a face in a gap.
template <int D>
struct GapSite : GapPlace<D, StillWalls<D>> {
    std::int32_t piece;
    std::array<std::int32_t, 2> solid;
    std::array<bool, 2> still; ///< closed sides of the domain: they never move
    std::array<bool, 2> round; ///< balls that turn about their centres: that moves nothing
    Standoff<D> standoff;
};

/// Of all pieces of the complex that lie in gaps, in their order.
template <int D>
void for_each_gap(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                  const Standoffs<D>& standoffs, const std::function<void(const GapSite<D>&)>& visit);

} // namespace gapflow
