#include "gapflow/complex/corner.hpp"

#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace gapflow {

namespace {

/// The part of a line from + t direction with a + t b >= 0 removed from an interval; whether the low or high end moved (-1, 1) or none.
int keep_positive(double a, double b, double& from, double& to)
{
    if (b > 0 && -a / b > from) {
        from = -a / b;
        return -1;
    }
    if (b < 0 && -a / b < to) {
        to = -a / b;
        return 1;
    }
    if (b == 0 && a < 0)
        to = from;
    return 0;
}

double area(const std::vector<Vec<2>>& polygon)
{
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec<2>&p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
        sum += 0.5 * (p[0] * q[1] - p[1] * q[0]);
    }
    return std::abs(sum);
}

/// The part of an edge in a cell, as fractions of its way; whether there is one.
bool part_in_cell(const SharpEdge& edge, const Vec<3>& low, const Vec<3>& high, double& from, double& to)
{
    from = 0;
    to = 1;
    const Vec<3> way = edge.to - edge.from;
    for (int axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0 && !(edge.from[axis] > low[axis] && edge.from[axis] < high[axis]))
            return false;
        keep_positive(edge.from[axis] - low[axis], way[axis], from, to);
        keep_positive(high[axis] - edge.from[axis], -way[axis], from, to);
    }
    return from < to;
}

} // namespace

void clip(std::vector<Vec<2>>& polygon, const Vec<2>& n, double c)
{
    std::vector<Vec<2>> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec<2>&p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
        const double a = n.dot(p) + c, b = n.dot(q) + c;
        if (a >= 0)
            kept.push_back(p);
        if ((a >= 0) != (b >= 0))
            kept.push_back(p + a / (a - b) * (q - p));
    }
    polygon = kept;
}

namespace {

auto key(const Index<3>& c)
{
    return std::tuple(c[0], c[1], c[2]);
}

template <class Item>
std::span<const Item> items_in(const std::vector<Item>& items, const Index<3>& cell)
{
    const auto first = std::lower_bound(items.begin(), items.end(), cell,
                                        [](const Item& item, const Index<3>& c) { return key(item.cell) < key(c); });
    auto last = first;
    while (last != items.end() && last->cell == cell)
        ++last;
    return {first, last};
}

template <class Item>
void sort_items(std::vector<Item>& items)
{
    std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return key(a.cell) < key(b.cell); });
}

/// The places at which an edge's plane is at an equal height above facet k and its own ones bound the plane: 1, its own ones are higher within;
/// -1, facet k is; 0: they bound nothing.
int bound_of(const SharpSolid& solid, const CellSectors& sectors, const SharpEdge& edge, int k)
{
    if (k == edge.a || k == edge.b)
        return 0;
    const auto group = [&](int facet) {
        return sectors.group[std::find(sectors.facets.begin(), sectors.facets.end(), facet) - sectors.facets.begin()];
    };
    const SharpFacet& facet = solid.facets[k];
    for (const int e : sectors.ways)
        if (solid.edges[e].a == k || solid.edges[e].b == k)
            return 0;
    if (group(k) != group(edge.a) || facet.in_plane_of(solid.facets[edge.a]) || facet.in_plane_of(solid.facets[edge.b]))
        return 0;
    return facet.height(0.5 * (edge.from + edge.to)) > parameters.joint_distance ? -1 : 1;
}

} // namespace

bool SharpFacet::in_plane_of(const SharpFacet& other) const
{
    return (normal - other.normal).norm() < parameters.parallel && std::abs(other.height(at)) < parameters.parallel;
}

std::span<const RimPiece> SharpSolid::pieces_in(const Index<3>& cell) const
{
    return items_in(pieces, cell);
}

std::span<const EdgeCell> SharpSolid::edges_in(const Index<3>& cell) const
{
    return items_in(edge_cells, cell);
}

std::span<const EdgeCell> SharpSolid::ways_in(const Index<3>& cell) const
{
    return items_in(way_cells, cell);
}

