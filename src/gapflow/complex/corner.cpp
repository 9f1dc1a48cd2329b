#include "gapflow/complex/corner.hpp"

#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
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

/// A convex polygon's part where n . x + c >= 0.
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

CellSectors cell_sectors(const SharpSolid& solid, const Vec<3>& low, const Vec<3>& high)
{
    CellSectors sectors;
    const auto add = [&](int facet) {
        if (std::find(sectors.facets.begin(), sectors.facets.end(), facet) == sectors.facets.end())
            sectors.facets.push_back(facet);
    };
    for (std::size_t e = 0; e < solid.edges.size(); ++e) {
        double from, to;
        const SharpEdge& edge = solid.edges[e];
        if (!part_in_cell(edge, low, high, from, to))
            continue;
        sectors.edges.push_back(static_cast<int>(e));
        sectors.lengths.push_back((to - from) * (edge.to - edge.from).norm());
        add(edge.a);
        add(edge.b);
    }
    return sectors;
}

BisectorAreas bisector_areas(const SharpSolid& solid, const CellSectors& sectors, int number, const Vec<3>& low,
                             const Vec<3>& high)
{
    const SharpEdge& edge = solid.edges[number];
    const SharpFacet &a = solid.facets[edge.a], &b = solid.facets[edge.b];
    double from, to;
    part_in_cell(edge, low, high, from, to);
    // Coordinates along the edge and outward, from the middle of its part in the cell.
    const Vec<3> way = edge.to - edge.from, along = way.normalized(), outward = (a.normal + b.normal).normalized(),
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
        if (k != edge.a && k != edge.b)
            keep(polygon, a.normal - solid.facets[k].normal, a.height(p) - solid.facets[k].height(p));
    clip(behind, {0, -1}, 0);
    clip(behind, {1, 0}, (p - edge.from).dot(along));
    clip(behind, {-1, 0}, (edge.to - p).dot(along));
    return {area(polygon), area(behind)};
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
    const Vec<2> difference = slope(edge.a) - slope(edge.b), middle = 0.5 * (low + high);
    const double steepness = difference.norm();
    if (steepness < parameters.parallel)
        return line;
    line.start = middle - (height(edge.a, middle) - height(edge.b, middle)) / (steepness * steepness) * difference;
    line.direction = Vec<2>(-difference[1], difference[0]) / steepness;
    if (line.direction.dot(slope(edge.a)) < 0)
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
    keep(height(edge.a, line.start), slope(edge.a).dot(line.direction), SectorLine::End::corner, -1, -1);
    for (const int k : sectors.facets)
        if (k != edge.a && k != edge.b)
            keep(height(edge.a, line.start) - height(k, line.start), (slope(edge.a) - slope(k)).dot(line.direction),
                 SectorLine::End::junction, -1, -1);
    return line;
}

double corner_conductance(double angle, double open, double covered)
{
    const double tau = 1 - angle / std::numbers::pi;
    return parameters.corner_link * std::pow(tau, -parameters.corner_exponent) * open /
           std::max(covered, parameters.least_covered);
}

} // namespace gapflow
