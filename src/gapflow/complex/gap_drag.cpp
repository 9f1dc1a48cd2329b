#include "gapflow/complex/gap_drag.hpp"

#include "gapflow/complex/gap_place.hpp"

#include <cmath>
#include <map>
#include <numbers>

namespace gapflow {
namespace {

template <int D>
using PairVectors = Eigen::Matrix<double, D, 2 * twist_size<D>>;

/// Of the two solids' twists those relative to the mean of their motions.
template <int D>
PairMass<D> relative_twists(const GapWalls<D>& walls)
{
    constexpr int T = twist_size<D>;
    PairMass<D> result = 0.5 * PairMass<D>::Identity();
    for (int side = 0; side < 2; ++side) {
        auto other = result.template block<T, T>(side * T, (1 - side) * T);
        other.template bottomRightCorner<spin_size<D>, spin_size<D>>() =
            -0.5 * Eigen::Matrix<double, spin_size<D>, spin_size<D>>::Identity();
        for (int k = 0; k < D; ++k)
            other.row(k) = -0.5 * speed_along<D>(unit<D>(k), walls.reference[side], walls.reference[1 - side]).transpose();
    }
    return result;
}

template <int D>
PairMass<D> in_relative(const PairMass<D>& relative, const PairMass<D>& mass)
{
    const PairMass<D> half = mass.lazyProduct(relative);
    return relative.transpose().lazyProduct(half);
}

/// Velocity along e of both walls: their mean, and of the first less that of the second.
template <int D>
struct WallSpeeds {
    PairTwist<D> mean, difference;

    WallSpeeds(const GapWalls<D>& walls, const GapSection<D>& at, const Vec<D>& n, const Vec<D>& e)
    {
        constexpr int T = twist_size<D>;
        const Vec<D> half = 0.5 * at.thickness * n;
        difference << speed_along<D>(e, at.middle - half, walls.reference[0]),
            -speed_along<D>(e, at.middle + half, walls.reference[1]);
        mean << 0.5 * difference.template head<T>(), -0.5 * difference.template tail<T>();
    }
};

/// The part of the pressure around a point contact that is known.
struct Peak {
    Vec<3> at, n;
    double end; ///< thickness at which it ends
    PairTwist<3> height;
    PairVectors<3> slope;
    Mat<3> hessian; ///< of the thickness
    // Along a line of contact it ends before the walls do.
    Vec<3> line = Vec<3>::Zero(); ///< zero: none
    double from = -1, to = 1, fade = 1;

    double place(const Vec<3>& x) const { return line.dot(x - at); }
    double within(const Vec<3>& x) const
    {
        const double y = place(x);
        return std::clamp(std::min(y - from, to - y) / fade, 0.0, 1.0);
    }
    double within_slope(const Vec<3>& x) const
    {
        const double y = place(x), least = std::min(y - from, to - y);
        return least <= 0 || least >= fade ? 0 : (y - from < to - y ? 1 : -1) / fade;
    }

