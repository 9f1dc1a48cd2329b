// A face in 2D is a segment x(t) = corner + t edge e, 0 <= t <= 1. It is cut exactly where it crosses the solids:
//
//     planes:        t = f(0) / (f(0) - f(1)),   f = normal . x - offset;
//     other shapes:  root of phi(x(t)) in each of 8 pieces at whose ends phi changes sign (Illinois' regula falsi).
//
// Each piece between consecutive crossings is open where phi > 0 at its middle for all solids, else it belongs to the solid
// with the smallest phi; pieces in several solids are cut once more where their distances are equal. Method, "Face fractions".
#include "gapflow/grid/clip_kernels.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr int samples = 8; // pieces in which a change of sign is looked for

class SegmentClipper {
public:
    SegmentClipper(const Vec<2>& corner, double edge, int tangent, std::span<const Cutter<2>> cutters, double tolerance,
                   FaceSums<2>& sums)
        : corner_(corner), edge_(edge), tangent_(tangent), cutters_(cutters), tolerance_(tolerance), sums_(sums)
    {
    }

    void clip()
    {
        static thread_local std::vector<double> cuts;
        cuts.assign(1, 0.0);
        for (const Cutter<2>& cutter : cutters_)
            if (cutter.planes.empty())
                add_roots([&](double t) { return phi(cutter, t); }, 0, 1, cuts);
            else
                for (const Plane<2>& plane : cutter.planes)
                    add_root_of_line(plane.normal.dot(at(0)) - plane.offset, plane.normal.dot(at(1)) - plane.offset, cuts);
        std::sort(cuts.begin(), cuts.end());
        cuts.push_back(1.0);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            if (cuts[i + 1] > cuts[i])
                give(cuts[i], cuts[i + 1]);
    }

private:
    Vec<2> at(double t) const
    {
        Vec<2> x = corner_;
        x[tangent_] += t * edge_;
        return x;
    }
    double phi(const Cutter<2>& cutter, double t) const { return snapped(cutter.shape->distance(at(t))); }
    double snapped(double value) const { return std::abs(value) <= tolerance_ ? 0.0 : value; }

    void add_root_of_line(double f0, double f1, std::vector<double>& roots) const
    {
        f0 = snapped(f0);
        f1 = snapped(f1);
        if ((f0 < 0 && f1 > 0) || (f0 > 0 && f1 < 0))
            roots.push_back(f0 / (f0 - f1));
    }

    template <class F>
    void add_roots(F&& f, double begin, double end, std::vector<double>& roots) const
    {
        double t0 = begin, f0 = f(begin);
        for (int k = 1; k <= samples; ++k) {
            const double t1 = k == samples ? end : begin + k * (end - begin) / samples, f1 = f(t1);
            if (f1 == 0 && k < samples)
                roots.push_back(t1);
            else if ((f0 < 0 && f1 > 0) || (f0 > 0 && f1 < 0))
                roots.push_back(root(f, t0, f0, t1, f1));
            t0 = t1;
            f0 = f1;
        }
    }

    template <class F>
    static double root(F&& f, double a, double fa, double b, double fb)
    {
        double t = a;
        for (int k = 0, side = 0; k < 60 && std::abs(b - a) > 1e-15; ++k) {
            t = (a * fb - b * fa) / (fb - fa);
            const double ft = f(t);
            if (ft == 0)
                break;
            if ((ft > 0) == (fb > 0)) {
                b = t;
                fb = ft;
                if (side == 1)
                    fa *= 0.5;
                side = 1;
            } else {
                a = t;
                fa = ft;
                if (side == -1)
                    fb *= 0.5;
                side = -1;
            }
        }
        return t;
    }

    // Inside at the middle of t0..t1; where that lies on the surface, as a piece along it does and a point of contact does
    // not, on or inside it at two more points.
    bool inside(const Cutter<2>& cutter, double t0, double t1, double& at_middle) const
    {
        at_middle = phi(cutter, 0.5 * (t0 + t1));
        return at_middle < 0 ||
               (at_middle == 0 && phi(cutter, 0.75 * t0 + 0.25 * t1) <= 0 && phi(cutter, 0.25 * t0 + 0.75 * t1) <= 0);
    }

    void give(double t0, double t1)
    {
        int owner = -1, count = 0;
        double smallest = 0, value;
        for (int i = 0; i < static_cast<int>(cutters_.size()); ++i)
            if (inside(cutters_[i], t0, t1, value)) {
                ++count;
                if (owner < 0 || value < smallest - tolerance_) {
                    owner = i;
                    smallest = value;
                }
            }
        if (count > 1)
            share(t0, t1);
        else
            (owner < 0 ? sums_.open : sums_.solid[owner]).add(t1 - t0, PartSum<2>::Local(0.5 * (t0 + t1)));
    }

    // A piece in several solids.
    void share(double t0, double t1)
    {
        static thread_local std::vector<double> cuts;
        static thread_local std::vector<int> owners;
        double value;
        owners.clear();
        for (int i = 0; i < static_cast<int>(cutters_.size()); ++i)
            if (inside(cutters_[i], t0, t1, value))
                owners.push_back(i);
        cuts.assign(1, t0);
        for (std::size_t i = 0; i < owners.size(); ++i)
            for (std::size_t j = i + 1; j < owners.size(); ++j)
                add_roots(
                    [&](double t) {
                        return snapped(cutters_[owners[i]].shape->distance(at(t)) - cutters_[owners[j]].shape->distance(at(t)));
                    },
                    t0, t1, cuts);
        std::sort(cuts.begin(), cuts.end());
        cuts.push_back(t1);
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const double length = cuts[k + 1] - cuts[k], middle = 0.5 * (cuts[k] + cuts[k + 1]);
            if (!(length > 0))
                continue;
            int owner = owners[0];
            double smallest = phi(cutters_[owner], middle);
            for (int i : owners)
                if (value = phi(cutters_[i], middle); value < smallest - tolerance_) {
                    owner = i;
                    smallest = value;
                }
            sums_.solid[owner].add(length, PartSum<2>::Local(middle));
        }
    }

    Vec<2> corner_;
    double edge_;
    int tangent_;
    std::span<const Cutter<2>> cutters_;
    double tolerance_;
    FaceSums<2>& sums_;
};

} // namespace

void clip_face(const Vec<2>& corner, const std::array<double, 1>& edges, const std::array<int, 1>& tangents,
               std::span<const Cutter<2>> cutters, double tolerance, FaceSums<2>& sums)
{
    sums.reset(cutters.size());
    SegmentClipper(corner, edges[0], tangents[0], cutters, tolerance, sums).clip();
}

} // namespace gapflow
