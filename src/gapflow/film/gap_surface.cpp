// Base mesh of the gap's surface, its vertices and the points where edges leave the gap.
#include "gapflow/film/gap_surface.hpp"

#include "gapflow/core/disjoint_sets.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {
namespace {

constexpr double nudge_fraction = 1e-9;

/// Squared distance from x to a box.
template <int D>
double squared_distance(const Bounds<D>& box, const Vec<D>& x)
{
    return (box.low - x).cwiseMax(x - box.high).cwiseMax(0).squaredNorm();
}

// Elements of the base mesh, its vertices at x in the world, within reach of the other's bounds; and all elements' centres.
template <int D>
std::vector<int> elements_within_reach(const GapTest<D>& test, const SurfaceMesh<D>& base, const std::vector<Vec<D>>& x,
                                       std::vector<Vec<D>>& centre)
{
    const PlacedShape<D>&master = test.master, &other = test.other;
    const int n = int(base.elements.size());
    centre.resize(n);
    const Bounds<D> bounds = other.shape().bounds();
    const bool bounded = !other.shape().inside_out() && !other.shape().complement() && other.shape().planes().empty();
    std::vector<int> kept;
    for (int e = 0; e < n; ++e) {
        centre[e].setZero();
        for (int i : base.elements[e])
            centre[e] += x[i] / D;
        double square = 0;
        for (int i : base.elements[e])
            square = std::max(square, (x[i] - centre[e]).squaredNorm());
        const double radius = std::sqrt(square);
        const double sagitta = std::min(radius, std::abs(master.shape().curvature(base.patch[e])) * radius * radius);
        const double reach = test.options.threshold + radius + sagitta;
        if (!bounded || squared_distance<D>(bounds, other.to_body(centre[e])) < reach * reach)
            kept.push_back(e);
    }
    return kept;
}

} // namespace