    PairTwist<3> amount(const Vec<3>& x) const
    {
        const Vec<3> r = x - at;
        return height + slope.transpose() * (r - n.dot(r) * n);
    }
    PairTwist<3> pressure(const GapSection<3>& section) const
    {
        const double t = section.thickness;
        if (t >= end)
            return PairTwist<3>::Zero();
        return within(section.middle) * (1 / (t * t) - 1 / (end * end) + 2 * (t - end) / (end * end * end)) *
               amount(section.middle);
    }
    /// Its share of the friction 1/t of sliding walls; the rest is (2 - t/t_a)/t_a.
    double friction(const GapSection<3>& section) const
    {
        const double t = section.thickness;
        return t < end && within(section.middle) > 0 ? (1 - t / end) * (1 - t / end) / t : 0;
    }
    PairTwist<3> flux(const GapSection<3>& section, const Vec<3>& e) const
    {
        const double t = section.thickness, x = t / end;
        if (x >= 1)
            return PairTwist<3>::Zero();
        const double height_flux = -t / 12 * (1 - 3 * x * x + 2 * x * x * x), y = within(section.middle);
        return height_flux *
                   (y * (slope.transpose() * e) + within_slope(section.middle) * line.dot(e) * amount(section.middle)) -
               y * (1 - x * x * x) / 6 * section.slope.dot(e) * amount(section.middle);
    }
};

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
PairTwist<2> stream(const GapWalls<2>& walls, const std::array<Vec<2>, 2>& at)
{
    PairTwist<2> row;
    for (int side = 0; side < 2; ++side) {
        const Vec<2> r = at[side] - walls.reference[side];
        row.segment<3>(3 * side) = (side == 0 ? -1 : 1) * Twist<2>(r[1], -r[0], -0.5 * r.squaredNorm());
    }
    return row;
}

/// Where the line of a face crosses the walls of a gap.
std::optional<std::array<Vec<2>, 2>> crossings(const GapWalls<2>& walls, const Vec<2>& x, const Vec<2>& along)
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
    double drop = 0;                          ///< int 12/t^3
    PairTwist<D> mean = PairTwist<D>::Zero(); ///< of D, so weighted
    PairMass<D> square = PairMass<D>::Zero(); ///< of D - mean
    PairMass<D> friction = PairMass<D>::Zero();

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
        std::vector<std::pair<double, PairTwist<D>>> points;
        for (std::size_t k = 0; k + 1 < n; ++k) {
            const double length = breaks_[k + 1] - breaks_[k];
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
                    const double t = at.thickness, ds = section[k][g]->stretch * length * Rule::weight[g],
                                 w = 12 * ds / (t * t * t);
                    drop += w;
                    mean += w * D_;
                    points.emplace_back(w, D_);
                    friction += ds * rub * speed.difference * speed.difference.transpose();
                }
            for (int h = 0; h < 3; ++h)
                through -= sigma * length * Rule::weight[h] * rate[k][h];
        }
        if (!(drop > 0))
            return;
        mean /= drop;
        for (const auto& [w, row] : points)
            square += w * (row - mean) * (row - mean).transpose();
    }

private:
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
        area_ += width * site_.walls.between_shapes(section->thickness);
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
    const Vec<D> centroid_;
    const Peak* peak_;
    double from_, to_, area_ = 0;
    std::vector<Line> lines_;
};

template <int D>
void leave_still(const GapSite<D>& site, PairTwist<D>& row)
{
    for (int side = 0; side < 2; ++side)
        if (site.still[side])
            row.template segment<twist_size<D>>(side * twist_size<D>).setZero();
}
template <int D>
void leave_still(const GapSite<D>& site, PairMass<D>& mass)
{
    constexpr int T = twist_size<D>;
    for (int side = 0; side < 2; ++side)
        if (site.still[side]) {
            mass.template middleRows<T>(side * T).setZero();
            mass.template middleCols<T>(side * T).setZero();
        }
}

template <int D>
GapDrag<D> drag_at(const GapSite<D>& site, const FacePiece<D>& piece, const Vec<D>& low, const Vec<D>& high, const Peak* peak)
{
    constexpr int T = twist_size<D>;
    const double t0 = site.here.thickness, A = piece.area;
    GapDrag<D> drag{site.piece, site.solid, 0, 0, PairTwist<D>::Zero(), {}, PairMass<D>::Zero(), t0};
    for (int side = 0; side < 2; ++side)
        drag.motion.template segment<T>(side * T) =
            0.5 * speed_along<D>(unit<D>(piece.axis), piece.centroid, site.walls.reference[side]);
    drag.share = share_up_to(t0, parameters.gap_start, parameters.gap_end);
    if (site.along_face())
        drag.resistance = 12 * site.delta * site.walls.between_shapes(t0) / (A * t0 * t0 * t0);
    else {
        GapShape<D> closing = shape_of_gap<D, StillWalls<D>>(site.walls, piece.centroid, site.n, site.here, site.e, site.way);
        if constexpr (D == 3)
            if (peak && !(closing.curvature > 0)) // beside the end of a wall
                closing.share = site.e.dot(peak->hessian * site.way) / peak->hessian.trace();
        DragFace<D> face(site, piece, low, high, peak);
        const auto lines = face.lines(closing.share);
        double conductance = 0;
        for (const auto& line : lines) {
            const double b = line.width * A / face.area();
            const DragLine<D>& way = line.way;
            if (!(way.drop > 0))
                continue;
            conductance += b / way.drop;
            drag.flux += b * way.mean;
            drag.mass += b * (way.square + way.friction);
        }
        if (!(conductance > 0)) {
            drag.share = 0;
            return drag;
        }
        drag.mass = site.delta * (drag.mass + drag.flux * drag.flux.transpose() / conductance);
        drag.flux *= site.delta / conductance;
        drag.resistance = site.delta / conductance;
        const PairMass<D> relative = relative_twists(site.walls);
        drag.flux = PairTwist<D>(relative.transpose().lazyProduct(drag.flux));
        drag.mass = in_relative<D>(relative, drag.mass);
    }
    drag.resistance *= drag.share;
    drag.flux *= drag.share;
    drag.mass *= drag.share;
    leave_still<D>(site, drag.flux);
    leave_still<D>(site, drag.motion);
    leave_still<D>(site, drag.mass);
    return drag;
}

