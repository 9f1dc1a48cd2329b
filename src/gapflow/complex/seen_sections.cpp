#include "gapflow/complex/seen_sections.hpp"

#include "gapflow/complex/surface_rate.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <type_traits>

namespace gapflow {
namespace {

/// The reference point in the plane.
Vec<2> reference_in(const PlacedSolid<3>& solid, int d)
{
    return {solid.reference[u_axis<3>(d)], solid.reference[v_axis<3>(d)]};
}

/// The window in a plane, (u, v), from a point of it.
struct Rectangle {
    Vec<2> low, high;
};
Rectangle rectangle_of(const Window<3>& window, int d, const Vec<2>& from)
{
    const int u = u_axis<3>(d), v = v_axis<3>(d);
    return {Vec<2>(window.low[u], window.low[v]) - from, Vec<2>(window.high[u], window.high[v]) - from};
}

/// Calls f(segment) for those of a section's border.
template <class F>
void for_each_segment(const Section& section, F&& f)
{
    for (int k = 0; k < section.count; ++k) {
        const Curve& c = section.curve[k];
        ArcSegment segment{section.corner[k], section.corner[(k + 1) % section.count],
                           c.kind == Curve::Kind::ellipse ? &c : nullptr, c.surface};
        if (section.single()) {
            segment.from = segment.to = c.centre + c.semi1 * c.e1;
            segment.whole = true;
        }
        f(segment);
    }
}

template <class Kind>
SeenVolume<2> sum_of_convex(const Kind& kind, const PlacedSolid<2>& solid, int d, const Planes& planes, const Window<2>& window)
{
    SeenVolume<2> sum;
    const int axis = 1 - d;
    const double end = std::min(planes.last, solid.high[d]);
    for (double at = planes.from(solid.low[d]); at <= end; ++at) {
        Stretch s = kind.line(axis, at * unit<2>(d));
        s.cut({window.low[axis], window.high[axis]});
        if (s.empty())
            continue;
        sum.volume += s.to - s.from;
        sum.moment[axis] += (s.to - s.from) * (0.5 * (s.to + s.from) - solid.reference[axis]);
    }
    return sum;
}

template <class Kind>
SeenVolume<3> sum_of_convex(const Kind& kind, const PlacedSolid<3>& solid, int d, const Planes& planes, const Window<3>& window)
{
    SeenVolume<3> sum;
    const bool whole = window.holds(solid);
    const Rectangle rectangle = rectangle_of(window, d, Vec<2>::Zero());
    const Vec<2> reference = reference_in(solid, d);
    const double end = std::min(planes.last, solid.high[d]);
    for (double at = planes.from(solid.low[d]); at <= end; ++at) {
        const Section section = kind.section(d, at);
        if (section.empty())
            continue;
        Bulge enclosed; // clockwise
        if (whole)
            enclosed = section.whole();
        else
            for_each_segment(section, [&](const ArcSegment& segment) {
                enclosed += enclosed_in_window(segment, rectangle.low, rectangle.high);
            });
        sum.volume -= enclosed.area;
        for (const auto& [k, axis] : {std::pair{0, u_axis<3>(d)}, {1, v_axis<3>(d)}})
            sum.moment[axis] -= enclosed.moment[k] - reference[k] * enclosed.area;
    }
    return sum;
}

template <int D, class Kind>
SeenVolume<D> sum_of_sections(const Kind& kind, const PlacedSolid<D>& solid, int d, const Planes& planes,
                              const Window<D>& window)
{
    return sum_of_convex(kind, solid, d, planes, window);
}

template <int D>
SeenVolume<D> sum_of_sections(const BallKind<D>& kind, const PlacedSolid<D>& solid, int d, const Planes& planes,
                              const Window<D>& window)
{
    if (!window.holds(solid))
        return sum_of_convex(kind, solid, d, planes, window);
    SeenVolume<D> sum;
    const double end = std::min(planes.last, kind.centre[d] + kind.radius);
    for (double at = planes.from(kind.centre[d] - kind.radius); at <= end; ++at) {
        const double r2 = kind.radius * kind.radius - (at - kind.centre[d]) * (at - kind.centre[d]);
        sum.volume += r2 > 0 ? (D == 2 ? 2 * std::sqrt(r2) : std::numbers::pi * r2) : 0.0;
    }
    sum.moment = sum.volume * (kind.centre - solid.reference);
    sum.moment[d] = 0;
    return sum;
}

template <int D>
SeenVolume<D> sum_of_sections(const FacetKind<D>& kind, const PlacedSolid<D>& solid, int d, const Planes& planes,
                              const Window<D>& window)
{
    // The border of each section, facet by facet: 1/2 x cross dx and 1/3 x of it; in 2D its ends.
    SeenVolume<D> sum;
    const bool whole = window.holds(solid);
    for (const auto& element : kind.surface->elements) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const int i : element) {
            low = std::min(low, kind.vertices[i][d]);
            high = std::max(high, kind.vertices[i][d]);
        }
        for (double at = planes.from(low); at < high && at <= planes.last; ++at) { // a vertex in the plane lies below it
            std::array<Vec<D>, 2> up_down; // where the facet's border goes up through the plane and where down
            for (int k = 0; k < D; ++k) {
                const Vec<D>&a = kind.vertices[element[k]], &b = kind.vertices[element[(k + 1) % D]];
                const bool above_a = a[d] > at, above_b = b[d] > at;
                if (above_a == above_b)
                    continue;
                const double t = (at - a[d]) / (b[d] - a[d]);
                const Vec<D> x = a + t * (b - a) - solid.reference;
                if constexpr (D == 2) {
                    // The solid lies on the left of the segment from a to b: upwards along x its interior has smaller y.
                    const double sign = (d == 0 ? 1 : -1) * (above_b ? -1 : 1);
                    const int axis = 1 - d;
                    const double end = std::clamp(x[axis], window.low[axis] - solid.reference[axis],
                                                  window.high[axis] - solid.reference[axis]);
                    sum.volume += sign * end;
                    sum.moment[axis] += 0.5 * sign * end * end;
                    break;
                } else
                    up_down[above_b ? 0 : 1] = x;
            }
            if constexpr (D == 3) {
                const int u = u_axis<3>(d), v = v_axis<3>(d);
                if (!whole) {
                    const Rectangle rectangle = rectangle_of(window, d, reference_in(solid, d));
                    const Bulge enclosed =
                        enclosed_in_window({Vec<2>(up_down[1][u], up_down[1][v]), Vec<2>(up_down[0][u], up_down[0][v])},
                                           rectangle.low, rectangle.high);
                    sum.volume += enclosed.area;
                    sum.moment[u] += enclosed.moment[0];
                    sum.moment[v] += enclosed.moment[1];
                    continue;
                }
                const double area = 0.5 * (up_down[1][u] * up_down[0][v] - up_down[1][v] * up_down[0][u]);
                sum.volume += area;
                for (const int axis : {u, v})
                    sum.moment[axis] += area / 3 * (up_down[0][axis] + up_down[1][axis]);
            }
        }
    }
    return sum;
}

