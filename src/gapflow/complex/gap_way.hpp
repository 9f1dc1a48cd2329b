// Gaps as the faces of the grid cut them: the way along a gap from node to node, and the integrals along it.
#pragma once

#include "gapflow/complex/gap_moving.hpp"

#include <algorithm>
#include <cmath>
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
    S bend;               ///< second derivative of the thickness along the way, without the negative part of the Hessian
    S share;              ///< e . Sigma way: of the closing that flows along the way
    S curvature = S(0.0); ///< trace of that Hessian
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

/// `here`: the gap at x. The way is along e.
template <int D, class Walls>
GapShape<D, typename Walls::Scalar>
shape_of_gap(const FacingWalls<D, Walls>& walls, const PlaceOf<D, typename Walls::Scalar>& x,
             const PlaceOf<D, typename Walls::Scalar>& n, const GapProfile<D, Walls>& here,
             const PlaceOf<D, typename Walls::Scalar>& e, const PlaceOf<D, typename Walls::Scalar>& way)
{
    using S = typename Walls::Scalar;
    using Place = PlaceOf<D, S>;
    if constexpr (D == 2)
        return {S(0.0), S(e.dot(way) - n.dot(e) * n.dot(way))};
    else {
        const Place u = n.unitOrthogonal(), v = n.cross(u);
        const S& t = here.thickness;
        const PlaceOf<2, S> gradient = slope_along<D>(walls, x, n, here, u, v);
        const double h = 0.5;
        // Second derivative along d; where a wall ends on one side of x from the slope there.
        const auto second = [&](const Place& d, const S& slope) {
            S sum = 0;
            int found = 0;
            for (const double s : {-h, h})
                if (const auto at = thickness_at<D>(walls, step_along<D, S>(x, S(s), d), n)) {
                    sum += *at - t + s * slope;
                    ++found;
                }
            return found ? S(2.0 / (found * h * h) * sum) : S(0.0);
        };
        const double r = std::sqrt(0.5);
        Eigen::Matrix<S, 2, 2> hess;
        hess(0, 0) = second(u, gradient[0]);
        hess(1, 1) = second(v, gradient[1]);
        hess(0, 1) = hess(1, 0) =
            0.5 * (second(r * (u + v), r * (gradient[0] + gradient[1])) - second(r * (u - v), r * (gradient[0] - gradient[1])));
        const double faint = parameters.faint_curvature;
        const Eigen::Matrix<S, 2, 2> curvature = positive_part<S>(hess);
        const PlaceOf<2, S> along(way.dot(u), way.dot(v)), across(e.dot(u), e.dot(v));
        // Sigma = (curvature + faint/t gradient gradient^T + faint^2 t I) over its trace.
        const S steep = faint / t, level = faint * faint * t;
        const S share = across.dot(curvature * along) + steep * across.dot(gradient) * along.dot(gradient) +
                        level * across.dot(along),
                trace = curvature.trace() + steep * gradient.squaredNorm() + 2.0 * level;
        return {S(along.dot(curvature * along)), S(share / trace), curvature.trace()};
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

/// A way along a gap, divided for its quadrature. Beyond the end of a wall the gap goes on as it is at the face, at rest.
template <int D, class Walls>
class DividedWay {
public:
    using S = typename Walls::Scalar;
    using Place = PlaceOf<D, S>;

    /// Whether the walls meet on the way: it leads nowhere.
    bool meets() const { return low_.meet || high_.meet; }

protected:
    static constexpr FivePoints rule{};

    /// Keeps references to its arguments, but the thickness, which is that at `start`.
    DividedWay(const FacingWalls<D, Walls>& walls, const Place& start, const Place& way, const Place& n, const S& thickness,
               const typename Walls::Frame& frame)
        : walls_(walls), start_(start), way_(way), n_(n), thickness_(thickness), frame_(frame)
    {
        if (still().round())
            round_.emplace(still(), values_of<D>(start), values_of<D>(way), values_of<D>(n));
    }

    /// `bend`: second derivative of the thickness along the way.
    void divide(const S& from, const S& to, const S& bend)
    {
        low_ = end_towards(std::min(from, S(0.0)));
        high_ = end_towards(std::max(to, S(0.0)));
        thinnest_ = find_thinnest(low_, high_, bend);
        set_breaks({from, low_.at, S(0.0), high_.at, to}, low_.at, high_.at, thinnest_);
    }
    /// Whether the walls do not face each other in a stretch.
    bool beyond(std::size_t stretch) const { return breaks_[stretch] < low_.at || breaks_[stretch + 1] > high_.at; }
    /// Divides a stretch where the thickness changes too much within it.
    template <class Thicknesses>
    bool divides(std::size_t stretch, const S& length, const Thicknesses& t)
    {
        const auto [least, most] = std::minmax_element(t.begin(), t.end());
        if (!(*most > parameters.way_widening * *least && breaks_.size() < parameters.most_intervals &&
              length > parameters.least_stretch))
            return false;
        breaks_.insert(breaks_.begin() + static_cast<long>(stretch) + 1, S(breaks_[stretch] + 0.5 * length));
        return true;
    }

    /// Of the stretch on which the walls face each other.
    struct End {
        S at, growth, thickness; ///< there
        bool meet = false;
    };
    struct Thinnest {
        S at;     ///< the place between the ends
        S beyond; ///< and how far beyond it the gap is thinnest
        S length; ///< from `at` to where the thickness of a quadratic gap is zero, at complex places too
    };

    const FacingWalls<D, Walls>& walls_;
    const Place &start_, &way_, &n_;
    S thickness_;
    const typename Walls::Frame& frame_;
    End low_{}, high_{};
    Thinnest thinnest_{};
    std::vector<S> breaks_;
    std::optional<RoundLine<D>> round_; ///< the same way of round walls

private:
    static constexpr int most_steps = 30; ///< of a root's search

    const GapWalls<D>& still() const
    {
        if constexpr (std::is_same_v<S, double>)
            return walls_;
        else
            return walls_.still();
    }
    /// The still walls' way.
    std::optional<Growth<double>> still_at(double s, GapStop* stop = nullptr) const
    {
        if (round_) {
            if (const auto found = round_->at(s, stop))
                return Growth<double>{found->thickness, found->growth};
            return {};
        }
        const Vec<D> way = values_of<D>(way_);
        if (const auto found = still().profile(step_along<D>(values_of<D>(start_), s, way), values_of<D>(n_), stop))
            return Growth<double>{found->thickness, -found->slope.dot(way)};
        return {};
    }

    /// `limit`, or where a wall ends before it, or where the walls meet.
    End end_towards(const S& limit) const
    {
        GapStop stop;
        const auto found = still_at(value_of(limit), &stop);
        if constexpr (std::is_same_v<S, double>)
            if (found)
                return {limit, found->growth, found->thickness};
        if (found)
            return end_at(limit, growth_at<D>(walls_, step_along<D, S>(start_, limit, way_), n_, way_));
        double in = 0, out = value_of(limit);
        for (double middle = 0.5 * out; middle != in && middle != out; middle = 0.5 * (in + out))
            (still_at(middle, &stop) ? in : out) = middle;
        S at = S(in);
        if constexpr (!std::is_same_v<S, double>)
            at = S::root(in, walls_.margin(step_along<D, S>(start_, S::along(in), way_), n_, stop));
        End end = end_at(at, growth_at<D>(walls_, step_along<D, S>(start_, at, way_), n_, way_));
        end.meet = stop.meet();
        return end;
    }
    End end_at(const S& at, const std::optional<Growth<S>>& there) const
    {
        if (!there)
            return {at, S(0.0), thickness_};
        return {at, there->growth, there->thickness};
    }

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
        double end[2] = {value_of(low.at), value_of(high.at)}, weight[2] = {value_of(low.growth), value_of(high.growth)},
               place = end[0], thickness = value_of(thickness_);
        for (int k = 0, last = -1; k < most_steps; ++k) {
            const double before = std::exchange(place, end[0] + weight[0] / (weight[0] - weight[1]) * (end[1] - end[0]));
            const auto found = still_at(place);
            if (!found)
                break;
            thickness = found->thickness;
            const double here = found->growth;
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
            if (const auto found = growth_at<D>(walls_, step_along<D, S>(start_, S::along(place), way_), n_, way_)) {
                const S at = S::root(place, found->growth);
                return {at, thickness_at<D>(walls_, step_along<D, S>(start_, at, way_), n_).value_or(thickness_)};
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
};

/// Rows and thickness along a gap, and their integrals over pieces of it. Rows of twists, or, of round walls, of the first wall's velocity less the second
/// one's.
template <int D, class Row = PairTwist<D>>
class GapWay : public DividedWay<D, StillWalls<D>> {
public:
    using DividedWay<D, StillWalls<D>>::rule;

    struct Point {
        double weight, thickness;
        Row flux; ///< D
    };

    GapWay(const GapWalls<D>& walls, const Vec<D>& start, const Vec<D>& way, const Vec<D>& n, double thickness,
           const typename StillWalls<D>::Frame& frame)
        : DividedWay<D, StillWalls<D>>(walls, start, way, n, thickness, frame)
    {
    }

    /// Quadrature of the stretch from .. to of the way. D is 0 where the gap is thinnest along the way: of a quadratic thickness there is no flux
    /// across the line on which it does not change along the way. `bend`: second derivative of the thickness along the way. `from_start`: D is 0 at
    /// the face, as in 2D.
    std::vector<Point> points(double from, double to, double sigma, double bend, bool from_start = D == 2)
    {
        constexpr int n = FivePoints::points;
        this->divide(from, to, bend);
        const auto& thinnest = this->thinnest_;
        const std::vector<double>& breaks = this->breaks_;
        std::vector<Point> result;
        result.reserve(n * breaks.size());
        Row here = Row::Zero(), zero = here;
        const auto pass = [&](double s) {
            if (s == 0.0)
                at_face_ = here;
            if (!from_start && s == thinnest.at) {
                zero = here;
                if (thinnest.beyond != 0.0)
                    zero -= sigma * thinnest.beyond * opening_at(s);
            }
        };
        for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
            const double length = breaks[k + 1] - breaks[k];
            std::array<Row, n> rate;
            std::array<double, n> t;
            if (this->beyond(k)) {
                rate.fill(Row::Zero());
                t.fill(this->thickness_);
            } else {
                find(breaks[k], length, rate, t);
                if (this->divides(k, length, t)) {
                    --k;
                    continue;
                }
            }
            pass(breaks[k]);
            if (breaks[k] >= from && breaks[k] < to)
                for (int g = 0; g < n; ++g) {
                    Point point{rule.weight[g] * length, t[g], here};
                    for (int h = 0; h < n; ++h)
                        point.flux -= sigma * length * rule.up_to[g][h] * rate[h];
                    result.push_back(point);
                }
            for (int h = 0; h < n; ++h)
                here -= sigma * length * rule.weight[h] * rate[h];
        }
        pass(breaks.back());
        if (from_start)
            zero = at_face_;
        for (Point& point : result)
            point.flux -= zero;
        at_face_ -= zero;
        return result;
    }
    /// D at the face, after points().
    const Row& at_face() const { return at_face_; }

private:
    /// Opening in the frame of the walls' mean motion, and thickness, at Gauss's points of a stretch.
    void find(double from, double length, std::array<Row, FivePoints::points>& rate, std::array<double, FivePoints::points>& t,
              int n = FivePoints::points) const
    {
        if constexpr (std::is_same_v<Row, Vec<D>>) {
            typename RoundLine<D>::Places at;
            RoundNumbers s = RoundNumbers::Constant(from);
            for (int g = 0; g < n; ++g)
                s[g] += rule.node[g] * length;
            this->round_->find(s, at);
            for (int g = 0; g < n; ++g) {
                t[g] = at.face[g] ? at.thickness[g] : this->thickness_;
                rate[g] = at.face[g] ? this->round_->opening(at, g) : Row::Zero().eval();
            }
        } else
            for (int g = 0; g < n; ++g) {
                const auto found =
                    this->walls_.across(step_along<D>(this->start_, from + rule.node[g] * length, this->way_), this->n_);
                t[g] = found ? found->thickness : this->thickness_;
                rate[g] = found ? Row(found->opening - StillWalls<D>::along(this->frame_, found->slope)) : Row::Zero().eval();
            }
    }
    Row opening_at(double s) const
    {
        std::array<Row, FivePoints::points> rate;
        std::array<double, FivePoints::points> t;
        find(s, 0, rate, t, 1);
        return rate[0];
    }

    Row at_face_ = Row::Zero();
};

} // namespace gapflow
