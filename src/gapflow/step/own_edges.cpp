#include "gapflow/step/own_edges.hpp"

#include <map>
#include <utility>

namespace gapflow {

void add_own(std::vector<double>& sum, const std::vector<double>& own)
{
    for (std::size_t e = 0; e < own.size(); ++e)
        sum[e] += own[e];
}

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
    return carried;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<double> own_along_edges<D>(const Placed<D>&, const Remainder<D>&);                                    \
    template std::vector<double> carried_along_edges<D>(const Placed<D>&, const std::vector<double>&, const Placed<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