/// Of the walls of a gap, searched from a place of it.
class PeakFinder {
public:
    explicit PeakFinder(const GapSite<3>& site) : walls_(site.walls), n_(site.n), x_(site.here.middle) {}

    std::optional<Peak> find()
    {
        if (!find_contact())
            return {};
        if (line_) { // from its middle
            const double end = end_of_peak();
            const Vec<3> line = plane_ * Vec<2>(-steep_[1], steep_[0]);
            x_ += 0.5 * (reach(line, end) - reach(-line, end)) * line;
            if (!find_contact() || !line_)
                return {};
        }
        Peak peak{x_, n_, end_of_peak(), PairTwist<3>::Zero(), PairVectors<3>::Zero(), plane_ * hessian_ * plane_.transpose()};
        if (!(peak.end > least_))
            return {};
        if (line_) {
            peak.line = plane_ * Vec<2>(-steep_[1], steep_[0]);
            peak.to = reach(peak.line, peak.end);
            peak.from = -reach(-peak.line, peak.end);
            peak.fade = std::min(std::sqrt(2 * least_ / curvature_), 0.5 * (peak.to - peak.from));
            if (!(peak.fade > 0))
                return {};
        }
        peak.height = -6 / hessian_.trace() * opening_;
        const Mat<2> inverse = (hessian_ + 2 * hessian_.trace() * Mat<2>::Identity()).inverse();
        peak.slope = -12 * plane_ * inverse * opening_slope_;
        return peak;
    }

    /// int 2 p s - 12 P P/t^3, s the source of the flux relative to the walls' mean motion.
    PairMass<3> mass(const Peak& peak)
    {
        PairMass<3> sum = PairMass<3>::Zero();
        const double area = 2 * std::numbers::pi / rays / std::sqrt(hessian_.determinant());
        if (!line_)
            for (int k = 0; k < rays; ++k)
                add_ray(peak, x_, ray(k), area, true, sum);
        else {
            std::vector<double> breaks{peak.from, peak.from + peak.fade};
            const double inner = peak.to - peak.from - 2 * peak.fade;
            const int n = static_cast<int>(std::ceil(inner));
            for (int k = 1; k <= n; ++k)
                breaks.push_back(peak.from + peak.fade + inner * k / n);
            breaks.push_back(peak.to);
            for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
                for (int g = 0; g < 3; ++g) {
                    const double length = breaks[k + 1] - breaks[k];
                    const Vec<3> x = x_ + (breaks[k] + ThreePoints::node[g] * length) * peak.line;
                    for (const double side : {-1.0, 1.0})
                        add_ray(peak, x, side * (plane_ * steep_), ThreePoints::weight[g] * length, false, sum);
                }
        }
        return sum;
    }

private:
    static constexpr int rays = 16;
    static constexpr double h = 0.5;

