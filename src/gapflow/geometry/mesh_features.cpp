// Normals, smooth patches, sharp edges and curvatures of a closed mesh.
#include "gapflow/geometry/mesh_features.hpp"
#include "gapflow/core/decompositions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace gapflow {
namespace {

const double cos_sharp = std::cos(30 * std::numbers::pi / 180) - 1e-12;

/// Normal times area (2D: length).
template <int D>
Vec<D> area_vector(const SurfaceMesh<D>& mesh, const std::array<int, D>& facet)
{
    const Vec<D> along = mesh.vertices[facet[1]] - mesh.vertices[facet[0]];
    if constexpr (D == 2)
        return {along[1], -along[0]};
    else
        return 0.5 * along.cross(mesh.vertices[facet[2]] - mesh.vertices[facet[0]]);
}

/// Local index of the ridge opposite to which the longest edge lies.
template <int D>
int longest_ridge(const SurfaceMesh<D>& mesh, const std::array<int, D>& facet)
{
    int longest = 0;
    double best = -1;
    for (int i = 0; i < D; ++i) {
        const double length = (mesh.vertices[facet[(i + 2) % D]] - mesh.vertices[facet[(i + 1) % D]]).norm();
        if (length > best) {
            best = length;
            longest = i;
        }
    }
    return longest;
}

template <int D>
void find_normals(const ClosedSurface<D>& surface, MeshFeatures<D>& features)
{
    const auto& mesh = surface.mesh;
    std::vector<int> without;
    for (const auto& facet : mesh.elements) {
        const Vec<D> area = area_vector<D>(mesh, facet);
        const int i = longest_ridge<D>(mesh, facet);
        const double length = (mesh.vertices[facet[(i + 2) % D]] - mesh.vertices[facet[(i + 1) % D]]).norm();
        const bool has_area = D == 2 || area.norm() > 1e-13 * length * length;
        features.facet_normal.push_back(has_area ? area.normalized() : Vec<D>::Zero());
        if (!has_area)
            without.push_back(int(features.facet_normal.size()) - 1);
    }
    for (std::size_t left = without.size() + 1; !without.empty() && without.size() < left;) {
        left = without.size();
        std::erase_if(without, [&](int f) {
            const int g = surface.neighbours[f][longest_ridge<D>(mesh, mesh.elements[f])];
            features.facet_normal[f] = features.facet_normal[g];
            return !features.facet_normal[f].isZero();
        });
    }
    if constexpr (D == 3)
        for (int f : without) // slivers that only touch slivers: any normal across them
            features.facet_normal[f] =
                (mesh.vertices[mesh.elements[f][1]] - mesh.vertices[mesh.elements[f][0]]).unitOrthogonal();
}

template <int D>
void find_patches(const ClosedSurface<D>& surface, MeshFeatures<D>& features)
{
    const auto& normal = features.facet_normal;
    const int n = int(normal.size());
    features.smooth.resize(n);
    for (int f = 0; f < n; ++f)
        for (int i = 0; i < D; ++i)
            features.smooth[f][i] = normal[f].dot(normal[surface.neighbours[f][i]]) >= cos_sharp;
    features.patch.assign(n, -1);
    int patches = 0;
    std::vector<int> stack;
    for (int seed = 0; seed < n; ++seed) {
        if (features.patch[seed] >= 0)
            continue;
        features.patch[seed] = patches;
        stack.push_back(seed);
        while (!stack.empty()) {
            const int f = stack.back();
            stack.pop_back();
            for (int i = 0; i < D; ++i)
                if (const int g = surface.neighbours[f][i]; features.smooth[f][i] && features.patch[g] < 0) {
                    features.patch[g] = patches;
                    stack.push_back(g);
                }
        }
        ++patches;
    }
    features.patch_curvature.assign(patches, 0);
}

template <int D>
void find_fans(const ClosedSurface<D>& surface, MeshFeatures<D>& features)
{
    const auto& elements = surface.mesh.elements;
    const int vertices = int(surface.mesh.vertices.size());
    features.fan_start.assign(vertices + 1, 0);
    for (const auto& facet : elements)
        for (int v : facet)
            ++features.fan_start[v + 1];
    for (int v = 0; v < vertices; ++v)
        features.fan_start[v + 1] += features.fan_start[v];
    features.fan.resize(features.fan_start.back());
    std::vector<int> next(features.fan_start.begin(), features.fan_start.end() - 1);
    for (int f = 0; f < int(elements.size()); ++f)
        for (int v : elements[f])
            features.fan[next[v]++] = f;

    features.vertex_one_fan.assign(vertices, true);
    if constexpr (D == 3)
        for (int v = 0; v < vertices; ++v) { // walk round v across the edges that leave it
            const auto fan = features.facets_at(v);
            std::size_t steps = 0;
            int f = fan[0];
            do {
                const auto& facet = elements[f];
                const int i = int(std::find(facet.begin(), facet.end(), v) - facet.begin());
                f = surface.neighbours[f][(i + 1) % 3];
                ++steps;
            } while (f != fan[0] && steps <= fan.size());
            features.vertex_one_fan[v] = steps == fan.size();
        }
}

template <int D>
Feature feature_of_vertex(const ClosedSurface<D>& surface, const MeshFeatures<D>& features, int v)
{
    const auto& mesh = surface.mesh;
    std::vector<Vec<D>> sharp; // directions of the sharp edges that leave v
    for (int f : features.facets_at(v)) {
        const auto& facet = mesh.elements[f];
        const int i = int(std::find(facet.begin(), facet.end(), v) - facet.begin());
        if constexpr (D == 2) {
            if (!features.smooth[f][1 - i])
                return Feature::corner;
        } else if (!features.smooth[f][(i + 2) % 3]) // each edge is seen once, from the facet where it leaves v
            sharp.push_back((mesh.vertices[facet[(i + 1) % 3]] - mesh.vertices[v]).normalized());
    }
    if (sharp.size() > 2 || (sharp.size() == 2 && sharp[0].dot(sharp[1]) > -cos_sharp))
        return Feature::corner;
    if (!sharp.empty())
        return Feature::edge;
    for (int f : features.facets_at(v)) // the tip of a cone whose sides meet smoothly
        if (features.facet_normal[f].dot(features.vertex_normal[v]) < std::numbers::sqrt2 / 2)
            return Feature::corner;
    return Feature::face;
}

template <int D>
void find_vertices(const ClosedSurface<D>& surface, MeshFeatures<D>& features)
{
    const auto& mesh = surface.mesh;
    features.vertex_normal.assign(mesh.vertices.size(), Vec<D>::Zero());
    for (int f = 0; f < int(mesh.elements.size()); ++f)
        for (int i = 0; i < D; ++i)
            features.vertex_normal[mesh.elements[f][i]] += facet_angle(mesh, f, i) * features.facet_normal[f];
    for (int v = 0; v < int(mesh.vertices.size()); ++v) {
        features.vertex_normal[v].normalize();
        features.vertex_feature.push_back(feature_of_vertex(surface, features, v));
    }
}

template <int D>
bool planar(const SurfaceMesh<D>& mesh, const std::vector<int>& facets)
{
    Vec<D> sum = Vec<D>::Zero(), low = mesh.vertices[mesh.elements[facets[0]][0]], high = low, centre = Vec<D>::Zero();
    double area = 0;
    for (int f : facets) {
        const Vec<D> a = area_vector<D>(mesh, mesh.elements[f]);
        sum += a;
        area += a.norm();
        for (int v : mesh.elements[f]) {
            low = low.cwiseMin(mesh.vertices[v]);
            high = high.cwiseMax(mesh.vertices[v]);
            centre += mesh.vertices[v] / double(D * facets.size());
        }
    }
    if (sum.norm() < 0.5 * area || area == 0)
        return area == 0;
    const Vec<D> normal = sum.normalized();
    return std::all_of(facets.begin(), facets.end(), [&](int f) {
        return std::all_of(mesh.elements[f].begin(), mesh.elements[f].end(), [&](int v) {
            return std::abs(normal.dot(mesh.vertices[v] - centre)) <= 1e-6 * (high - low).norm();
        });
    });
}

/// Share of local vertex i in a facet's area: that of its Voronoi cell, kept inside the facet (Meyer et al. 2003).
template <int D>
double area_share(const SurfaceMesh<D>& mesh, int f, int i)
{
    const double area = area_vector<D>(mesh, mesh.elements[f]).norm();
    if constexpr (D == 2)
        return area / 2;
    else {
        const auto angle = [&](int k) { return facet_angle(mesh, f, k % 3); };
        for (int k = 0; k < 3; ++k)
            if (angle(i + k) > 0.5 * std::numbers::pi)
                return k == 0 ? area / 2 : area / 4;
        const auto corner = [&](int k) { return mesh.vertices[mesh.elements[f][k % 3]]; };
        double share = 0;
        for (int k = 1; k < 3; ++k) // angle k faces the edge from i to the other vertex
            share += (corner(i + 3 - k) - corner(i)).squaredNorm() / std::tan(angle(i + k)) / 8;
        return share;
    }
}

/// Area and edge tensor of a vertex in one patch.
template <int D>
struct VertexBend {
    double area = 0;
    Mat<D> bend = Mat<D>::Zero();
};

/// Largest principal curvature of a patch. At a vertex of area A it is the largest eigenvalue of
///   (1 / A) sum over its edges of beta |e| / 2 e e^T        (Cohen-Steiner & Morvan 2003; beta: turn of the normal, e: edge)
/// in 2D simply beta / A; sums over a vertex and its neighbours. Of these the upper quartile, each weighted by its turn
/// |curvature| A: flat parts and single bad vertices do not count.
template <int D>
double curvature_of(const ClosedSurface<D>& surface, const MeshFeatures<D>& features, const std::vector<int>& facets)
{
    const auto& mesh = surface.mesh;
    std::unordered_map<int, VertexBend<D>> at;
    for (int f : facets) {
        const auto& facet = mesh.elements[f];
        const Vec<D>& n = features.facet_normal[f];
        for (int i = 0; i < D; ++i) {
            at[facet[i]].area += area_share(mesh, f, i);
            const int g = surface.neighbours[f][i];
            if (!features.smooth[f][i])
                continue;
            const Vec<D>& m = features.facet_normal[g];
            const double beta = 2 * std::atan2((n - m).norm(), (n + m).norm());
            const int a = facet[(i + 1) % D], b = facet[D == 2 ? 1 - i : (i + 2) % D];
            Vec<D> across = Vec<D>::Zero(); // into the neighbour
            for (int v : mesh.elements[g])
                across += mesh.vertices[v] - mesh.vertices[a];
            const double turn = across.dot(n) <= 0 ? beta : -beta;
            // Each ridge is met from both sides: half its share to each.
            if constexpr (D == 2)
                at[a].bend(0, 0) += turn / 2;
            else {
                const Vec<3> edge = mesh.vertices[b] - mesh.vertices[a];
                const Mat<3> part = turn / 4 * edge * edge.transpose() / edge.norm();
                at[a].bend += part;
                at[b].bend += part;
            }
        }
    }
    std::unordered_map<int, VertexBend<D>> ring = at; // with the neighbours: facets may have been split without bending
    for (int f : facets)
        for (int v : mesh.elements[f])
            for (int w : mesh.elements[f])
                if (v != w) { // each neighbour is met in two facets
                    ring[v].area += at[w].area / 2;
                    ring[v].bend += at[w].bend / 2;
                }
    std::vector<std::pair<double, double>> samples; // curvature, weight
    double total = 0;
    for (const auto& [v, sum] : ring) {
        if (sum.area <= 0)
            continue;
        double curvature;
        if constexpr (D == 2)
            curvature = sum.bend(0, 0) / sum.area;
        else {
            const Vec<3> principal = symmetric_eigenvalues<3>(sum.bend / sum.area);
            curvature = std::abs(principal[0]) > std::abs(principal[2]) ? principal[0] : principal[2];
        }
        samples.emplace_back(curvature, std::abs(curvature) * sum.area);
        total += samples.back().second;
    }
    std::sort(samples.begin(), samples.end(),
              [](const auto& s, const auto& t) { return std::pair(std::abs(s.first), s) < std::pair(std::abs(t.first), t); });
    double below = 0;
    for (const auto& [curvature, weight] : samples)
        if ((below += weight) >= 0.75 * total)
            return curvature;
    return 0;
}

} // namespace

