// Cutting the elements that straddle the gap's end.
//
// Where an edge leaves the gap close to one of its vertices, the vertex moves there: no slivers. Vertices on sharp edges of
// the master only slide along them. The other straddling edges get a new node at the crossing; a triangle keeps the polygon
// of its nodes in the gap, split along the shorter diagonal.
#include "gapflow/film/gap_cut.hpp"

#include <cmath>

namespace gapflow {
namespace {

constexpr double snap = 0.15;  ///< of an edge: a vertex this close to the crossing moves onto it
constexpr double touch = 1e-6; ///< of an edge: a vertex this close counts as on the crossing without moving

enum class Side : signed char { outside = -1, end = 0, inside = 1 };

template <int D>
struct Snap {
    int crossing = -1;
    double distance = snap;
    bool moves = false;
    Vec<D> x;
    SurfacePoint<D> p;
    RimEnd end;
};

template <int D>
double distance(const GapCut<D>& cut, int i, int j)
{
    return (cut.nodes[i].x - cut.nodes[j].x).norm();
}

/// For every vertex the crossing it moves to, if any.
template <int D>
std::vector<Snap<D>> find_snaps(FilmSurface<D>& surface)
{
    std::vector<Snap<D>> snaps(surface.vertices().size());
    for (const auto& edge : surface.edges()) {
        if (!surface.straddles(edge))
            continue;
        int id;
        const auto& c = surface.crossing(edge, &id);
        for (int v : {edge.a, edge.b}) {
            const auto& vertex = surface.vertices()[v];
            const double d = vertex.inside() ? c.fraction : 1 - c.fraction;
            const bool moves = !vertex.fixed && (!vertex.crease || edge.crease);
            if (d < snaps[v].distance * (1 - 1e-9) && (moves || d < touch))
                snaps[v] = {id, d, moves, c.x, c.p, c.end};
        }
    }
    return snaps;
}

} // namespace

template <int D>
GapCut<D> cut_at_end(FilmSurface<D>& surface)
{
    GapCut<D> cut;
    const auto& vertices = surface.vertices();
    const std::vector<Snap<D>> snaps = find_snaps(surface);
    std::vector<Side> side;
    cut.nodes.reserve(vertices.size());
    side.reserve(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto& v = vertices[i];
        const Snap<D>& s = snaps[i];
        side.push_back(s.crossing >= 0 ? Side::end : v.inside() ? Side::inside : Side::outside);
        cut.nodes.push_back({v.x, v.p, {}});
        if (s.crossing >= 0)
            cut.nodes.back() = {s.moves ? s.x : v.x, s.moves || !v.inside() ? s.p : v.p, s.end};
    }

    std::vector<int> node_of(surface.edges().size(), -1);
    for (std::size_t k = 0; k < surface.edges().size(); ++k) {
        const auto& edge = surface.edges()[k];
        if (edge.crease)
            cut.creases.insert(edge.a, edge.b) = 1;
        if (side[edge.a] == Side::end || side[edge.b] == Side::end || side[edge.a] == side[edge.b])
            continue;
        const auto& c = surface.crossing(edge);
        node_of[k] = int(cut.nodes.size());
        cut.nodes.push_back({c.x, c.p, c.end});
        if (edge.crease)
            cut.creases.insert(side[edge.a] == Side::inside ? edge.a : edge.b, node_of[k]) = 1;
    }

    const GapTest<D>& test = surface.test();
    for (int e = 0; e < int(surface.elements().size()); ++e) {
        const auto& element = surface.elements()[e];
        bool any_inside = false, any_outside = false;
        for (int v : element.nodes) {
            any_inside |= side[v] == Side::inside;
            any_outside |= side[v] == Side::outside;
        }
        if (!any_inside) {
            if (any_outside)
                continue;
            Vec<D> centre = Vec<D>::Zero();
            for (int v : element.nodes)
                centre += cut.nodes[v].x / D;
            const Vec<D> x = test.onto(centre, element.patch);
            if (test.fails(x, test.master.patch_normal(x, element.patch), test.other.closest(x)))
                continue;
        }
        if (!any_outside) {
            cut.elements.push_back(element);
            continue;
        }
        std::array<int, 2 * D> polygon;
        int n = 0;
        for (int k = 0; k < D; ++k) {
            if (side[element.nodes[k]] != Side::outside)
                polygon[n++] = element.nodes[k];
            if (k < FilmSurface<D>::edges_per_element && node_of[surface.edges_of(e)[k]] >= 0)
                polygon[n++] = node_of[surface.edges_of(e)[k]];
        }
        if constexpr (D == 2) {
            if (n == 2)
                cut.elements.push_back({{polygon[0], polygon[1]}, element.patch});
        } else if (n == 3) {
            cut.elements.push_back({{polygon[0], polygon[1], polygon[2]}, element.patch});
        } else if (n == 4) {
            const int turn = distance(cut, polygon[1], polygon[3]) < (1 - 1e-9) * distance(cut, polygon[0], polygon[2]);
            const auto at = [&](int k) { return polygon[(k + turn) % 4]; };
            cut.elements.push_back({{at(0), at(1), at(2)}, element.patch});
            cut.elements.push_back({{at(0), at(2), at(3)}, element.patch});
        }
    }
    return cut;
}

template GapCut<2> cut_at_end(FilmSurface<2>&);
template GapCut<3> cut_at_end(FilmSurface<3>&);

} // namespace gapflow
