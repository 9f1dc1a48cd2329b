// What solids leave open of a rectangle: a face of the grid in 3D, a cell of it in 2D.
//
// Each solid covers stretches of the rectangle's four edges and has arcs within it that join the ends of these stretches. Walking along
// open stretches of the edges and along arcs gives the pieces: connected open regions. Every piece's border closes by construction, so
// areas and area vectors balance to round-off whatever the degeneracy.
//
// A corner of a solid may divide a piece: its border is then led from the corner along a straight line to the next solid or to the
// rectangle's border and back on the line's other side, as around a fin of no thickness. To all that follows the fin is the solid's border.
//
// Edges, counterclockwise: 0 at v low, 1 at u high, 2 at v high, 3 at u low. Coordinates on an edge are those along its axis.
#pragma once

#include "gapflow/complex/convex.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace gapflow {

/// A place on the border of the rectangle.
struct OnEdge {
    int edge = -1;
    double at = 0; ///< coordinate along the edge's axis

    bool operator==(const OnEdge& other) const = default;
};

/// One segment of an arc: straight, or clockwise along an ellipse (counterclockwise, where the solid is its outside).
struct ArcSegment {
    Vec<2> from, to;
    const Curve* curve = nullptr; ///< null: straight
    int surface = 0;              ///< face of the solid to which it belongs; -1: none, its ends are equal to round-off
    bool backwards = false;       ///< counterclockwise
    bool whole = false;           ///< once around the ellipse
    int fin = -1;                 ///< a side of the line by which a corner divides, or of a line (see SquareLink)

    Bulge bulge() const;
    /// Of a straight one or a piece of a circle.
    double length() const;
    /// At t of its way, 0 .. 1.
    Vec<2> at(double t) const;
    /// How many chords of equal angles stand for it in pictures.
    int chords() const;
    /// Of its point nearest to x, which lies close to it.
    double nearest(const Vec<2>& x) const;
    /// The part between two of these.
    ArcSegment part(double t0, double t1) const;
};

/// A solid's border inside the rectangle, with the fluid at its left: from where the border of the fluid enters it to where it leaves.
struct SquareArc {
    int solid = 0;     ///< index into Square::solids
    OnEdge start, end; ///< edge -1: within the rectangle (closed, or at a junction)
    Vec<2> from = Vec<2>::Zero(), to = Vec<2>::Zero();
    InlineVector<ArcSegment, 3> segments;
    int joins = -1; ///< end at a junction: the arc that follows
    int piece = -1;

    Bulge bulge() const;
};

/// Appends the piece of a section's border between A and B, both on it (see Section::piece); `backwards`: from B to A, counterclockwise.
/// The section outlives the arc.
void add_walk(SquareArc& arc, const Section& section, const Vec<2>& A, const Vec<2>& B, bool around, bool backwards);

/// What one solid covers of the rectangle's edges, and its arcs.
struct SquareSolid {
    int solid = 0;                                 ///< the caller's number
    std::array<InlineVector<Stretch, 1>, 4> edges; ///< covered, in ascending order
    std::array<bool, 4> corner{};                  ///< covered: (low, low), (high, low), (high, high), (low, high)
    /// Of a convex solid: its section; arcs follow. Null: `arcs` are given.
    const Section* section = nullptr;
    bool inverse = false;        ///< the solid is what lies outside the section
    bool section_inside = false; ///< the section lies within the rectangle
    std::vector<SquareArc> arcs; ///< solid and piece unset
};

struct SquarePiece {
    double area = 0;
    Vec<2> centroid = Vec<2>::Zero();
};

/// Where a piece's border goes over from one solid to another.
struct SquareJunction {
    int piece, from, to; ///< solids
    Vec<2> at;
    std::array<int, 2> fin; ///< of which line each of the two is a side (see SquareLink), or -1
};

/// A corner of a solid within the rectangle that divides.
struct SquareCorner {
    int solid;            ///< index into Square::solids
    Vec<2> at;            ///< where two segments of the solid's border meet
    Vec<2> outward;       ///< direction of the dividing line
    bool to_wall = false; ///< it leads to another solid, perhaps to a corner of that
};

