#include "gapflow/complex/wall_joins.hpp"

#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <variant>

namespace gapflow {

FacetsInCells::FacetsInCells(const GridPlanes<3>& planes, const DenseIndex<3>& index, const std::vector<PlacedSolid<3>>& solids)
{
    // A vertex in a plane lies below it (facet_cut.hpp).
    const auto cell_of = [&](const Vec<3>& x) -> std::int32_t {
        Index<3> c;
        for (int axis = 0; axis < 3; ++axis) {
            c[axis] = planes.place[axis].below(x[axis]);
            if (c[axis] < index.low[axis] || c[axis] >= index.low[axis] + index.size[axis] - 1)
                return -1;
        }
        return index(c);
    };
    for (int image = 0; image < static_cast<int>(solids.size()); ++image) {
        const auto* kind = std::get_if<FacetKind<3>>(&solids[image].kind);
        if (!kind)
            continue;
        std::vector<std::int32_t> cell;
        for (const Vec<3>& x : kind->vertices)
            cell.push_back(cell_of(x));
        const auto& facets = kind->surface->elements;
        for (int f = 0; f < static_cast<int>(facets.size()); ++f)
            for (int k = 0; k < 3; ++k) {
                const std::int32_t c = cell[facets[f][k]];
                if (c < 0 || (k > 0 && c == cell[facets[f][0]]) || (k > 1 && c == cell[facets[f][1]]))
                    continue;
                std::uint8_t corners = 0;
                for (int i = k; i < 3; ++i)
                    corners |= static_cast<std::uint8_t>((cell[facets[f][i]] == c) << i);
                entries_.push_back({c, image, f, corners});
            }
    }
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.cell < b.cell; });
}

std::span<const FacetsInCells::Entry> FacetsInCells::of(std::int32_t cell) const
{
    const auto [from, to] = std::equal_range(entries_.begin(), entries_.end(), Entry{cell, 0, 0, 0},
                                             [](const Entry& a, const Entry& b) { return a.cell < b.cell; });
    return {from, to};
}

int FacetJoins::node(const Node& key) const
{
    return static_cast<int>(std::lower_bound(nodes_.begin(), nodes_.end(), key) - nodes_.begin());
}

int FacetJoins::root(int k)
{
    while (up_[k] != k)
        k = up_[k] = up_[up_[k]];
    return k;
}

const std::vector<PiecePair>& FacetJoins::find(const std::vector<PlacedSolid<3>>& solids, std::span<const BorderFacet> borders,
                                               std::span<const FacetsInCells::Entry> inside)
{
    nodes_.clear();
    pairs_.clear();
    // Of a periodic domain's last cell the faces on its far side see another image of the same facet.
    for (const BorderFacet& border : borders)
        nodes_.push_back({solids[border.image].solid, border.facet});
    for (const FacetsInCells::Entry& entry : inside)
        nodes_.push_back({solids[entry.image].solid, entry.facet});
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    up_.resize(nodes_.size());
    for (std::size_t k = 0; k < up_.size(); ++k)
        up_[k] = static_cast<int>(k);
    for (const FacetsInCells::Entry& entry : inside) {
        const auto& links = (*std::get<FacetKind<3>>(solids[entry.image].kind).links)[entry.facet];
        for (int k = 0; k < 3; ++k)
            if (entry.corners >> k & 1 || entry.corners >> (k + 1) % 3 & 1)
                up_[root(node({solids[entry.image].solid, entry.facet}))] = root(node({solids[entry.image].solid, links[k]}));
    }
    piece_.assign(nodes_.size(), -1);
    for (const BorderFacet& border : borders) {
        int& piece = piece_[root(node({solids[border.image].solid, border.facet}))];
        if (piece < 0)
            piece = border.piece;
        else
            pairs_.push_back({piece, border.piece});
    }
    return pairs_;
}

double HoleInCell::radius() const
{
    return std::sqrt(area / std::numbers::pi);
}

double HoleInCell::conductance() const
{
    constexpr double watson =
        0.252731009858663; // resistance from a node of the cubic lattice to infinity, G(0); G(0) - G(1) = 1/6
    constexpr double grid = 2 * (watson + watson - 1.0 / 6);
    return 1 / ((0.5 / radius() - grid) * std::clamp(margin / radius(), parameters.least_covered, 1.0));
}