Vec<3> SharpSolid::across(int number) const
{
    const SharpEdge& edge = edges[number];
    const Vec<3> bisector = facets[edge.a].normal - facets[edge.b].normal;
    if (!edge.turned())
        return bisector;
    const Vec<3> normal = edge.along().cross(edge.outward);
    return normal.dot(bisector) < 0 ? Vec<3>(-normal) : normal;
}

void SharpSolid::sort_by_cell()
{
    sort_items(way_cells);
    sort_items(pieces);
    sort_items(edge_cells);
}

bool passes(const SharpEdge& edge, const Vec<3>& low, const Vec<3>& high)
{
    double from, to;
    return part_in_cell(edge, low, high, from, to);
}

CellSectors cell_sectors(const SharpSolid& solid, const Index<3>& cell, const Vec<3>& low, const Vec<3>& high)
{
    CellSectors sectors;
    for (const RimPiece& piece : solid.pieces_in(cell))
        if (sectors.rims.empty() || sectors.rims[sectors.rims.size() - 1] != piece.rim)
            sectors.rims.push_back(piece.rim);
    const auto merge = [&](int group, int other) {
        for (int& g : sectors.group)
            g = g == other ? group : g;
    };
    const auto add = [&](int facet) {
        int k = 0;
        while (k < static_cast<int>(sectors.facets.size()) && sectors.facets[k] != facet)
            ++k;
        if (k == static_cast<int>(sectors.facets.size())) {
            sectors.facets.push_back(facet);
            sectors.group.push_back(k);
            for (int j = 0; j < k; ++j)
                if (solid.facets[facet].in_plane_of(solid.facets[sectors.facets[j]]))
                    merge(sectors.group[j], sectors.group[k]);
        }
        return k;
    };
    for (const EdgeCell& in_cell : solid.edges_in(cell)) {
        double from, to;
        const SharpEdge& edge = solid.edges[in_cell.edge];
        if (!edge.divides || !part_in_cell(edge, low, high, from, to))
            continue;
        const bool known = std::any_of(sectors.edges.begin(), sectors.edges.end(), [&](int e) { // on the same line
            return solid.edges[e].a == edge.a && solid.edges[e].b == edge.b;
        });
        if (known)
            continue;
        if (!edge.leads())
            sectors.edges.push_back(in_cell.edge);
        const int a = add(edge.a), b = add(edge.b);
        merge(sectors.group[a], sectors.group[b]);
    }
    for (const EdgeCell& way : solid.ways_in(cell))
        sectors.ways.push_back(way.edge);
    return sectors;
}

namespace {

/// An edge's bisector plane in a cell: the convex polygons outward of the edge and behind it.
struct BisectorPolygons {
    Vec<3> origin, along, outward; ///< coordinates of the plane: from the middle of the edge's part in the cell
    std::vector<Vec<2>> open, covered;
    Vec<3> from, to; ///< ends of the edge's part in the cell

    Vec<3> place(const Vec<2>& x) const { return origin + x[0] * along + x[1] * outward; }
};

BisectorPolygons bisector_polygons(const SharpSolid& solid, const CellSectors& sectors, int number, const Vec<3>& low,
                                   const Vec<3>& high)
{
    const SharpEdge& edge = solid.edges[number];
    const SharpFacet &a = solid.facets[edge.a], &b = solid.facets[edge.b];
    double from, to;
    part_in_cell(edge, low, high, from, to);
    const Vec<3> way = edge.to - edge.from, along = way.normalized(),
                 outward = edge.turned() ? edge.outward : (a.normal + b.normal).normalized(),
                 p = edge.from + 0.5 * (from + to) * way;
    const double reach = 2 * (high - low).norm();
    std::vector<Vec<2>> polygon{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}};
    const auto keep = [&](std::vector<Vec<2>>& poly, const Vec<3>& n, double value) { // where value at p + n . (x - p) >= 0
        clip(poly, {n.dot(along), n.dot(outward)}, value);
    };
    for (int axis = 0; axis < 3; ++axis) {
        keep(polygon, Vec<3>::Unit(axis), p[axis] - low[axis]);
        keep(polygon, -Vec<3>::Unit(axis), high[axis] - p[axis]);
    }
    std::vector<Vec<2>> behind = polygon;
    clip(polygon, {0, 1}, 0);
    for (const int k : sectors.facets)
        if (const int bound = edge.leads() ? 0 : bound_of(solid, sectors, edge, k))
            keep(polygon, bound * (a.normal - solid.facets[k].normal), bound * (a.height(p) - solid.facets[k].height(p)));
    clip(behind, {0, -1}, 0);
    clip(behind, {1, 0}, (p - edge.from).dot(along));
    clip(behind, {-1, 0}, (edge.to - p).dot(along));
    return {p, along, outward, polygon, behind, edge.from + from * way, edge.from + to * way};
}

