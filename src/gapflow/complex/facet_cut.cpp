// Everything follows from three predicates, which are exact in integers and, by the shift of the grid planes, never 0: the side of
// a vertex of a plane; the side of an edge of a grid line, by the edge's place in a plane that contains the line; and the side of a
// facet's plane on which a grid vertex lies, which tells in what order a segment passes the grid lines next to it. As these
// are those of one surface and one grid, what is found in the planes of one axis fits what is found in those of another.
//
// The section of the surface by a grid plane (2D: the surface itself) is a set of closed ways, one segment a facet, whose corners
// are edges of the surface (2D: vertices). Each is walked once, from facet to facet, with the fluid at its left, and split into
// chains where it passes grid lines. Segments are convex, so a walk within a facet only goes up or down in u and in v. Passing the
// line u = const is a crossing of the facet with the grid line along v. In 3D each crossing is met in two planes and noted in one
// of them. Then crossings are sorted along the lines and made into covers, with winding numbers from one corner of the box on, and
// the ends of chains take the places of their crossings.
//
// Of a facet with a vertex A and the normal n, not of unit length, F(X) = n . (X - A). It crosses the grid line through X along
// axis a at the distance -F(X) / n_a from X. Of an edge from A to B, with R = B - A, the place at which it passes the plane
// x_d = p is off the plane x_w = q by ((A_w - q) R_d + (p - A_d) R_w) / R_d. Numerators are exact and rounded once.
//
// Places on a grid edge that differ by less than round-off may come in any order: winding numbers of 0 and 1 by turns tell the right
// one, and the places are made to increase.
#include "gapflow/complex/facet_cut.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>
#include <utility>

namespace gapflow {
namespace {

__extension__ typedef __int128 Wide;

constexpr int low_bits = 53; // of a place's difference, less its sign

template <class T>
int sign_of(T x)
{
    return (x > 0) - (x < 0);
}

/// An integer place, of magnitude below 2^52.
template <int D>
using Place = std::array<std::int64_t, D>;

/// The plane (2D: the line) of a facet.
template <int D>
class FacetPlane {
public:
    explicit FacetPlane(const std::array<const Place<D>*, D>& corners) : from_(*corners[0])
    {
        const Place<D>& a = *corners[0];
        const Place<D>& b = *corners[1];
        if constexpr (D == 2) {
            normal_ = {b[1] - a[1], a[0] - b[0]};
        } else {
            const Place<D>& c = *corners[2];
            for (int k = 0; k < 3; ++k) {
                const int u = (k + 1) % 3, v = (k + 2) % 3;
                normal_[k] = Wide(b[u] - a[u]) * (c[v] - a[v]) - Wide(b[v] - a[v]) * (c[u] - a[u]);
            }
        }
    }

    /// Of the normal's component: positive out of the solid.
    int sign(int axis) const { return sign_of(normal_[axis]); }
    /// Positive: the grid vertex lies in front of the facet, in the fluid.
    int side(const Place<D>& vertex) const
    {
        const Value f = value(vertex);
        if (f.high != 0 || f.low != 0)
            return f.high < 0 ? -1 : 1;
        for (int k = 0; k < D; ++k)
            if (normal_[k] != 0)
                return sign(k);
        return 0;
    }
    /// How far above the grid vertex it crosses the grid line along `axis`.
    double crossing(const Place<D>& vertex, int axis) const
    {
        const Value f = value(vertex);
        return -(double(f.high) * double(std::int64_t(1) << low_bits) + double(f.low)) / double(normal_[axis]);
    }

    // F is high 2^low_bits + low, 0 <= low < 2^low_bits; 3D: of 162 bits.
    struct Value {
        Wide high;
        std::int64_t low;
    };
    void add_value(const Place<D>& x, Value& sum) const
    {
        const Value f = value(x);
        const std::int64_t low = sum.low + f.low;
        sum.high += f.high + (low >> low_bits);
        sum.low = low & low_mask;
    }
    /// Length of the normal, 3D twice the facet's area.
    double area() const
    {
        double square = 0;
        for (const Wide n : normal_)
            square += double(n) * double(n);
        return std::sqrt(square);
    }

private:
    static constexpr std::int64_t low_mask = (std::int64_t(1) << low_bits) - 1;

