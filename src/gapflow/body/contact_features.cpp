#include "gapflow/body/contact_features.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace gapflow {

namespace {

// Patches that meet at less than this angle (cosine) form no edge.
constexpr double smooth_cosine = 0.9998;

enum class Bend { smooth, convex, hollow };

template <int D>
Bend bend_of(const Vec<D>& normal_a, const Vec<D>& normal_b, const Vec<D>& into_b)
{
    if (normal_a.dot(normal_b) > smooth_cosine)
        return Bend::smooth;
    return into_b.dot(normal_a) < 0 ? Bend::convex : Bend::hollow;
}

// Where two elements meet.
template <int D>
struct Joint {
    std::array<int, 2> element{-1, -1};
};

template <int D>
Vec<D> facet_normal(const SurfaceMesh<D>& mesh, int element)
{
    const auto& nodes = mesh.elements[element];
    const Vec<D> side = mesh.vertices[nodes[1]] - mesh.vertices[nodes[0]];
    if constexpr (D == 2)
        return Vec<2>(side[1], -side[0]).normalized();
    else
        return side.cross(Vec<3>(mesh.vertices[nodes[2]] - mesh.vertices[nodes[0]])).normalized();
}

} // namespace

template <int D>
ContactFeatures<D> contact_features(const Shape<D>& shape)
{
    ContactFeatures<D> features;
    features.cores = shape.cores();
    const SurfaceMesh<D> mesh = shape.surface_mesh();
    for (int patch : mesh.patch)
        features.patches = std::max(features.patches, patch + 1);

    // Facets of dimension D - 2 with the two elements that share them.
    std::map<std::array<int, D - 1>, Joint<D>> joints;
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e)
        for (int k = 0; k < D; ++k) {
            std::array<int, D - 1> key;
            for (int i = 0; i < D - 1; ++i)
                key[i] = mesh.elements[e][(k + i) % D];
            std::sort(key.begin(), key.end());
            Joint<D>& joint = joints[key];
            joint.element[joint.element[0] < 0 ? 0 : 1] = e;
        }

    // A vertex can touch first if convex edges meet there, or if it belongs to a curved part without a core.
    const std::size_t count = mesh.vertices.size();
    std::vector<char> convex(count, 0), hollow(count, 0), curved(count, 0);
    if (features.cores.empty() && !shape.inside_out())
        for (std::size_t e = 0; e < mesh.elements.size(); ++e)
            if (shape.curvature(mesh.patch[e]) != 0)
                for (int v : mesh.elements[e])
                    curved[v] = 1;
    auto centroid = [&](int e) {
        Vec<D> sum = Vec<D>::Zero();
        for (int v : mesh.elements[e])
            sum += mesh.vertices[v] / D;
        return sum;
    };
    for (const auto& [key, joint] : joints) {
        const auto [a, b] = joint.element;
        if (b >= 0 && mesh.patch[a] == mesh.patch[b] && shape.inside_out()) { // a bump of a container's wall
            const Bend bend = bend_of<D>(facet_normal(mesh, a), facet_normal(mesh, b), centroid(b) - mesh.vertices[key[0]]);
            for (int v : key)
                curved[v] = curved[v] || bend == Bend::convex;
        }
        if (b < 0 || mesh.patch[a] == mesh.patch[b])
            continue;
        const int patch_a = mesh.patch[a], patch_b = mesh.patch[b];
        Vec<D> middle = Vec<D>::Zero();
        for (int v : key)
            middle += mesh.vertices[v] / (D - 1);
        middle = shape.onto(shape.onto(middle, patch_a), patch_b);
        const Vec<D> normal_a = shape.patch_normal(middle, patch_a), normal_b = shape.patch_normal(middle, patch_b);
        const Bend bend = bend_of<D>(normal_a, normal_b, centroid(b) - middle);
        if (bend == Bend::smooth)
            continue;
        for (int v : key)
            (bend == Bend::convex ? convex : hollow)[v] = 1;
        if constexpr (D == 3)
            if (bend == Bend::convex) {
                const bool straight = shape.curvature(patch_a) == 0 && shape.curvature(patch_b) == 0;
                features.edges.push_back({mesh.vertices[key[0]], mesh.vertices[key[1]], normal_a, normal_b, patch_a, patch_b,
                                          straight || !shape.convex()}); // a mesh's edges are straight
            }
    }
    std::vector<std::vector<Vec<D>>> beside(count); // along each edge once for every element at it
    for (const auto& element : mesh.elements)
        for (int v : element)
            for (int other : element)
                if (other != v)
                    beside[v].push_back((mesh.vertices[other] - mesh.vertices[v]).normalized());
    for (std::size_t v = 0; v < count; ++v)
        if (convex[v] || (curved[v] && !hollow[v])) {
            features.vertices.push_back(mesh.vertices[v]);
            features.beside.push_back(std::move(beside[v]));
        }
    return features;
}

template ContactFeatures<2> contact_features<2>(const Shape<2>&);
template ContactFeatures<3> contact_features<3>(const Shape<3>&);

} // namespace gapflow
