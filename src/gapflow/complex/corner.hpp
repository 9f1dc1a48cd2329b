// Sharp corners of solids, which divide the part of the fluid in which they lie.
//
// A grid that does not see a corner moves it by up to half a cell: the flow around it passes through the cell's one node. The part is
// therefore divided along the corner's bisector, and a link joins the two sides (see ComplexParameters::corner_link).
#pragma once

#include "gapflow/core/types.hpp"
#include "gapflow/grid/inline_vector.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// A convex corner of a solid in the plane; lengths in cells.
struct SharpCorner {
    Vec<2> at;
    Vec<2> outward; ///< of unit length: along the bisector, or to another wall (mouth.hpp)
    double angle;   ///< of the solid, 0 .. pi
    /// Share of the corner's own resistance in that of its link; 0 where it does not divide, unless it has a mouth.
    double own = 1;
    Vec<2> bisector = Vec<2>::Zero(); ///< `outward` without other walls
    int mouth = -1;                   ///< the gap whose end it is
    double reach = 0; ///< of the dividing line, to a little behind the other wall; 0: to the border of the corner's cell

    /// Along one of its two sides to an open side of the domain, beyond which the solid is none of it: direction, length, axis of the side. Length 0: none.
    Vec<2> way_out = Vec<2>::Zero();
    double length_out = 0;
    int axis_out = 0;

    bool divides() const { return own > 0 || mouth >= 0; }
};

/// The part of a corner's dividing line in one cell, where that is not the corner's own.
struct LineInCell {
    Index<2> cell;
    int corner;
    Vec<2> from, to;
    int from_edge, to_edge; ///< of the cell, counterclockwise from the low one; -1: ends within the cell
};

/// A flat face of a solid in space and a convex edge between two of them.
struct SharpFacet {
    Vec<3> normal, at; ///< out of the solid; a point of it

    double height(const Vec<3>& x) const { return normal.dot(x - at); }
    /// Whether another one lies in the same plane.
    bool in_plane_of(const SharpFacet& other) const;
};
struct SharpEdge {
    int a, b; ///< facets
    Vec<3> from, to;
    double angle; ///< of the solid
    /// Of unit length and normal to the edge, within the plane by which it divides where that is not the bisector plane: to another wall (rim.hpp). Else zero.
    Vec<3> outward = Vec<3>::Zero();
    int way = -1;        ///< of the gap that ends there, see SharpSolid::ways
    bool divides = true; ///< the cells through which it passes
    Vec<3> along() const { return (to - from).normalized(); }
    bool turned() const { return !outward.isZero(0); }
    /// Whether its plane leads to another wall, through all cells on the way.
    bool leads() const { return way >= 0 && turned(); }
};

/// The way from an edge to another wall (edge_mouth.hpp), by its length at places along the edge.
struct EdgeWay {
    int edge, number;               ///< number: of all ways
    std::vector<double> at, length; ///< straight between these places
    double beyond;                  ///< by which it ends behind the other wall
    int axis = -1, plane = 0;       ///< where it lies in a plane of the grid, which it does not divide; else axis -1

    double length_at(double s) const;
};

/// A round edge between a flat end and the side of a cylinder. The cone on which the heights over both are equal divides its cells.
struct SharpRim {
    Vec<3> centre, normal; ///< of the end, out of the solid
    double radius;
};
/// Part of a rim in one cell, between planes of the grid.
struct RimPiece {
    Index<3> cell;
    int rim;
    Vec<3> from, to, out; ///< out: normal of the side at its middle
};

/// An edge in a cell.
struct EdgeCell {
    Index<3> cell;
    int edge;
};

/// Convex edges and their facets: the fluid of a cell through which edges pass is divided among their facets. The borders are bisector planes at
/// edges; at a vertex three of them meet. Of a convex solid each point belongs to the facet above which it is highest. Where an edge lies in front
/// of the plane of a facet that edges in the cell join with it, its plane ends where it is as high above that facet.
struct SharpSolid {
    std::vector<SharpFacet> facets;
    std::vector<SharpEdge> edges;
    std::vector<EdgeCell> edge_cells; ///< the cells that edges pass through or touch, sorted (see sort_by_cell)
    std::vector<int> facet_of;        ///< of a mesh: the SharpFacet to which each of its facets belongs; -1: none
    std::vector<SharpRim> rims;       ///< the number of a rim as an edge: from edges.size() on
    std::vector<RimPiece> pieces;     ///< sorted by cell and rim
    std::vector<EdgeWay> ways;
    std::vector<EdgeCell> way_cells; ///< through which the ways lead, sorted by cell

