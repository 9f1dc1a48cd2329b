// Integrals of a gap's dissipation along a face's lines, from node to node (gap_drag.hpp).
//
// In 2D they have the next order too. Along the middle of a gap, t' = dt/ds, the flow u = 6 W/t (1/4 - z^2) + v z changes along the way: of |grad u|^2 that
// is 2 int (d_s u)^2 t dz, of W, of its derivative, which is the closing, and of v.
#pragma once

#include "gapflow/complex/drag_peak.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace gapflow {

/// A gap along its own normal, at the place of a line.
template <int D>
struct OwnSection {
    GapSection<D> section;
    Vec<D> n;
    double stretch; ///< length along the gap's middle over that along the line
};

template <int D>
std::optional<OwnSection<D>> own_section(const GapWalls<D>& walls, const Vec<D>& x, const Vec<D>& n)
{
    const auto first = walls.across(x, n);
    if (!first)
        return {};
    const Vec<D> own = (first->normal[0] - first->normal[1]).normalized();
    const auto section = walls.across(first->middle, own);
    if (!section)
        return {};
    return OwnSection<D>{*section, own, 1 / std::max(own.dot(n), parameters.least_facing)};
}

/// Points of both walls at a section of a gap.
template <int D>
std::array<Vec<D>, 2> wall_points(const GapProfile<D, StillWalls<D>>& at, const Vec<D>& n)
{
    return {at.middle - 0.5 * at.thickness * n, at.middle + 0.5 * at.thickness * n};
}

/// The stream function of both walls' twists, of the second less that of the first: its change is that of the flux along the gap to the right of the
/// way from the first wall to the second one.
inline PairTwist<2> stream(const GapWalls<2>& walls, const std::array<Vec<2>, 2>& at)
{
    PairTwist<2> row;
    for (int side = 0; side < 2; ++side) {
        const Vec<2> r = at[side] - walls.reference[side];
        row.segment<3>(3 * side) = (side == 0 ? -1 : 1) * Twist<2>(r[1], -r[0], -0.5 * r.squaredNorm());
    }
    return row;
}

/// Where the line of a face crosses the walls of a gap.
inline std::optional<std::array<Vec<2>, 2>> crossings(const GapWalls<2>& walls, const Vec<2>& x, const Vec<2>& along)
{
    std::array<Vec<2>, 2> found{x, x};
    for (int side = 0; side < 2; ++side)
        for (int k = 0;; ++k) {
            const WallPoint<2, double> at = walls.nearest(side, found[side]);
            const double slope = at.normal.dot(along), step = at.distance / slope;
            if (!(std::abs(slope) > parameters.parallel) || !(std::abs(step) < 2) || k == 20)
                return {};
            found[side] -= step * along;
            if (std::abs(step) < parameters.least_stretch)
                break;
        }
    return found;
}

/// The place of the gap's middle from which its normal leads to x.
template <int D>
std::optional<Vec<D>> foot(const GapWalls<D>& walls, const Vec<D>& x, Vec<D> n)
{
    std::optional<Vec<D>> found;
    for (int k = 0; k < 10; ++k) {
        const auto at = walls.across(x, n);
        if (!at)
            return {};
        found = at->middle;
        n = (at->normal[0] - at->normal[1]).normalized();
    }
    return found;
}

/// Integrals along a line of a face, from node to node.
template <int D>
class DragLine {
public:
    struct Half {
        double length = 0;                        ///< over that of the way
        double drop = 0;                          ///< int 12/t^3
        PairTwist<D> mean = PairTwist<D>::Zero(); ///< of D, so weighted
        PairMass<D> square = PairMass<D>::Zero(); ///< of D - mean
        PairMass<D> friction = PairMass<D>::Zero();
    };
    std::array<Half, 2> half; ///< before the face and behind it

    double drop() const { return half[0].drop + half[1].drop; }
    PairTwist<D> mean() const { return (half[0].drop * half[0].mean + half[1].drop * half[1].mean) / drop(); }

    /// From the place + from way to the place + to way.
    DragLine(const GapSite<D>& site, int axis, const Vec<D>& place, double from, double to, const Peak* peak)
        : site_(site), axis_(axis), place_(place), from_(from), to_(to), peak_(peak)
    {
        std::array<double, 3> ends{from, 0.0, to}; // in any order
        std::sort(ends.begin(), ends.end());
        breaks_.assign(1, ends[0]);
        double here = thickness(ends[0]);
        for (int k = 1; k < 3; ++k)
            if (ends[k] > ends[k - 1]) {
                const double next = thickness(ends[k]);
                refine(ends[k - 1], here, ends[k], next, halvings);
                here = next;
            }
    }

    double least() const { return least_; }

