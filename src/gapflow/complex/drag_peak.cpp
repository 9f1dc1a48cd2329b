#include "gapflow/complex/drag_peak.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace gapflow {
namespace {

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

} // namespace

std::optional<FoundPeak> find_peak(const GapSite<3>& site)
{
    PeakFinder finder(site);
    const std::optional<Peak> peak = finder.find();
    if (!peak)
        return {};
    return FoundPeak{*peak, finder.mass(*peak)};
}

} // namespace gapflow