template <int D>
FilmSurface<D>::FilmSurface(const GapTest<D>& test, const SurfaceMesh<D>& base)
    : test_(test), sizes_{}, other_planar_(!test.other.shape().planes().empty())
{
    const PlacedShape<D>& master = test_.master;
    const int n = int(base.elements.size());
    std::vector<Vec<D>> x(base.vertices.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = master.to_world(base.vertices[i]);

    std::vector<Vec<D>> centre;
    const std::vector<int> kept = elements_within_reach(test_, base, x, centre);

    // Corners of elements that share a vertex on a smooth junction become one vertex.
    DisjointSets corners(D * n);
    const auto corner = [&](int e, int vertex) {
        return D * e + int(std::find(base.elements[e].begin(), base.elements[e].end(), vertex) - base.elements[e].begin());
    };
    struct Crease {
        int element, a, b, across;
    };
    std::vector<Crease> creases;
    EdgeTable first;
    first.reset(2 * kept.size());
    for (int e : kept)
        for (int k = 0; k < D; ++k) {
            const int a = base.elements[e][k], b = D == 2 ? a : base.elements[e][(k + 1) % D];
            int& neighbour = first.insert(a, b);
            if (neighbour < 0) {
                neighbour = e;
                continue;
            }
            const int p = base.patch[neighbour], q = base.patch[e];
            const Vec<D> middle = 0.5 * (x[a] + x[b]);
            if (p == q || master.patch_normal(middle, p).dot(master.patch_normal(middle, q)) > smooth_cosine) {
                for (int v : {a, b})
                    corners.join(corner(e, v), corner(neighbour, v));
            } else {
                creases.push_back({neighbour, a, b, q});
                creases.push_back({e, a, b, p});
            }
        }

    std::vector<int> number(D * n, -1);
    for (int e : kept) {
        Element element{{}, base.patch[e]};
        for (int k = 0; k < D; ++k) {
            int& id = number[corners.find(D * e + k)];
            if (id < 0)
                id = add_vertex(x[base.elements[e][k]], Vec<D>::Zero(), base.patch[e], false, false);
            element.nodes[k] = id;
        }
        elements_.push_back(element);
    }
    for (const Crease& c : creases) {
        const int a = number[corners.find(corner(c.element, c.a))], b = number[corners.find(corner(c.element, c.b))];
        if (D == 3)
            creases_.insert(a, b) = c.across;
        for (int v : {a, b}) {
            vertices_[v].crease = vertices_[v].fixed = true;
            vertices_[v].nudge = nudge_fraction * (centre[c.element] - vertices_[v].x);
        }
    }
    for (Vertex& v : vertices_)
        if (v.crease) {
            v.p = test_.other.closest(v.x + v.nudge);
            look(v);
        }
    number_edges();
}

template <int D>
int FilmSurface<D>::add_vertex(const Vec<D>& x, const Vec<D>& nudge, int patch, bool crease, bool fixed)
{
    Vertex v{x, nudge, test_.other.closest(x + nudge), 0, patch, crease, fixed, {}};
    look(v);
    vertices_.push_back(v);
    return int(vertices_.size()) - 1;
}

/// Decides whether a vertex, its closest point known, is in the gap.
template <int D>
void FilmSurface<D>::look(Vertex& v) const
{
    const Vec<D> x = v.x + v.nudge;
    const Vec<D> n = test_.master.patch_normal(x, v.patch);
    v.facing = n.dot(v.p.normal);
    v.fails = test_.fails(x, n, v.p);
}

template <int D>
std::vector<int> FilmSurface<D>::other_patches() const
{
    std::vector<int> patches;
    for (const Vertex& v : vertices_)
        if (v.inside() && std::find(patches.begin(), patches.end(), v.p.patch) == patches.end())
            patches.push_back(v.p.patch);
    std::sort(patches.begin(), patches.end());
    return patches;
}

template <int D>
void FilmSurface<D>::restrict_to(const std::vector<int>& label)
{
    test_.label = label;
    for (Vertex& v : vertices_) {
        if (v.fails != RimEnd::thickness && v.fails != RimEnd::touching && v.fails != RimEnd::other_edge &&
            !test_.in_label(v.p.patch))
            v.fails = RimEnd::patch;
    }
}

template <int D>
void FilmSurface<D>::number_edges()
{
    edges_.clear();
    element_edges_.resize(elements_.size());
    edge_table_.reset(2 * elements_.size());
    for (std::size_t e = 0; e < elements_.size(); ++e)
        for (int k = 0; k < edges_per_element; ++k) {
            const int a = elements_[e].nodes[k], b = elements_[e].nodes[(k + 1) % D];
            int& id = edge_table_.insert(a, b);
            if (id < 0) {
                id = int(edges_.size());
                Edge edge{std::min(a, b), std::max(a, b), elements_[e].patch, -1, (vertices_[a].x - vertices_[b].x).norm()};
                const int across = across_crease(a, b);
                edge.crease = across >= -1;
                edge.second = std::max(across, -1);
                edges_.push_back(edge);
            } else if (edges_[id].patch != elements_[e].patch) {
                edges_[id].second = elements_[e].patch;
            }
            element_edges_[e][k] = id;
        }
}

template <int D>
int FilmSurface<D>::across_crease(int a, int b) const
{
    if (D == 2 || !vertices_[a].crease || !vertices_[b].crease)
        return -2;
    const int across = creases_.find(a, b);
    return across < 0 ? -2 : across;
}

template <int D>
auto FilmSurface<D>::crossing(const Edge& edge, int* index) -> const Crossing&
{
    int& id = crossing_table_.insert(edge.a, edge.b);
    if (id < 0) {
        id = int(crossings_.size());
        const bool forward = vertices_[edge.a].inside();
        const Vertex &in = vertices_[forward ? edge.a : edge.b], &out = vertices_[forward ? edge.b : edge.a];
        Crossing c{in.x, in.p, 0, *out.fails};
        // Bisection; where the thickness ends the gap, false position (Illinois) for h - h_c in two steps out of three, aimed a
        // little inside.
        const double precision = 1e-12 * test_.options.dx, tolerance = precision / edge.length;
        const auto excess = [&](const SurfacePoint<D>& p) { return p.distance - test_.options.threshold + 0.5 * precision; };
        double beyond = 1, below = excess(in.p), above = excess(out.p);
        int last_side = 0;
        for (int i = 0; i < 60 && beyond - c.fraction > tolerance; ++i) {
            double t = 0.5 * (c.fraction + beyond);
            if (c.end == RimEnd::thickness && i % 3 != 2 && below < 0 && above > 0)
                t = c.fraction + (beyond - c.fraction) * below / (below - above);
            const Vec<D> x = test_.onto(in.x + t * (out.x - in.x), edge.patch, edge.second);
            const Vec<D> z = x + in.nudge + t * (out.nudge - in.nudge);
            const SurfacePoint<D> p = test_.other.closest(z);
            if (const auto fails = test_.fails(z, test_.master.patch_normal(z, edge.patch), p)) {
                beyond = t;
                c.end = *fails;
                above = excess(p);
                below *= last_side > 0 ? 0.5 : 1.0;
                last_side = 1;
            } else {
                c.fraction = t;
                c.x = x;
                c.p = p;
                below = excess(p);
                above *= last_side < 0 ? 0.5 : 1.0;
                last_side = -1;
                if (c.end == RimEnd::thickness && below > -0.5 * precision)
                    break;
            }
        }
        crossings_.push_back(c);
    }
    if (index)
        *index = id;
    return crossings_[id];
}

template class FilmSurface<2>;
template class FilmSurface<3>;

} // namespace gapflow