    Value value(const Place<D>& x) const
    {
        Wide high = 0, low = 0;
        for (int k = 0; k < D; ++k) {
            const std::int64_t w = x[k] - from_[k];
            high += Wide(std::int64_t(normal_[k] >> low_bits)) * w;
            low += Wide(std::int64_t(normal_[k] & low_mask)) * w;
        }
        return {high + (low >> low_bits), std::int64_t(low & low_mask)};
    }

    Place<D> from_;
    std::array<Wide, D> normal_;
};

/// Sorts items by key in 0 .. count - 1, in time proportional to both; returns where each key's items start, and the end.
template <class Item, class Key>
std::vector<int> sort_by_key(std::vector<Item>& items, int count, Key&& key)
{
    std::vector<int> starts(count + 1, 0);
    for (const Item& item : items)
        ++starts[key(item) + 1];
    for (int i = 0; i < count; ++i)
        starts[i + 1] += starts[i];
    std::vector<int> next(starts.begin(), starts.end() - 1);
    std::vector<Item> sorted(items.size());
    for (const Item& item : items)
        sorted[next[key(item)]++] = item;
    items = std::move(sorted);
    return starts;
}

} // namespace

template <int D>
std::vector<std::array<int, D>> facet_links(int vertex_count, std::span<const std::array<int, D>> elements)
{
    struct Border {
        int vertex; // 3D: the lower one of the edge
        int other;  // 3D: the higher one
        bool back;  // 3D: goes from the higher to the lower one; 2D: is the element's second one
        int facet, k;
    };
    std::vector<Border> borders;
    borders.reserve(D * elements.size());
    std::vector<std::array<int, D>> links(elements.size());
    for (int facet = 0; facet < int(elements.size()); ++facet) {
        links[facet].fill(facet);
        for (int k = 0; k < D; ++k) {
            const int a = elements[facet][k], b = elements[facet][(k + 1) % D];
            if constexpr (D == 2)
                borders.push_back({a, 0, k == 1, facet, k});
            else if (a != b)
                borders.push_back({std::min(a, b), std::max(a, b), a > b, facet, k});
        }
    }
    const std::vector<int> starts = sort_by_key(borders, vertex_count, [](const Border& b) { return b.vertex; });
    for (int vertex = 0; vertex < vertex_count; ++vertex) {
        const auto begin = borders.begin() + starts[vertex], end = borders.begin() + starts[vertex + 1];
        std::sort(begin, end, [](const Border& a, const Border& b) {
            return std::tie(a.other, a.back, a.facet, a.k) < std::tie(b.other, b.back, b.facet, b.k);
        });
        // Those of one edge: first all that go one way, then as many that go the other.
        for (auto group = begin; group != end;) {
            const auto next = std::find_if(group, end, [&](const Border& b) { return b.other != group->other; });
            const auto half = (next - group) / 2;
            assert(next - group == 2 * half);
            for (auto here = group, there = group + half; there != next; ++here, ++there) {
                assert(!here->back && there->back);
                links[here->facet][here->k] = there->facet;
                links[there->facet][there->k] = here->facet;
            }
            group = next;
        }
    }
    return links;
}

template <int D>
class FacetCut<D>::Maker {
public:
    Maker(FacetCut& cut, std::span<const Vec<D>> vertices, std::span<const std::array<int, D>> elements,
          std::span<const std::array<int, D>> links)
        : cut_(cut), elements_(elements), links_(links)
    {
        place_vertices(vertices);
        find_near_facets();
        for (int axis = D == 2 ? 2 : 0; axis < 3; ++axis)
            walk_planes(axis);
        for (int axis = 0; axis < D; ++axis)
            sort_crossings(axis);
        find_windings();
        for (int axis = 0; axis < D; ++axis)
            make_covers(axis);
        sort_chains();
        place_chain_ends();
    }

private:
    struct Vertex {
        Place<D> x;
        Index<D> cell; // number of planes below, less one
    };
    // Where a section passes from a facet to the next.
    struct Node {
        int u, v;     // the square
        Vec<2> point; // from the square's low vertex; only of squares in the box
    };
    struct Crossing {
        int line, cell, facet;
        int step; // change of the winding number along the line
        double place;
    };
    struct Chain {
        int key, u; // row of faces, of all axes; and the face's index along u
        int facet;  // the first one
        FaceChains::Record record;
    };
    static constexpr double round_off = 1e-6; // of crossings with facets at small angles, generously
    static constexpr int not_yet = -2;        // edge on which a chain begins that is met amid its way