/// Open and covered area of an edge's bisector plane.
std::pair<double, double> bisector_areas(const SharpSolid& solid, const CellSectors& sectors, int number, const Vec<3>& low,
                                         const Vec<3>& high)
{
    const BisectorPolygons polygons = bisector_polygons(solid, sectors, number, low, high);
    return {area(polygons.open), area(polygons.covered)};
}

/// The side of the cell on which both points lie: its outward normal; nothing where there is none.
std::optional<Vec<3>> side_of(const Vec<3>& x, const Vec<3>& y, const Vec<3>& low, const Vec<3>& high)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const bool end : {false, true}) {
            const double at = end ? high[axis] : low[axis];
            if (std::abs(x[axis] - at) < parameters.least_stretch && std::abs(y[axis] - at) < parameters.least_stretch)
                return Vec<3>((end ? 1 : -1) * Vec<3>::Unit(axis));
        }
    return {};
}

/// Adds the rates of a bisector plane's areas. speed(n, x): velocity along n of the plane's point x, over the solid's twist. Of a side of the cell with
/// the normal n the border moves over the plane with -speed/|n_plane|; borders inside the cell move with the plane.
template <class Speed>
void add_plane_rates(const BisectorPolygons& polygons, const Vec<3>& low, const Vec<3>& high, Speed&& speed, EdgeRates& rates)
{
    for (const auto& [polygon, rate] : {std::pair{&polygons.open, &rates.open}, {&polygons.covered, &rates.covered}})
        for (std::size_t k = 0; k < polygon->size(); ++k) {
            const Vec<2>&p = (*polygon)[k], &q = (*polygon)[(k + 1) % polygon->size()];
            const Vec<3> x = polygons.place(p), y = polygons.place(q);
            if (const auto n = side_of(x, y, low, high); n && p != q)
                *rate -= (q - p).norm() / std::hypot(n->dot(polygons.along), n->dot(polygons.outward)) *
                         speed(*n, Vec<3>(0.5 * (x + y)));
        }
}

/// A rim's piece as a straight edge.
SharpSolid chord_of(const SharpRim& rim, const RimPiece& piece)
{
    SharpSolid chord;
    chord.facets = {{rim.normal, rim.centre}, {piece.out, piece.from}};
    chord.edges = {{0, 1, piece.from, piece.to, std::numbers::pi / 2}};
    return chord;
}
CellSectors both_facets()
{
    CellSectors sectors;
    for (const int facet : {0, 1}) {
        sectors.facets.push_back(facet);
        sectors.group.push_back(0);
    }
    return sectors;
}