    bool empty() const { return edges.empty() && pieces.empty(); }
    std::span<const RimPiece> pieces_in(const Index<3>& cell) const;
    std::span<const EdgeCell> edges_in(const Index<3>& cell) const;
    std::span<const EdgeCell> ways_in(const Index<3>& cell) const;
    /// Normal of an edge's dividing plane, towards its first facet.
    Vec<3> across(int edge) const;
    void sort_by_cell();
};

/// What divides a cell.
struct CellSectors {
    InlineVector<int, 4> facets, edges;
    InlineVector<int, 4> group; ///< of each facet: those that edges in the cell join have one number
    InlineVector<int, 2> rims;
    InlineVector<int, 2> ways; ///< edges whose planes lead through the cell to another wall; they are not among `edges`

    bool empty() const { return edges.empty() && rims.empty() && ways.empty(); }
};
CellSectors cell_sectors(const SharpSolid& solid, const Index<3>& cell, const Vec<3>& low, const Vec<3>& high);

/// Whether an edge passes through the inside of a cell.
bool passes(const SharpEdge& edge, const Vec<3>& low, const Vec<3>& high);

/// An edge, or a rim by its chords, in a cell.
struct EdgeInCell {
    double angle, length;
    /// Areas of the bisector plane: outward of the edge as far as it parts two sectors, and behind the edge within its ends.
    double open, covered;
    Vec<3> at;
};
EdgeInCell edge_in_cell(const SharpSolid& solid, const CellSectors& sectors, int edge, const Index<3>& cell, const Vec<3>& low,
                        const Vec<3>& high);

/// What of an edge's way to another wall lies in a cell, or in a rectangle of no thickness.
struct WayInCell {
    double area = 0;
    double at = 0; ///< mean place along the edge
};
WayInCell way_in_cell(const SharpSolid& solid, const EdgeWay& way, const Vec<3>& low, const Vec<3>& high);

/// By the twist of the solid about its reference point.
struct EdgeRates {
    Twist<3> open = Twist<3>::Zero(), covered = Twist<3>::Zero(), length = Twist<3>::Zero();
};
EdgeRates edge_rates(const SharpSolid& solid, const CellSectors& sectors, int edge, const Index<3>& cell, const Vec<3>& low,
                     const Vec<3>& high, const Vec<3>& reference);

/// Where the border of two sectors cuts a face of the cell: from `from` on outward of the edge, to - from > 0 along `direction`.
struct SectorLine {
    enum class End { corner, border, junction };
    Vec<2> start, direction;
    double from = 0, to = 0; ///< from start
    End from_end = End::border, to_end = End::border;
    int from_edge = -1, to_edge = -1; ///< of the rectangle, where the line ends there
    bool empty() const { return !(to > from); }
    Vec<2> at(double t) const { return start + t * direction; }
};
/// In the plane x[d] = at, in the rectangle low .. high.
SectorLine sector_line(const SharpSolid& solid, const CellSectors& sectors, int edge, int d, double at, const Vec<2>& low,
                       const Vec<2>& high);

/// Where the way of an edge to another wall cuts the face; from `from` to `to` the edge's first facet lies at its left.
SectorLine way_line(const SharpSolid& solid, const EdgeWay& way, int d, double at, const Vec<2>& low, const Vec<2>& high);

/// Where an edge's dividing plane cuts the grid line along `axis` through x: the same number whichever face asks.
double bisector_crossing(const SharpSolid& solid, int edge, int axis, const Vec<3>& x);

/// On a face of the grid: the chord of the curve in which a rim's cone cuts it.
struct RimLine {
    Vec<2> from, to;
    int from_edge, to_edge; ///< of the rectangle; -1: at the rim
};
/// Of the part of the cone outside the solid, in the plane x[d] = at, in the rectangle low .. high.
InlineVector<RimLine, 2> rim_lines(const SharpRim& rim, int d, double at, const Vec<2>& low, const Vec<2>& high);

/// A convex polygon becomes its part where n . x + c >= 0.
void clip(std::vector<Vec<2>>& polygon, const Vec<2>& n, double c);

/// Conductance (over 1/density) of the link across a dividing line of which a length `open` lies in the fluid of the corner's cell;
/// `covered`: from the corner back along the bisector to the cell's border. In 3D `open` is an area, `covered` the mean length behind the
/// edge: area over the edge's length.
double corner_conductance(double angle, double open, double covered);

} // namespace gapflow