    void place_vertices(std::span<const Vec<D>> vertices)
    {
        vertices_.resize(vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i)
            for (int axis = 0; axis < D; ++axis) {
                const std::int64_t x = std::llrint(vertices[i][axis] / place_unit);
                assert(std::abs(x) < std::int64_t(1) << 52);
                const std::vector<std::int64_t>& p = cut_.places_[axis];
                // Equal distances make the first guess right.
                const double guess = std::floor(double(x - p.front()) * (double(p.size() - 1) / double(p.back() - p.front())));
                int cell = int(std::clamp(guess, -1., double(p.size() - 1)));
                if ((cell >= 0 && p[cell] >= x) || (cell + 1 < int(p.size()) && p[cell + 1] < x))
                    cell = int(std::lower_bound(p.begin(), p.end(), x) - p.begin()) - 1;
                vertices_[i].x[axis] = x;
                vertices_[i].cell[axis] = cell;
            }
    }

    const Vertex& corner(int facet, int k) const { return vertices_[elements_[facet][k]]; }

    FacetPlane<D> plane_of(int facet) const
    {
        std::array<const Place<D>*, D> corners;
        for (int k = 0; k < D; ++k)
            corners[k] = &corner(facet, k).x;
        return FacetPlane<D>(corners);
    }

    Place<D> place_of(const Index<D>& vertex) const
    {
        Place<D> x;
        for (int axis = 0; axis < D; ++axis)
            x[axis] = cut_.places_[axis][vertex[axis]];
        return x;
    }

    // Marks facets whose bounds meet the box, and adds up the winding number at the box's first vertex: of the facets that cross the
    // line from there towards low x.
    void find_near_facets()
    {
        near_.resize(elements_.size());
        typename FacetPlane<D>::Value volume{0, 0}; // less than 0 by D! times the solid's
        double area = 0;                            // times (D - 1)!
        int winding = 0;
        for (int facet = 0; facet < int(elements_.size()); ++facet) {
            Index<D> low = corner(facet, 0).cell, high = low;
            for (int k = 1; k < D; ++k) {
                low = low.cwiseMin(corner(facet, k).cell);
                high = high.cwiseMax(corner(facet, k).cell);
            }
            near_[facet] = (high.array() >= 0).all() && (low.array() <= cut_.count_.array() - 2).all();
            if (low[0] < 0 && (low.template tail<D - 1>().array() < 0).all() &&
                (high.template tail<D - 1>().array() >= 0).all())
                winding += step_below_corner(facet);
            const FacetPlane<D> plane = plane_of(facet);
            plane.add_value(corner(0, 0).x, volume);
            area += plane.area();
        }
        // Rounding alone turns over what is thinner than it.
        const bool inside_out = -double(volume.high) * double(std::int64_t(1) << low_bits) < -D * area;
        corner_winding_ = winding + inside_out;
    }

    // What a facet adds to the winding number on the way along the first line of axis 0 to the box's first vertex.
    int step_below_corner(int facet)
    {
        const FacetPlane<D> plane = plane_of(facet);
        if constexpr (D == 3) {
            choose_axis(1); // u = 2
            plane_index_ = 0;
            if ((node(facet, entry(facet)).u < 0) == (node(facet, exit(facet)).u < 0))
                return 0;
        }
        return plane.side(place_of(Index<D>::Zero())) == plane.sign(0) ? -plane.sign(0) : 0;
    }

    void choose_axis(int axis)
    {
        axis_ = axis;
        u_ = (axis + 1) % 3;
        v_ = (axis + 2) % 3;
    }

    // The sections by all planes of an axis (2D: the surface).
    void walk_planes(int axis)
    {
        choose_axis(axis);
        // Of each facet, where the marks of its planes start, and its first plane.
        std::vector<int> starts(elements_.size() + 1, 0), first_planes(elements_.size(), 0);
        for (int facet = 0; facet < int(elements_.size()); ++facet) {
            int count = 0;
            if (near_[facet]) {
                if constexpr (D == 2) {
                    count = 1;
                } else {
                    const auto [low, high] =
                        std::minmax({corner(facet, 0).cell[axis], corner(facet, 1).cell[axis], corner(facet, 2).cell[axis]});
                    first_planes[facet] = low + 1;
                    count = high - low;
                }
            }
            starts[facet + 1] = starts[facet] + count;
        }
        std::vector<std::uint8_t> passed(starts.back(), 0);
        const auto mark = [&](int facet) { passed[starts[facet] + plane_index_ - first_planes[facet]] = 1; };
        for (int facet = 0; facet < int(elements_.size()); ++facet)
            for (int i = starts[facet]; i < starts[facet + 1]; ++i)
                if (!passed[i]) {
                    plane_index_ = first_planes[facet] + i - starts[facet];
                    walk(facet, mark);
                }
    }