    void integrate(double sigma)
    {
        if constexpr (D == 2) {
            const auto cut = crossings(site_.walls, place_, unit<2>(1 - axis_));
            at_cut_ = stream(site_.walls, cut ? *cut : wall_points(site_.here, site_.n));
        }
        using Rule = ThreePoints;
        const std::size_t n = breaks_.size();
        std::vector<std::array<PairTwist<D>, 3>> rate(n - 1);
        std::vector<std::array<std::optional<OwnSection<D>>, 3>> section(n - 1);
        PairTwist<D> through = PairTwist<D>::Zero(), at_face = through; // what the opening takes
        for (std::size_t k = 0; k + 1 < n; ++k) {
            const double length = breaks_[k + 1] - breaks_[k];
            if (breaks_[k] == 0)
                at_face = through;
            for (int g = 0; g < 3; ++g) {
                section[k][g] = across(breaks_[k] + Rule::node[g] * length);
                rate[k][g] = section[k][g] ? PairTwist<D>(section[k][g]->stretch * section[k][g]->section.opening)
                                           : PairTwist<D>::Zero();
                through -= sigma * length * Rule::weight[g] * rate[k][g];
            }
        }
        if (breaks_.back() == 0)
            at_face = through;
        through = -at_face;
        std::array<std::vector<std::pair<double, PairTwist<D>>>, 2> points;
        for (std::size_t k = 0; k + 1 < n; ++k) {
            const double length = breaks_[k + 1] - breaks_[k];
            const int side = breaks_[k] < 0 ? 0 : 1;
            Half& of = half[side];
            if (breaks_[k] >= from_ && breaks_[k] < to_)
                for (int g = 0; g < 3; ++g) {
                    if (!section[k][g])
                        continue;
                    const GapSection<D>& at = section[k][g]->section;
                    const Vec<D>& own = section[k][g]->n;
                    const Vec<D> e = (site_.e - own.dot(site_.e) * own).normalized() * site_.e.norm();
                    const WallSpeeds<D> speed(site_.walls, at, own, e);
                    PairTwist<D> D_ = through - at.thickness * speed.mean;
                    if constexpr (D == 2) {
                        const double right = e[0] * own[1] - e[1] * own[0];
                        D_ = right * (stream(site_.walls, wall_points(at, own)) - at_cut_) - at.thickness * speed.mean;
                    } else
                        for (int h = 0; h < 3; ++h)
                            D_ -= sigma * length * Rule::collocation[g][h] * rate[k][h];
                    double rub = 1 / at.thickness;
                    if constexpr (D == 3)
                        if (peak_) {
                            D_ -= peak_->flux(at, e);
                            rub -= peak_->friction(at);
                        }
                    const double t = at.thickness, ds = section[k][g]->stretch * length * Rule::weight[g];
                    double w = 12 * ds / (t * t * t);
                    if constexpr (D == 2) {
                        // 2 int (d_s u)^2 = 2/t [1.8 (W t'/t)^2 - 1.2 (W t'/t) W' + 1.2 W'^2] + (t' e v)^2/(6 t)
                        const double slope = -at.slope.dot(e) / e.norm(), factor = 12 + 3.6 * slope * slope,
                                     shift = 1.2 * slope * t / factor;
                        const PairTwist<D> change = -e.norm() * at.opening;
                        w = factor * ds / (t * t * t);
                        D_ -= shift * change;
                        of.friction += ds * (2.4 - factor * shift * shift / (t * t)) / t * change * change.transpose();
                        rub += slope * slope / (6 * t);
                    }
                    of.length += ds;
                    of.drop += w;
                    of.mean += w * D_;
                    points[side].emplace_back(w, D_);
                    of.friction += ds * rub * speed.difference * speed.difference.transpose();
                }
            for (int h = 0; h < 3; ++h)
                through -= sigma * length * Rule::weight[h] * rate[k][h];
        }
        for (int side = 0; side < 2; ++side) {
            Half& of = half[side];
            if (!(of.drop > 0))
                continue;
            of.mean /= of.drop;
            for (const auto& [w, row] : points[side])
                of.square += w * (row - of.mean) * (row - of.mean).transpose();
        }
        if constexpr (D == 2)
            end_at_line();
    }

private:
    /// The two halves end at the face's line, which is inclined to the gap's normal: between the two 2 W v of the shear's square goes from the one half to the other,
    /// as far as both stay sums of squares.
    void end_at_line()
    {
        const auto cut = crossings(site_.walls, place_, unit<2>(1 - axis_));
        const auto at = across(0);
        if (!cut || !at || !(half[0].drop > 0) || !(half[1].drop > 0))
            return;
        const Vec<2> e = (site_.e - at->n.dot(site_.e) * at->n).normalized() * site_.e.norm();
        const WallSpeeds<2> speed(site_.walls, at->section, at->n, e);
        const double most = std::sqrt(12) * std::min(half[0].length, half[1].length), t = at->section.thickness,
                     lean = std::clamp(((*cut)[1] - (*cut)[0]).dot(e) / (e.squaredNorm() * site_.delta), -most, most);
        for (const int side : {0, 1}) {
            Half& of = half[side];
            const PairTwist<2> shear = (side == 0 ? lean : -lean) / (t * t) * speed.difference,
                               rest = -t * speed.mean - of.mean;
            of.friction += rest * shear.transpose() + shear * rest.transpose() - shear * shear.transpose() / of.drop;
            of.mean += shear / of.drop;
        }
    }

