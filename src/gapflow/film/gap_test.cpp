#include "gapflow/film/gap_test.hpp"

#include "gapflow/film/edge_table.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace gapflow {

template <int D>
bool GapTest<D>::in_label(int patch) const
{
    return label.empty() || std::find(label.begin(), label.end(), patch) != label.end();
}

template <int D>
std::optional<RimEnd> GapTest<D>::fails(const Vec<D>& x, const Vec<D>& n, const SurfacePoint<D>& p) const
{
    if (!(p.distance < options.threshold))
        return RimEnd::thickness;
    if (options.touching && p.distance <= *options.touching)
        return RimEnd::touching;
    if (p.feature != Feature::face)
        return RimEnd::other_edge;
    if (!in_label(p.patch))
        return RimEnd::patch;
    if (!(n.dot(p.normal) < facing_cosine))
        return RimEnd::normals;
    // equally near by symmetry counts as in the gap, whatever the rounding
    if (third(x, n) < p.distance - 1e-10 * options.dx)
        return RimEnd::third_body;
    return {};
}

template <int D>
double GapTest<D>::curvature(int master_patch, int other_patch) const
{
    return std::max(0.0, master.shape().curvature(master_patch) + other.shape().curvature(other_patch));
}

template <int D>
double GapTest<D>::curvature_along(int master_patch, int other_patch, const std::array<Vec<D>, 2>& x,
                                   const std::array<Vec<D>, 2>& y) const
{
    return std::max(0.0, master.shape().curvature_along(master_patch, master.to_body(x[0]), master.to_body(x[1])) +
                             other.shape().curvature_along(other_patch, other.to_body(y[0]), other.to_body(y[1])));
}

template <int D>
Vec<D> GapTest<D>::onto(const Vec<D>& x, int patch, int second) const
{
    const auto put = [&](const Vec<D>& z, int k) { return master.shape().curvature(k) == 0 ? z : master.onto(z, k); };
    if (second < 0 || second == patch)
        return put(x, patch);
    return put(put(put(put(x, patch), second), patch), second);
}

namespace {

/// Sharing one facet (2D: vertex) makes two elements neighbours: the middle of the facet and both patches.
template <int D, class Visit>
void for_each_joint(const SurfaceMesh<D>& mesh, Visit visit)
{
    EdgeTable first;
    first.reset(2 * mesh.elements.size());
    for (int e = 0; e < int(mesh.elements.size()); ++e)
        for (int k = 0; k < D; ++k) {
            const int a = mesh.elements[e][k], b = D == 2 ? a : mesh.elements[e][(k + 1) % D];
            int& neighbour = first.insert(a, b);
            if (neighbour < 0)
                neighbour = e;
            else
                visit(Vec<D>(0.5 * (mesh.vertices[a] + mesh.vertices[b])), mesh.patch[neighbour], mesh.patch[e]);
        }
}

} // namespace

template <int D>
std::vector<std::vector<int>> smooth_groups(const Shape<D>& shape, const std::vector<int>& patches)
{
    std::map<int, int> group;
    for (int patch : patches)
        group[patch] = patch;
    const auto root = [&](int k) {
        while (group[k] != k)
            k = group[k];
        return k;
    };
    if (group.size() > 1)
        for_each_joint<D>(shape.surface_mesh(), [&](const Vec<D>& x, int a, int b) {
            if (a == b || !group.count(a) || !group.count(b))
                return;
            if (shape.patch_normal(x, a).dot(shape.patch_normal(x, b)) > smooth_cosine)
                group[std::max(root(a), root(b))] = std::min(root(a), root(b));
        });
    std::map<int, std::vector<int>> members;
    for (const auto& [patch, unused] : group)
        members[root(patch)].push_back(patch);
    std::vector<std::vector<int>> groups;
    for (auto& [patch, list] : members)
        groups.push_back(std::move(list));
    return groups;
}

template <int D>
bool in_gap(const PlacedShape<D>& a, const PlacedShape<D>& b, const Vec<D>& x, double threshold)
{
    const SurfacePoint<D> pa = a.closest(x), pb = b.closest(x);
    return pa.distance + pb.distance < threshold && pa.feature == Feature::face && pb.feature == Feature::face &&
           pa.normal.dot(pb.normal) < facing_cosine;
}

template struct GapTest<2>;
template struct GapTest<3>;
template std::vector<std::vector<int>> smooth_groups(const Shape<2>&, const std::vector<int>&);
template std::vector<std::vector<int>> smooth_groups(const Shape<3>&, const std::vector<int>&);
template bool in_gap(const PlacedShape<2>&, const PlacedShape<2>&, const Vec<2>&, double);
template bool in_gap(const PlacedShape<3>&, const PlacedShape<3>&, const Vec<3>&, double);

} // namespace gapflow