    // The whole way through a facet, or as much of it as lies in near facets: nothing else of it lies in the box.
    template <class Mark>
    void walk(int start, Mark&& mark)
    {
        begin_chain(not_yet, node(start, entry(start)));
        if (walk_on(start, start, mark)) {
            join_head();
            return;
        }
        assert(!inside_);
        int first = start;
        for (int facet; (facet = links_[first][entry(first)]), near_[facet];)
            first = facet;
        if (first == start)
            return;
        begin_chain(not_yet, node(first, entry(first)));
        assert(!inside_);
        walk_on(first, start, mark);
        join_head();
    }

    // From the entry of a facet to that of another one; false: the way leaves the near facets before.
    template <class Mark>
    bool walk_on(int facet, int end, Mark&& mark)
    {
        Node at = node(facet, entry(facet));
        do {
            mark(facet);
            at = pass(facet, at);
            facet = links_[facet][exit(facet)];
            if (!near_[facet])
                return false;
        } while (facet != end);
        return true;
    }

    // The border of a facet at which its section begins and ends, with the fluid at the left. 3D: the edges of the facet that go up
    // and down through the plane.
    int entry(int facet) const
    {
        if constexpr (D == 2)
            return 1;
        else
            return border(facet, true);
    }
    int exit(int facet) const
    {
        if constexpr (D == 2)
            return 0;
        else
            return border(facet, false);
    }
    int border(int facet, bool up) const
    {
        std::array<bool, 3> above;
        for (int k = 0; k < 3; ++k)
            above[k] = corner(facet, k).cell[axis_] >= plane_index_;
        for (int k = 0; k < 2; ++k)
            if (above[k] != up && above[k + 1] == up)
                return k;
        return 2;
    }

    Node node(int facet, int k) const
    {
        Node n{0, 0, Vec<2>::Zero()};
        if constexpr (D == 2) {
            const Vertex& a = corner(facet, k);
            n.u = a.cell[0];
            n.v = a.cell[1];
            if (in_box(n.u, n.v))
                for (int w = 0; w < 2; ++w)
                    n.point[w] = place_unit * double(a.x[w] - cut_.places_[w][a.cell[w]]);
        } else {
            const Vertex &a = corner(facet, k), &b = corner(facet, (k + 1) % 3);
            n.u = node_cell(a, b, u_);
            n.v = node_cell(a, b, v_);
            if (in_box(n.u, n.v)) {
                n.point[0] = node_place(a, b, u_, n.u);
                n.point[1] = node_place(a, b, v_, n.v);
            }
        }
        return n;
    }

    // Where the edge from a to b passes the plane, off the plane `index` of axis w, times the edge's rise.
    Wide off_plane(const Vertex& a, const Vertex& b, int w, int index) const
    {
        return Wide(a.x[w] - cut_.places_[w][index]) * (b.x[axis_] - a.x[axis_]) +
               Wide(cut_.places_[axis_][plane_index_] - a.x[axis_]) * (b.x[w] - a.x[w]);
    }
    // Number of planes of axis w below that place, less one.
    int node_cell(const Vertex& a, const Vertex& b, int w) const
    {
        int low = std::min(a.cell[w], b.cell[w]), high = std::max(a.cell[w], b.cell[w]); // planes low + 1 .. high may be below
        const int rise = sign_of(b.x[axis_] - a.x[axis_]);
        while (low < high) {
            const int middle = low + (high - low + 1) / 2;
            int side = sign_of(off_plane(a, b, w, middle)) * rise;
            if (side == 0 && axis_ < w) // the plane's own shift takes the place along the edge, by more than the other's
                side = sign_of(b.x[w] - a.x[w]) * rise;
            if (side > 0)
                low = middle;
            else
                high = middle - 1;
        }
        return low;
    }
    double node_place(const Vertex& a, const Vertex& b, int w, int cell) const
    {
        const double place = place_unit * (double(off_plane(a, b, w, cell)) / double(b.x[axis_] - a.x[axis_]));
        return std::clamp(place, 0., length(w, cell));
    }

