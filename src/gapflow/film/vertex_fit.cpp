#include "gapflow/film/vertex_fit.hpp"

#include "gapflow/film/film_history.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace gapflow {

template <int D>
VertexRings vertex_rings(std::size_t vertices, std::span<const std::array<int, D>> elements)
{
    VertexRings rings;
    rings.first.assign(vertices + 1, 0);
    for (const auto& nodes : elements)
        for (int node : nodes)
            ++rings.first[node + 1];
    for (std::size_t i = 0; i < vertices; ++i)
        rings.first[i + 1] += rings.first[i];
    rings.element.resize(rings.first[vertices]);
    std::vector<int> next(rings.first.begin(), rings.first.end() - 1);
    for (std::size_t e = 0; e < elements.size(); ++e)
        for (int node : elements[e])
            rings.element[next[node]++] = static_cast<int>(e);
    return rings;
}

// With weights of sum 1, a = sum w f (1 - (t - <t>) . C^-1 <t>), C the covariance of t.
template <int D>
VertexFit vertex_fit(std::span<const Vec<D>> vertices, std::span<const std::array<int, D>> elements,
                     std::span<const Vec<D>> centroid, std::span<const Vec<D>> normal, std::span<const double> weight)
{
    const int n = static_cast<int>(vertices.size());
    const VertexRings rings = vertex_rings<D>(vertices.size(), elements);
    VertexFit fit;
    fit.first.assign(n + 1, 0);
    std::vector<int> around;
    for (int i = 0; i < n; ++i) {
        fit.first[i + 1] = fit.first[i];
        around.assign(rings.element.begin() + rings.first[i], rings.element.begin() + rings.first[i + 1]);
        if (around.size() < (D == 2 ? 2 : 5)) {
            for (int k = rings.first[i]; k < rings.first[i + 1]; ++k)
                for (int node : elements[rings.element[k]])
                    around.insert(around.end(), rings.element.begin() + rings.first[node],
                                  rings.element.begin() + rings.first[node + 1]);
            std::sort(around.begin(), around.end());
            around.erase(std::unique(around.begin(), around.end()), around.end());
        }
        double reach = 0, total = 0;
        Vec<D> across = Vec<D>::Zero(); // mean normal
        for (int e : around) {
            reach = std::max(reach, (centroid[e] - vertices[i]).squaredNorm());
            total += weight[e];
            across += weight[e] * normal[e];
        }
        if (total <= 0)
            continue;
        reach = std::max(std::sqrt(reach), 1e-300);
        across.normalize();
        Vec<D> mean = Vec<D>::Zero();
        Mat<D> covariance = Mat<D>::Zero();
        for (int e : around) {
            const Vec<D> t = tangential<D>(centroid[e] - vertices[i], across) / reach;
            mean += weight[e] / total * t;
            covariance += weight[e] / total * t * t.transpose();
        }
        covariance -= mean * mean.transpose();
        // Slopes across the surface are 0, and so are those of a lone element.
        covariance += across * across.transpose();
        covariance.diagonal().array() += 1e-8;
        const Vec<D> slope = covariance.inverse() * mean;
        for (int e : around) {
            const Vec<D> t = tangential<D>(centroid[e] - vertices[i], across) / reach;
            fit.element.push_back(e);
            fit.share.push_back(weight[e] / total * (1 - (t - mean).dot(slope)));
        }
        fit.first[i + 1] = static_cast<int>(fit.element.size());
    }
    return fit;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template VertexRings vertex_rings<D>(std::size_t, std::span<const std::array<int, D>>);                                    \
    template VertexFit vertex_fit<D>(std::span<const Vec<D>>, std::span<const std::array<int, D>>, std::span<const Vec<D>>,    \
                                     std::span<const Vec<D>>, std::span<const double>);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
