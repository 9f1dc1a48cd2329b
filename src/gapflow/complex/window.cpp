#include "gapflow/complex/window.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

/// Where along the way, 0 .. 1, the segment crosses a side, `turn` the clockwise angle of an ellipse's piece.
std::vector<double> crossings(const ArcSegment& segment, double turn, double start, const Vec<2>& low, const Vec<2>& high)
{
    std::vector<double> stops{0, 1};
    const auto offer = [&](double t) {
        if (t > 0 && t < 1)
            stops.push_back(t);
    };
    for (int k = 0; k < 2; ++k)
        for (const double side : {low[k], high[k]}) {
            if (!std::isfinite(side))
                continue;
            if (!segment.curve) {
                const double a = segment.from[k] - side, b = segment.to[k] - side;
                if ((a > 0) != (b > 0))
                    offer(a / (a - b));
                continue;
            }
            const Curve& c = *segment.curve;
            const double cosine = c.semi1 * c.e1[k], sine = c.semi2 * (k ? c.e1[0] : -c.e1[1]), most = std::hypot(cosine, sine);
            if (!(std::abs(side - c.centre[k]) < most))
                continue;
            const double out = std::acos((side - c.centre[k]) / most), top = std::atan2(sine, cosine);
            for (const double angle : {top - out, top + out}) {
                const double way = start - angle, round = 2 * std::numbers::pi;
                offer((way - round * std::floor(way / round)) / turn);
            }
        }
    std::ranges::sort(stops);
    return stops;
}

} // namespace

std::vector<WindowPart> parts_in_window(const ArcSegment& segment, const Vec<2>& low, const Vec<2>& high)
{
    double turn = 0, start = 0;
    if (segment.curve) {
        const Vec<2> from = segment.curve->scaled(segment.from);
        start = std::atan2(from[1], from[0]);
        turn = segment.whole ? 2 * std::numbers::pi : ellipse_angle(*segment.curve, segment.from, segment.to);
    }
    const auto at = [&](double t) -> Vec<2> {
        if (t == 0 || t == 1)
            return t == 0 ? segment.from : segment.to;
        if (!segment.curve)
            return segment.from + t * (segment.to - segment.from);
        const Curve& c = *segment.curve;
        const double angle = start - t * turn, x = c.semi1 * std::cos(angle), y = c.semi2 * std::sin(angle);
        return c.centre + Vec<2>(x * c.e1[0] - y * c.e1[1], x * c.e1[1] + y * c.e1[0]);
    };
    const std::vector<double> stops = crossings(segment, turn, start, low, high);
    std::vector<WindowPart> parts;
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
        if (!(stops[k] < stops[k + 1]))
            continue;
        WindowPart part{segment, false, at(0.5 * (stops[k] + stops[k + 1]))};
        part.segment.from = at(stops[k]);
        part.segment.to = at(stops[k + 1]);
        part.segment.whole = segment.whole && stops.size() == 2;
        part.inside = (part.middle.array() > low.array()).all() && (part.middle.array() < high.array()).all();
        parts.push_back(part);
    }
    return parts;
}

Bulge enclosed_in_window(const ArcSegment& segment, const Vec<2>& low, const Vec<2>& high)
{
    Bulge sum;
    for (const WindowPart& part : parts_in_window(segment, low, high)) {
        if (part.middle[1] < low[1] || part.middle[1] > high[1])
            continue;
        Vec<2> a = part.segment.from, b = part.segment.to;
        if (part.inside)
            sum += part.segment.bulge();
        else
            a[0] = b[0] = std::clamp(part.middle[0], low[0], high[0]);
        const double rise = b[1] - a[1];
        sum.area += 0.5 * rise * (a[0] + b[0]);
        sum.moment[0] += rise / 6 * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]);
        sum.moment[1] += rise / 6 * (2 * a[0] * a[1] + a[0] * b[1] + b[0] * a[1] + 2 * b[0] * b[1]);
    }
    return sum;
}

} // namespace gapflow
