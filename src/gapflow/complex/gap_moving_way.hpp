// The integrals along a gap with the derivatives by the places of its walls, backwards: the quadrature in plain numbers, then from the derivatives of an
// energy by each of its sums to those by what the way is made of. One pass costs as much as a few evaluations, whatever the number of variables.
#pragma once

#include "gapflow/complex/gap_way.hpp"

#include <vector>

namespace gapflow {

template <int D>
class MovingWay : public DividedWay<D, MovingWalls<D>> {
public:
    using S = MovingNumber<D>;
    using Place = PlaceOf<D, S>;
    using Base = DividedWay<D, MovingWalls<D>>;
    using Base::rule;
    static constexpr int n = FivePoints::points;

    struct Point {
        double weight, thickness, flux; ///< D
        double by_weight = 0, by_thickness = 0, by_flux = 0;
    };

    MovingWay(const FacingWalls<D, MovingWalls<D>>& walls, const Place& start, const Place& way, const Place& normal,
              const S& thickness, const typename MovingWalls<D>::Frame& frame)
        : Base(walls, start, way, normal, thickness, frame), start_value_(values_of<D>(start)), way_value_(values_of<D>(way)),
          normal_value_(values_of<D>(normal)), frame_value_(values_of<D>(frame))
    {
    }

    /// As GapWay::points, for the walls' twists.
    void find_points(const S& from, const S& to, const S& sigma, const S& bend)
    {
        this->divide(from, to, bend);
        sigma_ = sigma.value;
        stretches_.reserve(this->breaks_.size());
        points_.reserve(n * this->breaks_.size());
        traces_.reserve(this->breaks_.size());
        double here = 0, zero = 0;
        const auto pass = [&](const S& s) {
            if (s == 0.0)
                at_face_ = here;
            if (!from_start && s == this->thinnest_.at) {
                zero = here;
                if (this->thinnest_.beyond != 0.0) {
                    find(s.value, 0, 1, thinnest_place_);
                    zero -= sigma_ * this->thinnest_.beyond.value * thinnest_place_.node[0].rate;
                }
            }
        };
        for (std::size_t k = 0; k + 1 < this->breaks_.size(); ++k) {
            Stretch& stretch = stretches_.emplace_back();
            stretch.length = this->breaks_[k + 1].value - this->breaks_[k].value;
            if (!this->beyond(k)) {
                find(this->breaks_[k].value, stretch.length, n, stretch);
                std::array<double, n> t;
                for (int g = 0; g < n; ++g)
                    t[g] = stretch.node[g].thickness;
                if (this->divides(k, S(this->breaks_[k + 1] - this->breaks_[k]), t)) {
                    stretches_.pop_back();
                    --k;
                    continue;
                }
            } else
                for (Node& node : stretch.node)
                    node.thickness = this->thickness_.value;
            pass(this->breaks_[k]);
            if (this->breaks_[k] >= from && this->breaks_[k] < to) {
                stretch.first_point = static_cast<int>(points_.size());
                for (int g = 0; g < n; ++g) {
                    Point point{rule.weight[g] * stretch.length, stretch.node[g].thickness, here};
                    for (int h = 0; h < n; ++h)
                        point.flux -= sigma_ * stretch.length * rule.up_to[g][h] * stretch.node[h].rate;
                    points_.push_back(point);
                }
            }
            for (int h = 0; h < n; ++h)
                here -= sigma_ * stretch.length * rule.weight[h] * stretch.node[h].rate;
        }
        pass(this->breaks_.back());
        if (from_start)
            zero = at_face_;
        for (Point& point : points_)
            point.flux -= zero;
        at_face_ -= zero;
    }
    std::vector<Point>& points() { return points_; }
    double at_face() const { return at_face_; }

    /// Derivatives of a number by the start and by the thickness at it, and by what all ways of a piece share.
    struct Rates {
        Vec<D> way = Vec<D>::Zero();
        double sigma = 0;
        SectionRates<D> walls; ///< x: unused
    };
    /// The derivatives by the points' weights, thicknesses and fluxes, as points() has them, and by at_face(): to `rates`, and those by numbers of this way
    /// alone to `sum`.
    void add_rates(double by_at_face, Rates& rates, S& sum)
    {
        double by_zero = -by_at_face;
        for (const Point& point : points_)
            by_zero -= point.by_flux;
        if (from_start)
            by_at_face += by_zero;
        const int last = static_cast<int>(stretches_.size());
        by_break_.assign(last + 1, 0.0);
        double by_here = 0;
        for (int k = last; k >= 0; --k) {
            if (k < last)
                add_stretch(k, by_here, rates);
            const S& s = this->breaks_[k];
            if (s == 0.0)
                by_here += by_at_face;
            if (!from_start && s == this->thinnest_.at) {
                by_here += by_zero;
                if (const double beyond = this->thinnest_.beyond.value; beyond != 0) {
                    Node& node = thinnest_place_.node[0];
                    rates.sigma -= by_zero * beyond * node.rate;
                    sum.add_rates_of(this->thinnest_.beyond, -by_zero * sigma_ * node.rate);
                    node.by_rate = -by_zero * sigma_ * beyond;
                    by_break_[k] += add_nodes(thinnest_place_, 1, rates)[0];
                }
            }
        }
        for (int k = 0; k <= last; ++k)
            sum.add_rates_of(this->breaks_[k], by_break_[k]);
        add_rates_along<D>(by_start_, this->start_, sum);
        sum.add_rates_of(this->thickness_, by_thickness_);
    }

private:
    static constexpr bool from_start = D == 2;

