// The way along a gap between round walls with the derivatives of all that its integrals need, by the few variables of gap_round_moving.hpp but the last.
#pragma once

#include "gapflow/complex/gap_round_moving.hpp"
#include "gapflow/complex/gap_way.hpp"

#include <vector>

namespace gapflow {

/// Derivatives by the places of the two walls and by the centroid.
template <int D>
using RoundRates = Eigen::Array<double, 3 * D - 1, 1>;
template <int D>
RoundRates<D> rates_of(const RoundNumber<D>& x)
{
    return Eigen::Map<const RoundRates<D>>(x.rate.data());
}

/// A row that a difference of velocities is multiplied by. Rates by columns.
template <int D>
struct RoundRow {
    Vec<D> value;
    Eigen::Array<double, 3 * D - 1, D> rate;

    static RoundRow zero() { return {Vec<D>::Zero(), Eigen::Array<double, 3 * D - 1, D>::Zero()}; }
    /// += factor other, with the rates of the factor.
    void add(double factor, const RoundRates<D>& rates, const RoundRow& other)
    {
        value += factor * other.value;
        for (int k = 0; k < D; ++k)
            rate.col(k) += factor * other.rate.col(k) + other.value[k] * rates;
    }
    void scale(double factor, const RoundRates<D>& rates)
    {
        for (int k = 0; k < D; ++k)
            rate.col(k) = factor * rate.col(k) + value[k] * rates;
        value *= factor;
    }
    void add(double factor, const RoundRow& other)
    {
        value += factor * other.value;
        rate += factor * other.rate;
    }
    RoundRow& operator-=(const RoundRow& other)
    {
        value -= other.value;
        rate -= other.rate;
        return *this;
    }
};

template <int D>
class RoundWay : public DividedWay<D, MovingRoundWalls<D>> {
public:
    using S = RoundNumber<D>;
    using Place = PlaceOf<D, S>;
    using Rates = RoundRates<D>;
    using Base = DividedWay<D, MovingRoundWalls<D>>;
    using Base::rule;
    static constexpr int n = FivePoints::points;

    struct Point {
        double weight, thickness;
        Rates weight_rate, thickness_rate;
        RoundRow<D> flux; ///< D
    };

    RoundWay(const FacingWalls<D, MovingRoundWalls<D>>& walls, const Place& start, const Place& way, const Place& normal,
             const S& thickness)
        : Base(walls, start, way, normal, thickness, way), way_(values_of<D>(way)) // round walls have no frame
    {
        const S square = way.squaredNorm();
        square_ = square.value;
        by_square_ = rates_of<D>(square);
        standoff_rate_ = rates_of<D>(walls.standoff());
        for (int k = 0; k < D; ++k)
            way_rate_.col(k) = rates_of<D>(way[k]);
        for (int i = 0; i < 2; ++i) {
            Side& side = side_[i];
            const GapWall<D>& wall = walls.wall(i);
            side.sign = i == 0 ? 1 : -1;
            side.radius = wall.radius();
            const Place from = start - walls.point(i);
            if (side.radius > 0) {
                const S z = normal.dot(from);
                const Place p = from - z * normal;
                const S along = p.dot(way);
                set(side, z, along);
                side.by_square = rates_of<D>(S(p.squaredNorm()));
                for (int k = 0; k < D; ++k) {
                    side.p[k] = p[k].value;
                    side.p_rate.col(k) = rates_of<D>(p[k]);
                    force_rate_.col(k) -= 0.5 * rates_of<D>(normal[k]); // -sign n of both
                }
            } else {
                const Place out = wall.normal().template cast<S>();
                const S cosine = side.sign * normal.dot(out);
                set(side, S(out.dot(from)), S(out.dot(way)));
                side.cosine = cosine.value;
                side.by_cosine = rates_of<D>(cosine);
                for (int k = 0; k < D; ++k)
                    force_rate_.col(k) += 0.5 * side.sign * wall.normal()[k] / (side.cosine * side.cosine) * side.by_cosine;
            }
        }
    }