/// The ends of the piece slide along the rim, in the sides of the cell; its chord turns about the rim's axis with the mean of the two, and moves along `out`.
void add_chord_rates(const SharpRim& rim, const RimPiece& piece, const Vec<3>& low, const Vec<3>& high, const Vec<3>& reference,
                     EdgeRates& rates)
{
    const auto slide = [&](const Vec<3>& end) { // by angle
        Twist<3> rate = Twist<3>::Zero();
        if (const auto n = side_of(end, end, low, high))
            rate = -lever<3>(*n, end - reference) / n->dot(rim.normal.cross(end - rim.centre));
        return rate;
    };
    const Twist<3> from = slide(piece.from), to = slide(piece.to), turn = 0.5 * (from + to), spread = 0.5 * (to - from);
    const double half_length = 0.5 * (piece.to - piece.from).norm(), height = piece.out.dot(piece.from - rim.centre);
    const BisectorPolygons polygons = bisector_polygons(chord_of(rim, piece), both_facets(), 0, low, high);
    add_plane_rates(
        polygons, low, high,
        [&](const Vec<3>& n, const Vec<3>& x) {
            return Twist<3>(lever<3>(n, x - reference) + n.dot(rim.normal.cross(x - rim.centre)) * turn -
                            n.dot(piece.out) * half_length * spread);
        },
        rates);
    for (std::size_t k = 0; k < polygons.covered.size(); ++k) { // borders at the chord's ends
        const Vec<2>&p = polygons.covered[k], &q = polygons.covered[(k + 1) % polygons.covered.size()];
        const double off = std::max(std::abs(std::abs(p[0]) - half_length), std::abs(std::abs(q[0]) - half_length));
        const Vec<3> x = polygons.place(p), y = polygons.place(q);
        if (p[0] * q[0] > 0 && off < parameters.joint_distance && !side_of(x, y, low, high))
            rates.covered += (q - p).norm() * height * spread;
    }
    rates.length += 2 * height * spread;
}

} // namespace

EdgeRates edge_rates(const SharpSolid& solid, const CellSectors& sectors, int number, const Index<3>& cell, const Vec<3>& low,
                     const Vec<3>& high, const Vec<3>& reference)
{
    EdgeRates rates;
    const int edges = static_cast<int>(solid.edges.size());
    if (number >= edges) {
        for (const RimPiece& piece : solid.pieces_in(cell))
            if (piece.rim == number - edges)
                add_chord_rates(solid.rims[piece.rim], piece, low, high, reference, rates);
        return rates;
    }
    const BisectorPolygons polygons = bisector_polygons(solid, sectors, number, low, high);
    add_plane_rates(
        polygons, low, high, [&](const Vec<3>& n, const Vec<3>& x) { return lever<3>(n, x - reference); }, rates);
    for (const Vec<3>& end : {polygons.from, polygons.to})
        if (const auto n = side_of(end, end, low, high))
            rates.length -= lever<3>(*n, end - reference) / std::abs(n->dot(polygons.along));
    return rates;
}

EdgeInCell edge_in_cell(const SharpSolid& solid, const CellSectors& sectors, int number, const Index<3>& cell,
                        const Vec<3>& low, const Vec<3>& high)
{
    const int edges = static_cast<int>(solid.edges.size());
    if (number < edges) {
        const SharpEdge& edge = solid.edges[number];
        const auto [open, covered] = bisector_areas(solid, sectors, number, low, high);
        double from, to;
        part_in_cell(edge, low, high, from, to);
        return {edge.angle, (to - from) * (edge.to - edge.from).norm(), open, covered, 0.5 * (edge.from + edge.to)};
    }
    const SharpRim& rim = solid.rims[number - edges];
    EdgeInCell sum{std::numbers::pi / 2, 0, 0, 0, Vec<3>::Zero()};
    for (const RimPiece& piece : solid.pieces_in(cell)) {
        if (piece.rim != number - edges)
            continue;
        const auto [open, covered] = bisector_areas(chord_of(rim, piece), both_facets(), 0, low, high);
        sum.open += open;
        sum.covered += covered;
        sum.length += (piece.to - piece.from).norm();
        sum.at = 0.5 * (piece.from + piece.to);
    }
    return sum;
}

