// With p(x) = |x - c|^2 - r^2 the power of a place to a circle, p_a = p_b is the line through the points where two circles cross. On the
// side where p_a > p_b all that lies in a's disc lies in b's: what two discs share is a's on that side and b's on the other,
// and what they cover is the other way round.
#include "gapflow/grid/sphere_sections.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

using Point = Eigen::Vector2d;

double power(const Disc& disc, const Point& x)
{
    return (x - disc.centre).squaredNorm() - disc.radius * disc.radius;
}

// The part of a convex polygon where the power to `near` is the smaller one.
std::vector<Point> nearer_part(std::span<const Point> polygon, const Disc& near, const Disc& other)
{
    std::vector<Point> part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &p = polygon[i], &q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double f = power(near, p) - power(other, p), g = power(near, q) - power(other, q);
        if (f <= 0)
            part.push_back(p);
        if ((f < 0 && g > 0) || (f > 0 && g < 0))
            part.push_back(p + f / (f - g) * (q - p));
    }
    return part;
}

// Does a ball, one of the cutters, overlap others?
bool overlaps(std::span<const Cutter<3>> cutters, std::size_t ball, const Vec<3>& centre, double radius)
{
    for (std::size_t other = 0; other < cutters.size(); ++other)
        if (other != ball && cutters[other].shape->distance(centre) < radius)
            return true;
    return false;
}

} // namespace

bool SphereSections::take(const Vec<3>& corner, const std::array<int, 2>& tangents, std::span<const Cutter<3>> cutters,
                          double tolerance)
{
    clear();
    const int normal = 3 - tangents[0] - tangents[1];
    bool flat = false;
    int hollows = 0;
    for (std::size_t i = 0; i < cutters.size(); ++i) {
        const PlacedShape<3>& placed = *cutters[i].shape;
        if (!cutters[i].planes.empty()) {
            flat = true;
            continue;
        }
        const std::optional<double> radius = placed.shape().sphere_radius();
        const bool hollow = placed.shape().inside_out();
        const Vec<3> centre = placed.to_world(Vec<3>::Zero()), x = centre - corner;
        hollows += hollow;
        if (!radius || (!hollow && overlaps(cutters, i, centre, *radius - tolerance))) {
            clear();
            return false;
        }
        const double height = x[normal];
        sections_.push_back(
            {i, {{x[tangents[0]], x[tangents[1]]}, std::sqrt(std::max((*radius - height) * (*radius + height), 0.0))}, hollow});
    }
    if (hollows + flat > 1 && hollows > 0)
        clear();
    return !empty();
}

PartSum<3> SphereSections::part(const Section& section, std::span<const Point> polygon) const
{
    if (!section.hollow)
        return part_of_ball(section, polygon);
    PartSum<3> part = area_of(polygon);
    part -= area_inside(section.disc, polygon);
    return part;
}

PartSum<3> SphereSections::part_of_ball(const Section& ball, std::span<const Point> polygon) const
{
    std::vector<Point> mine; // where other balls have taken off a part
    const Disc* hole = nullptr;
    for (const Section& other : sections_)
        if (other.hollow) {
            hole = &other.disc;
        } else if (&other != &ball && (ball.disc.centre - other.disc.centre).norm() < ball.disc.radius + other.disc.radius) {
            mine = nearer_part(polygon, ball.disc, other.disc);
            polygon = mine;
        }
    if (!hole)
        return area_inside(ball.disc, polygon);
    PartSum<3> part = area_inside(*hole, nearer_part(polygon, ball.disc, *hole));
    part += area_inside(ball.disc, nearer_part(polygon, *hole, ball.disc));
    return part;
}

} // namespace gapflow
