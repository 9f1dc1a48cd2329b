#include "gapflow/complex/sharp_features.hpp"

#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace gapflow {

std::vector<SharpCorner> corners_of(const Section& polygon)
{
    std::vector<SharpCorner> corners;
    for (int k = 0; k < polygon.count; ++k) {
        const Vec<2>& at = polygon.corner[k];
        const Vec<2> a = (at - polygon.corner[(k + polygon.count - 1) % polygon.count]).normalized(),
                     b = (at - polygon.corner[(k + 1) % polygon.count]).normalized();
        corners.push_back({at, (a + b).normalized(), std::acos(std::clamp(a.dot(b), -1.0, 1.0))});
    }
    return corners;
}

std::vector<SharpCorner> corners_of(std::span<const Vec<2>> vertices, std::span<const std::array<int, 2>> segments,
                                    std::span<const std::array<int, 2>> links)
{
    std::vector<SharpCorner> corners;
    for (std::size_t k = 0; k < segments.size(); ++k) {
        const auto& next = segments[links[k][1]];
        const Vec<2>& at = vertices[segments[k][1]];
        const Vec<2> in = (at - vertices[segments[k][0]]).normalized(), out = (vertices[next[1]] - at).normalized();
        const double turn = std::atan2(in[0] * out[1] - in[1] * out[0], in.dot(out));
        if (turn > parameters.sharp_turn)
            corners.push_back({at, (in - out).normalized(), std::numbers::pi - turn});
    }
    return corners;
}

namespace {

/// Calls visit for the cells that an edge passes through or touches, in the domain and a layer around it.
template <class Visit>
void for_each_cell_of(const GridPlanes<3>& planes, const SharpEdge& edge, Visit&& visit)
{
    const Vec<3> way = edge.to - edge.from;
    Index<3> cell;
    const auto pass = [&](auto&& self, int axis, double from, double to) -> void {
        if (axis < 0) {
            visit(cell);
            return;
        }
        const double a = edge.from[axis] + from * way[axis], b = edge.from[axis] + to * way[axis];
        const int first = std::max(planes.cell_of(axis, std::min(a, b)) - 1, planes.place[axis].first() - 1),
                  last = std::min(planes.cell_of(axis, std::max(a, b)) + 1, planes.place[axis].last());
        for (cell[axis] = first; cell[axis] <= last; ++cell[axis]) {
            double t0 = from, t1 = to;
            const double lo = planes.place_of(axis, cell[axis]), hi = planes.place_of(axis, cell[axis] + 1);
            if (way[axis] == 0) {
                if (!(edge.from[axis] >= lo && edge.from[axis] <= hi))
                    continue;
            } else {
                const double s = (lo - edge.from[axis]) / way[axis], t = (hi - edge.from[axis]) / way[axis];
                t0 = std::max(t0, std::min(s, t));
                t1 = std::min(t1, std::max(s, t));
            }
            if (t0 <= t1)
                self(self, axis - 1, t0, t1);
        }
    };
    pass(pass, 2, 0.0, 1.0);
}

void add_edge_cells(SharpSolid& solid, const GridPlanes<3>& planes)
{
    for (int e = 0; e < static_cast<int>(solid.edges.size()); ++e)
        for_each_cell_of(planes, solid.edges[e], [&](const Index<3>& cell) { solid.edge_cells.push_back({cell, e}); });
    solid.sort_by_cell();
}

} // namespace

SharpSolid sharp_solid(const PlanesKind<3>& kind, const GridPlanes<3>& planes)
{
    SharpSolid solid;
    for (int k = 0; k < kind.planes; ++k)
        solid.facets.push_back({kind.normal[k], kind.centre + kind.offset[k] * kind.normal[k]});
    for (int a = 0; a < kind.planes; ++a)
        for (int b = a + 1; b < kind.planes; ++b) {
            const Vec<3>&m = kind.normal[a], &n = kind.normal[b];
            const Vec<3> way = m.cross(n);
            const double c = m.dot(n), sine2 = way.squaredNorm();
            if (sine2 < parameters.parallel * parameters.parallel)
                continue;
            const Vec<3> p = ((kind.offset[a] - c * kind.offset[b]) * m + (kind.offset[b] - c * kind.offset[a]) * n) / sine2;
            double from = -std::numeric_limits<double>::infinity(), to = -from;
            for (int k = 0; k < kind.planes; ++k) {
                const double room = kind.offset[k] - kind.normal[k].dot(p), slope = kind.normal[k].dot(way);
                if (k == a || k == b)
                    continue;
                if (std::abs(slope) < parameters.parallel) {
                    if (room < 0)
                        to = from;
                } else if (slope > 0)
                    to = std::min(to, room / slope);
                else
                    from = std::max(from, room / slope);
            }
            if (from < to)
                solid.edges.push_back({a, b, kind.centre + p + from * way, kind.centre + p + to * way,
                                       std::numbers::pi - std::atan2(std::sqrt(sine2), c)});
        }
    add_edge_cells(solid, planes);
    return solid;
}

