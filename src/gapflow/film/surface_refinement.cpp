// Conforming refinement of the gap's surface by marked edges.
//
// An edge may not be longer than min(largest dx, curved sqrt(2 R h)), R along the edge, nor h change by more than a factor over it, nor an
// element that the gap's end cuts be longer than straddle dx, all down to smallest dx (method, "Mesh"); h may where solids at rest touch. Edges are
// marked; with any edge of a triangle its longest is marked (Rivara, Int. J. Numer. Methods Eng. 20 (1984) 745), and triangles
// with one, two or three marked edges are split alike from both sides of each edge, so the mesh stays conforming. Lengths
// equal to 1e-9 count as equal: the mesh does not depend on the orientation of the scene.
//
// Elements that cannot be in the gap are dropped between rounds: phi_B is 1-Lipschitz and every point of an element lies within 0.6
// of its longest edge of a vertex.
#include "gapflow/film/gap_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {
namespace {

constexpr double slack = 1 + 1e-7;
constexpr double at_lines =
    0.75; ///< of the size elsewhere: there all edges but those along the line are as long as they may be
constexpr double smallest_kink = 1. / 16; ///< of the straddling size: elements with a kink are not refined below

} // namespace

template <int D>
bool FilmSurface<D>::refine_coarsely(double scale)
{
    const FilmMeshOptions& o = test_.options;
    sizes_ = {scale * o.largest * o.dx, scale * o.largest_curved * o.dx, 0, 0, 0, 0, 0, 0};
    return run(true);
}

template <int D>
bool FilmSurface<D>::refine(double scale)
{
    const FilmMeshOptions& o = test_.options;
    sizes_ = {scale * o.largest * o.dx,  scale * o.largest_curved * o.dx, scale * o.smallest * o.dx,
              scale * o.straddle * o.dx, scale * o.straddle_open * o.dx,  scale * o.straddle_smooth * o.dx,
              scale * o.curved,          scale * o.smallest * o.dx};
    return run(false);
}

template <int D>
bool FilmSurface<D>::run(bool coarse)
{
    drop_unreachable();
    for (int round = 0; round < 200; ++round) {
        number_edges();
        measure(coarse);
        // A line along which solids at rest touch lets no fluid through, and next to none along it: elements there need be no finer than others at the film's end. As fine as the gap
        // is thin at its tip, a wedge of 20 cells' length has 10 000 nodes.
        if (D == 3 && !coarse &&
            std::any_of(vertices_.begin(), vertices_.end(), [](const Vertex& v) { return v.fails == RimEnd::touching; }))
            sizes_.varying = std::max(sizes_.smallest, sizes_.straddle);
        if (!mark_edges(coarse) && (coarse || !mark_at_end()))
            break;
        close_marks();
        split_marked();
        drop_unreachable();
        if (int(vertices_.size()) > test_.options.node_cap) {
            const auto inside = std::count_if(vertices_.begin(), vertices_.end(), [](const Vertex& v) { return v.inside(); });
            if (inside > test_.options.node_cap || int(vertices_.size()) / 8 > test_.options.node_cap) {
                number_edges();
                return false;
            }
        }
    }
    return true;
}

/// Whether h changes by more than the largest ratio.
template <int D>
bool FilmSurface<D>::varies(double h0, double h1) const
{
    return std::max(h0, h1) > slack * test_.options.ratio * std::min(h0, h1);
}

/// Whether the gap ends between curved surfaces at a vertex that is not in it, not at an edge of either.
template <int D>
bool FilmSurface<D>::goes_out_smoothly(const Vertex& v, int patch) const
{
    return (v.fails == RimEnd::thickness || v.fails == RimEnd::normals || v.fails == RimEnd::third_body) &&
           test_.curvature(patch, v.p.patch) > 0;
}

/// Size of elements that the gap's end cuts; `v`: their vertex that is not in it.
template <int D>
double FilmSurface<D>::size_at_end(const Vertex& v, int patch) const
{
    if (goes_out_smoothly(v, patch))
        return sizes_.straddle_smooth;
    return v.fails == RimEnd::thickness || v.fails == RimEnd::other_edge ? sizes_.straddle_open : sizes_.straddle;
}

