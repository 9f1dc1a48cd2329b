#include "gapflow/step/own_edges.hpp"

#include <algorithm>
#include <limits>
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

/// The circulation around a mouth's edge and the faces along it: of the edge of the same solids that lies nearest to where the corner has moved to; of several that one
/// corner's line crosses in the nearest cell.
template <int D>
void carry_in_mouths(const Placed<D>& from, const std::vector<double>& own, const Placed<D>& to, std::vector<double>& carried)
{
    struct Known {
        Vec<D> at;
        Index<D> cell;
        double own;
    };
    const auto cell_of = [](const Placed<D>& of, const MouthEdge<D>& edge) {
        const auto rows = of.edges.rows_of(of.edges.edges[edge.edge]);
        return rows.empty() ? Index<D>(Index<D>::Zero()) : rows[0].cell;
    };
    const double dx = to.coupling.grid->dx(), round_off = 1e-9 * dx;
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<Known>> known;
    for (const MouthEdge<D>& edge : from.edges.in_mouths) {
        const int s = edge.solid[0];
        const Vec<D> moved = to.coupling.solids[s].shape.to_world(from.coupling.solids[s].shape.to_body(edge.at));
        known[pair_of(edge.solid)].push_back({moved, cell_of(from, edge), own[edge.edge]});
    }
    for (const MouthEdge<D>& edge : to.edges.in_mouths) {
        const auto of = known.find(pair_of(edge.solid));
        if (of == known.end())
            continue;
        const auto distance = [&](const Known& one) { return to.coupling.grid->nearest_image(one.at - edge.at).norm(); };
        double nearest = dx;
        for (const Known& one : of->second)
            nearest = std::min(nearest, distance(one));
        if (nearest == dx)
            continue;
        const Index<D> cell = cell_of(to, edge);
        int least = std::numeric_limits<int>::max();
        for (const Known& one : of->second)
            if (const int steps = (one.cell - cell).squaredNorm(); distance(one) <= nearest + round_off && steps < least) {
                least = steps;
                carried[edge.edge] = one.own;
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
    carry_in_mouths(from, own, to, carried);
    return carried;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<double> own_along_edges<D>(const Placed<D>&, const Remainder<D>&);                                    \
    template std::vector<double> carried_along_edges<D>(const Placed<D>&, const std::vector<double>&, const Placed<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
