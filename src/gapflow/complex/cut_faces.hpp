// What solids leave open of the grid's faces (2D: of its cells), found slab by slab.
//
// A slab is some planes of cells along the last axis. Every solid marks the faces of a slab that it covers or cuts; faces cut by one convex
// solid in the common way are done at once, all others go through Square. Slabs are independent of each other.
#pragma once

#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/facet_cut.hpp"
#include "gapflow/complex/placed.hpp"
#include "gapflow/complex/square.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>

namespace gapflow {

/// The rectangles that are cut: faces normal to each axis in 3D, in 2D the cells.
template <int D>
inline constexpr int face_kinds = D == 3 ? 3 : 1;

/// In-plane axes of a rectangle.
template <int D>
int u_axis(int d)
{
    return D == 3 ? (d + 1) % 3 : 0;
}
template <int D>
int v_axis(int d)
{
    return D == 3 ? (d + 2) % 3 : 1;
}

/// Axis of an edge of a rectangle, and the lower vertex from which it starts.
template <int D>
int edge_axis(int d, int e)
{
    return e % 2 == 0 ? u_axis<D>(d) : v_axis<D>(d);
}
template <int D>
Index<D> edge_start(int d, Index<D> f, int e)
{
    if (e == 1)
        ++f[u_axis<D>(d)];
    if (e == 2)
        ++f[v_axis<D>(d)];
    return f;
}

/// A solid's border on a piece: in 3D a = 1/2 int x cross dx and -1/2 int |x|^2 dx along it; in 2D area vector and moment of the wall.
template <int D>
struct BorderArc {
    std::int32_t image; ///< of the placed solids
    std::int32_t piece; ///< of its rectangle
    Vec<D> area;
    Spin<D> moment;
};

template <int D>
struct Junction {
    std::int32_t piece, from, to; ///< images
    Vec<D> at;
    std::int32_t edge = -1, solid = -1; ///< where one of the two is a dividing line: of which edge of which solid
    int sides = 3;                      ///< which cells the lines divide, see CornerDivision
    int lines = 0;                      ///< how many of the two are lines
};

template <int D>
struct CutFace {
    enum class State : std::uint8_t { simple, general, dead };
    std::int32_t id; ///< in DenseIndex
    std::int8_t axis;
    State state;
    std::uint8_t open; ///< corners, counterclockwise from the low one, that are open: of a simple face
    std::int32_t image;
    std::int32_t piece = 0, arc = 0;   ///< first ones
    std::int32_t pieces = 0, arcs = 0; ///< how many
    std::int32_t detail = -1;          ///< of a general face
    std::int32_t crossing = -1;        ///< of a simple cell in 2D: first of its two
    std::array<std::int8_t, 2> crossing_edge{};
};

/// Two pieces of a rectangle on both sides of the line by which a solid's corner (3D: edge) divides it.
template <int D>
struct CornerDivision {
    std::int32_t image;
    std::int32_t a, b;                 ///< pieces of the rectangle, at the left and right of the way outward
    double conductance, open, covered; ///< 3D: open only
    Vec<D> at;                         ///< the corner
    int edge = -1;                     ///< 3D: of the image
    int sides = 0;                     ///< 3D: which cells it divides: 1 that below the face, 2 that above it
    int mouth = -1;                    ///< 2D: SharpCorner::mouth
};

/// A line by which an edge of a solid divides the cells below and above a face, 3D.
struct FaceLine {
    int image, edge, sides; ///< sides: which cells it divides: 1 that below the face, 2 that above it
};

/// A facet on an arc of a slab.
struct ArcFacet {
    std::int32_t arc, facet;
};

/// How a point that solids' borders define moves: by the twists of one or two placed solids (cells, radians; rotation about the reference point).
template <int D>
struct PointRate {
    std::int32_t solid; ///< of its own number, or that of an image
    Eigen::Matrix<double, D, twist_size<D>> rate;
};
template <int D>
using PointRates = InlineVector<PointRate<D>, 2>;

/// Of a CornerDivision by the twist of a placed solid.
template <int D>
struct DivisionRate {
    std::int32_t division, image;
    Twist<D> rate; ///< of its conductance; 3D: of its open length
};

/// Of a general face.
struct FaceDetail {
    std::vector<int> images;
    std::array<int, 5> stretch{}; ///< first stretch of each edge, and the end
    int junction = 0, junctions = 0;
    int division = 0, divisions = 0;
};

template <int D>
struct Slab {
    int begin, end; ///< planes of cells
    std::vector<CutFace<D>> faces;
    std::vector<SquarePiece> pieces;
    std::vector<BorderArc<D>> arcs;
    std::vector<ArcFacet> arc_facets; ///< 3D: of the meshes' arcs, in their order
    std::vector<FaceDetail> details;
    std::vector<OpenStretch> stretches;
    std::vector<Junction<D>> junctions;
    std::vector<std::optional<FacetCut<D>>> facets; ///< of images with facets that meet the slab, where they are kept
    std::vector<double> crossings;                  ///< 2D: where solids cross the edges of simple cells, along the edge's axis
    std::vector<CornerDivision<D>> divisions;
    // Where derivatives are wanted.
    std::vector<PointRates<D>> junction_rates;   ///< of each junction, by images
    std::vector<DivisionRate<D>> division_rates; ///< in the order of the divisions