template <int D>
bool FilmSurface<D>::too_long(const Edge& edge, bool coarse) const
{
    const double length = edge.length;
    const Vertex &a = vertices_[edge.a], &b = vertices_[edge.b];
    const bool curved = length > slack * sizes_.largest && test_.curvature(edge.patch, a.p.patch) > 0 &&
                        test_.curvature(edge.patch, b.p.patch) > 0;
    if (length > slack * (curved ? sizes_.largest_curved : sizes_.largest))
        return true;
    if (coarse || !(a.inside() || b.inside()))
        return false;
    if (a.inside() != b.inside() && length > slack * size_at_end(a.inside() ? b : a, edge.patch))
        return true;
    if (edge.extent <= slack * sizes_.smallest)
        return false;
    if (a.inside() && b.inside() && edge.extent > slack * sizes_.varying && varies(test_.thickness(a.p), test_.thickness(b.p)))
        return true;
    // the flat end of a round body is a polygon as fine as other ends of the film
    if (edge.crease && edge.second >= 0 && length > slack * sizes_.straddle &&
        test_.master.shape().curvature(edge.patch) == 0 && test_.master.shape().curvature(edge.second) != 0)
        return true;
    return length > slack * edge.lateral;
}

/// Sets what depends on the direction of edges: the gap between a cylinder and a plane asks for small elements across the line of contact alone.
template <int D>
void FilmSurface<D>::measure(bool coarse)
{
    for (Edge& edge : edges_) {
        edge.extent = edge.length;
        if (coarse)
            continue;
        const Vertex &a = vertices_[edge.a], &b = vertices_[edge.b];
        const std::array x{a.x, b.x}, y{a.p.x, b.p.x};
        double largest = 0, along = 0, h = test_.options.threshold;
        for (const Vertex* v : {&a, &b})
            if (v->inside()) {
                for (int patch : {edge.patch, edge.crease ? -1 : edge.second})
                    if (patch >= 0) {
                        largest = std::max(largest, test_.curvature(patch, v->p.patch));
                        along = std::max(along, test_.curvature_along(patch, v->p.patch, x, y));
                    }
                // where bodies overlap the thickness is constant (the floor): the distance to the overlap's edge varies
                h = std::min(h, std::max(std::abs(v->p.distance), test_.options.floor));
            }
        const auto allowed = [&](double curvature) {
            return curvature > 0 ? std::max(sizes_.smallest, sizes_.curved * std::sqrt(2 * h / curvature))
                                 : sizes_.largest_curved;
        };
        const double across = allowed(largest);
        if (slack * along < largest) { // r: the part of the length that counts
            const double r = std::sqrt(along / largest);
            edge.lateral = at_lines * across / r;
            edge.extent *= std::max(r, std::min(across / sizes_.largest_curved, 1.0));
        } else {
            edge.lateral = along > 0 ? allowed(along) : std::numeric_limits<double>::infinity();
            if (along > largest)
                edge.extent *= std::min(across, sizes_.largest_curved) / std::min(edge.lateral, sizes_.largest_curved);
        }
    }
}

template <int D>
bool FilmSurface<D>::mark_edges(bool coarse)
{
    bool any = false;
    for (Edge& edge : edges_)
        any |= edge.marked = too_long(edge, coarse);
    if (coarse)
        return any;
    // elements that may contain a piece of the gap but no vertex in it
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const auto& nodes = elements_[e].nodes;
        if (std::any_of(nodes.begin(), nodes.end(), [&](int v) { return vertices_[v].inside(); }))
            continue;
        Edge& edge = edges_[longest_edge(int(e))];
        const bool smooth =
            std::all_of(nodes.begin(), nodes.end(), [&](int v) { return goes_out_smoothly(vertices_[v], elements_[e].patch); });
        if (edge.length > slack * (smooth ? sizes_.straddle_smooth : sizes_.straddle))
            any = edge.marked = true;
    }
    return any;
}

/// Marks the edges that the cut at the gap's end requires: h up to the end within the largest ratio, straight cuts.
template <int D>
bool FilmSurface<D>::mark_at_end()
{
    bool any = false;
    for (Edge& edge : edges_)
        if (edge.extent > slack * sizes_.varying && straddles(edge)) {
            const Vertex& in = vertices_[vertices_[edge.a].inside() ? edge.a : edge.b];
            if (varies(test_.thickness(in.p), test_.thickness(crossing(edge).p)))
                any = edge.marked = true;
        }
    if (D == 3)
        for (int e = 0; e < int(elements_.size()); ++e)
            if (!straight(e)) {
                edges_[longest_edge(e)].marked = true;
                any = true;
            }
    return any;
}