/// Calls f(at) for the planes between two places.
template <class F>
void for_each_plane(double low, double high, const Planes& planes, F&& f)
{
    const double end = std::min(planes.last, high);
    for (double at = planes.from(low); at <= end; ++at)
        f(at);
}

template <class Kind>
void add_rates_of_convex(const Kind& kind, const PlacedSolid<2>& solid, int d, const Planes& planes, const Window<2>& window,
                         PieceRate<2>& rate)
{
    for_each_plane(solid.low[d], solid.high[d], planes, [&](double at) {
        const int axis = 1 - d;
        Vec<2> x = at * unit<2>(d);
        const Stretch s = kind.line(axis, x);
        if (s.empty())
            return;
        for (const bool last : {false, true}) {
            x[axis] = last ? s.to : s.from;
            if (x[axis] > window.low[axis] && x[axis] < window.high[axis]) {
                const auto [place, normal] = end_of_rates(kind, axis, x, last);
                add_end(axis, last ? -1 : 1, x, solid.reference[axis], solid.reference - (place - x), normal, rate);
            }
        }
    });
}

/// Of a segment of a border what lies in the window. `slope` of a piece of it.
template <class F>
void add_rate_within(const FacePlane& plane, const PlacedSolid<3>& solid, const ArcSegment& segment, const Window<3>& window,
                     F&& slope, PieceRate<3>& rate)
{
    if (window.holds(solid)) {
        add_segment(plane, solid.reference, segment, slope(segment), rate);
        return;
    }
    const Rectangle rectangle = rectangle_of(window, plane.d, Vec<2>::Zero());
    for (const WindowPart& part : parts_in_window(segment, rectangle.low, rectangle.high))
        if (part.inside)
            add_segment(plane, solid.reference, part.segment, slope(part.segment), rate);
}

