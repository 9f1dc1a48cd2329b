// What a closed surface of facets (3D: triangles, 2D: segments) covers of the vertices, edges and faces of a Cartesian grid.
//
// All statements about what lies where are exact and fit together, wherever facets, their edges and vertices lie, on grid planes,
// lines and vertices, too. Places are rounded to multiples of 2^-36 and a grid plane at p stands for p + e_axis, with
// e_0 >> e_1 >> e_2 > 0 less than any length (simulation of simplicity, Edelsbrunner & Mücke 1990): no vertex of the surface
// lies on a grid plane, no edge of it meets a grid line and no facet a grid vertex. A solid whose side lies in a grid plane covers
// that plane if it lies above it, and not if below.
//
// Faces of a 2D grid are its squares, with axis 2. Of a face with axis d the two others are u = (d + 1) % 3, v = (d + 2) % 3; its
// edges are 0: low v, 1: high u, 2: high v, 3: low u. An edge or face has the index of its low vertex.
#pragma once

#include "gapflow/core/types.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gapflow {

/// Of coordinates, in cells: they are whole multiples of it, exact in a double and, with differences and products, in 128-bit integers.
inline constexpr double place_unit = 0x1p-36;

/// The facets on the other side of each facet's borders: 3D of its edges (edge k from vertex k to the next one), 2D of its vertices.
/// Where more than two meet they are taken in pairs. Depends on the elements only; vertices are 0 .. vertex_count - 1.
/// The surface is closed and consistently oriented (assertion).
template <int D>
std::vector<std::array<int, D>> facet_links(int vertex_count, std::span<const std::array<int, D>> elements);

/// Stretch of a grid edge inside the solid, measured from the edge's low vertex: 0 <= from <= to <= the edge's length. Exactly 0 or
/// that length where the vertex is covered.
struct EdgeCover {
    double from, to;
};

/// A polyline in which the surface cuts a face; the fluid is at its left, seen from above the face (from +d).
struct FacetChain {
    std::span<const Vec<2>>
        points; ///< (u, v) from the face's low vertex. Open: the first and last lie on the face's edges, their place
                ///< along the edge exactly that of the cover's end there. Closed: the last is the first
    std::span<const int> facets; ///< the facet of each segment, one fewer than points
    int first_edge, last_edge;   ///< of the face, on which it begins and ends; closed: -1
    bool closed() const { return first_edge < 0; }
};

/// The chains of a face, in the order of their first facets.
class FaceChains {
public:
    struct Record {
        int first_point, point_count;
        int first_edge, last_edge;
    };

    FaceChains() = default;
    FaceChains(std::span<const Record> records, const Vec<2>* points, const int* facets)
        : records_(records), points_(points), facets_(facets)
    {
    }
    int size() const { return int(records_.size()); }
    FacetChain operator[](int i) const
    {
        const Record& r = records_[i];
        return {{points_ + r.first_point, std::size_t(r.point_count)},
                {facets_ + r.first_point, std::size_t(r.point_count - 1)},
                r.first_edge,
                r.last_edge};
    }

private:
    std::span<const Record> records_;
    const Vec<2>* points_ = nullptr;
    const int* facets_ = nullptr; // as many as points, the last one of a chain is not used
};

/// A face with chains.
template <int D>
struct ChainedFace {
    int axis;
    Index<D> face;
    int first_chain, chain_count; ///< see FacetCut::chains
};

