#include "gapflow/film/rim_points.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr double rim_spacing = 0.125; // of points along a rim, in dx
constexpr double smooth_rim_spacing =
    1.3; // the same where the film goes out between curved surfaces, whose rim has edges of a cell: one an edge

} // namespace

template <int D>
std::vector<RimPoint<D>> rim_points(std::span<const Film<D>> films, double dx)
{
    std::vector<RimPoint<D>> points;
    for (int k = 0; k < static_cast<int>(films.size()); ++k) {
        const FilmMesh<D>& mesh = films[k].mesh;
        for (const RimEdge<D>& edge : mesh.rim) {
            if constexpr (D == 2) {
                points.push_back({k, &edge, {1.0}, mesh.mid[edge.nodes[0]], 1.0, mesh.h[edge.nodes[0]]});
            } else {
                const auto [a, b] = edge.nodes;
                const bool smooth = !mesh.flat && (edge.end == RimEnd::thickness || edge.end == RimEnd::normals ||
                                                   edge.end == RimEnd::third_body);
                const double spacing = (smooth ? smooth_rim_spacing : rim_spacing) * dx;
                const int count = std::max(1, static_cast<int>(std::ceil(edge.length / spacing - 1e-9)));
                for (int i = 0; i < count; ++i) {
                    const double s = (i + 0.5) / count;
                    points.push_back({k,
                                      &edge,
                                      {1 - s, s},
                                      (1 - s) * mesh.mid[a] + s * mesh.mid[b],
                                      edge.length / count,
                                      (1 - s) * mesh.h[a] + s * mesh.h[b]});
                }
            }
        }
    }
    return points;
}

template std::vector<RimPoint<2>> rim_points<2>(std::span<const Film<2>>, double);
template std::vector<RimPoint<3>> rim_points<3>(std::span<const Film<3>>, double);

} // namespace gapflow