template <class Kind>
void add_rates_of_convex(const Kind& kind, const PlacedSolid<3>& solid, int d, const Planes& planes, const Window<3>& window,
                         PieceRate<3>& rate)
{
    for_each_plane(solid.low[d], solid.high[d], planes, [&](double at) {
        const Section section = kind.section(d, at);
        if (section.empty())
            return;
        for_each_segment(section, [&](const ArcSegment& segment) {
            add_rate_within(
                {d, at, reference_in(solid, d)}, solid, segment, window,
                [&](const ArcSegment& part) { return kind.slope(d, at, part.surface, Vec<2>(0.5 * (part.from + part.to))); },
                rate);
        });
    });
}

/// By the facets' normals, out of what is enclosed.
template <int D>
void add_rates_of_facets(const FacetKind<D>& kind, const PlacedSolid<D>& solid, int d, const Planes& planes,
                         const Window<D>& window, PieceRate<D>& rate)
{
    for (std::size_t facet = 0; facet < kind.surface->elements.size(); ++facet) {
        const auto& element = kind.surface->elements[facet];
        std::array<double, D> place;
        for (int k = 0; k < D; ++k)
            place[k] = kind.vertices[element[k]][d];
        const auto [low, high] = std::minmax_element(place.begin(), place.end());
        const Vec<D> normal = facet_normal(kind, static_cast<int>(facet));
        for_each_plane(*low, *high, planes, [&](double at) {
            if (*low > at || *high <= at) // a vertex in the plane lies below it
                return;
            InlineVector<Vec<D>, 2> cut;
            for (int k = 0; k < (D == 2 ? 1 : D); ++k) {
                const Vec<D>&a = kind.vertices[element[k]], &b = kind.vertices[element[(k + 1) % D]];
                if ((a[d] > at) != (b[d] > at))
                    cut.push_back(a + (at - a[d]) / (b[d] - a[d]) * (b - a));
            }
            if constexpr (D == 2) {
                if (cut[0][1 - d] > window.low[1 - d] && cut[0][1 - d] < window.high[1 - d])
                    add_end(1 - d, normal[1 - d] > 0 ? -1 : 1, cut[0], solid.reference[1 - d], solid.reference, normal, rate);
            } else {
                const int u = u_axis<3>(d), v = v_axis<3>(d);
                Vec<2> from(cut[0][u], cut[0][v]), to(cut[1][u], cut[1][v]);
                if ((to - from)[0] * normal[v] < (to - from)[1] * normal[u])
                    std::swap(from, to);
                add_rate_within(
                    {d, at, reference_in(solid, d)}, solid, {from, to}, window,
                    [&](const ArcSegment&) { return flat_slope(normal, d); }, rate);
            }
        });
    }
}

} // namespace

template <int D>
SeenVolume<D> sum_of_sections(const PlacedSolid<D>& solid, int d, const Planes& planes, const Window<D>& window)
{
    const SeenVolume<D> sum =
        std::visit([&](const auto& kind) { return sum_of_sections(kind, solid, d, planes, window); }, solid.kind);
    return sum.volume < 0 ? -sum : sum; // facets of a surface that is inside out
}

template <int D>
SeenVolumeRate<D> rate_of_sections(const PlacedSolid<D>& solid, int d, const Planes& planes, const Window<D>& window)
{
    return std::visit(
        [&](const auto& kind) -> SeenVolumeRate<D> {
            PieceRate<D> open{solid.solid}; // of what is open
            if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<D>>) {
                add_rates_of_facets(kind, solid, d, planes, window, open);
                if (sum_of_sections(kind, solid, d, planes, window).volume < 0)
                    return {open.area, open.moment};
            } else
                add_rates_of_convex(kind, solid, d, planes, window, open);
            return {-open.area, -open.moment};
        },
        solid.kind);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template SeenVolume<D> sum_of_sections(const PlacedSolid<D>&, int, const Planes&, const Window<D>&);                       \
    template SeenVolumeRate<D> rate_of_sections(const PlacedSolid<D>&, int, const Planes&, const Window<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