    bool in_box(int u, int v) const { return u >= 0 && v >= 0 && u < cut_.count_[u_] - 1 && v < cut_.count_[v_] - 1; }
    double length(int axis, int cell) const { return cut_.lengths_[axis][cell].to; }

    Index<D> grid_vertex(int u, int v) const
    {
        Index<D> i;
        if constexpr (D == 3)
            i[axis_] = plane_index_;
        i[u_] = u;
        i[v_] = v;
        return i;
    }

    // Goes through a facet's segment from its node; returns the node at its end.
    Node pass(int facet, const Node& from)
    {
        const Node to = node(facet, exit(facet));
        add_point(from.point, facet);
        int u = from.u, v = from.v;
        if (u == to.u && v == to.v)
            return to;
        const FacetPlane<D> plane = plane_of(facet);
        const bool up_u = to.u > u, up_v = to.v > v;
        while (u != to.u || v != to.v) {
            const int next_u = u + up_u, next_v = v + up_v; // the lines ahead
            bool along_u = u != to.u;
            if (u != to.u && v != to.v) {
                const bool left = plane.side(place_of(grid_vertex(next_u, next_v))) > 0; // of the way lies the vertex ahead
                along_u = left == (up_u == up_v);
            }
            if (along_u) {
                note_crossing(plane, facet, v_, grid_vertex(next_u, v));
                end_chain(up_u ? 1 : 3, u, v);
                u += up_u ? 1 : -1;
                begin_chain(up_u ? 3 : 1, {u, v, Vec<2>::Zero()});
            } else {
                if constexpr (D == 2)
                    note_crossing(plane, facet, u_, grid_vertex(u, next_v));
                end_chain(up_v ? 2 : 0, u, v);
                v += up_v ? 1 : -1;
                begin_chain(up_v ? 0 : 2, {u, v, Vec<2>::Zero()});
            }
            add_point(Vec<2>::Zero(), facet);
        }
        return to;
    }

    void note_crossing(const FacetPlane<D>& plane, int facet, int axis, const Index<D>& edge)
    {
        if (edge[axis] < 0 || edge[axis] >= cut_.count_[axis] - 1)
            return;
        const double place = place_unit * plane.crossing(place_of(edge), axis);
        crossings_[axis].push_back(
            {cut_.line(axis, edge), edge[axis], facet, -plane.sign(axis), std::clamp(place, 0., length(axis, edge[axis]))});
    }

    void begin_chain(int edge, const Node& at)
    {
        inside_ = in_box(at.u, at.v);
        first_edge_ = edge;
        first_point_ = int(cut_.points_.size());
    }
    void add_point(const Vec<2>& point, int facet)
    {
        if (!inside_)
            return;
        cut_.points_.push_back(point);
        cut_.facets_.push_back(facet);
    }
    void end_chain(int edge, int u, int v)
    {
        if (!inside_)
            return;
        if (first_edge_ == not_yet) { // its beginning comes at the end of the way
            head_points_.assign(cut_.points_.begin() + first_point_, cut_.points_.end());
            head_facets_.assign(cut_.facets_.begin() + first_point_, cut_.facets_.end());
            cut_.points_.resize(first_point_);
            cut_.facets_.resize(first_point_);
            head_edge_ = edge;
            head_u_ = u;
            head_v_ = v;
        } else {
            add_point(Vec<2>::Zero(), -1);
            store_chain(edge, u, v);
        }
    }
    // At the way's end, which is where it began.
    void join_head()
    {
        if (!inside_)
            return;
        if (first_edge_ == not_yet) { // all in one square
            add_point(Vec<2>(cut_.points_[first_point_]), -1);
            const int facet = cut_.facets_[first_point_];
            const Node at = node(facet, entry(facet));
            first_edge_ = -1;
            store_chain(-1, at.u, at.v);
            return;
        }
        cut_.points_.insert(cut_.points_.end(), head_points_.begin(), head_points_.end());
        cut_.facets_.insert(cut_.facets_.end(), head_facets_.begin(), head_facets_.end());
        add_point(Vec<2>::Zero(), -1);
        store_chain(head_edge_, head_u_, head_v_);
    }
    void store_chain(int last_edge, int u, int v)
    {
        const int slot = face_slot(axis_);
        chains_.push_back({row_base(slot) + cut_.row(axis_, grid_vertex(u, v)),
                           u,
                           cut_.facets_[first_point_],
                           {first_point_, int(cut_.points_.size()) - first_point_, first_edge_, last_edge}});
    }
    // Number of rows of faces of the axes before.
    int row_base(int slot) const
    {
        int rows = 0;
        for (int i = 0; i < slot; ++i)
            rows += row_count(i);
        return rows;
    }
    int row_count(int slot) const
    {
        if constexpr (D == 2)
            return cut_.count_[1];
        else
            return cut_.count_[slot] * cut_.count_[(slot + 2) % 3];
    }