    std::span<const DivisionRate<D>> rates_of_division(int division) const
    {
        const auto before = [](const DivisionRate<D>& r, int d) { return r.division < d; };
        const auto first = std::lower_bound(division_rates.begin(), division_rates.end(), division, before),
                   last = std::lower_bound(first, division_rates.end(), division + 1, before);
        return {first, last};
    }
};

template <int D>
struct CutFaces {
    const Grid<D>* grid = nullptr;
    bool for_derivatives = false;
    std::array<std::vector<std::int32_t>, face_kinds<D>> face; ///< number in its slab's faces, Complex::open or Complex::solid
    std::vector<Slab<D>> slabs;
    std::vector<int> slab_of; ///< plane of cells, from DenseIndex::low; of the faces on the last side the last slab
};

template <int D>
class GeneralCut;

/// ArcSegment::surface of the plane by which a solid's edge divides a cell, and the edge again.
inline int surface_of_fin(int edge)
{
    return -2 - edge;
}

/// Finds the arcs of cut faces again, with the curves of which they are made: the same numbers as those of cut_faces.
template <int D>
class FaceArcs {
public:
    FaceArcs(const CutFaces<D>& cut, const GridPlanes<D>& planes, const DenseIndex<D>& index,
             const std::vector<PlacedSolid<D>>& solids, bool with_chords = false);
    ~FaceArcs();
    /// Of a face of a slab that has pieces; their solids are images. Valid until the next call; cheap where faces come as in the slab.
    std::span<const SquareArc> of(const Slab<D>& slab, const CutFace<D>& face);
    /// Borders of the pieces of the face of the last call, where they are wanted; solids are images.
    std::span<const BorderChord> chords() const { return chords_; }
    /// The dividing line of which a chord of that face is a side, 3D.
    const FaceLine& line(int fin) const;

private:
    template <class Kind>
    void find_simple(const PlacedSolid<D>& placed, const Kind& kind, const CutFace<D>& face);

    const GridPlanes<D>& planes_;
    const DenseIndex<D>& index_;
    const std::vector<PlacedSolid<D>>& solids_;
    std::unique_ptr<GeneralCut<D>> general_;
    std::vector<SquareArc> arcs_;
    bool with_chords_;
    std::vector<BorderChord> chords_;
    // Sections of one solid with planes normal to one axis.
    int image_ = -1, axis_ = -1;
    std::vector<std::unique_ptr<Section>> sections_;
};

/// `for_derivatives`: keeps facets for FaceArcs, and finds rates.
template <int D>
CutFaces<D> cut_faces(const Grid<D>& grid, const GridPlanes<D>& planes, const DenseIndex<D>& index,
                      const std::vector<PlacedSolid<D>>& solids, bool for_derivatives);

} // namespace gapflow
