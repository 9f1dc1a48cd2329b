#include "gapflow/step/own_edges.hpp"

#include <map>
#include <utility>

namespace gapflow {

void add_own(std::vector<double>& sum, const std::vector<double>& own)
{
    for (std::size_t e = 0; e < own.size(); ++e)
        sum[e] += own[e];
}

namespace {

std::pair<std::int32_t, std::int32_t> pair_of(const std::array<std::int32_t, 2>& solid)
{
    return std::minmax<std::int32_t>(solid[0], solid[1]);
}

/// The circulation around an edge across a corner's line and the faces beside it: of the edge of the same solids that lies nearest to where the corner has moved to.
template <int D>
void carry_at_corners(const Placed<D>& from, const std::vector<double>& own, const Placed<D>& to, std::vector<double>& carried)
{
    const double reach = to.coupling.grid->dx();
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::pair<Vec<D>, double>>> known;
    for (const CornerEdge<D>& edge : from.edges.at_corners) {
        const int s = edge.solid[0];
        const Vec<D> moved = to.coupling.solids[s].shape.to_world(from.coupling.solids[s].shape.to_body(edge.at));
        known[pair_of(edge.solid)].emplace_back(moved, own[edge.edge]);
    }
    for (const CornerEdge<D>& edge : to.edges.at_corners) {
        const auto of = known.find(pair_of(edge.solid));
        double nearest = reach;
        for (const auto& [at, value] : of == known.end() ? std::vector<std::pair<Vec<D>, double>>{} : of->second)
            if (const double distance = to.coupling.grid->nearest_image(at - edge.at).norm(); distance < nearest) {
                nearest = distance;
                carried[edge.edge] = value;
            }
    }
}

} // namespace

template <int D>
std::vector<double> own_along_edges(const Placed<D>& at, const Remainder<D>& remainder)
{
    if (!at.viscous)
        return {};
    std::vector<double> own = along_edges(at, remainder.faces);
    for (std::size_t e = 0; e < own.size(); ++e)
        own[e] = remainder.edges[e] - own[e];
    return own;
}

template <int D>
std::vector<double> carried_along_edges(const Placed<D>& from, const std::vector<double>& own, const Placed<D>& to)
{
    if (!to.viscous)
        return {};
    std::vector<double> carried(to.edges.edges.size(), 0.0);
    std::map<std::pair<int, std::int32_t>, std::vector<std::size_t>> pieces; // of the other place, by their faces
    for (std::size_t k = 0; k < from.complex.pieces.size(); ++k)
        if (const FacePiece<D>& piece = from.complex.pieces[k]; piece.area > 0)
            pieces[{piece.axis, piece.face}].push_back(k);
    for (std::size_t k = 0; k < to.complex.pieces.size(); ++k) {
        const std::int32_t edge = to.edges.edge_of_piece[k];
        if (edge < 0)
            continue;
        const FacePiece<D>& piece = to.complex.pieces[k];
        const auto there = pieces.find({piece.axis, piece.face});
        if (there == pieces.end())
            continue;
        std::size_t nearest = there->second.front();
        const auto distance = [&](std::size_t other) { return (from.complex.pieces[other].centroid - piece.centroid).norm(); };
        for (const std::size_t other : there->second)
            if (distance(other) < distance(nearest))
                nearest = other;
        if (const std::int32_t its = from.edges.edge_of_piece[nearest]; its >= 0)
            carried[edge] = own[its];
    }
    carry_at_corners(from, own, to, carried);
    return carried;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<double> own_along_edges<D>(const Placed<D>&, const Remainder<D>&);                                    \
    template std::vector<double> carried_along_edges<D>(const Placed<D>&, const std::vector<double>&, const Placed<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