    // Crossings by line, edge and place; cut edges with the change of the winding number along each, from 0.
    void sort_crossings(int axis)
    {
        std::vector<Crossing>& crossings = crossings_[axis];
        const int lines = D == 2 ? cut_.count_[1 - axis] : cut_.count_.prod() / cut_.count_[axis];
        const std::vector<int> starts = sort_by_key(crossings, lines, [](const Crossing& c) { return c.line; });
        std::vector<CutEdge>& edges = cut_.cut_edges_[axis];
        std::vector<int>& line_starts = cut_.line_starts_[axis];
        line_starts.resize(lines + 1);
        for (int line = 0; line < lines; ++line) {
            line_starts[line] = int(edges.size());
            std::sort(crossings.begin() + starts[line], crossings.begin() + starts[line + 1],
                      [](const Crossing& a, const Crossing& b) {
                          return std::tie(a.cell, a.place, a.facet) < std::tie(b.cell, b.place, b.facet);
                      });
            for (int i = starts[line]; i < starts[line + 1]; ++i) {
                if (i == starts[line] || crossings[i].cell != edges.back().cell)
                    edges.push_back({crossings[i].cell, i, 0, 0, 0});
                edges.back().winding_after += crossings[i].step;
            }
        }
        line_starts[lines] = int(edges.size());
        edges.push_back({0, int(crossings.size()), 0, 0, 0});
    }

    // Winding numbers on a line, from that at its first vertex on.
    void wind_line(int axis, int line, int winding)
    {
        for (int i = cut_.line_starts_[axis][line]; i < cut_.line_starts_[axis][line + 1]; ++i) {
            CutEdge& edge = cut_.cut_edges_[axis][i];
            edge.winding_after += winding - edge.winding;
            edge.winding = winding;
            winding = edge.winding_after;
        }
    }
    // Winding numbers at all vertices of a line through the box's first corner.
    std::vector<int> windings_on(int axis, const Index<D>& first, int winding)
    {
        std::vector<int> windings(cut_.count_[axis], winding);
        const int line = cut_.line(axis, first);
        wind_line(axis, line, winding);
        for (int i = cut_.line_starts_[axis][line]; i < cut_.line_starts_[axis][line + 1]; ++i) {
            const CutEdge& edge = cut_.cut_edges_[axis][i];
            std::fill(windings.begin() + edge.cell + 1, windings.end(), edge.winding_after);
        }
        return windings;
    }

    // From the box's first vertex along the last axis, from there along the one before, and along axis 0.
    void find_windings()
    {
        if constexpr (D == 2) {
            cut_.line_windings_ = windings_on(1, Index<D>::Zero(), corner_winding_);
        } else {
            cut_.line_windings_.resize(cut_.count_[1] * cut_.count_[2]);
            const std::vector<int> last = windings_on(2, Index<D>::Zero(), corner_winding_);
            for (int z = 0; z < cut_.count_[2]; ++z) {
                const std::vector<int> windings = windings_on(1, Index<D>(0, 0, z), last[z]);
                for (int y = 0; y < cut_.count_[1]; ++y)
                    cut_.line_windings_[cut_.line(0, Index<D>(0, y, z))] = windings[y];
            }
        }
        for (int line = 0; line < int(cut_.line_windings_.size()); ++line)
            wind_line(0, line, cut_.line_windings_[line]);
    }

    Index<D> vertex_on(int axis, int line, int cell) const
    {
        Index<D> i;
        i[axis] = cell;
        if constexpr (D == 2) {
            i[1 - axis] = line;
        } else {
            const int count = cut_.count_[(axis + 1) % 3];
            i[(axis + 1) % 3] = line % count;
            i[(axis + 2) % 3] = line / count;
        }
        return i;
    }