InlineVector<RimLine, 2> rim_lines(const SharpRim& rim, int d, double at, const Vec<2>& low, const Vec<2>& high)
{
    const int u = (d + 1) % 3, v = (d + 2) % 3;
    // Angles around the axis from where the rim's plane rises most along d.
    const Vec<3> rise = Vec<3>::Unit(d) - rim.normal[d] * rim.normal;
    const double slope = rise.norm();
    const Vec<3> b1 = slope > parameters.parallel ? Vec<3>(rise / slope) : rim.normal.unitOrthogonal(),
                 b2 = rim.normal.cross(b1);
    struct Point {
        double angle;
        Vec<2> x;
        int edge;
    };
    InlineVector<Point, 6> points;
    const auto in_plane = [&](const Vec<3>& x) { return Vec<2>(x[u], x[v]); };
    const auto holds = [&](const Vec<2>& x) { return (x.array() >= low.array()).all() && (x.array() <= high.array()).all(); };
    if (const double c = (at - rim.centre[d]) / (rim.radius * slope); slope > parameters.parallel && std::abs(c) < 1)
        for (const double angle : {-std::acos(c), std::acos(c)}) {
            const Vec<2> x = in_plane(rim.centre + rim.radius * (std::cos(angle) * b1 + std::sin(angle) * b2));
            if (holds(x))
                points.push_back({angle, x, -1});
        }
    for (int e = 0; e < 4; ++e) {
        const int along = e % 2 == 0 ? u : v, across = e % 2 == 0 ? v : u;
        Vec<3> r = Vec<3>::Zero();
        r[d] = at - rim.centre[d];
        r[across] = (e % 2 == 0 ? (e == 0 ? low : high)[1] : (e == 3 ? low : high)[0]) - rim.centre[across];
        // |r + t e - z normal| = radius + z, z = z0 + q t
        const double z0 = rim.normal.dot(r), q = rim.normal[along], reach = rim.radius + z0, A = 1 - 2 * q * q,
                     B = -q * (z0 + reach), C = r.squaredNorm() - z0 * z0 - reach * reach, root2 = B * B - A * C;
        if (!(root2 > 0))
            continue;
        const double far = B > 0 ? -B - std::sqrt(root2) : -B + std::sqrt(root2);
        for (const double t : {far / A, C / far}) {
            const double place = rim.centre[along] + t;
            if (!(z0 + q * t > 0 && place > low[e % 2] && place < high[e % 2]))
                continue;
            Vec<3> x = r;
            x[along] = t;
            points.push_back({std::atan2(x.dot(b2), x.dot(b1)), in_plane(x + rim.centre), e});
        }
    }
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.angle < b.angle; });
    InlineVector<RimLine, 2> lines;
    const int n = static_cast<int>(points.size());
    for (int k = 0; k < n && n > 1; ++k) {
        const Point &a = points[k], &b = points[(k + 1) % n];
        const double angle = 0.5 * (a.angle + b.angle + (k + 1 == n ? 2 * std::numbers::pi : 0));
        const Vec<3> way = std::cos(angle) * b1 + std::sin(angle) * b2;
        // The cone there: centre + rho way + (rho - radius) normal.
        const double rho = (at - rim.centre[d] + rim.radius * rim.normal[d]) / (way[d] + rim.normal[d]);
        if (rho > rim.radius && (a.edge >= 0 || b.edge >= 0) &&
            holds(in_plane(rim.centre + rho * way + (rho - rim.radius) * rim.normal)))
            lines.push_back(a.edge < 0 ? RimLine{a.x, b.x, a.edge, b.edge} : RimLine{b.x, a.x, b.edge, a.edge});
    }
    return lines;
}

