// Closest point on triangles and segments, and where a ray meets them.
//
// Triangle: the query projects inside, or the closest point lies on one of the edges that face it (those beyond whose line
// the projection lies), so it is the best of at most two segments. Signs come from in-plane edge normals, exact where the
// facet is aligned with the axes.
#include "gapflow/geometry/facet_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace gapflow {
namespace {

constexpr int leaf_size = 4;

/// Squared distance to a box.
template <int D>
double distance2(const Vec<D>& low, const Vec<D>& high, const Vec<D>& q)
{
    return (low - q).cwiseMax(q - high).cwiseMax(0).squaredNorm();
}

template <int D>
FacetPoint<D> at_vertex(const Facet<D>& facet, int i, const Vec<D>& q)
{
    return {facet.corner[i], (q - facet.corner[i]).squaredNorm(), -1, i};
}

template <int D>
FacetPoint<D> in_plane(const Facet<D>& facet, const Vec<D>& q)
{
    const double d = (q - facet.corner[0]).dot(facet.normal);
    return {q - d * facet.normal, d * d, -1, -1};
}

FacetPoint<3> on_edge(const Facet<3>& facet, int ridge, const Vec<3>& q)
{
    const int i = (ridge + 1) % 3, j = (ridge + 2) % 3;
    const Vec<3>&a = facet.corner[i], &b = facet.corner[j], along = b - a;
    const double s = along.dot(q - a);
    if (s <= 0)
        return at_vertex(facet, i, q);
    if (along.dot(q - b) >= 0)
        return at_vertex(facet, j, q);
    const Vec<3> x = a + s / along.squaredNorm() * along;
    return {x, (q - x).squaredNorm(), ridge, -1};
}

/// Whether the ray from `start` meets the facet: the volumes (areas) that the direction spans with its ridges have one sign.
template <int D>
bool meets(const Facet<D>& facet, const Vec<D>& start, const Vec<D>& direction)
{
    const double ahead = (facet.corner[0] - start).dot(facet.normal) * direction.dot(facet.normal);
    if (!(ahead > 0))
        return false;
    bool positive = false, negative = false;
    for (int i = 0; i < D; ++i) {
        const Vec<D> a = facet.corner[i] - start;
        double side;
        if constexpr (D == 2)
            side = (i == 0 ? 1 : -1) * (a[0] * direction[1] - a[1] * direction[0]);
        else
            side = a.cross(facet.corner[(i + 1) % 3] - start).dot(direction);
        (side > 0 ? positive : negative) = true;
    }
    return positive != negative;
}

} // namespace

template <int D>
FacetPoint<D> closest_on(const Facet<D>& facet, const Vec<D>& q)
{
    if constexpr (D == 2) {
        const Vec<2> along = facet.corner[1] - facet.corner[0];
        if (along.dot(q - facet.corner[0]) <= 0)
            return at_vertex(facet, 0, q);
        if (along.dot(q - facet.corner[1]) >= 0)
            return at_vertex(facet, 1, q);
        return in_plane(facet, q);
    } else {
        FacetPoint<3> best;
        best.distance2 = std::numeric_limits<double>::infinity();
        bool inside = true;
        for (int ridge = 0; ridge < 3; ++ridge) {
            const Vec<3>&a = facet.corner[(ridge + 1) % 3], &b = facet.corner[(ridge + 2) % 3];
            if ((b - a).cross(facet.normal).dot(q - a) <= 0)
                continue;
            inside = false;
            if (const FacetPoint<3> p = on_edge(facet, ridge, q); p.distance2 < best.distance2)
                best = p;
        }
        return inside ? in_plane(facet, q) : best;
    }
}

template <int D>
FacetTree<D>::FacetTree(const std::vector<Facet<D>>& facets, const std::vector<int>& group)
{
    std::vector<int> order(facets.size());
    std::iota(order.begin(), order.end(), 0);
    nodes_.reserve(facets.size());
    build(order, facets, 0, int(order.size()));
    for (int f : order) {
        facets_.push_back(facets[f]);
        group_.push_back(group[f]);
        std::array<Vec<D>, 2> box{facets[f].corner[0], facets[f].corner[0]};
        for (const Vec<D>& x : facets[f].corner) {
            box[0] = box[0].cwiseMin(x);
            box[1] = box[1].cwiseMax(x);
        }
        boxes_.push_back(box);
    }
    id_ = std::move(order);
}

