#include "gapflow/complex/surface_rate.hpp"

#include "gapflow/complex/facet_area.hpp"

#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/parameters.hpp"

#include <cmath>

namespace gapflow {

template <int D>
Vec<D> facet_normal(const FacetKind<D>& kind, int facet)
{
    return facet_area<D>(kind.vertices, kind.surface->elements[facet]).normalized();
}

double plane_of_rates(const BallKind<2>& disk, int d, double at)
{
    constexpr double way = 0.05; // small_way of step/displaced
    // The chord at the depth y has the slope y^(-1/2), and the mean of it over way to both sides, or to the surface, is (y + way)^(1/2)/way.
    const double side = at < disk.centre[d] ? -1 : 1, depth = std::max(disk.radius - side * (at - disk.centre[d]), 0.0),
                 mean = way * way / (depth + way);
    return mean > depth && mean < disk.radius ? disk.centre[d] + side * (disk.radius - mean) : at;
}

Slope slope_of(const PlacedSolid<3>& solid, int d, double at, const ArcSegment& segment)
{
    if (segment.surface == -1)
        return {};
    if (segment.surface < -1) { // the bisector of two facets, which moves with the solid; its normal at the segment's left
        const SharpEdge& edge = solid.sharp.edges[surface_of_fin(segment.surface)];
        Vec<3> normal = (solid.sharp.facets[edge.a].normal - solid.sharp.facets[edge.b].normal).normalized();
        const Vec<2> way = segment.to - segment.from;
        if (normal[(d + 2) % 3] * way[0] - normal[(d + 1) % 3] * way[1] < 0)
            normal = -normal;
        return flat_slope(normal, d);
    }
    return std::visit(
        [&](const auto& kind) {
            if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<3>>)
                return flat_slope(facet_normal(kind, segment.surface), d);
            else {
                Slope slope = kind.slope(d, at, segment.surface, Vec<2>(0.5 * (segment.from + segment.to)));
                if (solid.inverse)
                    slope.constant = -slope.constant;
                return slope;
            }
        },
        solid.kind);
}

namespace {

/// Velocity, normal to a rim's chord in a face, of one of its ends over the solid's twist: where the cone crosses an edge of the grid, or at the rim
/// itself.
Twist<3> chord_end_speed(const SharpRim& rim, const Vec<3>& reference, int d, double at, const Vec<2>& end, int edge,
                         const Vec<3>& normal)
{
    Vec<3> x;
    x[d] = at;
    x[u_axis<3>(d)] = end[0];
    x[v_axis<3>(d)] = end[1];
    const Vec<3> r = x - rim.centre, radial = (r - r.dot(rim.normal) * rim.normal).normalized();
    if (edge >= 0) { // along the edge
        const int along = edge_axis<3>(d, edge);
        const Vec<3> cone = rim.normal - radial;
        return lever<3>(cone * (normal[along] / cone[along]), x - reference);
    }
    const Vec<3> tangent = rim.normal.cross(radial); // with the rim, less what leaves the plane along it
    return lever<3>(normal - normal.dot(tangent) / tangent[d] * Vec<3>::Unit(d), x - reference);
}

} // namespace

RimSpeeds rim_speeds(const SharpRim& rim, const Vec<3>& reference, int d, double at, const Vec<2>& low, const Vec<2>& high,
                     const ArcSegment& segment)
{
    const Vec<2> way = segment.to - segment.from;
    const double length = way.norm();
    double least = std::numeric_limits<double>::infinity();
    RimLine chord;
    for (const RimLine& line : rim_lines(rim, d, at, low, high)) {
        const Vec<2> along = (line.to - line.from).normalized();
        double off = 0;
        for (const Vec<2>& x : {segment.from, segment.to})
            off += std::abs((x - line.from)[0] * along[1] - (x - line.from)[1] * along[0]);
        if (off < least) {
            least = off;
            chord = line;
        }
    }
    if (!(least < length) || !(length > 0))
        return {};
    Vec<3> normal = Vec<3>::Zero();
    normal[u_axis<3>(d)] = -way[1] / length;
    normal[v_axis<3>(d)] = way[0] / length;
    const Twist<3> from = chord_end_speed(rim, reference, d, at, chord.from, chord.from_edge, normal),
                   to = chord_end_speed(rim, reference, d, at, chord.to, chord.to_edge, normal);
    const Vec<2> whole = chord.to - chord.from;
    const auto speed = [&](const Vec<2>& x) {
        const double t = (x - chord.from).dot(whole) / whole.squaredNorm();
        return Twist<3>((1 - t) * from + t * to);
    };
    return {speed(segment.from), speed(segment.to)};
}

namespace {

/// Unit normal of a segment at one of its ends, at the left of its way.
Vec<2> normal_of(const ArcSegment& segment, bool end)
{
    const Vec<2> way = segment.to - segment.from;
    if (!segment.curve)
        return Vec<2>(-way[1], way[0]).normalized();
    const Curve& c = *segment.curve;
    const Vec<2> s = c.scaled(end ? segment.to : segment.from), e2(-c.e1[1], c.e1[0]);
    return (segment.backwards ? -1 : 1) * (s[0] / c.semi1 * c.e1 + s[1] / c.semi2 * e2).normalized();
}

} // namespace

template <int D>
MovingLine<D> moving_line(const std::vector<PlacedSolid<D>>& solids, int image, int d, double at, const ArcSegment& segment,
                          bool end)
{
    const Vec<2> normal = normal_of(segment, end), &x = end ? segment.to : segment.from;
    Vec<D> n_space, place;
    n_space[u_axis<D>(d)] = normal[0];
    n_space[v_axis<D>(d)] = normal[1];
    place[u_axis<D>(d)] = x[0];
    place[v_axis<D>(d)] = x[1];
    if constexpr (D == 3) {
        const Slope slope = slope_of(solids[image], d, at, segment);
        n_space[d] = slope.constant + slope.along.dot(normal);
        place[d] = at;
    }
    return {normal, lever<D>(n_space, place - solids[image].reference), image};
}

template <int D>
PointRates<D> meeting_rates(int d, const MovingLine<D>& a, const MovingLine<D>& b)
{
    const double turn = a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0];
    if (std::abs(turn) < parameters.parallel)
        return {};
    PointRates<D> rates;
    const auto add = [&](const MovingLine<D>& line, const Vec<2>& along) {
        if (line.image < 0)
            return;
        PointRates<D> one;
        one.push_back({line.image, Eigen::Matrix<double, D, twist_size<D>>::Zero()});
        one[0].rate.row(u_axis<D>(d)) = along[0] * line.speed.transpose();
        one[0].rate.row(v_axis<D>(d)) = along[1] * line.speed.transpose();
        add_rates<D>(rates, one, 1);
    };
    add(a, Vec<2>(b.normal[1], -b.normal[0]) / turn); // along b: what moves a
    add(b, Vec<2>(-a.normal[1], a.normal[0]) / turn);
    return rates;
}

template Vec<2> facet_normal(const FacetKind<2>&, int);
template Vec<3> facet_normal(const FacetKind<3>&, int);
template MovingLine<2> moving_line(const std::vector<PlacedSolid<2>>&, int, int, double, const ArcSegment&, bool);
template MovingLine<3> moving_line(const std::vector<PlacedSolid<3>>&, int, int, double, const ArcSegment&, bool);
template PointRates<2> meeting_rates(int, const MovingLine<2>&, const MovingLine<2>&);
template PointRates<3> meeting_rates(int, const MovingLine<3>&, const MovingLine<3>&);

} // namespace gapflow