SectorLine sector_line(const SharpSolid& solid, const CellSectors& sectors, int number, int d, double at, const Vec<2>& low,
                       const Vec<2>& high)
{
    const SharpEdge& edge = solid.edges[number];
    const int u = (d + 1) % 3, v = (d + 2) % 3;
    // Heights of the facets in the plane: g . x + h.
    const auto slope = [&](int k) { return Vec<2>(solid.facets[k].normal[u], solid.facets[k].normal[v]); };
    const auto height = [&](int k, const Vec<2>& x) {
        Vec<3> y;
        y[u] = x[0];
        y[v] = x[1];
        y[d] = at;
        return solid.facets[k].height(y);
    };
    SectorLine line;
    const Vec<3> across = solid.across(number);
    const Vec<2> difference = edge.turned() ? Vec<2>(across[u], across[v]) : Vec<2>(slope(edge.a) - slope(edge.b)),
                 middle = 0.5 * (low + high), out(edge.outward[u], edge.outward[v]);
    const auto in_space = [&](const Vec<2>& x) {
        Vec<3> y;
        y[u] = x[0];
        y[v] = x[1];
        y[d] = at;
        return y;
    };
    const double steepness = difference.norm();
    if (steepness < parameters.parallel)
        return line;
    line.start =
        middle - (edge.turned() ? across.dot(in_space(middle) - edge.from) : height(edge.a, middle) - height(edge.b, middle)) /
                     (steepness * steepness) * difference;
    line.direction = Vec<2>(-difference[1], difference[0]) / steepness;
    if (line.direction.dot(edge.turned() ? out : slope(edge.a)) < 0)
        line.direction = -line.direction;
    line.from = -std::numeric_limits<double>::infinity();
    line.to = -line.from;
    const auto keep = [&](double a, double b, SectorLine::End end, int low_edge, int high_edge) {
        const int moved = keep_positive(a, b, line.from, line.to);
        if (moved < 0) {
            line.from_end = end;
            line.from_edge = low_edge;
        } else if (moved > 0) {
            line.to_end = end;
            line.to_edge = high_edge;
        }
    };
    for (int axis = 0; axis < 2; ++axis) {
        const int low_side = axis == 0 ? 3 : 0, high_side = axis == 0 ? 1 : 2;
        keep(line.start[axis] - low[axis], line.direction[axis], SectorLine::End::border, low_side, low_side);
        keep(high[axis] - line.start[axis], -line.direction[axis], SectorLine::End::border, high_side, high_side);
    }
    if (edge.turned())
        keep(edge.outward.dot(in_space(line.start) - edge.from), out.dot(line.direction), SectorLine::End::corner, -1, -1);
    else
        keep(height(edge.a, line.start), slope(edge.a).dot(line.direction), SectorLine::End::corner, -1, -1);
    for (const int k : sectors.facets)
        if (const int bound = bound_of(solid, sectors, edge, k))
            keep(bound * (height(edge.a, line.start) - height(k, line.start)),
                 bound * (slope(edge.a) - slope(k)).dot(line.direction), SectorLine::End::junction, -1, -1);
    return line;
}

double EdgeWay::length_at(double s) const
{
    const std::size_t k = std::clamp<std::size_t>(std::upper_bound(at.begin(), at.end(), s) - at.begin(), 1, at.size() - 1);
    const double share = (s - at[k - 1]) / (at[k] - at[k - 1]);
    return (1 - share) * length[k - 1] + share * length[k];
}

WayInCell way_in_cell(const SharpSolid& solid, const EdgeWay& way, const Vec<3>& low, const Vec<3>& high)
{
    const SharpEdge& edge = solid.edges[way.edge];
    const Vec<3> along = edge.along();
    WayInCell sum;
    for (std::size_t k = 0; k + 1 < way.at.size(); ++k) {
        std::vector<Vec<2>> polygon{
            {way.at[k], 0}, {way.at[k + 1], 0}, {way.at[k + 1], way.length[k + 1]}, {way.at[k], way.length[k]}};
        for (int axis = 0; axis < 3; ++axis) {
            const Vec<2> n(along[axis], edge.outward[axis]);
            clip(polygon, n, edge.from[axis] - low[axis]);
            clip(polygon, -n, high[axis] - edge.from[axis]);
        }
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
            const Vec<2> p = polygon[i] - polygon[0], q = polygon[i + 1] - polygon[0];
            const double A = 0.5 * std::abs(p[0] * q[1] - p[1] * q[0]);
            sum.area += A;
            sum.at += A * (polygon[0][0] + polygon[i][0] + polygon[i + 1][0]) / 3;
        }
    }
    if (sum.area > 0)
        sum.at /= sum.area;
    return sum;
}