    void make_covers(int axis)
    {
        std::vector<Crossing>& crossings = crossings_[axis];
        std::vector<CutEdge>& edges = cut_.cut_edges_[axis];
        std::vector<EdgeCover>& covers = cut_.covers_[axis];
        covers.reserve(crossings.size());
        for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
            CutEdge& edge = edges[i];
            const int begin = edge.first_crossing, end = edges[i + 1].first_crossing;
            if (axis > 0) {
                const int winding = cut_.winding(vertex_on(axis, crossings[begin].line, edge.cell));
                edge.winding_after += winding - edge.winding;
                edge.winding = winding;
            }
            edge.first_cover = int(covers.size());
            int winding = edge.winding;
            bool over = winding < 0 || winding > 1;
            double from = 0;
            for (int k = begin; k < end; ++k) {
                int next = k;
                while (next < end && crossings[next].step != (winding > 0 ? -1 : 1))
                    ++next;
                if (next == end)
                    next = k;
                std::rotate(crossings.begin() + k, crossings.begin() + next, crossings.begin() + next + 1);
                Crossing& c = crossings[k];
                if (k > begin && c.place < crossings[k - 1].place) {
                    over = over || crossings[k - 1].place - c.place > round_off;
                    c.place = crossings[k - 1].place;
                }
                if (winding == 1 && c.step < 0)
                    covers.push_back({from, c.place});
                else if (winding == 0 && c.step > 0)
                    from = c.place;
                winding += c.step;
                over = over || winding < 0 || winding > 1;
            }
            if (winding > 0)
                covers.push_back({from, length(axis, edge.cell)});
            assert(winding == edge.winding_after);
            cut_.overlaps_ += over;
        }
        edges.back().first_cover = int(covers.size());
    }

    // Into the order of faces, and of the first facets in each: those of one face differ, as it is convex.
    void sort_chains()
    {
        const std::vector<int> starts = sort_by_key(chains_, row_base(face_axes), [](const Chain& c) { return c.key; });
        for (std::size_t row = 0; row + 1 < starts.size(); ++row)
            std::sort(chains_.begin() + starts[row], chains_.begin() + starts[row + 1],
                      [](const Chain& a, const Chain& b) { return std::tie(a.u, a.facet) < std::tie(b.u, b.facet); });
        cut_.records_.reserve(chains_.size());
        int key = 0;
        for (int slot = 0; slot < face_axes; ++slot) {
            std::vector<int>& row_starts = cut_.row_starts_[slot];
            row_starts.reserve(row_count(slot) + 1);
            for (int row = 0; row < row_count(slot); ++row, ++key) {
                row_starts.push_back(int(cut_.chained_.size()));
                for (int i = starts[key]; i < starts[key + 1]; ++i) {
                    if (i == starts[key] || chains_[i].u != chains_[i - 1].u)
                        cut_.chained_.push_back(
                            {D == 2 ? 2 : slot, face_of(slot, row, chains_[i].u) + cut_.low_, int(cut_.records_.size()), 0});
                    ++cut_.chained_.back().chain_count;
                    cut_.records_.push_back(chains_[i].record);
                }
            }
            row_starts.push_back(int(cut_.chained_.size()));
        }
    }
    Index<D> face_of(int slot, int row, int u) const
    {
        if constexpr (D == 2) {
            return {u, row};
        } else {
            Index<D> i;
            i[slot] = row % cut_.count_[slot];
            i[(slot + 1) % 3] = u;
            i[(slot + 2) % 3] = row / cut_.count_[slot];
            return i;
        }
    }

    void place_chain_ends()
    {
        for (const ChainedFace<D>& face : cut_.chained_) {
            choose_axis(face.axis);
            for (int i = 0; i < face.chain_count; ++i) {
                const FaceChains::Record& chain = cut_.records_[face.first_chain + i];
                if (chain.first_edge < 0)
                    continue;
                const int last = chain.first_point + chain.point_count - 1;
                cut_.points_[chain.first_point] =
                    end_of_chain(face.face - cut_.low_, chain.first_edge, cut_.facets_[chain.first_point]);
                cut_.points_[last] = end_of_chain(face.face - cut_.low_, chain.last_edge, cut_.facets_[last - 1]);
            }
        }
    }
    // The crossing of an edge of the face by a facet.
    Vec<2> end_of_chain(const Index<D>& face, int number, int facet) const
    {
        const bool along_u = number == 0 || number == 2, high = number == 1 || number == 2;
        const int axis = along_u ? u_ : v_, other = along_u ? v_ : u_;
        Index<D> edge = face;
        edge[other] += high;
        const int at = cut_.find_edge(axis, edge);
        assert(at >= 0);
        int i = cut_.cut_edges_[axis][at].first_crossing;
        while (crossings_[axis][i].facet != facet)
            ++i;
        assert(i < cut_.cut_edges_[axis][at + 1].first_crossing);
        const double place = crossings_[axis][i].place, off = high ? length(other, face[other]) : 0;
        return along_u ? Vec<2>(place, off) : Vec<2>(off, place);
    }

