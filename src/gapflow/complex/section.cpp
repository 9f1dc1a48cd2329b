#include "gapflow/complex/section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gapflow {
namespace {

/// Clockwise angle from a to b, 0 .. 2 pi.
double clockwise(const Vec<2>& a, const Vec<2>& b)
{
    const double angle = -std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

} // namespace

std::pair<int, double> Section::locate(const Vec<2>& x) const
{
    int best = 0;
    double least = std::numeric_limits<double>::infinity(), along = 0;
    for (int k = 0; k < count; ++k) {
        const Vec<2>&from = corner[k], &to = corner[(k + 1) % count];
        double distance, place;
        if (curve[k].kind == Curve::Kind::line) {
            const Vec<2> way = to - from, r = x - from;
            const double length2 = way.squaredNorm();
            place = length2 > 0 ? r.dot(way) / length2 : 0;
            distance = (r - std::clamp(place, 0.0, 1.0) * way).squaredNorm();
        } else {
            const Vec<2> a = curve[k].scaled(from), s = curve[k].scaled(x);
            const double end = clockwise(a, curve[k].scaled(to)), past = 0.5 * (end + 2 * std::numbers::pi);
            place = clockwise(a, s);
            if (place > past) // nearer to the start, before it
                place -= 2 * std::numbers::pi;
            if (place < 0)
                distance = (x - from).squaredNorm();
            else if (place > end)
                distance = (x - to).squaredNorm();
            else {
                const double off = (s.norm() - 1) * std::min(curve[k].semi1, curve[k].semi2);
                distance = off * off;
            }
        }
        if (distance < least) {
            least = distance;
            best = k;
            along = place;
        }
    }
    return {best, along};
}

Section::Walk Section::walk(const Vec<2>& A, const Vec<2>& B, bool around) const
{
    Walk walk;
    walk.points.push_back(A);
    if (single()) {
        walk.curves.push_back(0);
        walk.points.push_back(B);
        return walk;
    }
    const auto [first, from] = locate(A);
    const auto [last, to] = locate(B);
    int steps = (last - first + count) % count;
    if (steps == 0 && to < from) // B lies before A: all the way round
        steps = count;
    if ((A - B).squaredNorm() < 1e-20) // unless both are one point
        steps = around ? (steps == 0 ? count : steps) : 0;
    for (int k = 0; k < steps; ++k) {
        walk.curves.push_back((first + k) % count);
        walk.points.push_back(corner[(first + k + 1) % count]);
    }
    walk.curves.push_back(last);
    walk.points.push_back(B);
    return walk;
}

Bulge Section::piece(const Vec<2>& A, const Vec<2>& B, bool around) const
{
    if (empty()) // the plane touches the solid: covered to round-off only
        return {};
    if (single()) {
        if (curve[0].kind == Curve::Kind::line)
            return {};
        if ((A - B).squaredNorm() < 1e-20)
            return around ? whole() : Bulge{};
        return ellipse_bulge(curve[0], A, B);
    }
    const Walk way = walk(A, B, around);
    Bulge sum;
    for (std::size_t k = 0; k + 1 < way.points.size(); ++k) {
        const Curve& c = curve[way.curves[k]];
        if (c.kind == Curve::Kind::ellipse)
            sum += ellipse_bulge(c, way.points[k], way.points[k + 1]);
        if (k > 0)
            sum += triangle(A, way.points[k], way.points[k + 1]);
    }
    return sum;
}

Bulge Section::whole() const
{
    if (single())
        return whole_ellipse(curve[0]);
    Bulge sum;
    for (int k = 0; k < count; ++k) {
        const Vec<2>&from = corner[k], &to = corner[(k + 1) % count];
        if (curve[k].kind == Curve::Kind::ellipse)
            sum += ellipse_bulge(curve[k], from, to);
        sum += triangle(corner[0], from, to);
    }
    return sum;
}

} // namespace gapflow