template <int D>
void FacetTree<D>::build(std::vector<int>& order, const std::vector<Facet<D>>& facets, int begin, int end)
{
    const int self = int(nodes_.size());
    const auto centre = [&](int f) { // times D
        Vec<D> sum = Vec<D>::Zero();
        for (const Vec<D>& x : facets[f].corner)
            sum += x;
        return sum;
    };
    Node node;
    node.low.setConstant(std::numeric_limits<double>::infinity());
    node.high = -node.low;
    Vec<D> low = node.low, high = node.high; // of the centres
    for (int k = begin; k < end; ++k) {
        for (const Vec<D>& x : facets[order[k]].corner) {
            node.low = node.low.cwiseMin(x);
            node.high = node.high.cwiseMax(x);
        }
        const Vec<D> c = centre(order[k]);
        low = low.cwiseMin(c);
        high = high.cwiseMax(c);
    }
    nodes_.push_back(node);
    if (end - begin <= leaf_size) {
        nodes_[self].first = begin;
        nodes_[self].count = end - begin;
        return;
    }
    int axis;
    (high - low).maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end, [&](int f, int g) {
        const double cf = centre(f)[axis], cg = centre(g)[axis];
        return cf != cg ? cf < cg : f < g;
    });
    build(order, facets, begin, middle);
    nodes_[self].first = int(nodes_.size());
    build(order, facets, middle, end);
}

template <int D>
typename FacetTree<D>::Hit FacetTree<D>::closest(const Vec<D>& q, int group) const
{
    Hit best;
    best.point.distance2 = std::numeric_limits<double>::infinity();
    std::array<std::pair<double, int>, 64> stack; // halving keeps the depth below 32
    int top = 0;
    const auto bound_of = [&](int node) { return distance2<D>(nodes_[node].low, nodes_[node].high, q); };
    stack[top++] = {bound_of(0), 0};
    while (top > 0) {
        const auto [bound, index] = stack[--top];
        if (bound >= best.point.distance2)
            continue;
        const Node& node = nodes_[index];
        for (int k = node.first; k < node.first + node.count; ++k)
            if ((group < 0 || group_[k] == group) &&
                distance2<D>(boxes_[k][0], boxes_[k][1], q) <= (1 + 1e-9) * best.point.distance2) // with room for round-off
                if (const FacetPoint<D> p = closest_on(facets_[k], q); p.distance2 < best.point.distance2)
                    best = {id_[k], p};
        if (node.count > 0)
            continue;
        const std::pair<double, int> left{bound_of(index + 1), index + 1}, right{bound_of(node.first), node.first};
        const bool left_first = left.first <= right.first;
        stack[top++] = left_first ? right : left;
        stack[top++] = left_first ? left : right;
    }
    return best;
}

template <int D>
bool FacetTree<D>::near(int node, int other, double margin) const
{
    const Node &a = nodes_[node], &b = nodes_[other];
    return ((a.low - b.high).array() <= margin).all() && ((b.low - a.high).array() <= margin).all();
}