/// A line by which a solid divides: each end at a corner of the solid's border or where lines meet (edge -1), or on the rectangle's border.
struct SquareLine {
    int solid; ///< index into Square::solids
    Vec<2> from, to;
    OnEdge from_border, to_border;
    bool to_wall = false; ///< it leads to another solid, perhaps to a corner of that
};

/// Two pieces on both sides of a dividing line.
struct SquareLink {
    int fin;     ///< index into Square::corners; from corners.size() on into Square::lines
    int a, b;    ///< pieces at the left and right of the way outward
    double open; ///< length of the line between them
};

struct OpenStretch {
    double from, to;
    int piece;
};

/// A straight line of a piece's border, or a chord of a curve of it, with the piece at its left.
struct BorderChord {
    int piece;
    Vec<2> from, to;
    int solid; ///< -1: on the rectangle's border
    int fin;   ///< of which dividing line it is a side (see SquareLink), or -1
};

/// The rectangle, and after cut() its pieces. Kept from call to call for its buffers.
class Square {
public:
    Vec<2> low, high;
    std::vector<SquareSolid> solids;
    std::vector<SquareCorner> corners;
    std::vector<SquareLine> lines;

    std::vector<SquarePiece> pieces;
    std::vector<SquareLink> links;
    std::vector<SquareArc> arcs; ///< those that bound a piece
    std::vector<SquareJunction> junctions;
    std::array<std::vector<OpenStretch>, 4> stretches; ///< of each edge, ascending
    bool with_chords = false;
    std::vector<BorderChord> chords; ///< where they are wanted: loop by loop, each in the order of its border

    void cut();

private:
    /// An open stretch of the border, around corners, counterclockwise.
    struct RingStretch {
        OnEdge start, end;
        int before, after; ///< solids that end and start there; -1: none, all of the border is open
        int piece = -1;
    };

    Vec<2> point(const OnEdge& place) const;
    Vec<2> corner(int c) const;
    /// 0 .. 4, counterclockwise from the low corner.
    double along_ring(const OnEdge& place) const;
    void find_open_stretches();
    void find_arcs();
    void arcs_of_convex(int s);
    double distance(int solid, const Vec<2>& x) const;
    void keep_outer();
    struct Hit {
        double way = 0; ///< from the ray's start
        int arc = -1, segment = 0;
        double t = 0;
    };
    /// A point where the border is open: arcs that end and start there, or a place on the rectangle's border, or neither in the fluid.
    struct End {
        int ends = -1, starts = -1;
        OnEdge place;
    };
    void divide(int corner);
    void draw_lines();
    bool draw(int number, bool turned);
    Hit joint_at(int solid, const Vec<2>& x, const Vec<2>& direction) const;
    Hit nearest_hit(const Vec<2>& start, const Vec<2>& direction, double least, bool to_corners = false, int from = -1) const;
    Hit arc_end(const OnEdge& place, const Vec<2>& direction) const;
    std::pair<double, OnEdge> exit_of(const Vec<2>& start, const Vec<2>& direction) const;
    End open_at(const Hit& hit, const Vec<2>& x);
    std::optional<End> open_border(const OnEdge& place, const Vec<2>& direction, int solid);
    void add_fin(const Vec<2>& p, End from, const Vec<2>& q, const End& to, int solid, int fin);
    int split_arc(int arc, int segment, double t, const Vec<2>& x);
    void split_ring(int ring, const OnEdge& place, int solid);
    int ring_at(const OnEdge& place) const;
    void find_links();
    int fin_of(int arc) const;
    Hit other_side(int arc, int segment, const Vec<2>& x) const;
    double ring_length(const RingStretch& r) const;
    void walk();
    void close_loops();
    void add_border(int ring);
    void add_arc(int arc);
    void add_chord(const Vec<2>& to, int solid, int fin);
    static void join(SquareArc& arc, const SquareArc& next);
    static void lead(const Vec<2>& x, SquareArc& arc);
    int next_ring(SquareArc& arc);

    std::vector<RingStretch> ring_;
    std::array<std::vector<int>, 4> ring_of_; ///< of each of `stretches`
    // Of the piece that is being walked around.
    Bulge sum_;
    Vec<2> start_, here_;
    int piece_ = -1;
};

} // namespace gapflow
