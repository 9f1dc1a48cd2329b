// The master's surface near the gap, refined to the gap's scales (method, "Mesh"). Private to film/.
#pragma once

#include "gapflow/film/edge_table.hpp"
#include "gapflow/film/gap_test.hpp"

namespace gapflow {

template <int D>
class FilmSurface {
public:
    static constexpr int edges_per_element = D == 2 ? 1 : 3;

    struct Vertex {
        Vec<D> x;
        Vec<D> nudge;                ///< from a sharp edge of the master 1e-9 of an element inwards: tests are made there
        SurfacePoint<D> p;           ///< closest point of the other to x + nudge
        double facing;               ///< n_A . n_B
        int patch;                   ///< of the master
        bool crease;                 ///< on a sharp edge of the master
        bool fixed;                  ///< crease vertex of the base mesh, which must stay
        std::optional<RimEnd> fails; ///< why it is not in the gap
        bool inside() const { return !fails; }
    };
    struct Element {
        std::array<int, D> nodes;
        int patch;
    };
    struct Edge {
        int a, b;   ///< vertices
        int patch;  ///< of the master
        int second; ///< other patch of the master that meets there, or -1
        double length;
        double lateral = 0; ///< the longest that the gap's curvature along the edge allows
        double extent = 0;  ///< length times what the largest curvature allows over what that along the edge does
        int middle = -1;    ///< vertex that splits it
        bool crease = false;
        bool marked = false;
    };
    /// Where an edge leaves the gap.
    struct Crossing {
        Vec<D> x;
        SurfacePoint<D> p;
        double fraction; ///< of the edge, from its vertex in the gap
        RimEnd end;
    };

    /// Base mesh: the elements of the master that may reach the gap. Vertices are split along sharp edges.
    FilmSurface(const GapTest<D>& test, const SurfaceMesh<D>& base);

    /// Splits until no element is larger than the largest size times `scale`; drops elements that cannot reach the gap. False if that
    /// needs more vertices in the gap than allowed.
    bool refine_coarsely(double scale);
    /// The other's patches that face the gap.
    std::vector<int> other_patches() const;
    /// Counts only these patches of the other as its surface from now on.
    void restrict_to(const std::vector<int>& label);
    /// Splits until every element in the gap has its size times `scale` and the gap's end cuts elements in straight lines.
    /// False if that needs more vertices in the gap than allowed.
    bool refine(double scale);

    const GapTest<D>& test() const { return test_; }
    std::vector<Vertex>& vertices() { return vertices_; }
    const std::vector<Element>& elements() const { return elements_; }
    /// Edges of element e, as of the last refinement (3D: edge k joins nodes k and k + 1).
    const std::array<int, edges_per_element>& edges_of(int e) const { return element_edges_[e]; }
    const std::vector<Edge>& edges() const { return edges_; }
    /// Whether the edge has one end in the gap.
    bool straddles(const Edge& edge) const { return vertices_[edge.a].inside() != vertices_[edge.b].inside(); }
    /// The crossing of a straddling edge, found to 1e-12 dx; `index`: its number.
    const Crossing& crossing(const Edge& edge, int* index = nullptr);
    /// The other patch across a sharp edge of the master (-1: an edge of the mesh for another reason; -2: no sharp edge).
    int across_crease(int a, int b) const;

private:
    struct Sizes {
        double largest, largest_curved, smallest, straddle, straddle_open, straddle_smooth, curved;
        double varying; ///< the smallest where h varies by more than the largest ratio
    };

    int add_vertex(const Vec<D>& x, const Vec<D>& nudge, int patch, bool crease, bool fixed);
    void look(Vertex& v) const;
    void number_edges();
    void measure(bool coarse);
    bool mark_edges(bool coarse);
    bool mark_at_end();
    bool varies(double h0, double h1) const;
    bool goes_out_smoothly(const Vertex& v, int patch) const;
    double size_at_end(const Vertex& v, int patch) const;
    bool too_long(const Edge& edge, bool coarse) const;
    bool out_of_reach(int e) const;
    bool straight(int e);
    int longest_edge(int e) const;
    void close_marks();
    void split_marked();
    void split_edge(Edge& edge, const Vec<D>& interior);
    void drop_unreachable();
    bool run(bool coarse);

    GapTest<D> test_;
    Sizes sizes_;
    bool other_planar_;
    std::vector<Vertex> vertices_;
    std::vector<Element> elements_;
    std::vector<Edge> edges_;
    std::vector<std::array<int, edges_per_element>> element_edges_;
    EdgeTable edge_table_, creases_, crossing_table_;
    std::vector<Crossing> crossings_;
};

} // namespace gapflow
