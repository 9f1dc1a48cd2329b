#include "gapflow/complex/convex.hpp"

#include <span>

namespace gapflow {
namespace {

Curve line_of(int surface)
{
    Curve c;
    c.surface = surface;
    return c;
}

Curve circle(const Vec<2>& centre, double radius, int surface)
{
    Curve c;
    c.kind = Curve::Kind::ellipse;
    c.centre = centre;
    c.semi1 = c.semi2 = radius;
    c.surface = surface;
    return c;
}

/// In-plane axes of the plane normal to d.
int across(int d, int k)
{
    return (d + 1 + k) % 3;
}

void set_box(Section& section, const Vec<2>& low, const Vec<2>& high)
{
    section.low = low;
    section.high = high;
}

Section round_section(const Vec<2>& centre, double radius)
{
    Section section;
    section.add(circle(centre, radius, 0), centre);
    section.inside = centre;
    set_box(section, centre - Vec<2>::Constant(radius), centre + Vec<2>::Constant(radius));
    return section;
}

/// Polygon with the surface of the side that leaves each corner; counterclockwise.
struct LabelledPolygon {
    std::array<Vec<2>, 16> corner;
    std::array<int, 16> surface;
    int count = 0;
};

/// Its part where normal . x <= room.
void clip(LabelledPolygon& polygon, const Vec<2>& normal, double room, int surface)
{
    LabelledPolygon kept;
    for (int k = 0; k < polygon.count; ++k) {
        const Vec<2>&a = polygon.corner[k], &b = polygon.corner[(k + 1) % polygon.count];
        const double past_a = normal.dot(a) - room, past_b = normal.dot(b) - room;
        if (past_a <= 0) {
            kept.corner[kept.count] = a;
            kept.surface[kept.count++] = polygon.surface[k];
        }
        if ((past_a <= 0) != (past_b <= 0)) {
            kept.corner[kept.count] = a + past_a / (past_a - past_b) * (b - a);
            for (int axis = 0; axis < 2; ++axis)
                if (normal[1 - axis] == 0) // on a side along the grid to the last bit
                    kept.corner[kept.count][axis] = room / normal[axis];
            kept.surface[kept.count++] = past_a <= 0 ? surface : polygon.surface[k];
        }
    }
    polygon = kept;
}

/// The planes' common part, in-plane normals n and rooms, around `centre`.
Section polygon_section(std::span<const Vec<2>> n, std::span<const double> room, const Vec<2>& centre, double reach)
{
    Section section;
    if (n.size() == 1) { // a half-plane: its line only
        section.closed = false;
        if (n[0].squaredNorm() > 0) {
            section.add(line_of(0), centre + room[0] / n[0].squaredNorm() * n[0]);
            section.inside = section.corner[0] - n[0];
            set_box(section, Vec<2>::Constant(-std::numeric_limits<double>::infinity()),
                    Vec<2>::Constant(std::numeric_limits<double>::infinity()));
        }
        return section;
    }
    LabelledPolygon polygon;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        polygon.corner[polygon.count] = 2 * reach * Vec<2>(x, y);
        polygon.surface[polygon.count++] = -1;
    }
    for (std::size_t k = 0; k < n.size(); ++k)
        clip(polygon, n[k], room[k], static_cast<int>(k));
    if (polygon.count < 3)
        return section;
    Vec<2> low = polygon.corner[0], high = low, mean = Vec<2>::Zero();
    for (int k = polygon.count - 1; k >= 0; --k) { // clockwise: side k runs from corner k + 1 to corner k
        section.add(line_of(polygon.surface[k]), centre + polygon.corner[(k + 1) % polygon.count]);
        low = low.cwiseMin(polygon.corner[k]);
        high = high.cwiseMax(polygon.corner[k]);
        mean += polygon.corner[k] / polygon.count;
    }
    section.inside = centre + mean;
    set_box(section, centre + low, centre + high);
    return section;
}

/// Widens a section's box by what its ellipses hold between their corners: all of each.
void widen_box(Section& section)
{
    Vec<2> low = Vec<2>::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (int k = 0; k < section.count; ++k) {
        const Curve& c = section.curve[k];
        low = low.cwiseMin(section.corner[k]);
        high = high.cwiseMax(section.corner[k]);
        if (c.kind == Curve::Kind::ellipse) {
            const Vec<2> half(std::hypot(c.semi1 * c.e1[0], c.semi2 * c.e1[1]),
                              std::hypot(c.semi1 * c.e1[1], c.semi2 * c.e1[0]));
            low = low.cwiseMin(c.centre - half);
            high = high.cwiseMax(c.centre + half);
        }
    }
    set_box(section, low, high);
}

} // namespace

template <int D>
Section BallKind<D>::section(int d, double at) const
{
    if constexpr (D == 2)
        return round_section(centre, radius);
    else {
        const double h = at - centre[d], r2 = radius * radius - h * h;
        if (!(r2 > 0))
            return {};
        return round_section({centre[across(d, 0)], centre[across(d, 1)]}, std::sqrt(r2));
    }
}

template <int D>
Section PlanesKind<D>::section(int d, double at) const
{
    std::array<Vec<2>, 2 * D> n;
    std::array<double, 2 * D> room;
    Vec<2> middle;
    if constexpr (D == 2) {
        for (int k = 0; k < planes; ++k)
            n[k] = normal[k], room[k] = offset[k];
        middle = centre;
    } else {
        for (int k = 0; k < planes; ++k) {
            n[k] = {normal[k][across(d, 0)], normal[k][across(d, 1)]};
            room[k] = offset[k] - normal[k][d] * (at - centre[d]);
        }
        middle = {centre[across(d, 0)], centre[across(d, 1)]};
    }
    const std::size_t count = static_cast<std::size_t>(planes);
    return polygon_section({n.data(), count}, {room.data(), count}, middle, reach);
}