/// What a surface covers of a box of grid vertices. The same, bit for bit, in every box that has the edge or face, and of surface
/// and planes shifted by multiples of 2^-36.
///
/// Every place where the surface crosses an edge of a face is the end of exactly one of the face's chains. A chain begins where a
/// way counterclockwise round the face enters the solid, and ends where it leaves it. A face without chains is wholly open or wholly
/// covered, as any of its vertices.
template <int D>
class FacetCut {
public:
    /// @param vertices  of the surface, of magnitude below 2^16 (in cells, say); rounded to multiples of 2^-36
    /// @param elements  as of SurfaceMesh: normals out of the solid; a surface wholly inside out has the solid outside
    /// @param links     facet_links of the elements
    /// @param places    of the grid planes of each axis, two or more; increasing by 2^-36 or more; rounded as the vertices
    /// @param low       index of the first plane of each axis
    ///
    /// The surface may touch itself; it does not cut itself by more than round-off (see overlaps).
    FacetCut(std::span<const Vec<D>> vertices, std::span<const std::array<int, D>> elements,
             std::span<const std::array<int, D>> links, const std::array<std::vector<double>, D>& places, const Index<D>& low);

    /// Place of a grid plane as it is used, rounded.
    double place(int axis, int index) const { return place_unit * double(places_[axis][index - low_[axis]]); }
    /// Length of a grid edge along the axis from plane `index` to the next.
    double length(int axis, int index) const { return lengths_[axis][index - low_[axis]].to; }

    bool covered(const Index<D>& vertex) const { return winding(vertex - low_) > 0; }
    /// Sorted covered stretches of the edge along `axis`, apart or touching.
    std::span<const EdgeCover> edge(int axis, const Index<D>& e) const;
    /// Chains of a face; 2D: axis is 2.
    FaceChains face(int axis, const Index<D>& f) const;

    /// All faces with chains, sorted by axis and place.
    std::span<const ChainedFace<D>> chained_faces() const { return chained_; }
    FaceChains chains(const ChainedFace<D>& face) const
    {
        return {std::span(records_).subspan(face.first_chain, face.chain_count), points_.data(), facets_.data()};
    }

    /// Number of cut edges on which parts of the solid lie over each other or are turned over: where winding numbers are not 0 and 1
    /// by turns, unless crossings come in that order when moved by up to 1e-6. With winding numbers of vertices, too, other
    /// than 0 and 1, starts and ends of chains are not those of the covers.
    int overlaps() const { return overlaps_; }

private:
    class Maker;

    static constexpr int face_axes = D == 2 ? 1 : 3;

    struct CutEdge {
        int cell; // index along the edge's axis
        int first_crossing, first_cover;
        int winding, winding_after; // winding numbers at its low and high vertex
    };

    // Local indices, from low_, below.

    // Number of the grid line on which an edge lies.
    int line(int axis, const Index<D>& e) const
    {
        if constexpr (D == 2)
            return e[1 - axis];
        else
            return e[(axis + 1) % 3] + count_[(axis + 1) % 3] * e[(axis + 2) % 3];
    }
    // Number of the row along u in which a face lies.
    int row(int axis, const Index<D>& f) const
    {
        if constexpr (D == 2)
            return f[1];
        else
            return f[axis] + count_[axis] * f[(axis + 2) % 3];
    }
    static constexpr int face_slot(int axis) { return D == 2 ? 0 : axis; }
    // Position in cut_edges_, or -1.
    int find_edge(int axis, const Index<D>& e) const;
    int winding(const Index<D>& vertex) const;

    Index<D> low_, count_;                               // first index and number of planes
    std::array<std::vector<std::int64_t>, D> places_;    // in units of place_unit
    std::array<std::vector<EdgeCover>, D> lengths_;      // from 0 to the length: the cover of a whole edge
    std::array<std::vector<int>, D> line_starts_;        // of each grid line in cut_edges_, and the end
    std::array<std::vector<CutEdge>, D> cut_edges_;      // one more at the end
    std::array<std::vector<EdgeCover>, D> covers_;       // of the cut edges
    std::vector<int> line_windings_;                     // at the first vertex of each line along axis 0
    std::array<std::vector<int>, face_axes> row_starts_; // of each row of faces in chained_, and the end
    std::vector<ChainedFace<D>> chained_;
    std::vector<FaceChains::Record> records_;
    std::vector<Vec<2>> points_;
    std::vector<int> facets_;
    int overlaps_ = 0;
};

} // namespace gapflow