    struct Node {
        double place = 0, rate = 0, thickness = 0; ///< rate: of the opening, in the frame
        double by_rate = 0, by_thickness = 0;
        bool faces = false; ///< whether the walls face each other here
    };
    struct Stretch {
        double length = 0;
        int first_point = -1; ///< -1: none
        int found = -1;       ///< number of its sections, as they were found, in `traces_`; -1: none
        std::array<Node, n> node;
    };

    void find(double from, double length, int count, Stretch& to)
    {
        for (int g = 0; g < count; ++g)
            to.node[g].place = from + rule.node[g] * length;
        to.found = static_cast<int>(traces_.size());
        traces_.emplace_back();
        for (int g = 0; g < count; ++g) {
            Node& node = to.node[g];
            if (SectionTrace<D>& trace = traces_[to.found][g];
                const auto found = this->walls_.still().profile(step_along<D>(start_value_, node.place, way_value_),
                                                                normal_value_, nullptr, &trace)) {
                node.faces = true;
                node.thickness = found->thickness;
                node.rate = this->walls_.opening(trace, normal_value_, frame_value_);
            }
            if (!node.faces)
                node.thickness = this->thickness_.value;
        }
    }

    void add_stretch(int k, double& by_here, Rates& rates)
    {
        Stretch& of = stretches_[k];
        double by_length = 0, moved = 0; // rates over sigma and length
        for (int h = 0; h < n; ++h) {
            of.node[h].by_rate = by_here * rule.weight[h];
            moved += by_here * rule.weight[h] * of.node[h].rate;
        }
        if (of.first_point >= 0)
            for (int g = 0; g < n; ++g) {
                const Point& point = points_[of.first_point + g];
                of.node[g].by_thickness = point.by_thickness;
                by_length += rule.weight[g] * point.by_weight;
                for (int h = 0; h < n; ++h) {
                    of.node[h].by_rate += point.by_flux * rule.up_to[g][h];
                    moved += point.by_flux * rule.up_to[g][h] * of.node[h].rate;
                }
                by_here += point.by_flux;
            }
        rates.sigma -= of.length * moved;
        by_length -= sigma_ * moved;
        for (Node& node : of.node)
            node.by_rate *= -sigma_ * of.length;
        const std::array<double, n> by_place = add_nodes(of, n, rates);
        for (int h = 0; h < n; ++h) {
            by_break_[k] += (1 - rule.node[h]) * by_place[h];
            by_break_[k + 1] += rule.node[h] * by_place[h];
        }
        by_break_[k] -= by_length;
        by_break_[k + 1] += by_length;
    }
    /// The derivatives by the nodes' places on the way.
    std::array<double, n> add_nodes(const Stretch& of, int count, Rates& rates)
    {
        std::array<double, n> by_place{};
        for (int g = 0; g < count; ++g) {
            const Node& node = of.node[g];
            if (!node.faces) {
                by_thickness_ += node.by_thickness;
                continue;
            }
            const double by_own = this->walls_.free_thickness(node.thickness) ? node.by_thickness : 0.0;
            SectionRates<D>& walls = rates.walls;
            walls.x.setZero();
            this->walls_.add_rates(traces_[of.found][g], normal_value_, frame_value_, {by_own, node.by_rate, Vec<D>::Zero()},
                                   walls);
            by_start_ += walls.x;
            rates.way += node.place * walls.x;
            by_place[g] = way_value_.dot(walls.x);
        }
        return by_place;
    }

    Vec<D> start_value_, way_value_, normal_value_, frame_value_;
    double sigma_ = 0, at_face_ = 0;
    Stretch thinnest_place_;
    std::vector<Stretch> stretches_;
    std::vector<std::array<SectionTrace<D>, n>> traces_;
    std::vector<Point> points_;
    std::vector<double> by_break_;
    Vec<D> by_start_ = Vec<D>::Zero();
    double by_thickness_ = 0;
};

} // namespace gapflow
