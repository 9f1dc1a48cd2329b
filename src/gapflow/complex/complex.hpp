// One complex of fluid parts: every connected part of the fluid in a cell is a cell of it, whatever its thickness (theory, "The complex").
//
// Built from the solids' poses and const from then on. A rank builds that of its own cells and of some layers around them; all ranks find the same of what they share. Lengths are in cells (dx), counted from Grid::anchor(): in the core grid plane i lies at i.
// Coordinates of solids are rounded to 2^-36 of a cell, so that a shift by whole periods is exact: what lies on two sides of a periodic domain is
// the same to the last bit.
#pragma once

#include "gapflow/geometry/solid.hpp"
#include "gapflow/grid/grid.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace gapflow {

/// Numbers of cells and faces in a dense array over a block of cells and one layer beyond on each high side. The block of a rank: its own cells, and
/// `shared_layers` of others' around them. Across a periodic side of which other ranks own the other one cells are numbered on.
template <int D>
struct DenseIndex {
    /// Rows of K take what is lent two faces beyond their cell, and who lends looks at two faces further.
    static constexpr int shared_layers = 4;

    Index<D> low, size; ///< cells: low <= c < high()
    Index<D> stride;
    std::array<bool, D> wraps{}; ///< axes along which the last cell lies before the first
    long count = 0;

    DenseIndex() = default;
    DenseIndex(const Index<D>& low_, const Index<D>& high) : low(low_), size(high - low_ + Index<D>::Ones())
    {
        count = 1;
        for (int axis = 0; axis < D; ++axis) {
            stride[axis] = static_cast<int>(count);
            count *= size[axis];
        }
    }
    explicit DenseIndex(const Grid<D>& grid);
    Index<D> high() const { return low + size - Index<D>::Ones(); }
    /// One past the last faces normal to an axis.
    Index<D> faces_end(int axis) const { return wraps[axis] ? high() : Index<D>(high() + step<D>(axis)); }
    int operator()(const Index<D>& c) const { return (c - low).dot(stride); }
    Index<D> wrapped(Index<D> c) const
    {
        for (int axis = 0; axis < D; ++axis)
            if (wraps[axis])
                c[axis] += c[axis] < low[axis] ? size[axis] - 1 : c[axis] >= low[axis] + size[axis] - 1 ? 1 - size[axis] : 0;
        return c;
    }
    bool holds(const Index<D>& cell) const
    {
        return (cell.array() >= low.array()).all() && (cell.array() < low.array() + size.array() - 1).all();
    }
    Index<D> index(int number) const
    {
        Index<D> c;
        for (int axis = D - 1; axis >= 0; --axis) {
            c[axis] = low[axis] + number / stride[axis];
            number %= stride[axis];
        }
        return c;
    }
};

/// One side of a face piece: a part of a cut cell, a whole cell, or nothing (beyond the domain).
struct PartOrCell {
    static constexpr std::int32_t none = std::numeric_limits<std::int32_t>::min();
    std::int32_t code = none;

    static PartOrCell part(int number) { return {number}; }
    static PartOrCell cell(int number) { return {-1 - number}; }
    bool is_part() const { return code >= 0; }
    bool is_cell() const { return code < 0 && code != none; }
    bool exists() const { return code != none; }
    int number() const { return code >= 0 ? code : -1 - code; }
};

/// A connected open piece of a face of the grid, where not all of the face is open between two whole cells.
template <int D>
struct FacePiece {
    std::int8_t axis;
    std::int32_t face; ///< number of the cell on its high side in Complex::index
    PartOrCell low, high;
    double area; ///< in cells^(D-1)
    Vec<D> centroid;
};

/// A solid's surface in a part: area vector out of the fluid and its moment about the solid's reference point. The flux of the solid's twist out of the part
/// is their product.
template <int D>
struct WallPatch {
    std::int32_t solid;
    Vec<D> area;
    Spin<D> moment;
};

/// Two parts of a cell on both sides of the line (3D: plane) by which a sharp corner (edge) of a solid divides it. Its flux is relative to the solid: that
/// of the solid's motion through the line is part of their wall patches.
template <int D>
struct CornerLink {
    std::int32_t a, b; ///< parts; 2D: at the left and right of the way outward
    std::int32_t solid;
    double conductance;   ///< times density
    double open, covered; ///< lengths of the corner's bisector in the cell; 3D: areas of the edge's bisector plane
    Vec<D> at;            ///< the corner; 3D: the edge's middle
    int mouth = -1;       ///< of which it is a part, see Complex::mouths; its conductance is then that of the corner alone
};

/// What lies on one side of a mouth.
struct GapMouthSide {
    double gap = 0; ///< the share of a gap, 0 .. 1; the rest is fluid into which the flow spreads
    // Where it is not a gap alone:
    double angle = 0;  ///< of the sector around the mouth on this side
    double apex = 0.5; ///< where the sector's walls would meet: the share of the way from the corner to the other wall
    double outlet = 0; ///< resistance to a source spread evenly over the sector
};