    FacetCut& cut_;
    std::span<const std::array<int, D>> elements_, links_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint8_t> near_;
    int corner_winding_ = 0;
    std::array<std::vector<Crossing>, D> crossings_; // by the axis of their line
    std::vector<Chain> chains_;
    // The plane that is walked in.
    int axis_ = 0, u_ = 0, v_ = 0, plane_index_ = 0;
    // The chain that is walked along.
    bool inside_ = false;
    int first_edge_ = 0, first_point_ = 0;
    // The end of the chain amid which the walk began.
    std::vector<Vec<2>> head_points_;
    std::vector<int> head_facets_;
    int head_edge_ = 0, head_u_ = 0, head_v_ = 0;
};

template <int D>
FacetCut<D>::FacetCut(std::span<const Vec<D>> vertices, std::span<const std::array<int, D>> elements,
                      std::span<const std::array<int, D>> links, const std::array<std::vector<double>, D>& places,
                      const Index<D>& low)
    : low_(low)
{
    for (int axis = 0; axis < D; ++axis) {
        assert(places[axis].size() >= 2);
        count_[axis] = int(places[axis].size());
        for (const double place : places[axis])
            places_[axis].push_back(std::llrint(place / place_unit));
        for (int i = 0; i + 1 < count_[axis]; ++i) {
            assert(places_[axis][i] < places_[axis][i + 1]);
            lengths_[axis].push_back({0, place_unit * double(places_[axis][i + 1] - places_[axis][i])});
        }
    }
    Maker(*this, vertices, elements, links);
}

template <int D>
int FacetCut<D>::find_edge(int axis, const Index<D>& e) const
{
    const int l = line(axis, e);
    const auto begin = cut_edges_[axis].begin() + line_starts_[axis][l],
               end = cut_edges_[axis].begin() + line_starts_[axis][l + 1];
    const auto at = std::lower_bound(begin, end, e[axis], [](const CutEdge& edge, int cell) { return edge.cell < cell; });
    return at != end && at->cell == e[axis] ? int(at - cut_edges_[axis].begin()) : -1;
}

template <int D>
int FacetCut<D>::winding(const Index<D>& vertex) const
{
    const int l = line(0, vertex);
    const auto begin = cut_edges_[0].begin() + line_starts_[0][l], end = cut_edges_[0].begin() + line_starts_[0][l + 1];
    const auto next = std::lower_bound(begin, end, vertex[0], [](const CutEdge& edge, int x) { return edge.cell < x; });
    return next == begin ? line_windings_[l] : next[-1].winding_after;
}

template <int D>
std::span<const EdgeCover> FacetCut<D>::edge(int axis, const Index<D>& e) const
{
    const Index<D> local = e - low_;
    if (const int at = find_edge(axis, local); at >= 0) {
        const int first = cut_edges_[axis][at].first_cover;
        return std::span(covers_[axis]).subspan(first, cut_edges_[axis][at + 1].first_cover - first);
    }
    return std::span(lengths_[axis]).subspan(local[axis], winding(local) > 0 ? 1 : 0);
}

template <int D>
FaceChains FacetCut<D>::face(int axis, const Index<D>& f) const
{
    const Index<D> local = f - low_;
    const int slot = face_slot(axis), r = row(axis, local), u = (axis + 1) % 3;
    const auto begin = chained_.begin() + row_starts_[slot][r], end = chained_.begin() + row_starts_[slot][r + 1];
    const auto at = std::lower_bound(begin, end, f[u], [u](const ChainedFace<D>& face, int i) { return face.face[u] < i; });
    return at != end && at->face[u] == f[u] ? chains(*at) : FaceChains();
}

template std::vector<std::array<int, 2>> facet_links<2>(int, std::span<const std::array<int, 2>>);
template std::vector<std::array<int, 3>> facet_links<3>(int, std::span<const std::array<int, 3>>);
template class FacetCut<2>;
template class FacetCut<3>;

} // namespace gapflow