/// Whether the gap's end cuts the element in a straight line (or the element is as small as it may be).
template <int D>
bool FilmSurface<D>::straight(int e)
{
    if constexpr (D == 3) {
        const double length = edges_[longest_edge(e)].length;
        if (length <= slack * smallest_kink * sizes_.straddle)
            return true;
        int found = 0;
        std::array<Vec<3>, 3> cut;
        for (int id : element_edges_[e])
            if (straddles(edges_[id]))
                cut[found++] = crossing(edges_[id]).x;
        if (found < 2)
            return true;
        const Vec<3> along = cut[1] - cut[0];
        if (along.norm() < 0.02 * length)
            return true;
        const auto& nodes = elements_[e].nodes;
        const Vec<3> x0 = vertices_[nodes[0]].x;
        Vec<3> across = along.cross((vertices_[nodes[1]].x - x0).cross(vertices_[nodes[2]].x - x0)).normalized();
        const Vec<3> middle = 0.5 * (cut[0] + cut[1]);
        for (int i : nodes) // towards the outside
            if (vertices_[i].inside() != (across.dot(vertices_[i].x - middle) < 0)) {
                across = -across;
                break;
            }
        const auto inside = [&](double step) {
            const Vec<3> x = test_.onto(middle + step * across, elements_[e].patch);
            return !test_.fails(x, test_.master.patch_normal(x, elements_[e].patch), test_.other.closest(x));
        };
        const double step = test_.options.kink * along.norm();
        return inside(-step) && !inside(step);
    }
    return true;
}

template <int D>
int FilmSurface<D>::longest_edge(int e) const
{
    const auto& ids = element_edges_[e];
    int best = ids[0];
    for (int k = 1; k < edges_per_element; ++k) {
        const Edge &edge = edges_[ids[k]], &old = edges_[best];
        const double difference = edge.extent - old.extent;
        const bool tie = std::abs(difference) <= 1e-9 * old.extent;
        if (tie ? std::pair(edge.a, edge.b) < std::pair(old.a, old.b) : difference > 0)
            best = ids[k];
    }
    return best;
}

/// Marks the longest edge of every element with a marked edge.
template <int D>
void FilmSurface<D>::close_marks()
{
    if (D == 2)
        return;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t e = 0; e < elements_.size(); ++e) {
            const auto& ids = element_edges_[e];
            if (std::none_of(ids.begin(), ids.end(), [&](int id) { return edges_[id].marked; }))
                continue;
            Edge& longest = edges_[longest_edge(int(e))];
            changed |= !longest.marked;
            longest.marked = true;
        }
    }
}

template <int D>
void FilmSurface<D>::split_edge(Edge& edge, const Vec<D>& interior)
{
    const Vec<D> x = test_.onto(0.5 * (vertices_[edge.a].x + vertices_[edge.b].x), edge.patch, edge.second);
    const Vec<D> nudge = edge.crease ? Vec<D>(1e-9 * (interior - x)) : Vec<D>(Vec<D>::Zero());
    edge.middle = add_vertex(x, nudge, edge.patch, edge.crease, false);
    if (edge.crease)
        for (int end : {edge.a, edge.b})
            creases_.insert(end, edge.middle) = edge.second;
}