/// Where a gap ends at a sharp corner in front of another wall (mouth.hpp).
template <int D>
struct GapMouth {
    std::array<std::int32_t, 2> solid; ///< that of the corner, and the one across
    Vec<D> at, end;                    ///< the corner, and the place on the other wall nearest to it
    double length;                     ///< of the dividing line
    double share;                      ///< of the mouth in the resistance of its links; the rest is that of the corner alone
    double radius;                     ///< of the sector into which the flow spreads
    double room;                       ///< how far it is one, up to the farthest places of cells that reach into it
    std::array<GapMouthSide, 2> sides; ///< 2D: at the left and right of the way from the corner
    int axis = -1, plane = 0;          ///< where it lies in a plane of the grid, whose faces it is then; else axis -1
    // 3D: of an edge in one cell or face, at the middle of what lies there.
    Vec<D> across = Vec<D>::Zero(); ///< normal to edge and line, of unit length: to the left
    double area = 0;
    struct Wall {
        Vec<D> at, normal;
    };
    std::array<std::array<Wall, 2>, 2> walls{}; ///< half a cell to each side: the two walls there
    std::int32_t piece = -1;                    ///< of the face, where it lies in a plane
};

template <int D>
struct Complex {
    static constexpr std::int32_t open = -1, solid = -2;

    DenseIndex<D> index;
    std::vector<std::int32_t> cell; ///< number of the cut cell, or open, or solid
    /// Open area of the face on the low side of each cell along each axis, in cells^(D-1), as far as it joins the largest parts of two cells; on
    /// sides of the domain that of the largest part beside it. Faces on the far side of an axis that wraps: those of its first cell.
    std::array<std::vector<double>, D> main_area;
    // Cut cells. Their parts: the first one is the largest.
    std::vector<std::int32_t> cut_cell; ///< number in `index`
    std::vector<std::int32_t> first_part{0};
    // Parts.
    std::vector<std::int32_t> part_cell; ///< cut cell
    std::vector<double> part_area;       ///< of its open face pieces (2D: its own area)
    std::vector<Vec<D>> part_centroid;   ///< 2D
    std::vector<std::int32_t> first_patch{0};
    std::vector<WallPatch<D>> patches;
    /// Faces that solids cut, and those that do not lead to the largest part.
    std::vector<FacePiece<D>> pieces;
    std::vector<CornerLink<D>> links;
    std::vector<GapMouth<D>> mouths; ///< 3D: one of each link or piece

    /// Whether a piece is part of main_area.
    bool joins_main(const FacePiece<D>& piece) const { return is_main(piece.low) && is_main(piece.high); }
    bool is_main(const PartOrCell& side) const { return !side.is_part() || is_main(side.number()); }
    /// The largest part of a cell (number in `index`), the cell where it is whole, nothing where it is solid.
    PartOrCell main_of(int number) const
    {
        const std::int32_t c = cell[number];
        return c >= 0 ? PartOrCell::part(first_part[c]) : c == open ? PartOrCell::cell(number) : PartOrCell{};
    }
    /// The cell beside a piece, number in `index`.
    int cell_of(const PartOrCell& side) const { return side.is_part() ? cut_cell[part_cell[side.number()]] : side.number(); }

    /// A convex corner; 3D: a place of an edge or rim, for some length of it (corner_faces.hpp).
    struct Corner {
        std::int32_t solid;
        Vec<D> at, reference; ///< reference: the solid's
        double strength;      ///< corner_gain(); 3D: times the length
        Vec<D> outward;       ///< the bisector, of unit length
        double half;          ///< angle between it and the walls
        Vec<D> along;         ///< 3D: of the edge, of unit length
    };
    std::vector<Corner> corners; ///< near this rank's cells

    /// D of each solid, by its twist, in cells: what the grid's planes see of it less its volume (seen_volume.hpp), and the relative flux around its corners.
    /// Uniform motion is exact with it.
    std::vector<TwistMatrix<D>> seen_mass;

    int parts() const { return static_cast<int>(part_cell.size()); }
    int cut_cells() const { return static_cast<int>(cut_cell.size()); }
    std::span<const WallPatch<D>> patches_of(int part) const
    {
        return {patches.data() + first_patch[part], static_cast<std::size_t>(first_patch[part + 1] - first_patch[part])};
    }
    bool is_main(int part) const { return first_part[part_cell[part]] == part; }
    Index<D> cell_of_part(int part) const { return index.index(cut_cell[part_cell[part]]); }
    long bytes() const;
};

template <int D>
struct FaceDerivatives;
template <int D>
struct PartFace;

/// Of the solids at their poses; walls among them (closed sides of the domain) cut nothing and have no patches. `derivatives`: those of
/// its pieces, where they are wanted (area_derivative.hpp); `borders`: those of its parts (part_borders.hpp). `mouths`: whether other walls lead the
/// dividing lines of corners near them (2D); derivatives are those of lines along bisectors.
template <int D>
Complex<D> build_complex(const Grid<D>& grid, std::span<const Solid<D>> solids, FaceDerivatives<D>* derivatives = nullptr,
                         std::vector<PartFace<D>>* borders = nullptr, bool mouths = true);

} // namespace gapflow