template <int D>
void FacetTree<D>::for_near_pairs(double margin, const std::function<bool(int, int)>& visit) const
{
    const auto near_boxes = [&](const Facet<D>& f, const Facet<D>& g) {
        for (int i = 0; i < D; ++i) {
            const auto along = [i](const Facet<D>& facet) {
                double low = facet.corner[0][i], high = low;
                for (int k = 1; k < D; ++k) {
                    low = std::min(low, facet.corner[k][i]);
                    high = std::max(high, facet.corner[k][i]);
                }
                return std::pair(low, high);
            };
            const auto [f_low, f_high] = along(f);
            const auto [g_low, g_high] = along(g);
            if (f_low - g_high > margin || g_low - f_high > margin)
                return false;
        }
        return true;
    };
    std::vector<std::pair<int, int>> stack{{0, 0}};
    while (!stack.empty()) {
        const auto [a, b] = stack.back();
        stack.pop_back();
        const Node &m = nodes_[a], &n = nodes_[b];
        if (a != b && !near(a, b, margin))
            continue;
        if (m.count > 0 && n.count > 0) {
            for (int i = m.first; i < m.first + m.count; ++i)
                for (int k = a == b ? i + 1 : n.first; k < n.first + n.count; ++k)
                    if (near_boxes(facets_[i], facets_[k]) && !visit(id_[i], id_[k]))
                        return;
        } else if (a == b)
            stack.insert(stack.end(), {{a + 1, a + 1}, {m.first, m.first}, {a + 1, m.first}});
        else if (n.count > 0 || (m.count == 0 && (m.high - m.low).norm() >= (n.high - n.low).norm()))
            stack.insert(stack.end(), {{a + 1, b}, {m.first, b}});
        else
            stack.insert(stack.end(), {{a, b + 1}, {a, n.first}});
    }
}

template <int D>
int FacetTree<D>::crossings(const Vec<D>& start, const Vec<D>& direction) const
{
    int sum = 0, top = 0;
    std::array<int, 64> stack;
    stack[top++] = 0;
    while (top > 0) {
        const int index = stack[--top];
        const Node& node = nodes_[index];
        const Vec<D> low = (node.low - start).cwiseQuotient(direction), high = (node.high - start).cwiseQuotient(direction);
        if (std::max(0., low.cwiseMin(high).maxCoeff()) > low.cwiseMax(high).minCoeff() * (1 + 1e-12))
            continue;
        for (int k = node.first; k < node.first + node.count; ++k)
            if (meets(facets_[k], start, direction))
                sum += direction.dot(facets_[k].normal) > 0 ? 1 : -1;
        if (node.count == 0) {
            stack[top++] = index + 1;
            stack[top++] = node.first;
        }
    }
    return sum;
}

template <int D>
double FacetTree<D>::entry(const Vec<D>& start, const Vec<D>& direction, double tolerance) const
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double first = infinity;
    const auto reaches = [&](const Node& node) { // its box; infinity: not at all
        double in = 0, out = infinity;
        for (int i = 0; i < D; ++i) {
            const double low = node.low[i] - tolerance - start[i], high = node.high[i] + tolerance - start[i];
            if (direction[i] == 0) {
                if (low > 0 || high < 0)
                    return infinity;
                continue;
            }
            const double a = low / direction[i], b = high / direction[i];
            in = std::max(in, std::min(a, b));
            out = std::min(out, std::max(a, b));
        }
        return in <= out ? in : infinity;
    };
    const auto look = [&](const Facet<D>& facet) {
        const double against = direction.dot(facet.normal);
        if (!(against < 0))
            return;
        const double t = (facet.corner[0] - start).dot(facet.normal) / against;
        if (t < -tolerance || !(t < first))
            return;
        if (closest_on(facet, Vec<D>(start + t * direction)).distance2 <= tolerance * tolerance)
            first = std::max(t, 0.0);
    };
    std::array<std::pair<double, int>, 64> stack;
    int top = 0;
    stack[top++] = {reaches(nodes_[0]), 0};
    while (top > 0) {
        const auto [bound, index] = stack[--top];
        if (!(bound < first))
            continue;
        const Node& node = nodes_[index];
        for (int k = node.first; k < node.first + node.count; ++k)
            look(facets_[k]);
        if (node.count > 0)
            continue;
        const std::pair<double, int> left{reaches(nodes_[index + 1]), index + 1},
            right{reaches(nodes_[node.first]), node.first};
        const bool left_first = left.first <= right.first;
        stack[top++] = left_first ? right : left;
        stack[top++] = left_first ? left : right;
    }
    return first;
}

template FacetPoint<2> closest_on<2>(const Facet<2>&, const Vec<2>&);
template FacetPoint<3> closest_on<3>(const Facet<3>&, const Vec<3>&);
template class FacetTree<2>;
template class FacetTree<3>;

} // namespace gapflow