    /// As GapWay::points.
    void find_points(const S& from, const S& to, const S& sigma, const S& bend)
    {
        this->divide(from, to, bend);
        const auto& breaks = this->breaks_;
        const double share = sigma.value;
        const Rates share_rate = rates_of<D>(sigma);
        points_.reserve(n * breaks.size());
        RoundRow<D> here = RoundRow<D>::zero(), zero = here;
        const auto pass = [&](const S& s) {
            if (s == 0.0)
                at_face_ = here;
            if (D == 3 && s == this->thinnest_.at) {
                zero = here;
                if (const S& beyond = this->thinnest_.beyond; beyond != 0.0) {
                    Nodes nodes;
                    find(s, s, 1, nodes);
                    const S factor = -sigma * beyond;
                    zero.add(factor.value, rates_of<D>(factor), nodes[0].opening);
                }
            }
        };
        for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
            const double length = breaks[k + 1].value - breaks[k].value;
            const Rates length_rate = rates_of<D>(breaks[k + 1]) - rates_of<D>(breaks[k]);
            Nodes nodes;
            if (!this->beyond(k)) {
                find(breaks[k], breaks[k + 1], n, nodes);
                std::array<double, n> t;
                for (int g = 0; g < n; ++g)
                    t[g] = nodes[g].thickness;
                if (this->divides(k, S(breaks[k + 1] - breaks[k]), t)) {
                    --k;
                    continue;
                }
            } else
                for (Node& node : nodes)
                    set_end(node);
            pass(breaks[k]);
            const Rates flows_rate = -share * length_rate - length * share_rate;
            for (Node& node : nodes) // what flows out on the stretch
                node.opening.scale(-share * length, flows_rate);
            if (breaks[k] >= from && breaks[k] < to)
                for (int g = 0; g < n; ++g) {
                    Point& point = points_.emplace_back(Point{rule.weight[g] * length, nodes[g].thickness,
                                                              rule.weight[g] * length_rate, nodes[g].thickness_rate, here});
                    for (int h = 0; h < n; ++h)
                        point.flux.add(rule.up_to[g][h], nodes[h].opening);
                }
            for (int h = 0; h < n; ++h)
                here.add(rule.weight[h], nodes[h].opening);
        }
        pass(breaks.back());
        if (D == 2)
            zero = at_face_;
        for (Point& point : points_)
            point.flux -= zero;
        at_face_ -= zero;
    }
    const std::vector<Point>& points() const { return points_; }
    /// D at the face.
    const RoundRow<D>& at_face() const { return at_face_; }

private:
    /// As RoundLine::Side, with rates.
    struct Side {
        double sign = 1, radius = 0; ///< of a ball, else 0
        double z = 0, along = 0;     ///< of a plane: distance and slope
        Rates by_z, by_along, by_square;
        Vec<D> p;
        Eigen::Array<double, 3 * D - 1, D> p_rate;
        double cosine = 1; ///< of a plane
        Rates by_cosine;
    };
    static void set(Side& side, const S& z, const S& along)
    {
        side.z = z.value;
        side.along = along.value;
        side.by_z = rates_of<D>(z);
        side.by_along = rates_of<D>(along);
    }

    struct Node {
        double thickness;
        Rates thickness_rate;
        RoundRow<D> opening;
    };
    using Nodes = std::array<Node, n>;

    /// Beyond the end of a wall.
    void set_end(Node& node) const
    {
        node.thickness = this->thickness_.value;
        node.thickness_rate = rates_of<D>(this->thickness_);
        node.opening = RoundRow<D>::zero();
    }
    /// Sections at Gauss's points between two places.
    void find(const S& from, const S& to, int count, Nodes& nodes) const
    {
        typename RoundLine<D>::Places at;
        const double length = to.value - from.value;
        RoundNumbers s = RoundNumbers::Constant(from.value);
        for (int g = 0; g < count; ++g)
            s[g] += rule.node[g] * length;
        this->round_->find(s, at);
        for (int g = 0; g < count; ++g)
            if (at.face[g])
                set_node(at, g, (1 - rule.node[g]) * rates_of<D>(from) + rule.node[g] * rates_of<D>(to), nodes[g]);
            else
                set_end(nodes[g]);
    }
    /// A section at the place s, which has these rates.
    void set_node(const typename RoundLine<D>::Places& at, int g, const Rates& by_s, Node& node) const
    {
        const double s = at.s[g];
        std::array<Rates, 2> by_first, by_square;
        for (int i = 0; i < 2; ++i) {
            const Side& side = side_[i];
            const double first = at.first_way[i][g];
            if (!(side.radius > 0)) {
                by_first[i] = (side.by_z + s * side.by_along + side.along * by_s - first * side.by_cosine) / side.cosine;
                continue;
            }
            const double length = at.first_length[i][g], by_length = (2 * length - side.radius) * (side.sign / side.z);
            by_square[i] = side.by_square + 2 * s * side.by_along + s * s * by_square_ + 2 * (side.along + s * square_) * by_s;
            by_first[i] = (by_length * side.z / length - first / side.z) * side.by_z + 0.5 * by_length / length * by_square[i];
        }
        const Rates by_up = 0.5 * (by_first[1] - by_first[0]);
        Rates thickness = standoff_rate_;
        auto& opening = node.opening.rate;
        opening = force_rate_;
        const double between = at.inverse[0][g] - at.inverse[1][g];
        for (int i = 0; i < 2; ++i) {
            const Side& side = side_[i];
            if (!(side.radius > 0)) {
                thickness += by_first[i] + side.sign * by_up;
                continue;
            }
            const double height = at.height[i][g], length = at.length[i][g], inverse = at.inverse[i][g],
                         by_length = (2 * length - side.radius) * inverse,
                         by_height = by_length * height / length - (length - side.radius) * length * inverse / height;
            const Rates rise = side.by_z + by_up;
            thickness += by_height * rise + 0.5 * by_length / length * by_square[i];
            const double half = -0.5 * side.sign * inverse, by_rise = -half / height;
            for (int k = 0; k < D; ++k)
                opening.col(k) += half * side.p_rate.col(k) + by_rise * (side.p[k] + s * way_[k]) * rise;
        }
        for (int k = 0; k < D; ++k)
            opening.col(k) -= 0.5 * between * (s * way_rate_.col(k) + way_[k] * by_s);
        node.thickness = at.thickness[g];
        node.thickness_rate = thickness;
        if (!(node.thickness > place_unit))
            node.thickness_rate.setZero();
        node.opening.value = this->round_->opening(at, g);
    }

    Vec<D> way_;
    double square_; ///< of the way
    Rates by_square_, standoff_rate_;
    Eigen::Array<double, 3 * D - 1, D> way_rate_,
        force_rate_ = Eigen::Array<double, 3 * D - 1, D>::Zero(); ///< of half the difference of the forces of both sides
    std::array<Side, 2> side_;
    std::vector<Point> points_;
    RoundRow<D> at_face_ = RoundRow<D>::zero();
};

} // namespace gapflow