    bool find_contact()
    {
        for (int k = 0; k < 30; ++k) {
            const auto here = walls_.across(x_, n_);
            if (!here)
                return false;
            x_ = here->middle;
            n_ = (here->normal[0] - here->normal[1]).normalized();
            const auto at = walls_.across(x_, n_);
            if (!at)
                return false;
            const Vec<3> u = n_.unitOrthogonal();
            plane_ << u, n_.cross(u);
            least_ = at->thickness;
            opening_ = at->opening;
            for (int i = 0; i < 2; ++i) {
                const auto up = walls_.across(x_ + h * plane_.col(i), n_), down = walls_.across(x_ - h * plane_.col(i), n_);
                if (!up || !down)
                    return false;
                hessian_.row(i) = ((down->slope - up->slope) / (2 * h)).transpose() * plane_;
                opening_slope_.row(i) = ((up->opening - down->opening) / (2 * h)).transpose();
            }
            hessian_ = (0.5 * (hessian_ + hessian_.transpose())).eval();
            if (!(hessian_.trace() > 0))
                return false;
            const double mean = 0.5 * hessian_.trace(),
                         radius = std::hypot(0.5 * (hessian_(0, 0) - hessian_(1, 1)), hessian_(0, 1));
            curvature_ = mean + radius;
            const double least = mean - radius;
            line_ = least < parameters.faint_curvature * curvature_;
            if (least < -parameters.faint_curvature * curvature_)
                return false;
            steep_ = hessian_.row(0).squaredNorm() > hessian_.row(1).squaredNorm()
                         ? Vec<2>(hessian_(0, 0) - least, hessian_(0, 1)).normalized()
                         : Vec<2>(hessian_(0, 1), hessian_(1, 1) - least).normalized();
            const Vec<2> slope = plane_.transpose() * at->slope;
            const Vec<2> step = line_ ? Vec<2>(steep_.dot(slope) / curvature_ * steep_) : Vec<2>(hessian_.inverse() * slope);
            if (step.norm() < 1e-10)
                return true;
            x_ += plane_ * (step * std::min(1.0, 1 / step.norm()));
        }
        return false;
    }

    /// In coordinates in which the thickness is round.
    Vec<3> ray(int k) const
    {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / rays;
        const Mat<2> L = hessian_.llt().matrixL();
        return plane_ * (L.transpose().inverse() * Vec<2>(std::cos(angle), std::sin(angle)));
    }
    double thickness(const Vec<3>& x) const
    {
        const auto found = walls_.across(x, n_);
        return found ? found->thickness : 1e300;
    }
    /// How far the thickness along a line stays below the peak's end.
    double reach(const Vec<3>& way, double end) const
    {
        double in = 0, out = h;
        for (; thickness(x_ + out * way) < end && out < 1e3; out += h)
            in = out;
        for (int i = 0; i < 30; ++i)
            (thickness(x_ + 0.5 * (in + out) * way) < end ? in : out) = 0.5 * (in + out);
        return in;
    }
    /// From x along a way up to the peak's end. `round`: of a wedge.
    void add_ray(const Peak& peak, const Vec<3>& x, const Vec<3>& way, double width, bool round, PairMass<3>& sum) const
    {
        const double here = thickness(x), step = std::sqrt(2 * (peak.end - least_) / (round ? 1 : curvature_));
        if (!(here < peak.end))
            return;
        double most = 0;
        while (thickness(x + (most + step) * way) < peak.end)
            most += step;
        double out = most + step;
        for (int i = 0; i < 30; ++i)
            (thickness(x + 0.5 * (most + out) * way) < peak.end ? most : out) = 0.5 * (most + out);
        add(peak, x, way, width, round, 0, here, most, peak.end, 30, sum);
    }
    double end_of_peak() const
    {
        double end = std::min(parameters.gap_start, least_ + 0.25 / curvature_);
        if (!(end > least_))
            return 0;
        for (int k = 0; k < (line_ ? 2 : rays); ++k) {
            const Vec<3> way = line_ ? Vec<3>((k - 0.5) * 2 / std::sqrt(curvature_) * (plane_ * steep_)) : ray(k);
            const double step = std::sqrt(2 * (end - least_)) / 8;
            double last = least_;
            for (int i = 1; last < end; ++i) {
                const auto found = walls_.across(x_ + i * step * way, n_);
                if (!found || i > 12)
                    end = std::min(end, last);
                else
                    last = found->thickness;
            }
        }
        return end;
    }
    void add(const Peak& peak, const Vec<3>& x, const Vec<3>& way, double width, bool round, double from, double t_from,
             double to, double t_to, int depth, PairMass<3>& sum) const
    {
        if (depth > 0 && t_to > parameters.widening * t_from) {
            const double middle = 0.5 * (from + to), t = thickness(x + middle * way);
            add(peak, x, way, width, round, from, t_from, middle, t, depth - 1, sum);
            add(peak, x, way, width, round, middle, t, to, t_to, depth - 1, sum);
            return;
        }
        for (int g = 0; g < 3; ++g) {
            const double r = from + ThreePoints::node[g] * (to - from);
            const auto at = walls_.across(x + r * way, n_);
            if (!at)
                continue;
            const double t = at->thickness, w = width * ThreePoints::weight[g] * (to - from) * (round ? r : 1.0);
            const PairTwist<3> p = peak.pressure(*at);
            sum -= w * (p * at->opening.transpose() + at->opening * p.transpose());
            for (int k = 0; k < 2; ++k) {
                const Vec<3> e = plane_.col(k);
                const PairTwist<3> P = peak.flux(*at, e);
                const WallSpeeds<3> speed(walls_, *at, n_, e);
                sum -= 12 * w / (t * t) * (speed.mean * P.transpose() + P * speed.mean.transpose()) +
                       12 * w / (t * t * t) * P * P.transpose();
                sum += w * peak.friction(*at) * speed.difference * speed.difference.transpose();
            }
        }
    }