SharpSolid sharp_solid(const FacetKind<3>& kind, const GridPlanes<3>& planes)
{
    const auto& elements = kind.surface->elements;
    const auto& links = *kind.links;
    const int count = static_cast<int>(elements.size());
    std::vector<Vec<3>> normal(count);
    const auto at = [&](int facet, int k) -> const Vec<3>& { return kind.vertices[elements[facet][k % 3]]; };
    for (int f = 0; f < count; ++f)
        normal[f] = (at(f, 1) - at(f, 0)).cross(at(f, 2) - at(f, 0)).normalized(); // 0 where it has no area
    struct Border {
        int facet, k; ///< of the lower-numbered of its two facets
    };
    std::vector<Border> sharp;
    const double flattest = std::cos(parameters.sharp_turn);
    for (int f = 0; f < count; ++f)
        for (int k = 0; k < 3; ++k) {
            const int g = links[f][k];
            if (g <= f || !(normal[f].dot(normal[g]) < flattest) || normal[f].isZero() || normal[g].isZero())
                continue;
            if (normal[f].cross(normal[g]).dot(at(f, k + 1) - at(f, k)) > 0)
                sharp.push_back({f, k});
        }
    SharpSolid solid;
    if (sharp.empty())
        return solid;
    // Facets of one plane.
    solid.facet_of.assign(count, -1);
    std::vector<int> stack;
    const auto facet_of = [&](int facet) {
        if (solid.facet_of[facet] >= 0)
            return solid.facet_of[facet];
        const int number = static_cast<int>(solid.facets.size());
        solid.facet_of[facet] = number;
        int largest = facet;
        double most = 0;
        stack.assign(1, facet);
        while (!stack.empty()) {
            const int f = stack.back();
            stack.pop_back();
            if (const double area = (at(f, 1) - at(f, 0)).cross(at(f, 2) - at(f, 0)).norm(); area > most) {
                most = area;
                largest = f;
            }
            for (const int g : links[f])
                if (solid.facet_of[g] < 0 && (normal[f] - normal[g]).norm() < parameters.parallel) {
                    solid.facet_of[g] = number;
                    stack.push_back(g);
                }
        }
        solid.facets.push_back({normal[largest], at(largest, 0)});
        return number;
    };
    struct Part {
        int a, b;
        double from, to; ///< along its direction
        Vec<3> start, end;
        double turn;
    };
    std::vector<Part> parts;
    for (const Border& border : sharp) {
        const int f = border.facet, g = links[f][border.k];
        int a = facet_of(f), b = facet_of(g);
        Vec<3> start = at(f, border.k), end = at(f, border.k + 1);
        const double turn = std::atan2(normal[f].cross(normal[g]).norm(), normal[f].dot(normal[g]));
        if (a > b) {
            std::swap(a, b);
            std::swap(start, end);
        }
        const Vec<3> along = solid.facets[a].normal.cross(solid.facets[b].normal).normalized();
        parts.push_back({a, b, along.dot(start), along.dot(end), start, end, turn});
    }
    std::sort(parts.begin(), parts.end(),
              [](const Part& x, const Part& y) { return std::tie(x.a, x.b, x.from) < std::tie(y.a, y.b, y.from); });
    for (std::size_t k = 0; k < parts.size();) {
        std::size_t last = k;
        while (last + 1 < parts.size() && parts[last + 1].a == parts[k].a && parts[last + 1].b == parts[k].b &&
               parts[last + 1].start == parts[last].end)
            ++last;
        solid.edges.push_back({parts[k].a, parts[k].b, parts[k].start, parts[last].end, std::numbers::pi - parts[k].turn});
        k = last + 1;
    }
    add_edge_cells(solid, planes);
    return solid;
}

namespace {

/// Pieces of a rim: cut by the planes of the grid, in the order of the angle around the axis.
void add_pieces(SharpSolid& solid, int number, const GridPlanes<3>& planes)
{
    const SharpRim& rim = solid.rims[number];
    const Vec<3> e1 = rim.normal.unitOrthogonal(), e2 = rim.normal.cross(e1);
    const auto at = [&](double angle) { return Vec<3>(std::cos(angle) * e1 + std::sin(angle) * e2); };
    std::vector<double> angles;
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = rim.radius * std::hypot(e1[axis], e2[axis]), middle = std::atan2(e2[axis], e1[axis]);
        for (int k = planes.place[axis].first() - 1; k <= planes.place[axis].last() + 1; ++k)
            if (const double c = (planes.place_of(axis, k) - rim.centre[axis]) / reach; std::abs(c) < 1)
                for (const double angle : {middle - std::acos(c), middle + std::acos(c)})
                    angles.push_back(std::remainder(angle, 2 * std::numbers::pi));
    }
    std::sort(angles.begin(), angles.end());
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const double from = angles[k], to = k + 1 < angles.size() ? angles[k + 1] : angles[0] + 2 * std::numbers::pi;
        const Vec<3> out = at(0.5 * (from + to)), x = rim.centre + rim.radius * out;
        Index<3> cell;
        bool known = rim.radius * (to - from) > parameters.joint_distance;
        for (int axis = 0; axis < 3; ++axis) {
            cell[axis] = planes.cell_of(axis, x[axis]);
            known = known && x[axis] > planes.place_of(axis, cell[axis]) && x[axis] < planes.place_of(axis, cell[axis] + 1);
        }
        if (known)
            solid.pieces.push_back({cell, number, rim.centre + rim.radius * at(from), rim.centre + rim.radius * at(to), out});
    }
}

} // namespace

SharpSolid sharp_solid(const RoundKind<3>& kind, const GridPlanes<3>& planes)
{
    SharpSolid solid;
    for (const int end : {-1, 1}) {
        solid.rims.push_back({kind.centre + end * kind.half * kind.axis, end * kind.axis, kind.radius});
        add_pieces(solid, static_cast<int>(solid.rims.size()) - 1, planes);
    }
    solid.sort_by_cell();
    return solid;
}

} // namespace gapflow