template <int D>
double facet_angle(const SurfaceMesh<D>& mesh, int facet, int i)
{
    if constexpr (D == 2)
        return 1;
    else {
        const auto& corner = mesh.elements[facet];
        const Vec<3> a = mesh.vertices[corner[(i + 1) % 3]] - mesh.vertices[corner[i]];
        const Vec<3> b = mesh.vertices[corner[(i + 2) % 3]] - mesh.vertices[corner[i]];
        return std::atan2(a.cross(b).norm(), a.dot(b));
    }
}

template <int D>
MeshFeatures<D> find_features(const ClosedSurface<D>& surface)
{
    MeshFeatures<D> features;
    find_normals(surface, features);
    find_patches(surface, features);
    find_fans(surface, features);
    find_vertices(surface, features);
    std::vector<std::vector<int>> facets(features.patch_curvature.size());
    for (int f = 0; f < int(features.patch.size()); ++f)
        facets[features.patch[f]].push_back(f);
    for (std::size_t p = 0; p < facets.size(); ++p)
        if (!planar(surface.mesh, facets[p]))
            features.patch_curvature[p] = curvature_of(surface, features, facets[p]);
    return features;
}

template MeshFeatures<2> find_features<2>(const ClosedSurface<2>&);
template MeshFeatures<3> find_features<3>(const ClosedSurface<3>&);
template double facet_angle<2>(const SurfaceMesh<2>&, int, int);
template double facet_angle<3>(const SurfaceMesh<3>&, int, int);

} // namespace gapflow