std::optional<HoleInCell> sharp_hole(const SharpSolid& solid, const Index<3>& cell, const Vec<3>& low, const Vec<3>& high)
{
    std::vector<const SharpEdge*> edges; // wholly in the cell
    const auto inside = [&](const Vec<3>& x) { return (x.array() > low.array()).all() && (x.array() < high.array()).all(); };
    for (const EdgeCell& e : solid.edges_in(cell))
        if (const SharpEdge& edge = solid.edges[e.edge]; inside(edge.from) && inside(edge.to))
            edges.push_back(&edge);
    std::optional<HoleInCell> narrowest;
    while (!edges.empty()) {
        const Vec<3> start = edges.back()->from;
        Vec<3> end = edges.back()->to;
        edges.pop_back();
        std::vector<Vec<3>> rim{start};
        while (end != start) {
            const auto next =
                std::find_if(edges.begin(), edges.end(), [&](const SharpEdge* e) { return e->from == end || e->to == end; });
            if (next == edges.end())
                break;
            rim.push_back(end);
            end = (*next)->from == end ? (*next)->to : (*next)->from;
            edges.erase(next);
        }
        if (end != start)
            continue;
        Vec<3> area = Vec<3>::Zero();
        HoleInCell hole{0, std::numeric_limits<double>::infinity(), start, Vec<3>::Zero()};
        for (std::size_t k = 0; k < rim.size(); ++k) {
            area += 0.5 * (rim[k] - start).cross(rim[(k + 1) % rim.size()] - start);
            for (int axis = 0; axis < 3; ++axis)
                for (const bool top : {false, true})
                    if (const double margin = top ? high[axis] - rim[k][axis] : rim[k][axis] - low[axis];
                        margin < hole.margin) {
                        hole.margin = margin;
                        hole.nearest = rim[k];
                        hole.inward = (top ? -1 : 1) * Vec<3>::Unit(axis);
                    }
        }
        hole.area = area.norm();
        if (hole.area > parameters.least_area && (!narrowest || hole.area < narrowest->area))
            narrowest = hole;
    }
    return narrowest;
}

namespace {

/// Whether the way from a to b meets a convex solid.
bool meets(const BallKind<3>& ball, const Vec<3>& a, const Vec<3>& b)
{
    const Vec<3> way = b - a, r = ball.centre - a;
    const double t = std::clamp(r.dot(way) / way.squaredNorm(), 0.0, 1.0);
    return ball.covers(a + t * way);
}

bool meets(const PlanesKind<3>& kind, const Vec<3>& a, const Vec<3>& b)
{
    Stretch in{0, 1};
    for (int k = 0; k < kind.planes; ++k) {
        const double here = kind.normal[k].dot(a - kind.centre) - kind.offset[k],
                     there = kind.normal[k].dot(b - kind.centre) - kind.offset[k];
        if (here > 0 && there > 0)
            return false;
        if (here > 0)
            in.from = std::max(in.from, here / (here - there));
        else if (there > 0)
            in.to = std::min(in.to, here / (here - there));
    }
    return in.from <= in.to;
}

bool meets(const RoundKind<3>& bar, const Vec<3>& a, const Vec<3>& b)
{
    if (!bar.flat)
        for (const int end : {-1, 1})
            if (meets(BallKind<3>{bar.centre + end * bar.half * bar.axis, bar.radius}, a, b))
                return true;
    // Between its ends the distance from the axis has one minimum.
    const Vec<3> way = b - a, r = a - bar.centre;
    const double s = r.dot(bar.axis), slope = way.dot(bar.axis);
    Stretch in{0, 1};
    if (slope != 0) {
        const double t0 = (-bar.half - s) / slope, t1 = (bar.half - s) / slope;
        in.cut({std::min(t0, t1), std::max(t0, t1)});
    } else if (std::abs(s) > bar.half)
        return false;
    if (in.from > in.to)
        return false;
    const Vec<3> q = r - s * bar.axis, e = way - slope * bar.axis;
    const double square = e.squaredNorm(), t = std::clamp(square > 0 ? -q.dot(e) / square : 0.0, in.from, in.to);
    return (q + t * e).squaredNorm() <= bar.radius * bar.radius;
}

} // namespace

bool in_sight(const GridPlanes<3>& planes, const std::vector<PlacedSolid<3>>& solids, std::span<const int> images,
              const Vec<3>& a, const Vec<3>& b)
{
    for (const int image : images) {
        const PlacedSolid<3>& solid = solids[image];
        const bool blocked = std::visit(
            [&](const auto& kind) {
                if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<3>>) {
                    const Vec<3> from = planes.in_world(a), way = planes.in_world(b) - from;
                    const auto entry = solid.shape.entry(from, way.normalized());
                    return !entry || *entry <= way.norm() || solid.shape.distance(from) <= 0;
                } else // the inside of a convex solid is convex
                    return solid.inverse ? !kind.covers(a) || !kind.covers(b) : meets(kind, a, b);
            },
            solid.kind);
        if (blocked)
            return false;
    }
    return true;
}

} // namespace gapflow