template <int D>
void FilmSurface<D>::split_marked()
{
    const int n = int(elements_.size());
    for (int e = 0; e < n; ++e)
        for (int id : element_edges_[e])
            if (Edge& edge = edges_[id]; edge.marked && edge.middle < 0) {
                Vec<D> centre = Vec<D>::Zero();
                for (int v : elements_[e].nodes)
                    centre += vertices_[v].x / D;
                split_edge(edge, centre);
            }
    std::vector<Element> children;
    children.reserve(2 * n);
    for (int e = 0; e < n; ++e) {
        const Element& old = elements_[e];
        const auto& ids = element_edges_[e];
        const auto add = [&](const std::array<int, D>& nodes) { children.push_back({nodes, old.patch}); };
        const int longest = longest_edge(e);
        const int m = edges_[longest].middle;
        if (m < 0) {
            children.push_back(old);
        } else if constexpr (D == 2) {
            add({old.nodes[0], m});
            add({m, old.nodes[1]});
        } else {
            const int k = int(std::find(ids.begin(), ids.end(), longest) - ids.begin());
            const int a = old.nodes[k], b = old.nodes[(k + 1) % 3], c = old.nodes[(k + 2) % 3];
            const Edge &bc = edges_[ids[(k + 1) % 3]], &ca = edges_[ids[(k + 2) % 3]];
            const double squares = bc.extent * bc.extent + ca.extent * ca.extent;
            const double square = edges_[longest].extent * edges_[longest].extent;
            if (bc.middle >= 0 && ca.middle >= 0 && square < (1 - 1e-9) * squares) { // acute: four similar triangles
                add({a, m, ca.middle});
                add({m, b, bc.middle});
                add({ca.middle, bc.middle, c});
                add({m, bc.middle, ca.middle});
                continue;
            }
            if (ca.middle >= 0) {
                add({a, m, ca.middle});
                add({m, c, ca.middle});
            } else {
                add({a, m, c});
            }
            if (bc.middle >= 0) {
                add({m, b, bc.middle});
                add({m, bc.middle, c});
            } else {
                add({m, b, c});
            }
        }
    }
    elements_.swap(children);
}

/// Whether an element can be dropped.
template <int D>
bool FilmSurface<D>::out_of_reach(int e) const
{
    const Element& element = elements_[e];
    const double kappa_master = test_.master.shape().curvature(element.patch);
    const Vertex& first = vertices_[element.nodes[0]];
    const int patch = first.p.patch;
    bool one_face = true, gap_ends_nearby = false;
    double kappa_other = 0, length = 0, nearest = first.p.distance, furthest = nearest, facing = first.facing;
    for (int k = 0; k < D; ++k) {
        const Vertex& v = vertices_[element.nodes[k]];
        if (v.inside())
            return false;
        one_face &= v.p.feature == Feature::face && v.p.patch == patch;
        gap_ends_nearby |= v.fails == RimEnd::thickness || v.fails == RimEnd::normals;
        if (k == 0 || v.p.patch != vertices_[element.nodes[k - 1]].p.patch) {
            const double kappa = test_.other.shape().curvature(v.p.patch);
            kappa_other = k == 0 || std::abs(kappa) > std::abs(kappa_other) ? kappa : kappa_other;
        }
        nearest = std::min(nearest, v.p.distance);
        furthest = std::max(furthest, v.p.distance);
        facing = std::min(facing, v.facing);
        length = std::max(length, (v.x - vertices_[element.nodes[(k + 1) % D]].x).norm());
    }
    const bool small = length <= slack * (kappa_master + kappa_other > 0 ? sizes_.largest_curved : sizes_.largest);
    const double threshold = test_.options.threshold;
    const bool linear = one_face && kappa_master == 0 && kappa_other == 0 && (other_planar_ || small); // h
    if (test_.options.touching && furthest + (linear ? 0.0 : 0.6 * length) <= *test_.options.touching)
        return true;
    if (linear)
        return nearest >= threshold || facing >= facing_cosine || small;
    // Curvatures over the largest size are those of facets' edges: the normal may change abruptly.
    if (!small)
        return nearest >= threshold + 0.6 * length + std::min(0.25 * std::abs(kappa_master) * length, 0.5) * length;
    const double bend = 0.25 * length * length;
    const double lowest =
        nearest - (one_face ? bend * std::max(0.0, kappa_master + kappa_other) : 0.6 * length + bend * std::abs(kappa_master));
    const double turn = 0.3 + (std::abs(kappa_master) + std::abs(kappa_other)) * length;
    return !gap_ends_nearby || lowest >= threshold || facing >= facing_cosine + turn;
}

template <int D>
void FilmSurface<D>::drop_unreachable()
{
    std::vector<Element> kept;
    kept.reserve(elements_.size());
    for (std::size_t e = 0; e < elements_.size(); ++e)
        if (!out_of_reach(int(e)))
            kept.push_back(elements_[e]);
    elements_.swap(kept);
}

template class FilmSurface<2>;
template class FilmSurface<3>;

} // namespace gapflow
