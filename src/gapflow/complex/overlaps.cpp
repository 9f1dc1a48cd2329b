#include "gapflow/complex/overlaps.hpp"

#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gapflow {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// How far a solid reaches along a unit vector n.
double reach(const BallKind<3>& kind, const PlacedSolid<3>&, const Vec<3>& n)
{
    return n.dot(kind.centre) + kind.radius;
}
double reach(const PlanesKind<3>& kind, const PlacedSolid<3>& solid, const Vec<3>& n)
{
    double most = -infinite;
    for (const SharpEdge& edge : solid.sharp.edges)
        most = std::max({most, n.dot(edge.from), n.dot(edge.to)});
    if (solid.sharp.edges.empty()) // a half-space, or a box's outside
        for (int k = 0; k < kind.planes; ++k)
            if (kind.planes == 1)
                most = kind.normal[k].dot(n) > 1 - 1e-15 ? n.dot(kind.centre) + kind.offset[k] : infinite;
    return most;
}
double reach(const RoundKind<3>& kind, const PlacedSolid<3>&, const Vec<3>& n)
{
    const double along = std::abs(n.dot(kind.axis));
    return n.dot(kind.centre) + kind.half * along +
           kind.radius * (kind.flat ? std::sqrt(std::max(0.0, 1 - along * along)) : 1.0);
}
double reach(const FacetKind<3>& kind, const PlacedSolid<3>&, const Vec<3>& n)
{
    double most = -infinite;
    for (const Vec<3>& x : kind.vertices)
        most = std::max(most, n.dot(x));
    return most;
}
double reach(const PlacedSolid<3>& solid, const Vec<3>& n)
{
    return std::visit([&](const auto& kind) { return reach(kind, solid, n); }, solid.kind);
}

std::vector<Vec<3>> directions(const PlacedSolid<3>& solid)
{
    std::vector<Vec<3>> found;
    if (const auto* planes = std::get_if<PlanesKind<3>>(&solid.kind))
        for (int k = 0; k < planes->planes; ++k)
            found.push_back(planes->normal[k]);
    if (const auto* bar = std::get_if<RoundKind<3>>(&solid.kind))
        found.push_back(bar->axis);
    return found;
}

bool separates(const PlacedSolid<3>& a, const PlacedSolid<3>& b, const Vec<3>& n)
{
    return -reach(a, -n) > reach(b, n) || -reach(b, -n) > reach(a, n);
}

/// Corners of a box around a convex solid, along its own axes if it is a cylinder.
std::vector<Vec<3>> corners_around(const PlacedSolid<3>& solid)
{
    std::vector<Vec<3>> corners;
    for (const SharpEdge& edge : solid.sharp.edges) {
        corners.push_back(edge.from);
        corners.push_back(edge.to);
    }
    if (const auto* bar = std::get_if<RoundKind<3>>(&solid.kind)) {
        const Vec<3> u = bar->axis.unitOrthogonal(), v = bar->axis.cross(u);
        for (const int i : {-1, 1})
            for (const int j : {-1, 1})
                for (const int k : {-1, 1})
                    corners.push_back(bar->centre + i * bar->half * bar->axis + bar->radius * (j * u + k * v));
    }
    return corners;
}

bool reaches_outside(const PlacedSolid<3>& sharp, const PlacedSolid<3>& container)
{
    for (const Vec<3>& x : corners_around(sharp)) {
        const bool inside = std::visit(
            [&](const auto& kind) {
                if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<3>>)
                    return false;
                else
                    return kind.covers(x);
            },
            container.kind);
        if (!inside)
            return true;
    }
    return false;
}

} // namespace

bool overlap(const PlacedSolid<3>& sharp, const PlacedSolid<3>& other)
{
    if (other.inverse)
        return reaches_outside(sharp, other);
    const std::vector<Vec<3>> own = directions(sharp), others = directions(other);
    for (const std::vector<Vec<3>>* list : {&own, &others})
        for (const Vec<3>& n : *list)
            if (separates(sharp, other, n))
                return false;
    for (const Vec<3>& m : own)
        for (const Vec<3>& n : others)
            if (const Vec<3> way = m.cross(n); way.norm() > parameters.parallel && separates(sharp, other, way.normalized()))
                return false;
    // Between points that are nearest to each other in turn.
    const auto nearest = [](const PlacedSolid<3>& solid, const Vec<3>& x) -> Vec<3> {
        return std::visit(
            [&](const auto& kind) -> Vec<3> {
                using Kind = std::decay_t<decltype(kind)>;
                if constexpr (std::is_same_v<Kind, BallKind<3>>)
                    return kind.centre;
                else if constexpr (std::is_same_v<Kind, RoundKind<3>>) {
                    const double s = std::clamp((x - kind.centre).dot(kind.axis), -kind.half, kind.half);
                    return kind.centre + s * kind.axis;
                } else
                    return 0.5 * (solid.low + solid.high);
            },
            solid.kind);
    };
    Vec<3> x = nearest(sharp, nearest(other, sharp.reference));
    for (int turn = 0; turn < 8; ++turn) {
        const Vec<3> y = nearest(other, x);
        if (const Vec<3> way = y - x; way.norm() > parameters.parallel && separates(sharp, other, way.normalized()))
            return false;
        x = nearest(sharp, y);
    }
    return true;
}

void find_overlaps(std::span<PlacedSolid<3>> solids)
{
    for (std::size_t a = 0; a < solids.size(); ++a)
        if (!solids[a].sharp.empty())
            for (std::size_t b = 0; b < solids.size(); ++b) {
                const PlacedSolid<3>&p = solids[a], &q = solids[b];
                const bool near = q.inverse || ((p.low.array() <= q.high.array()).all() && (p.high.array() >= q.low.array()).all());
                if (a != b && near && overlap(p, q))
                    solids[a].sharp.overlapping.push_back({q.low, q.high});
            }
}

} // namespace gapflow