SectorLine way_line(const SharpSolid& solid, const EdgeWay& way, int d, double at, const Vec<2>& low, const Vec<2>& high)
{
    const SharpEdge& edge = solid.edges[way.edge];
    const int u = (d + 1) % 3, v = (d + 2) % 3;
    const Vec<3> across = solid.across(way.edge), along = edge.along();
    const auto in_plane = [&](const Vec<3>& x) { return Vec<2>(x[u], x[v]); };
    const auto from_edge = [&](const Vec<2>& x) {
        Vec<3> y;
        y[u] = x[0];
        y[v] = x[1];
        y[d] = at;
        return Vec<3>(y - edge.from);
    };
    SectorLine line;
    const Vec<2> slope = in_plane(across), middle = 0.5 * (low + high);
    const double steepness = slope.norm();
    if (steepness < parameters.parallel)
        return line;
    line.start = middle - across.dot(from_edge(middle)) / (steepness * steepness) * slope;
    line.direction = Vec<2>(slope[1], -slope[0]) / steepness;
    line.from = -std::numeric_limits<double>::infinity();
    line.to = -line.from;
    const auto keep = [&](double a, double b, SectorLine::End end, int border) {
        const int moved = keep_positive(a, b, line.from, line.to);
        if (moved < 0) {
            line.from_end = end;
            line.from_edge = border;
        } else if (moved > 0) {
            line.to_end = end;
            line.to_edge = border;
        }
    };
    for (int axis = 0; axis < 2; ++axis) {
        keep(line.start[axis] - low[axis], line.direction[axis], SectorLine::End::border, axis == 0 ? 3 : 0);
        keep(high[axis] - line.start[axis], -line.direction[axis], SectorLine::End::border, axis == 0 ? 1 : 2);
    }
    // Ends on the border to round-off lie there.
    const double touching = parameters.joint_distance;
    const auto cut = [&](const Vec<3>& n, double more, SectorLine::End end) { // where n . x + more >= 0
        const double a = n.dot(from_edge(line.start)) + more, b = in_plane(n).dot(line.direction);
        if (std::abs(b) < parameters.parallel) {
            if (a < -touching)
                line.to = line.from;
        } else if (const double place = -a / b; b > 0 ? place > line.from + touching : place < line.to - touching)
            keep(a, b, end, -1);
    };
    cut(edge.outward, 0, SectorLine::End::corner);
    cut(along, -way.at.front(), SectorLine::End::junction);
    cut(-along, way.at.back(), SectorLine::End::junction);
    if (line.empty())
        return line;
    // Behind the other wall; where the way's length bends between two places, to the first crossing.
    const auto over = [&](double t) {
        const Vec<3> x = from_edge(line.at(t));
        return edge.outward.dot(x) - way.length_at(along.dot(x)) - way.beyond;
    };
    const double first = over(line.from), last = over(line.to);
    if (first > 0 && last > 0)
        line.to = line.from;
    else if (first > 0 || last > 0) {
        double in = first > 0 ? line.to : line.from, out = first > 0 ? line.from : line.to;
        for (int k = 0; k < 60 && std::abs(out - in) > parameters.least_stretch; ++k)
            (over(0.5 * (in + out)) > 0 ? out : in) = 0.5 * (in + out);
        (first > 0 ? line.from : line.to) = in;
        (first > 0 ? line.from_end : line.to_end) = SectorLine::End::junction;
        (first > 0 ? line.from_edge : line.to_edge) = -1;
    }
    return line;
}

double bisector_crossing(const SharpSolid& solid, int number, int axis, const Vec<3>& x)
{
    const SharpEdge& edge = solid.edges[number];
    if (edge.turned()) {
        const Vec<3> n = solid.across(number);
        double sum = 0;
        for (const int other : {(axis + 1) % 3, (axis + 2) % 3})
            sum -= n[other] * (x[other] - edge.from[other]);
        return edge.from[axis] + sum / n[axis];
    }
    const SharpFacet &a = solid.facets[edge.a], &b = solid.facets[edge.b];
    const Vec<3> n = a.normal - b.normal;
    double sum = b.normal.dot(a.at - b.at);
    for (const int across : {(axis + 1) % 3, (axis + 2) % 3})
        sum -= n[across] * (x[across] - a.at[across]);
    return a.at[axis] + sum / n[axis];
}

double corner_conductance(double angle, double open, double covered)
{
    const double tau = 1 - angle / std::numbers::pi;
    return parameters.corner_link * std::pow(tau, -parameters.corner_exponent) * open /
           std::max(covered, parameters.least_covered);
}

} // namespace gapflow
