// Segments and arcs of solids' borders in a rectangle.
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/square_helpers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace gapflow {

Bulge ArcSegment::bulge() const
{
    if (!curve)
        return {};
    if (whole)
        return backwards ? -whole_ellipse(*curve) : whole_ellipse(*curve);
    return backwards ? -ellipse_bulge(*curve, to, from) : ellipse_bulge(*curve, from, to);
}

double ArcSegment::length() const
{
    if (!curve)
        return (to - from).norm();
    return curve->semi1 * (whole       ? 2 * std::numbers::pi
                           : backwards ? ellipse_angle(*curve, to, from)
                                       : ellipse_angle(*curve, from, to));
}

int ArcSegment::chords() const
{
    if (!curve || (!whole && from == to))
        return 1;
    constexpr double widest = std::numbers::pi / 32;
    const double angle = whole       ? 2 * std::numbers::pi
                         : backwards ? ellipse_angle(*curve, to, from)
                                     : ellipse_angle(*curve, from, to);
    return std::max(1, static_cast<int>(std::ceil(angle / widest)));
}

Vec<2> ArcSegment::at(double t) const
{
    if (!curve)
        return from + t * (to - from);
    if (!whole && from == to)
        return from;
    const Vec<2> a = curve->scaled(from), b = curve->scaled(to), chord = curve->axes(Vec<2>(to - from));
    if (const double half = 0.5 * chord.norm(); !whole && half < 0.5 && a.dot(b) > 0 && (cross(a, chord) <= 0) != backwards) {
        // A small angle: between the ends, so that the centre of a long ellipse costs no digits.
        const double angle = 2 * std::asin(half), to_share = std::sin(t * angle) / std::sin(angle),
                     rest = -2 * std::sin(0.5 * t * angle) * std::sin(0.5 * (1 - t) * angle) / std::cos(0.5 * angle);
        return from + to_share * (to - from) + rest * (curve->centre - from);
    }
    double angle = -std::atan2(cross(a, b), a.dot(b)); // clockwise from a to b
    if (whole)
        angle = 2 * std::numbers::pi;
    else if (backwards)
        angle = angle > 0 ? angle - 2 * std::numbers::pi : angle;
    else
        angle = angle < 0 ? angle + 2 * std::numbers::pi : angle;
    const double c = std::cos(t * angle), s = std::sin(t * angle);
    const Vec<2> at(c * a[0] + s * a[1], c * a[1] - s * a[0]), e2(-curve->e1[1], curve->e1[0]);
    return curve->centre + at[0] * curve->semi1 * curve->e1 + at[1] * curve->semi2 * e2;
}

double ArcSegment::nearest(const Vec<2>& x) const
{
    if (!whole && from == to)
        return 0;
    if (!curve) {
        const Vec<2> way = to - from;
        return std::clamp((x - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    }
    const Vec<2> a = curve->scaled(from), b = curve->scaled(to), s = curve->scaled(x);
    if (const Vec<2> chord = curve->axes(Vec<2>(to - from));
        !whole && chord.norm() < 1e-4 && (cross(a, chord) <= 0) != backwards) // straight but for a millionth
        return std::clamp((x - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
    const double turn = backwards ? -1 : 1;
    const auto angle = [&](const Vec<2>& y) { // from a, along the way
        const double way = -turn * std::atan2(cross(a, y), a.dot(y));
        return way < 0 ? way + 2 * std::numbers::pi : way;
    };
    const double all = whole ? 2 * std::numbers::pi : angle(b), here = angle(s);
    if (here <= all)
        return all > 0 ? here / all : 0.0;
    return (x - from).squaredNorm() < (x - to).squaredNorm() ? 0.0 : 1.0;
}

ArcSegment ArcSegment::part(double t0, double t1) const
{
    ArcSegment result = *this;
    result.from = t0 > 0 ? at(t0) : from;
    result.to = t1 < 1 ? at(t1) : to;
    result.whole = whole && t0 == 0 && t1 == 1;
    return result;
}

Bulge SquareArc::bulge() const
{
    Bulge sum;
    for (std::size_t k = 0; k < segments.size(); ++k) {
        sum += segments[k].bulge();
        if (k > 0)
            sum += triangle(from, segments[k].from, segments[k].to);
    }
    return sum;
}

void add_walk(SquareArc& arc, const Section& section, const Vec<2>& A, const Vec<2>& B, bool around, bool backwards)
{
    const Section::Walk way = section.walk(A, B, around);
    const std::size_t n = way.points.size() - 1;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t at = backwards ? n - 1 - k : k;
        const Curve& c = section.curve[way.curves[at]];
        ArcSegment segment{way.points[at], way.points[at + 1], c.kind == Curve::Kind::ellipse ? &c : nullptr,
                           c.surface,      backwards,          false};
        if (backwards)
            std::swap(segment.from, segment.to);
        if (around && n == 1 && segment.curve && (A - B).squaredNorm() < 1e-20)
            segment.whole = true;
        arc.segments.push_back(segment);
    }
}

} // namespace gapflow
