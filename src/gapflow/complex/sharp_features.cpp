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

SharpSolid sharp_solid(const PlanesKind<3>& kind)
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
    std::stable_sort(solid.pieces.begin(), solid.pieces.end(), [](const RimPiece& a, const RimPiece& b) {
        return std::tie(a.cell[0], a.cell[1], a.cell[2]) < std::tie(b.cell[0], b.cell[1], b.cell[2]);
    });
    return solid;
}

} // namespace gapflow