    const GapWalls<3>& walls_;
    Vec<3> n_, x_;
    double least_ = 0, curvature_ = 0;
    bool line_ = false;
    Vec<2> steep_ = Vec<2>::Zero(); ///< direction of the largest curvature
    Eigen::Matrix<double, 3, 2> plane_;
    Mat<2> hessian_;
    PairTwist<3> opening_;
    Eigen::Matrix<double, 2, 2 * twist_size<3>> opening_slope_;
};

/// Names the walls in an order that does not depend on the place.
template <int D>
void order_walls(GapSite<D>& site)
{
    const std::array<Vec<D>, 2>& x = site.walls.reference;
    if (site.solid[0] < site.solid[1] ||
        (site.solid[0] == site.solid[1] && std::lexicographical_compare(x[0].begin(), x[0].end(), x[1].begin(), x[1].end())))
        return;
    std::swap(site.solid[0], site.solid[1]);
    std::swap(site.still[0], site.still[1]);
    site.walls.swap();
    site.n = -site.n;
    std::swap(site.round[0], site.round[1]);
    std::swap(site.here.normal[0], site.here.normal[1]);
}

/// In 2D the fluid in a gap is one chain: of faces that follow each other across it the straighter ones count. Parts that others join
/// have the node of the largest.
class Chain {
public:
    Chain(const Grid<2>& grid, const Complex<2>& complex) : grid_(grid), complex_(complex) {}

    /// Whether a piece ends in the gap at a vertex of the grid where the gap is straighter across the other axis. Joins its parts.
    bool joins(const GapSite<2>& site)
    {
        const FacePiece<2>& piece = complex_.pieces[site.piece];
        bool found = false;
        for (const double side : {-0.5, 0.5}) {
            const Vec<2> end = piece.centroid + side * piece.area * unit<2>(1 - piece.axis);
            double least = 1;
            for (const int wall : {0, 1})
                least = std::min(least, std::abs(site.walls.nearest(wall, end).distance));
            if (least < parameters.joint_distance)
                continue;
            const auto middle = foot<2>(site.walls, end, site.n);
            const auto at = middle ? own_section<2>(site.walls, *middle, site.n) : std::nullopt;
            found = found || (at && at->section.thickness < parameters.gap_start &&
                              (std::abs(at->n[0]) > std::abs(at->n[1]) + parameters.parallel ? 1 : 0) != piece.axis);
        }
        if (found && piece.low.is_part() && piece.high.is_part()) {
            const int a = root(piece.low.number()), b = root(piece.high.number());
            const auto larger = [&](int x, int y) {
                return complex_.part_area[x] != complex_.part_area[y] ? complex_.part_area[x] > complex_.part_area[y] : x < y;
            };
            if (a != b)
                (larger(a, b) ? parent_[b] : parent_[a]) = larger(a, b) ? a : b;
        }
        return found;
    }
    /// From the centre of a part's cell to its node.
    Vec<2> way_to_node(const PartOrCell& at)
    {
        if (!at.is_part())
            return Vec<2>::Zero();
        const Index<2> from = complex_.cell_of_part(at.number()), to = complex_.cell_of_part(root(at.number()));
        Vec<2> way;
        for (int axis = 0; axis < 2; ++axis) {
            way[axis] = (grid_.centre_place(axis, to[axis]) - grid_.centre_place(axis, from[axis])) / grid_.dx();
            if (grid_.periodic(axis))
                way[axis] -= std::round(way[axis] / grid_.size()[axis] * grid_.dx()) * grid_.size()[axis] / grid_.dx();
        }
        return way;
    }

private:
    int root(int part)
    {
        auto at = parent_.find(part);
        while (at != parent_.end()) {
            part = at->second;
            at = parent_.find(part);
        }
        return part;
    }