    static constexpr int halvings = 30, to_end = 20; ///< to the digits of a double; to 1e-3 of the way where a wall ends

    std::optional<OwnSection<D>> across(double s) const { return own_section<D>(site_.walls, place_ + s * site_.way, site_.n); }
    double thickness(double s)
    {
        const auto found = across(s);
        if (found)
            least_ = std::min(least_, found->section.thickness);
        return found ? found->section.thickness : -1; // ended
    }
    void refine(double from, double t_from, double to, double t_to, int depth)
    {
        const double middle = 0.5 * (from + to), t_middle = thickness(middle);
        const auto [least, most] = std::minmax({t_from, t_middle, t_to});
        if (least > 0 ? depth > 0 && most > widening_ * least : depth > to_end && most > 0) {
            refine(from, t_from, middle, t_middle, depth - 1);
            refine(middle, t_middle, to, t_to, depth - 1);
        } else
            breaks_.push_back(to);
    }

    const GapSite<D>& site_;
    int axis_;
    PairTwist<D> at_cut_;
    Vec<D> place_;
    double from_, to_;
    const Peak* peak_;
    /// Of 1/t^3; in 3D peaks of the integrand are taken out of it.
    const double widening_ = D == 2 ? std::cbrt(parameters.widening) : parameters.widening;
    double least_ = 1e300;
    std::vector<double> breaks_;
};

/// Lines of a piece: of Gauss rules on stretches within which the least thickness on a line changes by no more than a factor.
template <int D>
class DragFace {
public:
    DragFace(const GapSite<D>& site, const FacePiece<D>& piece, const Vec<D>& low_node, const Vec<D>& high_node,
             const Peak* peak)
        : site_(site), axis_(piece.axis), centroid_(piece.centroid), peak_(peak)
    {
        if constexpr (D == 2) // all pieces of a line across the gap have its middle
            if (const auto cut = crossings(site.walls, piece.centroid, unit<2>(1 - axis_))) {
                centroid_ = 0.5 * ((*cut)[0] + (*cut)[1]);
                across_ = ((*cut)[1] - (*cut)[0]).norm() * site.e.norm();
            }
        const auto low = foot<D>(site.walls, low_node, site.n), high = foot<D>(site.walls, high_node, site.n);
        const double scale = 1 / site.way.squaredNorm();
        from_ = low ? scale * site.way.dot(*low - centroid_) : site.middle - 0.5;
        to_ = high ? scale * site.way.dot(*high - centroid_) : site.middle + 0.5;
    }

    struct Line {
        double width;
        DragLine<D> way;
    };
    std::vector<Line> lines(double sigma)
    {
        if constexpr (D == 3)
            if (std::abs(site_.to - site_.from) > parameters.least_stretch)
                refine(site_.from, least(site_.from), site_.to, least(site_.to), halvings);
        if (lines_.empty())
            add(centroid_, 1);
        for (Line& line : lines_)
            line.way.integrate(sigma);
        return std::move(lines_);
    }
    double area() const { return area_; } ///< of the lines

private:
    static constexpr int halvings = 12;

    Vec<D> place(double s) const { return centroid_ + s * site_.line; }
    double least(double s) const { return DragLine<D>(site_, axis_, place(s), from_, to_, nullptr).least(); }
    void add(const Vec<D>& x, double width)
    {
        const auto section = site_.walls.across(x, site_.n);
        if (!section)
            return;
        area_ += width * (across_ > 0 ? across_ : site_.walls.between_shapes(section->thickness));
        lines_.push_back({width, DragLine<D>(site_, axis_, x, from_, to_, peak_)});
    }
    void refine(double from, double t_from, double to, double t_to, int depth)
    {
        const double middle = 0.5 * (from + to), t_middle = least(middle);
        const auto [least, most] = std::minmax({t_from, t_middle, t_to});
        if (depth > 0 && most < 1e300 && most > parameters.widening * least) {
            refine(from, t_from, middle, t_middle, depth - 1);
            refine(middle, t_middle, to, t_to, depth - 1);
        } else
            for (int g = 0; g < 3; ++g)
                add(place(from + ThreePoints::node[g] * (to - from)), ThreePoints::weight[g] * std::abs(to - from));
    }

    const GapSite<D>& site_;
    const int axis_;
    Vec<D> centroid_;
    const Peak* peak_;
    double from_, to_, area_ = 0, across_ = 0;
    std::vector<Line> lines_;
};

} // namespace gapflow
