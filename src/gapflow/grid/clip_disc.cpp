// The part of a disc in a polygon is bounded by the polygon's edges where they are inside the circle, and by the circle where they
// are outside: each piece of an edge outside is projected onto the circle from its centre. That chain is closed. Its area is that
// of the polygon of its points, and of the circular segments over its arcs' chords, with s the sine of an arc's half angle a,
//
//     A = r^2 (a - s cos a),    first moment about the chord    r^3 (2/3 s^3 - (a - s cos a) cos a),    away from the centre,
//
// both odd in a: arcs that go back take off what those that go on have given, so no case is told from another, and all is
// continuous in the places. With areas of segments instead of sectors the round-off is that of places, not of r^2.
#include "gapflow/grid/clip_disc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {

namespace {

using Point = Eigen::Vector2d;

double cross(const Point& a, const Point& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// Of the triangle over a polygon's first corner and an edge from a to b.
void add_triangle(const Point& first, const Point& a, const Point& b, PartSum<3>& sum)
{
    const Point to_a = a - first, to_b = b - first;
    sum.add(0.5 * cross(to_a, to_b), first + (to_a + to_b) / 3);
}

// a - sin a cos a of s = sin a >= 0 and cos a >= 0; its series where the difference would lose digits.
double segment(double s, double cosine)
{
    const double q = s * s;
    if (q > 0.02)
        return std::atan2(s, cosine) - s * cosine;
    return s * q *
           (2. / 3 + q * (1. / 5 + q * (3. / 28 + q * (5. / 72 + q * (35. / 704 + q * (63. / 1664 + q * (77. / 2560)))))));
}

// The boundary of the part, as it is walked along.
class Chain {
public:
    explicit Chain(const Disc& disc) : disc_(disc) {}

    void line_to(const Point& x)
    {
        if (empty_) {
            first_ = last_ = x;
            empty_ = false;
            return;
        }
        add_triangle(first_, last_, x, sum_);
        last_ = x;
    }

    // From a point on the circle to another, the short way.
    void arc_to(const Point& x)
    {
        if (!empty_) {
            const Point from = last_ - disc_.centre, to = x - disc_.centre, chord = x - last_;
            const double r = disc_.radius, r2 = r * r;
            const double s = std::min(0.5 * chord.norm() / r, 1.0),
                         cosine = std::sqrt(std::max(0.5 * (1 + from.dot(to) / r2), 0.0));
            const double sign = cross(from, to) < 0 ? -1 : 1;
            const double f = segment(s, cosine);
            sum_.add(sign * r2 * f, 0.5 * (last_ + x));
            if (s > 0) // along the chord's normal, which turns with the sign
                sum_.moment += 0.5 * r2 * (2. / 3 * s * s - f * cosine / s) * Point(chord.y(), -chord.x());
        }
        line_to(x);
    }

    PartSum<3> sum() const { return sum_; }
    const Point& first() const { return first_; }

private:
    const Disc& disc_;
    Point first_, last_;
    bool empty_ = true;
    PartSum<3> sum_;
};

} // namespace

PartSum<3> area_of(std::span<const Point> polygon)
{
    PartSum<3> sum;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        add_triangle(polygon[0], polygon[i], polygon[i + 1], sum);
    return sum;
}

PartSum<3> area_inside(const Disc& disc, std::span<const Point> polygon)
{
    const double r = disc.radius;
    const std::size_t n = polygon.size();
    if (n < 3 || !(r > 0))
        return {};
    double size = 0; // no two corners are farther from each other
    for (const Point& x : polygon)
        size = std::max(size, (x - polygon[0]).squaredNorm());
    size = 2 * std::sqrt(size);
    // Seen from the centre of a disc as large as this, what is outside of it spans less than half a turn: one arc will do.
    const bool projects = r < size;
    const auto onto_circle = [&](const Point& x) {
        const Point a = x - disc.centre;
        return Point(disc.centre + r / a.norm() * a);
    };
    const auto is_inside = [&](const Point& x) { return (x - disc.centre).squaredNorm() < r * r; };

    Chain chain(disc);
    const bool begins_inside = is_inside(polygon[0]);
    if (begins_inside)
        chain.line_to(polygon[0]);
    else if (projects)
        chain.line_to(onto_circle(polygon[0]));
    bool inside = begins_inside, crosses = false, left_of_all = true;
    for (std::size_t i = 0; i < n; ++i) {
        const Point &p = polygon[i], &q = polygon[i + 1 < n ? i + 1 : 0];
        const bool ends_inside = i + 1 < n ? is_inside(q) : begins_inside;
        const Point a = p - disc.centre, d = q - p;
        const double length = d.norm(), height = length > 0 ? cross(a, d) / length : r; // of the centre over the edge
        left_of_all &= height > 0;
        if (!inside || !ends_inside) {
            const double half = std::sqrt(std::max((r - height) * (r + height), 0.0));
            const double foot = length > 0 ? -a.dot(d) / length : 0;
            const bool through = inside != ends_inside || (half > 0 && foot > 0 && foot < length);
            const auto at = [&](double along) { return Point(length > 0 ? p + std::clamp(along / length, 0.0, 1.0) * d : p); };
            if (through && !inside)
                chain.arc_to(at(foot - half));
            if (through && !ends_inside)
                chain.line_to(at(foot + half));
            if (!ends_inside && projects)
                chain.arc_to(onto_circle(q));
            crosses |= through;
        }
        if (ends_inside)
            chain.line_to(q);
        inside = ends_inside;
    }
    if (!crosses && !begins_inside) {
        const double area = left_of_all ? std::numbers::pi * r * r : 0;
        return {area, area * disc.centre};
    }
    if (!begins_inside)
        chain.arc_to(Point(chain.first()));
    return chain.sum();
}

} // namespace gapflow