    const Grid<2>& grid_;
    const Complex<2>& complex_;
    std::map<int, int> parent_;
};

template <int D>
bool same_walls(const GapSite<D>& a, const GapSite<D>& b)
{
    return a.solid == b.solid && a.walls.reference == b.walls.reference;
}

} // namespace

template <int D>
GapDrags<D> find_gap_drag(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                          const Standoffs<D>& standoffs)
{
    std::vector<GapSite<D>> sites;
    for_each_gap<D>(grid, solids, complex, standoffs, [&](const GapSite<D>& site) {
        sites.push_back(site);
        order_walls(sites.back());
    });
    std::vector<std::optional<Peak>> peaks;
    std::vector<int> peak_of(sites.size(), -1);
    GapDrags<D> drags;
    if constexpr (D == 3) {
        std::vector<std::vector<std::size_t>> pairs; // sites of each two images, the thinnest first
        for (std::size_t k = 0; k < sites.size(); ++k) {
            std::size_t p = 0;
            while (p < pairs.size() && !same_walls(sites[pairs[p][0]], sites[k]))
                ++p;
            if (p == pairs.size())
                pairs.emplace_back();
            pairs[p].push_back(k);
            peak_of[k] = static_cast<int>(p);
        }
        for (std::vector<std::size_t>& pair : pairs) {
            std::stable_sort(pair.begin(), pair.end(),
                             [&](std::size_t a, std::size_t b) { return sites[a].here.thickness < sites[b].here.thickness; });
            peaks.emplace_back();
            for (const std::size_t k : pair) {
                PeakFinder finder(sites[k]);
                peaks.back() = finder.find();
                if (!peaks.back())
                    continue;
                const PairMass<D> relative = relative_twists(sites[k].walls);
                PeakDrag<D> drag{sites[k].solid, peaks.back()->at, in_relative<D>(relative, finder.mass(*peaks.back()))};
                leave_still<D>(sites[k], drag.mass);
                drags.peaks.push_back(drag);
                break;
            }
        }
    }
    std::vector<char> joined(sites.size(), false);
    std::vector<std::array<Vec<D>, 2>> shift(sites.size(), {Vec<D>::Zero(), Vec<D>::Zero()});
    if constexpr (D == 2) {
        Chain chain(grid, complex);
        for (std::size_t k = 0; k < sites.size(); ++k)
            joined[k] = chain.joins(sites[k]);
        for (std::size_t k = 0; k < sites.size(); ++k) {
            const FacePiece<D>& piece = complex.pieces[sites[k].piece];
            shift[k] = {chain.way_to_node(piece.low), chain.way_to_node(piece.high)};
        }
    }
    for (std::size_t k = 0; k < sites.size(); ++k) {
        if (joined[k]) {
            const double share = share_up_to(sites[k].here.thickness, parameters.gap_start, parameters.gap_end);
            if (share > 0)
                drags.joined.push_back({sites[k].piece, share, sites[k].here.thickness});
            continue;
        }
        const FacePiece<D>& piece = complex.pieces[sites[k].piece];
        const Vec<D> half = 0.5 * sites[k].delta * unit<D>(piece.axis);
        const Peak* peak = peak_of[k] >= 0 && peaks[peak_of[k]] ? &*peaks[peak_of[k]] : nullptr;
        const GapDrag<D> drag =
            drag_at<D>(sites[k], piece, sites[k].nodes - half + shift[k][0], sites[k].nodes + half + shift[k][1], peak);
        if (drag.share > 0)
            drags.faces.push_back(drag);
    }
    return drags;
}

template GapDrags<2> find_gap_drag(const Grid<2>&, std::span<const Solid<2>>, const Complex<2>&, const Standoffs<2>&);
template GapDrags<3> find_gap_drag(const Grid<3>&, std::span<const Solid<3>>, const Complex<3>&, const Standoffs<3>&);

} // namespace gapflow