template <int D>
Section RoundKind<D>::section(int d, double at) const
{
    Section section;
    if constexpr (D == 2) {
        const Vec<2> side(-axis[1], axis[0]),
            a = half * axis, w = radius * side; // clockwise: along the left side forwards, around the far end, back
        section.add(line_of(2), centre - a + w);
        section.add(circle(centre + a, radius, 1), centre + a + w);
        section.add(line_of(3), centre + a - w);
        section.add(circle(centre - a, radius, 0), centre - a - w);
        section.inside = centre;
        widen_box(section);
        return section;
    } else {
        // In-plane axes: e2 along the axis's shadow, e1 to its right; y from the centre's foot.
        const Vec<2> foot(centre[across(d, 0)], centre[across(d, 1)]), shadow(axis[across(d, 0)], axis[across(d, 1)]);
        const double p = shadow.norm(), q = axis[d], h = at - centre[d];
        const Vec<2> e2 = p > 0 ? Vec<2>(shadow / p) : Vec<2>::UnitY(), e1(e2[1], -e2[0]);
        const auto point = [&](double y1, double y2) { return Vec<2>(foot + y1 * e1 + y2 * e2); };
        const auto ellipse_at = [&](double y2, double semi2, int surface) {
            Curve c = circle(point(0, y2), radius, surface);
            c.e1 = e1;
            c.semi2 = semi2;
            return c;
        };
        const bool parallel = std::abs(q) < 1e-9; // the side's curves are straight to round-off
        const Curve side = parallel ? line_of(2) : ellipse_at(h / q * p, radius / std::abs(q), 2);
        const auto end_curve = [&](int end,
                                   double corner2) { // where the plane cuts the end; no smaller than its corners are apart
            if (flat)
                return line_of(end > 0);
            const double off = h - end * half * q;
            Curve c = circle(point(0, end * half * p), std::sqrt(std::max(radius * radius - off * off, corner2)), end > 0);
            c.e1 = e1;
            return c;
        };
        // Corners: points of the side at its ends.
        std::array<double, 2> y2, w2;
        for (const int k : {0, 1}) {
            const double rise = (2 * k - 1) * half - q * h;
            y2[k] = p > 0 ? rise / p : std::copysign(std::numeric_limits<double>::infinity(), rise);
            w2[k] = p > 0 ? radius * radius + half * half - h * h - y2[k] * y2[k] : -1;
        }
        if (parallel) // a plane that touches the side to round-off touches all of it
            w2[0] = w2[1] = std::max(w2[0], w2[1]);
        const bool low = w2[0] > 0, high = w2[1] > 0;
        const double w0 = std::sqrt(std::max(w2[0], 0.0)), w1 = std::sqrt(std::max(w2[1], 0.0));
        if (low && high) {
            section.add(side, point(-w0, y2[0]));
            section.add(end_curve(1, w2[1]), point(-w1, y2[1]));
            section.add(side, point(w1, y2[1]));
            section.add(end_curve(-1, w2[0]), point(w0, y2[0]));
            section.inside = point(0, 0.5 * (y2[0] + y2[1]));
        } else if (high) {
            section.add(end_curve(1, w2[1]), point(-w1, y2[1]));
            section.add(side, point(w1, y2[1]));
            section.inside = point(0, y2[1]);
        } else if (low) {
            section.add(side, point(-w0, y2[0]));
            section.add(end_curve(-1, w2[0]), point(w0, y2[0]));
            section.inside = point(0, y2[0]);
        } else if (!parallel && std::abs(h) <= half * std::abs(q)) {
            section.add(side, side.centre);
            section.inside = side.centre;
        } else if (!flat)
            for (const int end : {-1, 1}) { // an end alone: its circle lies past the side's end
                const double off = h - end * half * q, r2 = radius * radius - off * off;
                if (!(r2 > 0) || (end > 0 ? end * half * p < y2[1] : end * half * p > y2[0]))
                    continue;
                section.add(end_curve(end, 0.0), point(0, end * half * p));
                section.inside = section.curve[0].centre;
                break;
            }
        if (!section.empty())
            widen_box(section);
        return section;
    }
}

template <int D>
Slope BallKind<D>::slope(int d, double at, int, const Vec<2>&) const requires(D == 3)
{
    const double h = at - centre[d], r2 = radius * radius - h * h;
    return {r2 > 0 ? h / std::sqrt(r2) : 0.0, Vec<2>::Zero()};
}

template <int D>
Slope PlanesKind<D>::slope(int d, double, int surface, const Vec<2>&) const requires(D == 3)
{
    return flat_slope(normal[surface], d);
}

template <int D>
Slope RoundKind<D>::slope(int d, double at, int surface, const Vec<2>& x) const requires(D == 3)
{
    const double side = surface == 0 ? -1 : 1; // of an end
    if (surface < 2)
        return flat ? flat_slope(side * axis, d) : BallKind<D>{centre + side * half * axis, radius}.slope(d, at, 0, x);
    const int u = across(d, 0), v = across(d, 1);
    if (std::abs(axis[d]) > 1e-7) // n . axis = 0
        return {0, Vec<2>(axis[u], axis[v]) / -axis[d]};
    Vec<D> r;
    r[u] = x[0];
    r[v] = x[1];
    r[d] = at;
    r -= centre;
    return flat_slope((r - r.dot(axis) * axis).normalized(), d);
}

template struct BallKind<2>;
template struct BallKind<3>;
template struct PlanesKind<2>;
template struct PlanesKind<3>;
template struct RoundKind<2>;
template struct RoundKind<3>;

} // namespace gapflow
